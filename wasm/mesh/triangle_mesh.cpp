#include "mesh/triangle_mesh.h"

#include <algorithm>

namespace limber {

Bounds bounds(const TriangleMesh& mesh) {
  if (mesh.positions.empty()) return {};
  Bounds box{mesh.positions[0], mesh.positions[0]};
  for (const Vec3& p : mesh.positions)
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], p[axis]);
      box.high[axis] = std::max(box.high[axis], p[axis]);
    }
  return box;
}

}  // namespace limber
