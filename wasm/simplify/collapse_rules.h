#pragma once

#include <cstdint>
#include <optional>

#include "base/job.h"
#include "simplify/collapse_mesh.h"
#include "simplify/deviation_limit.h"
#include "simplify/legality.h"
#include "simplify/mirror.h"
#include "simplify/options.h"

namespace limber {

// All that decides whether a collapse is carried out, besides its cost: legality, the largest deviation and
// the mirror symmetry, where these are asked for.
class CollapseRules {
 public:
  // Keeps references to `mesh`, `job` and the lists of `options`. Throws std::invalid_argument where
  // `options.constraints.mirror` is no symmetry of the mesh.
  CollapseRules(const TriangleMesh& input, CollapseMesh& mesh, const SimplifyOptions& options, Job& job);

  Verdict permanentVerdict(uint32_t edge) const { return legality_.permanentVerdict(edge); }

  // The collapse of an edge, with its target moved onto the mirror plane where both ends lie on it.
  Collapse collapseOf(uint32_t edge, const Vec3& target) const;

  // Whether a collapse is allowed; with a mirror its image has to be allowed too. Throws Cancelled.
  Verdict judge(const Collapse& step);

  // The image that has to be carried out after the step; nothing where the step is its own image.
  std::optional<Collapse> imageOf(const Collapse& step) const;

  // To be called before the mesh carries out a step: right after `judge` has allowed it, or after
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

}  // namespace limber
