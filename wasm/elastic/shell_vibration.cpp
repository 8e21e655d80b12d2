#include "elastic/shell_vibration.h"

#include <algorithm>

#include "elastic/pins.h"
#include "elastic/shell.h"
#include "elastic/solve_modes.h"

namespace limber {

namespace {

constexpr int kSpareModes = 6;  // the subspace converges as fast as the first mode left out allows
constexpr int kRigidMotions = 6;
constexpr int kFewUnknowns = 400;      // such a small shell is solved from scratch in no time
constexpr double kShiftOfStart = 0.5;  // times the first eigenvalue of a start

}  // namespace

VibratingShell::VibratingShell(const TriangleMesh& mesh, const Topology& topology,
                               const VibrationOptions& options, const Job& job)
    : topology_(topology), options_(options) {
  if (!options.pinned.empty()) clamped_ = clampedUnknowns(mesh, topology, options.pinned);
  structure_ = std::make_shared<const FactorStructure>(factorStructure(shellPattern(mesh, topology), job));
}

SparsePencil VibratingShell::pencilOf(const TriangleMesh& mesh, double thickness) const {
  SparsePencil pencil = shellPencil({mesh, topology_, thickness, options_.poisson});
  if (!clamped_.empty()) clampUnknowns(pencil, clamped_);
  return pencil;
}

EigenOptions VibratingShell::searchOptions(const VibrationRequest& request) const {
  const bool isPinned = !clamped_.empty();
  EigenOptions options;
  options.pairCount = request.modeCount;
  options.expectedNullity = isPinned ? options_.freeMotions : kRigidMotions;
  options.scale = roughFirstEigenvalue(request.thickness, isPinned);
  options.structure = structure_;
  return options;
}

EigenSolution VibratingShell::solveExactly(const TriangleMesh& mesh, const VibrationRequest& request,
                                           Job& job) const {
  return solveModes(pencilOf(mesh, request.thickness), searchOptions(request), job);
}

ModeBasis VibratingShell::solve(const TriangleMesh& mesh, const VibrationRequest& request, Job& job) const {
  EigenOptions options = searchOptions(request);
  options.pairCount += kSpareModes;
  options.isRough = true;
  return solveModes(pencilOf(mesh, request.thickness), options, job).basis;
}

RefineOptions VibratingShell::refineOptions(const ModeBasis& start) const {
  RefineOptions options;
  options.shift = -kShiftOfStart * start.lambda[0];
  options.tolerance = options_.tolerance;
  options.largestStepCount = options_.largestStepCount;
  options.structure = structure_;
  return options;
}

// The rigid motions of a free shell, then the start, with zeros for missing rows and clamped unknowns.
Eigen::MatrixXd VibratingShell::startColumns(const TriangleMesh& mesh, const Eigen::MatrixXd& phi) const {
  const int rigid = clamped_.empty() ? kRigidMotions : 0;
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(unknownCount(), rigid + phi.cols());
  if (rigid > 0)
    columns.topLeftCorner(3 * static_cast<Eigen::Index>(mesh.vertexCount()), rigid) = rigidMotions(mesh);
  columns.topRightCorner(phi.rows(), phi.cols()) = phi;
  for (uint32_t row : clamped_) columns.row(row).setZero();
  return columns;
}

EigenSolution VibratingShell::refine(const TriangleMesh& mesh, const ModeBasis& start,
                                     const VibrationRequest& request, Job& job) const {
  RefineOptions options = refineOptions(start);
  options.pairCount = request.modeCount;
  return refineModes(pencilOf(mesh, request.thickness), startColumns(mesh, start.phi), options, job);
}

ModeBasis VibratingShell::follow(const TriangleMesh& mesh, const ModeBasis& start,
                                 const VibrationRequest& request, Job& job) const {
  if (start.modeCount() == 0 || unknownCount() <= kFewUnknowns) return solve(mesh, request, job);
  RefineOptions options = refineOptions(start);
  options.pairCount = static_cast<int>(start.modeCount());
  options.spareCount = std::max(0, options.pairCount - request.modeCount);
  options.residuals = false;
  return refineModes(pencilOf(mesh, request.thickness), startColumns(mesh, start.phi), options, job).basis;
}

}  // namespace limber
