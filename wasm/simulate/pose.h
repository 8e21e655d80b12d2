#pragma once

#include <array>

#include "mesh/triangle_mesh.h"

namespace limber {

// Where a scenario starts a body: rotated about the middle of its box.
struct Pose {
  Vec3 centre;
  std::array<Vec3, 3> rows;  // of the rotation
  Bounds box;                // of the posed mesh

  Vec3 of(const Vec3& p) const {
    const Vec3 arm = p - centre;
    return centre + Vec3{dot(rows[0], arm), dot(rows[1], arm), dot(rows[2], arm)};
  }
};

// The least rotation that lays a body flat. Of a sheet, which reaches less than a quarter as far along its
// principal axis of least variance as along the next one, that axis becomes vertical (y), whatever its pose;
// of another body, the shortest side of its box, and the last of equal ones.
Pose layFlat(const TriangleMesh& mesh);

}  // namespace limber
