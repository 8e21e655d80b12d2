#include "simplify/collapse_rules.h"

namespace limber {

CollapseRules::CollapseRules(const TriangleMesh& input, CollapseMesh& mesh, const SimplifyOptions& options,
                             Job& job)
    : mesh_(mesh), legality_(mesh, options), job_(job) {
  if (options.maxDeviation > 0) deviation_.emplace(input, mesh, options.maxDeviation);
  if (!options.constraints.mirror.empty()) mirror_.emplace(input, mesh, options.constraints.mirror);
}

Collapse CollapseRules::collapseOf(uint32_t edge, const Vec3& target) const {
  const Collapse step = mesh_.collapseOf(edge, target);
  return mirror_ && mirror_->isItsOwnImage(step) ? mirror_->onPlane(step) : step;
}

Verdict CollapseRules::judge(const Collapse& step) {
  if (hasImage(step)) {
    if (!mirror_->isApart(step)) return Verdict::Locked;
    const Collapse image = mirror_->imageOf(step);
    if (image.edge == kNone) return Verdict::Locked;
    if (const Verdict verdict = judgeAlone(image); verdict != Verdict::Legal) return verdict;
  }
  return judgeAlone(step);
}

Verdict CollapseRules::judgeAlone(const Collapse& step) {
  if (deviation_) job_.check();  // for a step may take a millisecond
  const Verdict verdict = legality_.check(step);
  const bool goesTooFar = verdict == Verdict::Legal && deviation_ && !deviation_->allows(step);
  return goesTooFar ? Verdict::Deviation : verdict;
}

std::optional<Collapse> CollapseRules::imageOf(const Collapse& step) const {
  return hasImage(step) ? std::optional(mirror_->imageOf(step)) : std::nullopt;
}

void CollapseRules::prepareImage(const Collapse& image) {
  if (deviation_) deviation_->allows(image);
}

void CollapseRules::collapse() {
  if (deviation_) deviation_->collapse();
}

}  // namespace limber
