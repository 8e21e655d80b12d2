#include "pipeline/shell_vibration.h"

#include <algorithm>

#include "modes/eigensolver.h"
#include "modes/shell.h"

namespace limber {

namespace {

constexpr int kSpareModes = 6;  // the subspace converges by the first one left out
constexpr int kRigidMotions = 6;
constexpr int kFewUnknowns = 400;  // solved from scratch in no time

}  // namespace

VibratingShell::VibratingShell(const TriangleMesh& mesh, const Topology& topology,
                               const VibrationOptions& options, const Job& job)
    : topology_(topology), options_(options) {
  structure_ =
      std::make_shared<const FactorStructure>(factorStructure(shellModel(mesh, topology, 1, 0), job));
}

ShellVibration VibratingShell::solve(const TriangleMesh& mesh, double thickness, Job& job) const {
  const StiffnessModel model = shellModel(mesh, topology_, thickness, options_.poisson);
  const EigenPairs pairs = solveEigenproblem(
      model,
      {options_.modeCount + kSpareModes, kRigidMotions, roughFirstEigenvalue(thickness, false), structure_},
      job);
  return {thickness, pairs.lambda, pairs.phi};
}

ShellVibration VibratingShell::follow(const TriangleMesh& mesh, const ShellVibration& start, Job& job) const {
  if (start.lambda.size() == 0 || unknownCount() <= kFewUnknowns) return solve(mesh, start.thickness, job);
  const StiffnessModel model = shellModel(mesh, topology_, start.thickness, options_.poisson);
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(unknownCount(), kRigidMotions + start.phi.cols());
  columns.topLeftCorner(3 * static_cast<Eigen::Index>(mesh.vertexCount()), kRigidMotions) =
      rigidMotions(mesh);
  columns.topRightCorner(start.phi.rows(), start.phi.cols()) = start.phi;
  RefineOptions refine;
  refine.shift = -0.5 * start.lambda[0];
  refine.tolerance = options_.tolerance;
  refine.elasticCount = static_cast<int>(start.phi.cols());
  refine.spareCount = std::max(0, refine.elasticCount - options_.modeCount);
  refine.largestStepCount = options_.largestStepCount;
  refine.residuals = false;
  refine.structure = structure_;
  const EigenPairs pairs = refineEigenpairs(model, columns, refine, job);
  return {start.thickness, pairs.lambda, pairs.phi};
}

}  // namespace limber
