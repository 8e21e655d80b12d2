#pragma once

#include <cstdint>
#include <optional>

#include "base/job.h"
#include "simplify/collapse_mesh.h"
#include "simplify/deviation_limit.h"
#include "simplify/legality.h"
#include "simplify/simplify_options.h"
#include "simplify/symmetry/mirror.h"

namespace limber {

// All rules that decide whether a collapse is carried out, besides its cost: legality and, if requested, the
// largest deviation and the mirror symmetry.
class CollapseRules {
 public:
  // Keeps references to `mesh`, `job` and the lists of `options`. Throws std::invalid_argument if
  // `options.constraints.mirror` is not a symmetry of the mesh.
  CollapseRules(const TriangleMesh& input, CollapseMesh& mesh, const SimplifyOptions& options, Job& job);

  Verdict permanentVerdict(uint32_t edge) const { return legality_.permanentVerdict(edge); }

  // The collapse of an edge, with its target moved onto the mirror plane if both ends lie on it.
  Collapse collapseOf(uint32_t edge, const Vec3& target) const;

  // Whether a collapse is allowed; with a mirror its image has to be allowed too. Throws Cancelled.
  Verdict judge(const Collapse& step);

  // The image that has to be carried out after the step; nothing if the step is its own image.
  std::optional<Collapse> imageOf(const Collapse& step) const;

  // Must be called before the mesh carries out a step: right after `judge` has allowed it, or after
  // `prepareImage`.
  void collapse();
  void prepareImage(const Collapse& image);

 private:
  Verdict judgeAlone(const Collapse& step);
  bool hasImage(const Collapse& step) const { return mirror_ && !mirror_->isItsOwnImage(step); }

  CollapseMesh& mesh_;
  Legality legality_;
  std::optional<DeviationLimit> deviation_;
  std::optional<Mirror> mirror_;
  Job& job_;
};

// Inline, because the loop of every method calls them for each edge.

inline Collapse CollapseRules::collapseOf(uint32_t edge, const Vec3& target) const {
  const Collapse step = mesh_.collapseOf(edge, target);
  return mirror_ && mirror_->isItsOwnImage(step) ? mirror_->onPlane(step) : step;
}

inline Verdict CollapseRules::judge(const Collapse& step) {
  if (hasImage(step)) {
    if (!mirror_->isApart(step)) return Verdict::Locked;
    const Collapse image = mirror_->imageOf(step);
    if (image.edge == kNone || !mirror_->mayFollow(image, step)) return Verdict::Locked;
    if (const Verdict verdict = judgeAlone(image); verdict != Verdict::Legal) return verdict;
  }
  return judgeAlone(step);
}

inline Verdict CollapseRules::judgeAlone(const Collapse& step) {
  if (deviation_) job_.check();  // a step may take a millisecond
  const Verdict verdict = legality_.check(step);
  const bool goesTooFar = verdict == Verdict::Legal && deviation_ && !deviation_->allows(step);
  return goesTooFar ? Verdict::Deviation : verdict;
}

inline std::optional<Collapse> CollapseRules::imageOf(const Collapse& step) const {
  return hasImage(step) ? std::optional(mirror_->imageOf(step)) : std::nullopt;
}

inline void CollapseRules::prepareImage(const Collapse& image) {
  if (deviation_) deviation_->follow(image);
}

inline void CollapseRules::collapse() {
  if (deviation_) deviation_->collapse();
}

}  // namespace limber
