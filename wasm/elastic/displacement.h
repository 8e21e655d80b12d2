#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "base/vec3.h"

namespace limber {

// The displacement of vertex v in a mode shape with entries shape[3 v + c].
inline Vec3 displacementAt(const Eigen::Ref<const Eigen::VectorXd>& shape, size_t v) {
  const auto row = 3 * static_cast<Eigen::Index>(v);
  return {shape[row], shape[row + 1], shape[row + 2]};
}

}  // namespace limber
