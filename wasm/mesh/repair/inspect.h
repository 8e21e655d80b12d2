#pragma once

#include <cstdint>
#include <optional>

#include "mesh/triangle_mesh.h"

namespace limber {

// Counts that describe a mesh and its defects: the fields that "input" and "output" of a report have in
// common. WeldResult counts welded vertices and degenerate, duplicate and flipped faces.
struct Inspection {
  uint32_t vertices = 0, faces = 0;
  uint32_t components = 0;
  uint32_t solidComponents = 0;     // modelled as solids by default, see mesh/nesting.h; others are shells
  uint32_t boundaryLoops = 0;       // closed walks along edges with one face
  std::optional<int64_t> genus;     // sum over components; none if the mesh is non-manifold or not orientable
  int64_t eulerCharacteristic = 0;  // V - E + F
  uint32_t nonManifoldEdges = 0;    // with more than two faces
  uint32_t nonManifoldVertices = 0;  // with more than one fan of faces; without ends of non-manifold edges
  uint32_t orientationClashes = 0;   // edges with two faces that traverse them in the same direction
};

// O(n log n).
Inspection inspect(const TriangleMesh& mesh);

}  // namespace limber
