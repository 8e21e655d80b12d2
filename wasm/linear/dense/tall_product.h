#pragma once

#include <Eigen/Core>

namespace limber {

// Products of matrices with many more rows than columns, on all threads. Sums are formed over ranges of rows
// that do not depend on the number of threads, so neither do results.

// a^T b for matrices with equal numbers of rows.
Eigen::MatrixXd transposedProduct(const Eigen::Ref<const Eigen::MatrixXd>& a,
                                  const Eigen::Ref<const Eigen::MatrixXd>& b);
// c -= a b, where b is small.
void subtractTallProduct(const Eigen::Ref<const Eigen::MatrixXd>& a,
                         const Eigen::Ref<const Eigen::MatrixXd>& b, Eigen::Ref<Eigen::MatrixXd> c);
// a b, where b is small.
Eigen::MatrixXd tallProduct(const Eigen::Ref<const Eigen::MatrixXd>& a,
                            const Eigen::Ref<const Eigen::MatrixXd>& b);

}  // namespace limber
