#include "linear/dense/tall_product.h"

#include <vector>

#include "base/parallel.h"
#include "linear/dense/dense_product.h"

namespace limber {
namespace {

constexpr size_t kRowsPerRange = 1024;

}  // namespace

Eigen::MatrixXd transposedProduct(const Eigen::Ref<const Eigen::MatrixXd>& a,
                                  const Eigen::Ref<const Eigen::MatrixXd>& b) {
  const auto rows = static_cast<size_t>(a.rows());
  std::vector<Eigen::MatrixXd> sums((rows + kRowsPerRange - 1) / kRowsPerRange);
  parallelFor(rows, kRowsPerRange, [&](size_t begin, size_t end) {
    const auto first = static_cast<Eigen::Index>(begin), count = static_cast<Eigen::Index>(end - begin);
    sums[begin / kRowsPerRange] = product(a.middleRows(first, count).transpose(), b.middleRows(first, count));
  });
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(a.cols(), b.cols());
  for (const Eigen::MatrixXd& sum : sums) all += sum;
  return all;
}

void subtractTallProduct(const Eigen::Ref<const Eigen::MatrixXd>& a,
                         const Eigen::Ref<const Eigen::MatrixXd>& b, Eigen::Ref<Eigen::MatrixXd> c) {
  parallelFor(static_cast<size_t>(a.rows()), kRowsPerRange, [&](size_t begin, size_t end) {
    const auto first = static_cast<Eigen::Index>(begin), count = static_cast<Eigen::Index>(end - begin);
    subtractProduct(a.middleRows(first, count), b, c.middleRows(first, count));
  });
}

Eigen::MatrixXd tallProduct(const Eigen::Ref<const Eigen::MatrixXd>& a,
                            const Eigen::Ref<const Eigen::MatrixXd>& b) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(a.rows(), b.cols());
  subtractTallProduct(a, -b, result);
  return result;
}

}  // namespace limber
