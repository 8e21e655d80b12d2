#include "simplify/simplify.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "base/parallel.h"
#include "simplify/collapse_mesh.h"
#include "simplify/collapse_rules.h"
#include "simplify/cost/policies.h"
#include "simplify/deviation_estimate.h"
#include "simplify/edge_queue.h"

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
  if (!(options.deferBeyond >= 0) || !std::isfinite(options.deferBeyond))
    throw std::invalid_argument("The deviation beyond which collapses are deferred must be a number >= 0.");
  if (!(options.maxDeviation >= 0) || !(options.minAngle >= 0 && options.minAngle < 60))
    throw std::invalid_argument(
        "The largest deviation must be >= 0, the smallest angle between 0 and 60 degrees.");
}

// The collapse loop (Algorithm 2), from the input down to the floor, with the costs of one method.
template <CostPolicy Policy>
class Simplification {
 public:
  Simplification(const TriangleMesh& input, const Guidance& guidance, const SimplifyOptions& options,
                 Job& job)
      : mesh_(input, options.constraints),
        costs_(input, mesh_, guidance, options),
        rules_(input, mesh_, options, job),
        queue_(mesh_.edgeCount()),
        queuedBy_(mesh_.edgeCount(), QueuedBy::Nothing),
        stopFaces_(options.stopFaces),
        deferBeyond_(options.deferBeyond),
        job_(job) {
    if (options.recordErrors || options.deferBeyond > 0) estimate_.emplace(mesh_);
    if (options.recordErrors) history_.errors.reserve(input.vertexCount());
    recordsErrors_ = options.recordErrors;
    history_.vertexCount = input.vertexCount();
    history_.triangleCount = input.triangleCount();
    for (auto* list : {&history_.kept, &history_.removed, &history_.trianglesAfter})
      list->reserve(input.vertexCount());
    history_.positions.reserve(3 * size_t{input.vertexCount()});
  }

  History run() {
    queueAll();
    for (bool goesOn = true; goesOn;) {
      const uint32_t before = history_.collapseCount();
      collapseAll();
      // After a round without a collapse all further rounds would be the same.
      const bool hasCollapsed = history_.collapseCount() > before;
      goesOn = !isDone() && ((queueLegalEdges() && hasCollapsed) || queueDeferredEdges());
    }
    if (isDone()) history_.refused = {};
    history_.stop = stopReason();
    return std::move(history_);
  }

 private:
  // The number by which an edge is queued.
  enum class QueuedBy : uint8_t { Nothing, Bound, Cost };

  bool isDone() const { return mesh_.triangleCount() <= stopFaces_; }
  bool mayEverCollapse(uint32_t edge) const { return rules_.permanentVerdict(edge) == Verdict::Legal; }

  void queueAll() {
    edges_.clear();
    for (uint32_t edge = 0; edge < mesh_.edgeCount(); ++edge)
      if (mayEverCollapse(edge)) edges_.push_back(edge);
    parallelFor(edges_.size(), kEdgesPerRange, [&](size_t begin, size_t end) {
      job_.check();
      costs_.setBounds(std::span(edges_).subspan(begin, end - begin));
    });
    queueByBounds(edges_);
  }

  // Not inlined, because `run` has local objects with destructors: with Emscripten's exceptions every call
  // from such a function takes a detour through JavaScript.
  [[gnu::noinline]] void collapseAll() {
    while (!isDone() && findFirst()) tryCheapest();
  }

  bool findFirst() {
    return queue_.findFirst([&](std::span<const uint32_t> edges) {
      costs_.raiseBounds(edges);
      for (const uint32_t edge : edges) queueByBound(edge);
    });
  }

  // An edge first comes up by its bound and is queued again by its cost, unless that is the lowest anyway.
  // The order is therefore that of the costs, although most of them are never computed.
  void tryCheapest() {
    const uint32_t edge = queue_.pop();
    if (!costs_.boundsAreCosts() && queuedBy_[edge] == QueuedBy::Bound && isQueuedAgain(edge)) return;
    queuedBy_[edge] = QueuedBy::Nothing;
    const Collapse step = rules_.collapseOf(edge, costs_.target(edge));
    if (rules_.judge(step) == Verdict::Legal && !mustDefer(step))
      carryOutWithImage(step);
    else
      for (const uint32_t v : {step.kept, step.removed}) mesh_.setMarked(v, true);
  }

  // Queues an edge that has just come up by its bound again, if another edge comes before its cost.
  bool isQueuedAgain(uint32_t edge) {
    const double cost = costs_.cost(edge);
    if (!findFirst() || queue_.wouldBeFirst(edge, cost / Policy::kTolerance)) return false;
    queue_.set(edge, cost);
    queuedBy_[edge] = costs_.followsNeighbourhood() ? QueuedBy::Cost : QueuedBy::Bound;
    return true;
  }

  // Whether the collapse is deferred, see SimplifyOptions::deferBeyond. Must only be called for legal
  // collapses.
  bool mustDefer(const Collapse& step) { return deferBeyond_ > 0 && estimate_->of(step) > deferBeyond_; }

  StopReason stopReason() const {
    const auto [topology, flip, lock, angle, deviation] = history_.refused;
    if (isDone()) return StopReason::Target;
    if (angle + deviation == 0) return StopReason::Exhausted;
    return deviation >= angle ? StopReason::Deviation : StopReason::Angle;
  }

