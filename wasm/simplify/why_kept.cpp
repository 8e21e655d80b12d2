#include "simplify/why_kept.h"

#include <utility>

namespace limber {
namespace {

constexpr uint32_t kStepsPerReport = 512;

// A mesh and its costs at one moment of a history.
class Moment {
 public:
  Moment(const TriangleMesh& input, const Guidance& guidance, const SimplifyOptions& options)
      : mesh_(input, options.constraints),
        costs_(input, mesh_, guidance, options),
        legality_(mesh_, options) {}

  void replay(const History& history, uint32_t count, Job& job);
  void priceAll();
  std::vector<WhyKept> explainAll(Job& job);

 private:
  uint32_t edgeBetween(uint32_t a, uint32_t b) const;
  WhyKept explain(uint32_t v);

  CollapseMesh mesh_;
  CostModel costs_;
  Legality legality_;
};

uint32_t Moment::edgeBetween(uint32_t a, uint32_t b) const {
  uint32_t found = kNone;
  mesh_.forEachEdge(a, [&](uint32_t edge, uint32_t other) {
    if (other == b) found = edge;
  });
  return found;
}

void Moment::replay(const History& history, uint32_t count, Job& job) {
  for (uint32_t i = 0; i < count; ++i) {
    const float* p = &history.positions[3 * size_t{i}];
    const Collapse step{edgeBetween(history.kept[i], history.removed[i]), history.kept[i], history.removed[i],
                        mesh_.fromFile({p[0], p[1], p[2]})};
    if (step.edge == kNone) refuseHistory();
    costs_.collapse(step);
    mesh_.collapse(step);
    if (i % kStepsPerReport == 0) job.report(0.5 * i / count);
  }
}

void Moment::priceAll() {
  std::vector<uint32_t> edges;
  for (uint32_t edge = 0; edge < mesh_.edgeCount(); ++edge)
    if (mesh_.trianglesOnEdge(edge) != 0) edges.push_back(edge);
  costs_.setBounds(edges);
}

WhyKept Moment::explain(uint32_t v) {
  WhyKept best;
  if (mesh_.role(v).freedom == Freedom::Locked) return best;
  const auto rank = [](const WhyKept& why) {
    return std::pair(why.verdict != Verdict::Legal, why.terms.total());
  };
  mesh_.forEachEdge(v, [&](uint32_t edge, uint32_t other) {
    const Placement placement = costs_.place(edge);
    WhyKept why{other, costs_.terms(edge, placement),
                legality_.check(mesh_.collapseOf(edge, placement.target))};
    if (best.neighbour == kNone || rank(why) < rank(best)) best = why;
  });
  return best;
}

std::vector<WhyKept> Moment::explainAll(Job& job) {
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
      job.report(0.5 + 0.5 * static_cast<double>(all.size()) / static_cast<double>(vertices.size()));
    all.push_back(explain(v));
    if (all.back().neighbour != kNone) all.back().neighbour = number[all.back().neighbour];
  }
  return all;
}

}  // namespace

std::vector<WhyKept> whyKept(const TriangleMesh& mesh, const Guidance& guidance,
                             const SimplifyOptions& options, const History& history, uint32_t faces,
                             Job& job) {
  checkRequest(mesh, guidance, options);
  checkBelongs(mesh, history);
  job.begin(Phase::Simplify);
  Moment moment(mesh, guidance, options);
  moment.replay(history, collapsesFor(history, faces), job);
  moment.priceAll();
  return moment.explainAll(job);
}

}  // namespace limber
