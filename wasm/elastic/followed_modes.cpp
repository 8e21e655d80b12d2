#include "elastic/followed_modes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "elastic/shell.h"

namespace limber {

namespace {

constexpr double kShiftOfStart = 0.5;  // times the first eigenvalue of a start

// As many rigid motions as the clamped unknowns leave free: those that move the clamped unknowns the least.
Eigen::MatrixXd freeRigidMotions(const TriangleMesh& mesh, const std::vector<uint32_t>& clamped, int count) {
  const Eigen::MatrixXd motions = rigidMotions(mesh);
  if (clamped.empty()) return motions;
  Eigen::Matrix<double, 6, 6> squares = Eigen::Matrix<double, 6, 6>::Zero();
  for (const uint32_t row : clamped)
    if (static_cast<Eigen::Index>(row) < motions.rows())
      squares += motions.row(row).transpose() * motions.row(row);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(squares);
  return motions * solver.eigenvectors().leftCols(count);
}

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

Eigen::MatrixXd startColumns(const TriangleMesh& mesh, const ModeBasis& start,
                             const StartUnknowns& unknowns) {
  const int rigid = unknowns.freeMotions;
  const Eigen::MatrixXd& phi = start.phi;
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(unknowns.count, rigid + phi.cols());
  if (rigid > 0)
    columns.topLeftCorner(3 * static_cast<Eigen::Index>(mesh.vertexCount()), rigid) =
        freeRigidMotions(mesh, unknowns.clamped, rigid);
  columns.topRightCorner(phi.rows(), phi.cols()) = phi;
  for (const uint32_t row : unknowns.clamped) columns.row(row).setZero();
  return columns;
}

}  // namespace limber