  void carryOutWithImage(const Collapse& step) {
    const std::optional<Collapse> image = rules_.imageOf(step);
    carryOut(step);
    if (!image) return;
    queue_.remove(image->edge);
    queuedBy_[image->edge] = QueuedBy::Nothing;
    rules_.prepareImage(*image);
    carryOut(*image);
  }

  void carryOut(const Collapse& step) {
    const double error = estimate_ ? estimate_->collapse(step) : 0;
    costs_.collapse(step);
    rules_.collapse();
    for (const uint32_t gone : mesh_.collapse(step))
      if (gone != kNone) queue_.remove(gone);
    record(step, error);
    updateCosts(step.kept);
  }

  void record(const Collapse& step, double error) {
    if (recordsErrors_) history_.errors.push_back(static_cast<float>(error));
    history_.kept.push_back(step.kept);
    history_.removed.push_back(step.removed);
    for (const float coordinate : mesh_.inFile(step.target)) history_.positions.push_back(coordinate);
    history_.trianglesAfter.push_back(mesh_.triangleCount());
    if (history_.collapseCount() % kCollapsesPerReport == 0)
      job_.report(1 - static_cast<double>(mesh_.triangleCount()) / history_.triangleCount);
  }

  // The edges of the kept vertex have new costs. The edges of its neighbours have a new neighbourhood: for
  // some methods it affects the cost, and for all methods a refused collapse may have become legal.
  void updateCosts(uint32_t kept) {
    edges_.clear();
    neighbours_.clear();
    mesh_.forEachEdge(kept, [&](uint32_t edge, uint32_t neighbour) {
      if (mayEverCollapse(edge)) {
        if (!costs_.followsNeighbourhood() && queue_.isWaiting(edge))
          queue_.markStale(edge, costs_.expectedCost(edge, queue_.cost(edge)));
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

  // Queues edges whose bounds `setBounds` has just set.
  void queueByBounds(std::span<const uint32_t> edges) {
    for (const uint32_t edge : edges) {
      queueByBound(edge);
      if (Policy::kTolerance != 1) queue_.markStale(edge, costs_.bound(edge));
    }
  }

  void queueByBound(uint32_t edge) {
    queuedBy_[edge] = QueuedBy::Bound;
    queue_.set(edge, costs_.bound(edge));
  }

  void queueNeighbourhood(uint32_t neighbour) {
    mesh_.forEachEdge(neighbour, [&](uint32_t edge, uint32_t) {
      if (queuedBy_[edge] == QueuedBy::Bound) return;
      if (queuedBy_[edge] == QueuedBy::Cost || mayEverCollapse(edge)) queueByBound(edge);
    });
  }

  void queueRefused(uint32_t neighbour) {
    mesh_.forEachEdge(neighbour, [&](uint32_t edge, uint32_t) {
      if (queuedBy_[edge] == QueuedBy::Nothing && mayEverCollapse(edge)) queueByBound(edge);
    });
  }

  // Tests every remaining edge, so that the floor has no legal collapse left, as defined: counts the refusals
  // and queues the legal edges that need not be deferred. Returns whether there are any.
  bool queueLegalEdges() {
    history_.refused = {};
    edges_.clear();
    deferred_.clear();
    for (uint32_t edge = 0; edge < mesh_.edgeCount(); ++edge) {
      if (mesh_.trianglesOnEdge(edge) == 0) continue;
      if (edge % kEdgesPerRange == 0) job_.check();
      Verdict verdict = rules_.permanentVerdict(edge);
      if (verdict == Verdict::Legal) {
        const Collapse step = rules_.collapseOf(edge, costs_.optimum(edge).position);
        verdict = rules_.judge(step);
        const double estimate = verdict == Verdict::Legal && deferBeyond_ > 0 ? estimate_->of(step) : 0;
        if (estimate > deferBeyond_) {
          deferred_.push_back({edge, estimate});
          continue;
        }
      }
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

  // Queues the collapses that `queueLegalEdges` has just deferred, up to at least twice the last distance.
  // Returns whether there are any.
  bool queueDeferredEdges() {
    if (deferred_.empty()) return false;
    const auto least = std::ranges::min_element(deferred_, {}, &Deferred::estimate);
    deferBeyond_ = std::max(2 * deferBeyond_, least->estimate);
    edges_.clear();
    for (const auto& [edge, estimate] : deferred_)
      if (estimate <= deferBeyond_) edges_.push_back(edge);
    costs_.setBounds(edges_);
    queueByBounds(edges_);
    return true;
  }

  struct Deferred {
    uint32_t edge;
    double estimate;
  };

  CollapseMesh mesh_;
  Policy costs_;
  CollapseRules rules_;
  EdgeQueue queue_;
  std::vector<QueuedBy> queuedBy_;  // per edge
  std::optional<DeviationEstimate> estimate_;
  uint32_t stopFaces_;
  double deferBeyond_;              // doubles, see SimplifyOptions::deferBeyond
  std::vector<Deferred> deferred_;  // the deferred legal collapses of the last `queueLegalEdges`, ascending
  bool recordsErrors_ = false;
  std::vector<uint32_t> edges_, neighbours_;  // scratch memory
  Job& job_;
  History history_;
};

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
  History history = withPolicy(options.method, [&]<class Policy> {
    return Simplification<Policy>(mesh, guidance, options, job).run();
  });
  job.report(1);
  return history;
}

}  // namespace limber
