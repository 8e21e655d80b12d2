#pragma once

#include <Eigen/Core>

#include "base/vec3.h"

namespace limber {

inline Eigen::Vector3d eigen(const Vec3& v) {
  return {v.x, v.y, v.z};
}

}  // namespace limber
