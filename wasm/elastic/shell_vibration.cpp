#include "elastic/shell_vibration.h"

#include <utility>

#include "elastic/followed_modes.h"
#include "elastic/pins.h"
#include "elastic/shell.h"
#include "elastic/solve_modes.h"

namespace limber {

namespace {

constexpr int kRigidMotions = 6;

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

int VibratingShell::freeMotions() const {
  return clamped_.empty() ? kRigidMotions : options_.freeMotions;
}

EigenOptions VibratingShell::searchOptions(const VibrationRequest& request) const {
  EigenOptions options;
  options.pairCount = request.modeCount;
  options.expectedNullity = freeMotions();
  options.scale = roughFirstEigenvalue(request.thickness, !clamped_.empty());
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

EigenSolution VibratingShell::refined(const SparsePencil& pencil, const Eigen::MatrixXd& columns,
                                      RefineOptions options, Job& job) const {
  options.tolerance = options_.tolerance;
  options.largestStepCount = options_.largestStepCount;
  options.structure = structure_;
  return refineModes(pencil, columns, std::move(options), job);
}

EigenSolution VibratingShell::refine(const TriangleMesh& mesh, const ModeBasis& start,
                                     const VibrationRequest& request, Job& job) const {
  RefineOptions options = refineOptions(start);
  options.pairCount = request.modeCount;
  const Eigen::MatrixXd columns = startColumns(mesh, start, {unknownCount(), clamped_, freeMotions()});
  return refined(pencilOf(mesh, request.thickness), columns, std::move(options), job);
}

ModeBasis VibratingShell::follow(const TriangleMesh& mesh, const ModeBasis& start,
                                 const VibrationRequest& request, Job& job) const {
  if (start.modeCount() == 0 || unknownCount() <= kFewUnknowns) return solve(mesh, request, job);
  const Eigen::MatrixXd columns = startColumns(mesh, start, {unknownCount(), clamped_, freeMotions()});
  return refined(pencilOf(mesh, request.thickness), columns, followOptions(start, request.modeCount), job)
      .basis;
}

}  // namespace limber
