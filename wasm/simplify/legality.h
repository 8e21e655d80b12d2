#pragma once

#include <cstdint>
#include <span>

#include "simplify/collapse_mesh.h"
#include "simplify/simplify_options.h"

namespace limber {

// Why a collapse is refused, in the order in which the rules are checked.
enum class Verdict : uint8_t { Legal, Locked, Topology, Flip, Angle, Deviation };

// The rules that preserve topology, orientation, constraints and angles of a surface. Uses marks in the mesh,
// so it must not be used from several threads.
class Legality {
 public:
  // Keeps a reference to `mesh` and to the lists of `options`.
  Legality(CollapseMesh& mesh, const SimplifyOptions& options);

  // The reason why an edge cannot collapse as long as its ends are the same vertices: both ends must stay,
  // they are in different pinned sets, or a vertex would leave its feature edges. Legal if none of these
  // applies.
  Verdict permanentVerdict(uint32_t edge) const {
    const auto [a, b] = mesh_.edge(edge);
    const VertexRole &atA = mesh_.role(a), &atB = mesh_.role(b);
    if (atA.freedom == Freedom::Locked || atB.freedom == Freedom::Locked) return Verdict::Locked;
    if (atA.freedom == Freedom::Fixed && atB.freedom == Freedom::Fixed) return Verdict::Locked;
    if (!pinnedSets_.empty() && mixesPinnedSets(edge)) return Verdict::Locked;
    const VertexRole& removed = atA.freedom < atB.freedom ? atA : atB;
    return removed.onFeature && !mesh_.isFeature(edge) ? Verdict::Topology : Verdict::Legal;
  }

  // Checks every rule but the deviation, which DeviationLimit checks.
  Verdict check(const Collapse& step);

 private:
  bool mixesPinnedSets(uint32_t edge) const;
  bool keepsTopology(const Collapse& step);
  bool joinsFeatures(const Collapse& step) const;
  bool spoilsAnyFace(const Collapse& step);
  bool spoilsAngles(const Collapse& step) const;

  CollapseMesh& mesh_;
  std::span<const uint32_t> pinnedSets_;
  double largestCosine_;  // of an angle that a collapse may create; 1 without `minAngle`
};

}  // namespace limber
