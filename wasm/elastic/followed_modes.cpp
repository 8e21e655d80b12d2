#include "elastic/followed_modes.h"

#include <algorithm>

#include "elastic/shell.h"

namespace limber {

namespace {

constexpr int kRigidMotions = 6;
constexpr double kShiftOfStart = 0.5;  // times the first eigenvalue of a start

}  // namespace

RefineOptions refineOptions(const ModeBasis& start) {
  RefineOptions options;
  options.shift = -kShiftOfStart * start.lambda[0];
  options.pairCount = static_cast<int>(start.modeCount());
  return options;
}

RefineOptions followOptions(const ModeBasis& start, int count) {
  RefineOptions options = refineOptions(start);
  options.spareCount = std::max(0, options.pairCount - count);
  options.residuals = false;
  return options;
}

Eigen::MatrixXd startColumns(const TriangleMesh& mesh, const Eigen::MatrixXd& phi, Eigen::Index unknownCount,
                             const std::vector<uint32_t>& clamped) {
  const int rigid = clamped.empty() ? kRigidMotions : 0;
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(unknownCount, rigid + phi.cols());
  if (rigid > 0)
    columns.topLeftCorner(3 * static_cast<Eigen::Index>(mesh.vertexCount()), rigid) = rigidMotions(mesh);
  columns.topRightCorner(phi.rows(), phi.cols()) = phi;
  for (const uint32_t row : clamped) columns.row(row).setZero();
  return columns;
}

}  // namespace limber
