#include "simplify/simplify.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "base/parallel.h"
#include "simplify/collapse_mesh.h"
#include "simplify/cost.h"
#include "simplify/edge_heap.h"
#include "simplify/legality.h"

namespace limber {
namespace {

constexpr size_t kEdgesPerRange = 2048;
constexpr uint32_t kCollapsesPerReport = 512;

void checkGuidance(const TriangleMesh& mesh, const Guidance& guidance) {
  const auto checkSize = [](size_t found, size_t expected, const char* field, const char* item) {
    if (found != 0 && found != expected)
      throw std::invalid_argument(std::string("The ") + field + " that guides the simplification has " +
                                  std::to_string(found) + " values, but the mesh has " +
                                  std::to_string(expected) + " " + item + ": compute it for this mesh.");
  };
  checkSize(guidance.strain.size(), mesh.triangleCount(), "strain", "triangles");
  checkSize(guidance.curvature.size(), mesh.vertexCount(), "curvature", "vertices");
}

void checkWeights(const SimplifyOptions& options) {
  for (double weight : {options.strainWeight, options.curvatureWeight, options.qualityWeight})
    if (!(weight >= 0) || !std::isfinite(weight))
      throw std::invalid_argument("The weights of strain, curvature and quality must be numbers >= 0.");
}

// The collapse loop (Algorithm 2), from the input down to the floor.
class Simplification {
 public:
  Simplification(const TriangleMesh& input, const Guidance& guidance, const SimplifyOptions& options,
                 Job& job)
      : mesh_(input),
        costs_(input, mesh_, guidance, options),
        legality_(mesh_),
        heap_(mesh_.edgeCount()),
        hasRefused_(mesh_.vertexCount(), 0),
        revaluedAt_(costs_.dependsOnSurroundings() ? mesh_.edgeCount() : 0, kNone),
        stopFaces_(options.stopFaces),
        job_(job) {
    history_.vertexCount = input.vertexCount();
    history_.triangleCount = input.triangleCount();
    for (auto* list : {&history_.kept, &history_.removed, &history_.trianglesAfter})
      list->reserve(input.vertexCount());
    history_.positions.reserve(3 * size_t{input.vertexCount()});
  }

  History run() {
    queueAll();
    do collapseAll();
    while (!isDone() && queueWhatIsLegal());
    return std::move(history_);
  }

 private:
  bool isDone() const { return mesh_.triangleCount() <= stopFaces_; }
  void queueAll();
  // Not to be inlined where there is something to destroy: with Emscripten's exceptions every call from there
  // takes a way through JavaScript.
  [[gnu::noinline]] void collapseAll();
  void tryCheapest();
  bool queueWhatIsLegal();
  Collapse planned(uint32_t edge) const;
  void carryOut(const Collapse& step);
  void record(const Collapse& step);
  void updateCosts(uint32_t kept);
  void collectSurroundings(uint32_t neighbour);
  void collectRefused(uint32_t neighbour);
  void queueEdges();

