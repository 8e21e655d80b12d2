#include "simplify/why_kept.h"

#include <utility>

#include "simplify/collapse_rules.h"
#include "simplify/cost/policies.h"

namespace limber {
namespace {

constexpr uint32_t kStepsPerReport = 512;

// A mesh and its costs at one moment of a history.
template <CostPolicy Policy>
class Moment {
 public:
  Moment(const Reduction& of, Job& job)
      : mesh_(of.mesh, of.options.constraints),
        costs_(of.mesh, mesh_, of.guidance, of.options),
        rules_(of.mesh, mesh_, withoutDeviation(of.options), job),
        job_(job) {}

  void replay(const History& history, uint32_t count) {
    for (uint32_t i = 0; i < count; ++i) {
      const float* p = &history.positions[3 * size_t{i}];
      const Collapse step{edgeBetween(history.kept[i], history.removed[i]), history.kept[i],
                          history.removed[i], mesh_.fromFile({p[0], p[1], p[2]})};
      if (step.edge == kNone) refuseHistory();
      costs_.collapse(step);
      mesh_.collapse(step);
      if (i % kStepsPerReport == 0) job_.report(0.5 * i / count);
    }
  }

  void priceAll() {
    std::vector<uint32_t> edges;
    for (uint32_t edge = 0; edge < mesh_.edgeCount(); ++edge)
      if (mesh_.trianglesOnEdge(edge) != 0) edges.push_back(edge);
    costs_.setBounds(edges);
  }

  std::vector<WhyKept> explainAll() {
    std::vector<uint32_t> number(mesh_.vertexCount(), kNone);
    std::vector<uint32_t> vertices;
    for (uint32_t v = 0; v < mesh_.vertexCount(); ++v) {
      if (mesh_.star(v).empty()) continue;
      number[v] = static_cast<uint32_t>(vertices.size());
      vertices.push_back(v);
    }
    std::vector<WhyKept> all;
    all.reserve(vertices.size());
    for (const uint32_t v : vertices) {
      if (all.size() % kStepsPerReport == 0)
        job_.report(0.5 + 0.5 * static_cast<double>(all.size()) / static_cast<double>(vertices.size()));
      all.push_back(explain(v));
      if (all.back().neighbour != kNone) all.back().neighbour = number[all.back().neighbour];
    }
    return all;
  }

 private:
  uint32_t edgeBetween(uint32_t a, uint32_t b) const {
    uint32_t found = kNone;
    mesh_.forEachEdge(a, [&](uint32_t edge, uint32_t other) {
      if (other == b) found = edge;
    });
    return found;
  }

  WhyKept explain(uint32_t v) {
    WhyKept best;
    if (mesh_.role(v).freedom == Freedom::Locked) return best;
    const auto rank = [](const WhyKept& why) {
      return std::pair(why.verdict != Verdict::Legal, why.terms.total());
    };
    mesh_.forEachEdge(v, [&](uint32_t edge, uint32_t other) {
      const Optimum optimum = costs_.optimum(edge);
      const WhyKept why{other, costs_.terms(edge, optimum),
                        rules_.judge(rules_.collapseOf(edge, optimum.position))};
      if (best.neighbour == kNone || rank(why) < rank(best)) best = why;
    });
    return best;
  }

  static SimplifyOptions withoutDeviation(SimplifyOptions options) {
    options.maxDeviation = 0;
    return options;
  }

  CollapseMesh mesh_;
  Policy costs_;
  CollapseRules rules_;
  Job& job_;
};

}  // namespace

std::vector<WhyKept> whyKept(const Reduction& reduction, uint32_t faces, Job& job) {
  checkRequest(reduction.mesh, reduction.guidance, reduction.options);
  checkBelongs(reduction.mesh, reduction.history);
  job.begin(Phase::Simplify);
  return withPolicy(reduction.options.method, [&]<class Policy> {
    Moment<Policy> moment(reduction, job);
    moment.replay(reduction.history, collapsesFor(reduction.history, faces));
    moment.priceAll();
    return moment.explainAll();
  });
}

}  // namespace limber
