#include "simplify/collapse_rules.h"

namespace limber {

CollapseRules::CollapseRules(const TriangleMesh& input, CollapseMesh& mesh, const SimplifyOptions& options,
                             Job& job)
    : mesh_(mesh), legality_(mesh, options), job_(job) {
  if (options.maxDeviation > 0) deviation_.emplace(input, mesh, options.maxDeviation);
  if (!options.constraints.mirror.empty()) mirror_.emplace(input, mesh, options.constraints.mirror);
}

}  // namespace limber
