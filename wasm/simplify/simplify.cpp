#include "simplify/simplify.h"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "base/parallel.h"
#include "simplify/collapse_mesh.h"
#include "simplify/cost.h"
#include "simplify/deviation_limit.h"
#include "simplify/edge_queue.h"
#include "simplify/legality.h"
#include "simplify/mirror.h"

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

void checkNumbers(const SimplifyOptions& options) {
  for (double weight :
       {options.strainWeight, options.curvatureWeight, options.qualityWeight, options.sizeWeight})
    if (!(weight >= 0) || !std::isfinite(weight))
      throw std::invalid_argument("The weights of strain, curvature, quality and size must be numbers >= 0.");
  if (!(options.maxDeviation >= 0) || !(options.minAngle >= 0 && options.minAngle < 60))
    throw std::invalid_argument(
        "The largest deviation must be >= 0, the smallest angle between 0 and 60 degrees.");
}

// The collapse loop (Algorithm 2), from the input down to the floor.
class Simplification {
 public:
  Simplification(const TriangleMesh& input, const Guidance& guidance, const SimplifyOptions& options,
                 Job& job)
      : mesh_(input, options.constraints),
        costs_(input, mesh_, guidance, options),
        legality_(mesh_, options),
        queue_(mesh_.edgeCount()),
        places_(mesh_.edgeCount(), Place::None),
        stopFaces_(options.stopFaces),
        job_(job) {
    if (options.maxDeviation > 0) deviation_.emplace(input, mesh_, options.maxDeviation);
    if (!options.constraints.mirror.empty()) mirror_.emplace(input, mesh_, options.constraints.mirror);
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
    if (isDone()) history_.refused = {};
    history_.stop = stopReason();
    return std::move(history_);
  }

 private:
  // Where an edge waits.
  enum class Place : uint8_t { None, ByBound, ByCost };

  bool isDone() const { return mesh_.triangleCount() <= stopFaces_; }
  void queueAll();
  // Not to be inlined where there is something to destroy: with Emscripten's exceptions every call from there
  // takes a way through JavaScript.
  [[gnu::noinline]] void collapseAll();
  void tryCheapest();
  bool findFirst();
  bool goesBack(uint32_t edge);
  bool queueWhatIsLegal();
  Collapse planned(uint32_t edge, const Vec3& target) const;
  Verdict judge(const Collapse& step);
  Verdict judgeAlone(const Collapse& step);
  void carryOutWithImage(const Collapse& step);
  StopReason stopReason() const;
  void carryOut(const Collapse& step);
  void record(const Collapse& step);
  void updateCosts(uint32_t kept);
  void queueNeighbourhood(uint32_t neighbour);
  void queueRefused(uint32_t neighbour);
  void queueByBounds(std::span<const uint32_t> edges);
  void queueByBound(uint32_t edge);

  CollapseMesh mesh_;
  CostModel costs_;
  Legality legality_;
  std::optional<DeviationLimit> deviation_;
  std::optional<Mirror> mirror_;
  EdgeQueue queue_;
  std::vector<Place> places_;  // per edge
  uint32_t stopFaces_;
  std::vector<uint32_t> edges_, neighbours_;  // scratch
  Job& job_;
  History history_;
};

void Simplification::queueAll() {
  edges_.clear();
  for (uint32_t edge = 0; edge < mesh_.edgeCount(); ++edge)
    if (legality_.forever(edge) == Verdict::Legal) edges_.push_back(edge);
  parallelFor(edges_.size(), kEdgesPerRange, [&](size_t begin, size_t end) {
    job_.check();
    costs_.setBounds(std::span(edges_).subspan(begin, end - begin));
  });
  queueByBounds(edges_);
}

void Simplification::collapseAll() {
  while (!isDone() && findFirst()) tryCheapest();
}

bool Simplification::findFirst() {
  return queue_.findFirst([&](std::span<const uint32_t> edges) {
    costs_.raiseBounds(edges);
    for (const uint32_t edge : edges) queueByBound(edge);
  });
}

// An edge comes up by its bound first and goes back by its cost, unless that is the lowest anyway. So the
// order is that of the costs, though most of them are never computed.
void Simplification::tryCheapest() {
  const uint32_t edge = queue_.pop();
  if (!costs_.boundsAreCosts() && places_[edge] == Place::ByBound && goesBack(edge)) return;
  places_[edge] = Place::None;
  const Collapse step = planned(edge, costs_.target(edge));
  if (judge(step) == Verdict::Legal)
    carryOutWithImage(step);
  else
    for (const uint32_t v : {step.kept, step.removed}) mesh_.setMarked(v, true);
}

// Whether another edge comes before `edge`, which has just been popped by a bound; then queues it again.
bool Simplification::goesBack(uint32_t edge) {
  const double cost = costs_.cost(edge);
  if (!findFirst() || queue_.wouldBeFirst(edge, cost / costs_.tolerance())) return false;
  queue_.set(edge, cost);
  places_[edge] = costs_.followsNeighbourhood() ? Place::ByCost : Place::ByBound;
  return true;
}

