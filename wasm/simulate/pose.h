#pragma once

#include <array>

#include "mesh/triangle_mesh.h"

namespace limber {

// The pose in which a scenario starts a body: a rotation about the centre of its box.
struct Pose {
  Vec3 centre;
  std::array<Vec3, 3> rows;  // of the rotation
  Bounds box;                // of the posed mesh

  Vec3 of(const Vec3& p) const {
    const Vec3 arm = p - centre;
    return centre + Vec3{dot(rows[0], arm), dot(rows[1], arm), dot(rows[2], arm)};
  }
};

// The smallest rotation that lays a body flat. For a sheet, whose extent along its principal axis of least
// variance is less than a quarter of that along the next one, that axis becomes vertical (y), whatever its
// pose; for any other body the shortest side of its box, the last of equal ones.
Pose layFlat(const TriangleMesh& mesh);

}  // namespace limber
