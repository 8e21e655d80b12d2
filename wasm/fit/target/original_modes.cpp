#include "fit/target/original_modes.h"

#include "elastic/mode_conversions.h"
#include "modes/find_modes.h"

namespace limber {

OriginalModes::OriginalModes(const TriangleMesh& original, const VibrationOptions& options, Job& job)
    : original_(original), options_(options) {
  if (original.vertexCount() > kRefinedVertices) return;
  topology_ = buildTopology(original);
  shell_.emplace(original, topology_, options, job);
}

ModeBasis OriginalModes::refine(const ModeBasis& start, const VibrationRequest& request, Job& job) const {
  return shell_->follow(original_, start, request, job);
}

ModeBasis OriginalModes::findCoarsely(const VibrationRequest& request, Job& job) const {
  ModesOptions options{ElasticModel::Shell, request.modeCount,
                       unitMaterial(request.thickness, options_.poisson)};
  options.pinned.assign(options_.pinned.begin(), options_.pinned.end());
  const ModeSet set = findModes(original_, options, false, job);
  return lowestModes(set, buildTopology(original_).componentOfVertex, set.modes.size());
}

}  // namespace limber
