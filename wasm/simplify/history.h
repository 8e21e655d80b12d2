#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace limber {

// Why a history ends.
enum class StopReason : int32_t {
  Target = 0,     // the requested number of triangles is reached
  Deviation = 1,  // all other legal collapses would move the surface too far from the input
  Angle = 2,      // all other legal collapses would make an angle too small
  Exhausted = 3,  // no legal collapse is left
};

// Numbers of edges that remain at the end, by the first reason why they cannot collapse; all 0 if the history
// ended at its target.
struct Refused {
  uint32_t topology = 0;   // the link condition: components, holes or handles would change
  uint32_t flip = 0;       // a face would flip or lose its area
  uint32_t lock = 0;       // a non-manifold edge or vertex, or a constraint
  uint32_t angle = 0;      // an angle below `minAngle` would appear
  uint32_t deviation = 0;  // the surface would be farther than `maxDeviation` from the input
};

// All collapses in order from the input down to the floor, or to the target that ended it; 24 bytes each.
// Collapse i moves vertex kept[i] to position i, gives it the triangles of removed[i], and leaves
// trianglesAfter[i] triangles.
struct History {
  uint32_t vertexCount = 0, triangleCount = 0;  // of the input
  std::vector<uint32_t> kept, removed;          // vertices of the input
  std::vector<float> positions;                 // positions[3 * i + c]
  std::vector<uint32_t> trianglesAfter;         // strictly descending
  // Per collapse an estimate of how far it has moved the surface from the input, see DeviationEstimate; in
  // units of the mesh, not monotonic. Empty unless SimplifyOptions::recordErrors is set.
  std::vector<float> errors;
  Refused refused;  // at the end
  StopReason stop = StopReason::Exhausted;

  uint32_t collapseCount() const { return static_cast<uint32_t>(kept.size()); }
};

// Edges that were flipped after the history. `triangles` are those before the flips; corners[3 * t + c] is
// the flat index in `triangles` of the corner that corner c of triangle t was, at the same vertex and in the
// same chart. Both are empty if nothing was flipped.
struct Flips {
  std::vector<Triangle> triangles;
  std::vector<uint32_t> corners;
};

// The number of collapses that lead to the largest mesh with at most `faces` triangles, or all of them if
// there is no such mesh. O(log n).
uint32_t collapsesFor(const History& history, uint32_t faces);

// Throws std::invalid_argument if a history cannot belong to this mesh. Only checks counts and ranges.
void checkBelongs(const TriangleMesh& input, const History& history);
[[noreturn]] void refuseHistory();

// The mesh at one moment of a history, without unused vertices and in the order of the input.
struct MeshAt {
  TriangleMesh mesh;
  std::vector<uint32_t> vertexOfInput;    // per input vertex: the vertex of `mesh` that it became, or kNone
  std::vector<uint32_t> inputOfVertex;    // per vertex of `mesh`: the input vertex that it was
  std::vector<uint32_t> inputOfTriangle;  // per triangle of `mesh`: the input triangle that it was
  Flips flips;
};

// The largest mesh of the history with at most `faces` triangles, or the floor if there is none. O(input),
// independent of earlier calls. Throws std::invalid_argument if `history` does not belong to `input`.
MeshAt meshAt(const TriangleMesh& input, const History& history, uint32_t faces);

}  // namespace limber