  CollapseMesh mesh_;
  CostModel costs_;
  Legality legality_;
  EdgeHeap heap_;
  std::vector<uint8_t> hasRefused_;   // per vertex: an edge of it may have been refused since the last retry
  std::vector<uint32_t> revaluedAt_;  // per edge: the collapse after which it got its last cost
  uint32_t stopFaces_;
  std::vector<uint32_t> edges_;  // scratch: edges to price, and their costs
  std::vector<double> edgeCosts_;
  Job& job_;
  History history_;
};

void Simplification::queueAll() {
  edges_.clear();
  for (uint32_t edge = 0; edge < mesh_.edgeCount(); ++edge)
    if (legality_.forever(edge) == Verdict::Legal) edges_.push_back(edge);
  edgeCosts_.resize(edges_.size());
  parallelFor(edges_.size(), kEdgesPerRange, [&](size_t begin, size_t end) {
    job_.check();
    costs_.evaluate(std::span(edges_).subspan(begin, end - begin),
                    std::span(edgeCosts_).subspan(begin, end - begin));
  });
  for (size_t i = 0; i < edges_.size(); ++i) heap_.append(edges_[i], edgeCosts_[i]);
  heap_.build();
}

void Simplification::collapseAll() {
  while (!heap_.empty() && !isDone()) tryCheapest();
}

void Simplification::tryCheapest() {
  const Collapse step = planned(heap_.pop());
  if (legality_.check(step) == Verdict::Legal)
    carryOut(step);
  else
    hasRefused_[step.kept] = hasRefused_[step.removed] = 1;
}

// Of the two ends the one on a border stays, else the one nearer to the target, else the lower one.
Collapse Simplification::planned(uint32_t edge) const {
  const auto [a, b] = mesh_.edge(edge);
  const Vec3 target = costs_.place(edge).target;
  const double toA = squaredLength(target - mesh_.position(a)),
               toB = squaredLength(target - mesh_.position(b));
  const bool keepsA = toA != toB ? toA < toB : a < b;
  return keepsA ? Collapse{edge, a, b, target} : Collapse{edge, b, a, target};
}

void Simplification::carryOut(const Collapse& step) {
  costs_.collapse(step);
  for (const uint32_t gone : mesh_.collapse(step))
    if (gone != kNone) heap_.remove(gone);
  hasRefused_[step.kept] |= hasRefused_[step.removed];
  record(step);
  updateCosts(step.kept);
}

void Simplification::record(const Collapse& step) {
  history_.kept.push_back(step.kept);
  history_.removed.push_back(step.removed);
  for (const float coordinate : mesh_.inFile(step.target)) history_.positions.push_back(coordinate);
  history_.trianglesAfter.push_back(mesh_.triangleCount());
  if (history_.collapseCount() % kCollapsesPerReport == 0)
    job_.report(1 - static_cast<double>(mesh_.triangleCount()) / history_.triangleCount);
}

// The edges of the kept vertex have new costs. Those of its neighbours have new surroundings: some methods
// price these, and for all of them a collapse that was refused may have become legal.
void Simplification::updateCosts(uint32_t kept) {
  edges_.clear();
  mesh_.forEachEdge(kept, [&](uint32_t edge, uint32_t) {
    if (legality_.forever(edge) == Verdict::Legal) edges_.push_back(edge);
    if (costs_.dependsOnSurroundings()) revaluedAt_[edge] = history_.collapseCount();
  });
  hasRefused_[kept] = 0;
  edgeCosts_.resize(edges_.size());
  costs_.evaluate(edges_, edgeCosts_);
  queueEdges();

  edges_.clear();
  mesh_.forEachEdge(kept, [&](uint32_t, uint32_t neighbour) {
    if (mesh_.freedom(neighbour) == Freedom::Locked) return;
    if (costs_.dependsOnSurroundings())
      collectSurroundings(neighbour);
    else if (hasRefused_[neighbour])
      collectRefused(neighbour);
    hasRefused_[neighbour] = 0;
  });
  if (edges_.empty()) return;
  edgeCosts_.resize(edges_.size());
  costs_.revalue(edges_, edgeCosts_);
  queueEdges();
}

void Simplification::queueEdges() {
  for (size_t i = 0; i < edges_.size(); ++i) heap_.set(edges_[i], edgeCosts_[i]);
}

void Simplification::collectSurroundings(uint32_t neighbour) {
  mesh_.forEachEdge(neighbour, [&](uint32_t edge, uint32_t) {
    if (revaluedAt_[edge] == history_.collapseCount()) return;
    revaluedAt_[edge] = history_.collapseCount();
    if (legality_.forever(edge) == Verdict::Legal) edges_.push_back(edge);
  });
}

// An edge between two such neighbours is collected twice, which does no harm.
void Simplification::collectRefused(uint32_t neighbour) {
  mesh_.forEachEdge(neighbour, [&](uint32_t edge, uint32_t) {
    if (!heap_.contains(edge) && legality_.forever(edge) == Verdict::Legal) edges_.push_back(edge);
  });
}

// Asks every edge that is left, so that the floor is one by its definition; counts the refusals. Returns
// whether there is anything to do.
bool Simplification::queueWhatIsLegal() {
  history_.refused = {};
  edges_.clear();
  for (uint32_t edge = 0; edge < mesh_.edgeCount(); ++edge) {
    if (mesh_.trianglesOnEdge(edge) == 0) continue;
    if (edge % kEdgesPerRange == 0) job_.check();
    const Verdict forever = legality_.forever(edge);
    const Verdict verdict = forever == Verdict::Legal ? legality_.check(planned(edge)) : forever;
    history_.refused.lock += verdict == Verdict::Locked;
    history_.refused.topology += verdict == Verdict::Topology;
    history_.refused.flip += verdict == Verdict::Flip;
    if (verdict == Verdict::Legal) edges_.push_back(edge);
  }
  edgeCosts_.resize(edges_.size());
  costs_.evaluate(edges_, edgeCosts_);
  queueEdges();
  return !heap_.empty();
}

}  // namespace

History simplify(const TriangleMesh& mesh, const Guidance& guidance, const SimplifyOptions& options,
                 Job& job) {
  checkGuidance(mesh, guidance);
  checkWeights(options);
  job.begin(Phase::Simplify);
  History history = Simplification(mesh, guidance, options, job).run();
  job.report(1);
  return history;
}

}  // namespace limber
