#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "mesh/triangle_mesh.h"
#include "simplify/history.h"

namespace limber {

// The points of a result to which the vertices of its original are bound.
struct Binding {
  std::vector<uint32_t> triangle;  // [v] of the original: a triangle of the result; kNone if v is not used
  std::vector<float> barycentric;  // [3 v + c]: of that triangle, each in [0, 1] with sum 1
  std::vector<float> offset;  // [v]: height of v above the triangle's plane, outwards, in units of the mesh
};

// Binds every vertex of `original` to `result`, a mesh of its history whose vertices may have moved since
// then (by a fit, for example). The search starts around the vertices that the vertex and its neighbours were
// merged into and walks over the surface to a local closest point, preferably across faces that face the same
// way, so that it stays on its sheet of the surface however close another one lies. Throws Cancelled, and
// std::invalid_argument if `result` belongs to another mesh.
Binding bindToResult(const TriangleMesh& original, const MeshAt& result, Job& job);

}  // namespace limber
