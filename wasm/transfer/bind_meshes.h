#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "mesh/triangle_mesh.h"
#include "simplify/history.h"

namespace limber {

// The points of a result that the vertices of its original are bound to.
struct Binding {
  std::vector<uint32_t> triangle;  // [v] of the original: of the result; kNone where v is no vertex of it
  std::vector<float> barycentric;  // [3 v + c]: of that triangle, each in [0, 1] with sum 1
  std::vector<float> offset;  // [v]: height of v above the triangle's plane, outwards, in units of the mesh
};

// Binds every vertex of `original` to `result`, a mesh of its history whose vertices may have moved since
// then (by a fit, for example). The search starts around the vertices that the vertex and its neighbours have
// become and walks over the surface to a local closest point, across faces that look the same way where there
// are any: so it stays on its sheet of the surface however close another one lies. Throws Cancelled, and
// std::invalid_argument where `result` belongs to another mesh.
Binding bindToResult(const TriangleMesh& original, const MeshAt& result, Job& job);

}  // namespace limber
