#pragma once

#include <cstdint>
#include <span>

#include "simplify/collapse_mesh.h"
#include "simplify/simplify.h"

namespace limber {

// Why a collapse may not be, in the order in which the rules are asked.
enum class Verdict : uint8_t { Legal, Locked, Topology, Flip, Angle, Deviation };

// The rules that keep a surface what it is. Uses marks in the mesh; not for use from several threads.
class Legality {
 public:
  // Keeps a reference to `mesh` and to the lists of `options`.
  Legality(CollapseMesh& mesh, const SimplifyOptions& options);

  // Whether an edge cannot collapse as long as its own ends stay what they are: an end that must stay, ends
  // of different pinned sets, or a vertex of a line that would leave it. Legal where it
  // may.
  Verdict permanentVerdict(uint32_t edge) const {
    const auto [a, b] = mesh_.edge(edge);
    const VertexRole &atA = mesh_.role(a), &atB = mesh_.role(b);
    if (atA.freedom == Freedom::Locked || atB.freedom == Freedom::Locked) return Verdict::Locked;
    if (atA.freedom == Freedom::Fixed && atB.freedom == Freedom::Fixed) return Verdict::Locked;
    if (!pinnedSets_.empty() && mixesPinnedSets(edge)) return Verdict::Locked;
    const VertexRole& removed = atA.freedom < atB.freedom ? atA : atB;
    return removed.onFeature && !mesh_.isFeature(edge) ? Verdict::Topology : Verdict::Legal;
  }

  // Asks every rule but the deviation, which DeviationLimit knows.
  Verdict check(const Collapse& step);

 private:
  bool mixesPinnedSets(uint32_t edge) const;
  bool keepsTopology(const Collapse& step);
  bool joinsFeatures(const Collapse& step) const;
  bool spoilsAnyFace(const Collapse& step);
  bool spoilsAngles(const Collapse& step) const;

  CollapseMesh& mesh_;
  std::span<const uint32_t> pinnedSets_;
  double largestCosine_;  // of an angle that a collapse may make
};

}  // namespace limber
