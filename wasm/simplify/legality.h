#pragma once

#include <cstdint>
#include <vector>

#include "simplify/collapse_mesh.h"
#include "simplify/history.h"

namespace limber {

// Why a collapse may not be, in the order in which the rules are asked.
enum class Verdict : uint8_t { Legal, Locked, Topology, Flip };

// The rules that keep a surface what it is. Holds scratch memory; not for use from several threads.
class Legality {
 public:
  explicit Legality(const CollapseMesh& mesh) : mesh_(mesh), seen_(mesh.vertexCount(), 0) {}

  // Whether an edge can never collapse, whatever happens around it: a locked end, or an inner edge that
  // joins two border vertices. Legal where it may.
  Verdict forever(uint32_t edge) const {
    const auto [a, b] = mesh_.edge(edge);
    const Freedom atA = mesh_.freedom(a), atB = mesh_.freedom(b);
    if (atA == Freedom::Locked || atB == Freedom::Locked) return Verdict::Locked;
    const bool joinsBorders = atA == Freedom::Border && atB == Freedom::Border;
    return joinsBorders && mesh_.trianglesOnEdge(edge) == 2 ? Verdict::Topology : Verdict::Legal;
  }

  // Asks every rule.
  Verdict check(const Collapse& step);

 private:
  bool keepsTopology(const Collapse& step);
  uint32_t countCommonNeighbours(uint32_t a, uint32_t b);
  bool spoilsAnyFace(uint32_t v, const Collapse& step) const;

  const CollapseMesh& mesh_;
  std::vector<uint32_t> seen_;  // per vertex: the last mark that was set on it
  uint32_t mark_ = 0;
};

}  // namespace limber
