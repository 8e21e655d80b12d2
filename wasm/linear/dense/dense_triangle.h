#pragma once

#include <Eigen/Core>

namespace limber {

// A unit lower triangular matrix. Entries on and above its diagonal are not read.
using UnitLower = Eigen::Ref<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
// Right-hand sides as the columns of a row-major matrix, or of the transpose of a column-major one.
using RightSides = Eigen::Ref<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>, 0,
                              Eigen::OuterStride<>>;

// y := L^-1 y.
void solveLower(const UnitLower& lower, RightSides y);
// y := L^-T y.
void solveLowerTransposed(const UnitLower& lower, RightSides y);

}  // namespace limber
