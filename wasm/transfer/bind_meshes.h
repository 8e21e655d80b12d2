#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "mesh/triangle_mesh.h"
#include "simplify/history.h"

namespace limber {

// Where each vertex of the input lies on the result.
struct Binding {
  std::vector<uint32_t>
      triangle;  // of the result, per input vertex; kNone where it has become no vertex of it
  std::vector<float> barycentric;  // barycentric[3 * v + c], each in [0, 1], the sum is 1
  std::vector<float> offset;       // height above the triangle's plane, outwards, in units of the mesh
};

// Binds every vertex of `input` to `result`, a mesh of its history whose vertices may have moved since (by a
// fit, say). The search starts around the vertices that the input vertex and its neighbours have become and
// walks on over the surface to a local closest point, on faces that look the same way where there are any: so
// it stays on its own sheet however close another one lies. Throws Cancelled, and std::invalid_argument where
// `result` is of another mesh.
Binding bindToResult(const TriangleMesh& input, const MeshAt& result, Job& job);

}  // namespace limber
