#pragma once

#include <Eigen/Core>

namespace limber {

// A lower triangle with a diagonal of ones; what is on and above its diagonal is not looked at.
using UnitLower = Eigen::Ref<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
// Several right-hand sides, side by side in each row: a row-major matrix, or the transpose of another one.
using RightSides = Eigen::Ref<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>, 0,
                              Eigen::OuterStride<>>;

// y becomes L^-1 y, or L^-T y.
void solveLower(const UnitLower& lower, RightSides y);
void solveLowerTransposed(const UnitLower& lower, RightSides y);

}  // namespace limber