Collapse Simplification::planned(uint32_t edge, const Vec3& target) const {
  const Collapse step = mesh_.collapseOf(edge, target);
  return mirror_ && mirror_->isItsOwnImage(step) ? mirror_->onPlane(step) : step;
}

// With a mirror the image has to be legal too.
Verdict Simplification::judge(const Collapse& step) {
  if (mirror_ && !mirror_->isItsOwnImage(step)) {
    if (!mirror_->isApart(step)) return Verdict::Locked;
    const Collapse image = mirror_->imageOf(step);
    if (image.edge == kNone) return Verdict::Locked;
    if (const Verdict verdict = judgeAlone(image); verdict != Verdict::Legal) return verdict;
  }
  return judgeAlone(step);
}

Verdict Simplification::judgeAlone(const Collapse& step) {
  if (deviation_) job_.check();  // which may take a millisecond a step
  const Verdict verdict = legality_.check(step);
  const bool goesTooFar = verdict == Verdict::Legal && deviation_ && !deviation_->allows(step);
  return goesTooFar ? Verdict::Deviation : verdict;
}

StopReason Simplification::stopReason() const {
  const auto [topology, flip, lock, angle, deviation] = history_.refused;
  if (isDone()) return StopReason::Target;
  if (angle + deviation == 0) return StopReason::Exhausted;
  return deviation >= angle ? StopReason::Deviation : StopReason::Angle;
}

void Simplification::carryOutWithImage(const Collapse& step) {
  if (!mirror_ || mirror_->isItsOwnImage(step)) return carryOut(step);
  const Collapse image = mirror_->imageOf(step);
  carryOut(step);
  queue_.remove(image.edge);
  places_[image.edge] = Place::None;
  if (deviation_) deviation_->allows(image);  // prepares what the collapse hands over
  carryOut(image);
}

void Simplification::carryOut(const Collapse& step) {
  costs_.collapse(step);
  if (deviation_) deviation_->collapse();
  for (const uint32_t gone : mesh_.collapse(step))
    if (gone != kNone) queue_.remove(gone);
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
  neighbours_.clear();
  mesh_.forEachEdge(kept, [&](uint32_t edge, uint32_t neighbour) {
    if (legality_.forever(edge) == Verdict::Legal) {
      if (!costs_.followsNeighbourhood() && queue_.isWaiting(edge))
        queue_.doubt(edge, costs_.guess(edge, queue_.cost(edge)));
      else
        edges_.push_back(edge);
    }
    if (costs_.followsNeighbourhood() || mesh_.isMarked(neighbour)) neighbours_.push_back(neighbour);
  });
  mesh_.setMarked(kept, false);
  costs_.setBounds(edges_);
  queueByBounds(edges_);
  for (const uint32_t neighbour : neighbours_) {
    if (mesh_.role(neighbour).freedom == Freedom::Locked) continue;
    if (costs_.followsNeighbourhood())
      queueNeighbourhood(neighbour);
    else
      queueRefused(neighbour);
    mesh_.setMarked(neighbour, false);
  }
}

// Those that `setBounds` has just priced.
void Simplification::queueByBounds(std::span<const uint32_t> edges) {
  for (const uint32_t edge : edges) {
    queueByBound(edge);
    if (costs_.tolerance() != 1) queue_.doubt(edge, costs_.bound(edge));
  }
}

void Simplification::queueByBound(uint32_t edge) {
  places_[edge] = Place::ByBound;
  queue_.set(edge, costs_.bound(edge));
}

void Simplification::queueNeighbourhood(uint32_t neighbour) {
  mesh_.forEachEdge(neighbour, [&](uint32_t edge, uint32_t) {
    const Place place = places_[edge];
    if (place == Place::ByBound) return;
    if (place == Place::ByCost || legality_.forever(edge) == Verdict::Legal) queueByBound(edge);
  });
}

void Simplification::queueRefused(uint32_t neighbour) {
  mesh_.forEachEdge(neighbour, [&](uint32_t edge, uint32_t) {
    if (places_[edge] == Place::None && legality_.forever(edge) == Verdict::Legal) queueByBound(edge);
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
    const Verdict verdict =
        forever == Verdict::Legal ? judge(planned(edge, costs_.place(edge).target)) : forever;
    history_.refused.lock += verdict == Verdict::Locked;
    history_.refused.topology += verdict == Verdict::Topology;
    history_.refused.flip += verdict == Verdict::Flip;
    history_.refused.angle += verdict == Verdict::Angle;
    history_.refused.deviation += verdict == Verdict::Deviation;
    if (verdict == Verdict::Legal) edges_.push_back(edge);
  }
  costs_.setBounds(edges_);
  queueByBounds(edges_);
  return !edges_.empty();
}

}  // namespace

void checkRequest(const TriangleMesh& mesh, const Guidance& guidance, const SimplifyOptions& options) {
  checkGuidance(mesh, guidance);
  checkNumbers(options);
  checkConstraints(mesh, options.constraints);
}

History simplify(const TriangleMesh& mesh, const Guidance& guidance, const SimplifyOptions& options,
                 Job& job) {
  checkRequest(mesh, guidance, options);
  job.begin(Phase::Simplify);
  History history = Simplification(mesh, guidance, options, job).run();
  job.report(1);
  return history;
}

}  // namespace limber
