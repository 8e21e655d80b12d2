#include "elastic/shell_vibration.h"

#include <algorithm>

#include "elastic/pins.h"
#include "elastic/shell.h"
#include "linear/eigensolver.h"

namespace limber {

namespace {

constexpr int kSpareModes = 6;  // the subspace converges by the first one left out
constexpr int kRigidMotions = 6;
constexpr int kFewUnknowns = 400;  // solved from scratch in no time

}  // namespace

VibratingShell::VibratingShell(const TriangleMesh& mesh, const Topology& topology,
                               const VibrationOptions& options, const Job& job)
    : topology_(topology), options_(options) {
  if (!options.pinned.empty()) held_ = heldUnknowns(mesh, topology, options.pinned);
  structure_ =
      std::make_shared<const FactorStructure>(factorStructure(shellModel(mesh, topology, 1, 0), job));
}

StiffnessModel VibratingShell::modelOf(const TriangleMesh& mesh, double thickness) const {
  StiffnessModel model = shellModel(mesh, topology_, thickness, options_.poisson);
  if (!held_.empty()) holdUnknowns(model, held_);
  return model;
}

ShellVibration VibratingShell::solve(const TriangleMesh& mesh, double thickness, int modeCount,
                                     Job& job) const {
  const StiffnessModel model = modelOf(mesh, thickness);
  const bool isHeld = !held_.empty();
  const EigenPairs pairs = solveEigenproblem(model,
                                             {modeCount + kSpareModes, isHeld ? 0 : kRigidMotions,
                                              roughFirstEigenvalue(thickness, isHeld), structure_, true},
                                             job);
  return {thickness, pairs.lambda, pairs.phi};
}

ShellVibration VibratingShell::follow(const TriangleMesh& mesh, const ShellVibration& start, int modeCount,
                                      Job& job) const {
  if (start.lambda.size() == 0 || unknownCount() <= kFewUnknowns)
    return solve(mesh, start.thickness, modeCount, job);
  const StiffnessModel model = modelOf(mesh, start.thickness);
  const int rigid = held_.empty() ? kRigidMotions : 0;
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(unknownCount(), rigid + start.phi.cols());
  if (rigid > 0)
    columns.topLeftCorner(3 * static_cast<Eigen::Index>(mesh.vertexCount()), rigid) = rigidMotions(mesh);
  columns.topRightCorner(start.phi.rows(), start.phi.cols()) = start.phi;
  for (uint32_t row : held_) columns.row(row).setZero();
  RefineOptions refine;
  refine.shift = -0.5 * start.lambda[0];
  refine.tolerance = options_.tolerance;
  refine.elasticCount = static_cast<int>(start.phi.cols());
  refine.spareCount = std::max(0, refine.elasticCount - modeCount);
  refine.largestStepCount = options_.largestStepCount;
  refine.residuals = false;
  refine.structure = structure_;
  const EigenPairs pairs = refineEigenpairs(model, columns, refine, job);
  return {start.thickness, pairs.lambda, pairs.phi};
}

}  // namespace limber
