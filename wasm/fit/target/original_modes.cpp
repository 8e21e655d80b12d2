#include "fit/target/original_modes.h"

#include "modes/find_modes.h"

namespace limber {

OriginalModes::OriginalModes(const TriangleMesh& original, const VibrationOptions& options, Job& job)
    : original_(original), options_(options) {
  if (original.vertexCount() > kRefinedVertices) return;
  topology_ = buildTopology(original);
  shell_.emplace(original, topology_, options, job);
}

ShellVibration OriginalModes::refine(const ShellVibration& start, int modeCount, Job& job) const {
  return shell_->follow(original_, start, modeCount, job);
}

ShellVibration OriginalModes::findCoarsely(double thickness, int modeCount, Job& job) const {
  ModesOptions options{Model::Shell, modeCount, thickness, 1, options_.poisson, 1, 1};
  options.pinned.assign(options_.pinned.begin(), options_.pinned.end());
  const ModeSet set = findModes(original_, options, false, job);
  const auto rows = 3 * static_cast<Eigen::Index>(original_.vertexCount()),
             columns = static_cast<Eigen::Index>(set.modes.size());
  ShellVibration found{thickness, Eigen::VectorXd(columns), Eigen::MatrixXd(rows, columns)};
  for (Eigen::Index k = 0; k < columns; ++k) {
    const Mode& mode = set.modes[static_cast<size_t>(k)];
    found.lambda[k] = mode.omega * mode.omega;
    for (Eigen::Index row = 0; row < rows; ++row)
      found.phi(row, k) = set.shapes[mode.ordinal * static_cast<size_t>(rows) + static_cast<size_t>(row)];
  }
  return found;
}

}  // namespace limber
