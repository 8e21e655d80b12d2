#include "pipeline/modal_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>

#include "base/parallel.h"
#include "modes/factorisation.h"
#include "modes/pins.h"
#include "pipeline/chart_sides.h"
#include "pipeline/delaunay_flips.h"
#include "pipeline/guarded_step.h"
#include "pipeline/modal_target.h"
#include "pipeline/surface_fit.h"

namespace limber {

namespace {

constexpr int kSurfaceRounds = 3, kModalRounds = 30;
constexpr uint32_t kSamplesPerTriangle = 6;
constexpr double kClip = 0.1;          // of a residual, in a step
constexpr uint32_t kFewestFaces = 12;  // smaller components stay as they are
constexpr uint32_t kMostVertices =
    20000;  // as do larger ones, which are off by little and would take minutes

// The root mean square distance may grow to this much of the simplified mesh's, or to this part of the
// diagonal.
constexpr double kBudget = 1.3, kLeastBudget = 2e-4;
// What a residual may be worth, in squared budgets of distance.
constexpr double kLeastWorth = 1, kMostWorth = 1e4;
constexpr int kHalvings = 30;  // of that range
constexpr double kSurfaceHold = 1e-3;
// How firmly vertices hold their places: more where a step gains less than foretold.
constexpr double kFirstHold = 0.01, kLeastHold = 0.003, kMostHold = 1e6;
constexpr double kPoorGain = 0.3, kGoodGain = 0.7, kFirmer = 3, kLooser = 2;
constexpr double kLost = 1.5;  // a mesh with this much of the best merit is given up

// A component of the original and what has become of it, in the frame where the original's diagonal is 1.
struct FitPart {
  TriangleMesh original, simplified;
  std::vector<uint32_t> vertexOfResult;    // per vertex of `simplified`
  std::vector<uint32_t> triangleOfResult;  // per triangle of it
  std::vector<uint8_t> locked;             // per vertex of it
  EdgeList originalLines, lines;           // seams, of both meshes
  Vec3 origin;
  double diagonal = 1;
};

// The triangles of a mesh that belong to one component; `vertexOf` and `triangleOf` say where they come from.
TriangleMesh extract(const TriangleMesh& mesh, const std::vector<uint32_t>& componentOfVertex,
                     uint32_t component, std::vector<uint32_t>& vertexOf, std::vector<uint32_t>& triangleOf) {
  TriangleMesh part;
  std::vector<uint32_t> number(mesh.vertexCount(), kNone);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    if (componentOfVertex[v] != component) continue;
    number[v] = part.vertexCount();
    vertexOf.push_back(v);
    part.positions.push_back(mesh.positions[v]);
  }
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    if (componentOfVertex[a] != component) continue;
    triangleOf.push_back(t);
    part.triangles.push_back({number[a], number[b], number[c]});
  }
  return part;
}

void intoFrame(TriangleMesh& mesh, const FitPart& part) {
  for (Vec3& p : mesh.positions) p = (p - part.origin) / part.diagonal;
}

// Which corner of the input, by chart, a corner of the result belongs to; an edge is a seam where its two
// triangles disagree.
EdgeList seamsOf(const MeshAt& simplified, const ChartSides& sides) {
  const TriangleMesh& mesh = simplified.mesh;
  const Topology topology = buildTopology(mesh);
  const auto sideAt = [&](uint32_t t, uint32_t v) {
    return sides.sideOf(3 * simplified.inputOfTriangle[t] + cornerAt(mesh, t, v) % 3);
  };
  EdgeList seams;
  for (const Topology::Edge& edge : topology.edges) {
    const auto around = topology.trianglesAt(edge);
    if (around.size() == 2 && (sideAt(around[0], edge.a) != sideAt(around[1], edge.a) ||
                               sideAt(around[0], edge.b) != sideAt(around[1], edge.b)))
      seams.push_back({edge.a, edge.b});
  }
  return seams;
}

EdgeList seamsOf(const Topology& topology, const ChartSides& sides) {
  EdgeList seams;
  for (uint32_t e = 0; e < topology.edges.size(); ++e)
    if (sides.isSeam(e) && topology.edges[e].useCount == 2)
      seams.push_back({topology.edges[e].a, topology.edges[e].b});
  return seams;
}

// Those edges of a list that lie in a part, by its own numbers.
EdgeList within(const EdgeList& edges, const std::vector<uint32_t>& vertexOf, uint32_t vertexCount) {
  std::vector<uint32_t> number(vertexCount, kNone);
  for (uint32_t v = 0; v < vertexOf.size(); ++v) number[vertexOf[v]] = v;
  EdgeList inside;
  for (const auto& [a, b] : edges)
    if (number[a] != kNone && number[b] != kNone) inside.push_back({number[a], number[b]});
  return inside;
}

std::vector<FitPart> partsOf(const TriangleMesh& original, const MeshAt& simplified,
                             const ModalFitOptions& options) {
  const Topology topology = buildTopology(original);
  const TriangleMesh& mesh = simplified.mesh;
  const ChartSides sides(original, topology, options.charts, simplified);
  const EdgeList originalLines = seamsOf(topology, sides), lines = seamsOf(simplified, sides);
  std::vector<uint32_t> componentOfResult(mesh.vertexCount());
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    componentOfResult[v] = topology.componentOfVertex[simplified.inputOfVertex[v]];
  std::vector<uint8_t> isLocked(mesh.vertexCount(), 0);
  for (uint32_t v = 0; v < options.locked.size(); ++v)
    if (options.locked[v] && simplified.vertexOfInput[v] != kNone) isLocked[simplified.vertexOfInput[v]] = 1;
  std::vector<FitPart> parts;
  for (uint32_t component = 0; component < topology.componentCount; ++component) {
    FitPart part;
    std::vector<uint32_t> vertexOfInput, triangleOfInput;
    part.original = extract(original, topology.componentOfVertex, component, vertexOfInput, triangleOfInput);
    part.simplified = extract(mesh, componentOfResult, component, part.vertexOfResult, part.triangleOfResult);
    if (part.simplified.triangleCount() < kFewestFaces || part.simplified.vertexCount() > kMostVertices)
      continue;
    const Bounds box = bounds(part.original);
    part.origin = box.low;
    part.diagonal = box.diagonal();
    intoFrame(part.original, part);
    intoFrame(part.simplified, part);
    part.originalLines = within(originalLines, vertexOfInput, original.vertexCount());
    part.lines = within(lines, part.vertexOfResult, mesh.vertexCount());
    for (uint32_t v : part.vertexOfResult) part.locked.push_back(isLocked[v]);
    parts.push_back(std::move(part));
  }
  return parts;
}

// A and the places of its numbers, which stay while vertices move.
class FitSolver {
 public:
  FitSolver(const std::vector<uint8_t>& locked, Job& job) : job_(job) {
    for (uint32_t v = 0; v <= locked.size(); ++v) model_.firstUnknown.push_back(3 * v);
    for (uint32_t v = 0; v < locked.size(); ++v)
      if (locked[v]) held_.insert(held_.end(), {3 * v, 3 * v + 1, 3 * v + 2});
  }

  // (A + hold * inertia)^-1 of each column; locked vertices stay.
  Eigen::MatrixXd solve(const SurfaceFit& fit, double hold, Eigen::MatrixXd columns) {
    model_.stiffness = fit.stiffness;
    model_.mass = fit.inertia;
    if (!held_.empty()) holdUnknowns(model_, held_);
    if (!structure_) structure_ = std::make_shared<const FactorStructure>(factorStructure(model_, job_));
    for (uint32_t row : held_) columns.row(row).setZero();
    Factorisation factorisation(model_, structure_);
    factorisation.factorise(-hold, job_);
    factorisation.solve(columns, job_);
    return columns;
  }

 private:
  Job& job_;
  StiffnessModel model_;
  std::vector<uint32_t> held_;
  std::shared_ptr<const FactorStructure> structure_;
};

// Edges flipped to Delaunay, vertices fitted to the surface.
uint32_t fitToSurface(FitPart& part, const FitSamples& samples, std::vector<uint32_t>& corners, Job& job) {
  uint32_t flips = 0;
  for (int round = 0; round < kSurfaceRounds; ++round) {
    flips += flipToDelaunay(part.simplified, part.lines, corners);
    const Topology topology = buildTopology(part.simplified);
    const SurfaceFit fit = fitSurface(part.simplified, topology, samples, {.lines = &part.lines});
    const Eigen::VectorXd step = FitSolver(part.locked, job).solve(fit, kSurfaceHold, fit.pull);
    part.simplified = GuardedStep(part.simplified, topology).apply(part.simplified, step);
  }
  return flips;
}

// Minima of dx^T A dx - 2 g^T dx + worth |r + J dx|^2 for any worth, by Woodbury: J has few rows. With s =
// A^-1 g, X = A^-1 J^T, G = J X and y = (1 / worth + G)^-1 (r + J s), dx = s - X y, and the first two terms
// are y^T G y - g^T s.
class TradeOff {
 public:
  // `solved`: A^-1 times the pull and the slopes.
  TradeOff(const SurfaceFit& fit, const Mismatch& mismatch, Eigen::MatrixXd solved)
      : solved_(std::move(solved)),
        gain_(fit.pull.dot(solved_.col(0))),
        gram_(mismatch.slope.transpose() * solved_.rightCols(mismatch.slope.cols())) {
    target_ = gram_.eigenvectors().transpose() * (mismatch.residual.cwiseMax(-kClip).cwiseMin(kClip) +
                                                  mismatch.slope.transpose() * solved_.col(0));
  }

  Eigen::VectorXd step(double worth) const {
    return solved_.col(0) - solved_.rightCols(target_.size()) * (gram_.eigenvectors() * multipliers(worth));
  }

  // How much the surface's squared distance, over the area, would grow.
  double growth(double worth) const {
    return multipliers(worth).cwiseAbs2().dot(gram_.eigenvalues()) - gain_;
  }

 private:
  Eigen::VectorXd multipliers(double worth) const {
    return target_.array() / (1 / worth + gram_.eigenvalues().array().max(0));
  }

  Eigen::MatrixXd solved_;
  double gain_;
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> gram_;
  Eigen::VectorXd target_;
};

Eigen::VectorXd difference(const TriangleMesh& after, const TriangleMesh& before) {
  Eigen::VectorXd moved(3 * static_cast<Eigen::Index>(after.vertexCount()));
  for (uint32_t v = 0; v < after.vertexCount(); ++v)
    for (int axis = 0; axis < 3; ++axis)
      moved[3 * static_cast<Eigen::Index>(v) + axis] = after.positions[v][axis] - before.positions[v][axis];
  return moved;
}

// Gauss-Newton rounds towards the original's modes within a budget of distance from its surface.
class ModalSearch {
 public:
  ModalSearch(const FitPart& part, const FitSamples& samples, ModalTarget& target, double budget, Job& job)
      : part_(part),
        samples_(samples),
        target_(target),
        budget_(budget),
        job_(job),
        topology_(buildTopology(part.simplified)),
        guard_(part.simplified, topology_),
        solver_(part.locked, job) {
    state_.mesh = part.simplified;
    measure();
  }

  // The best mesh of all rounds: the least mismatch, where distances beyond the budget count against it.
  TriangleMesh run(int rounds, const std::function<void(double)>& report) {
    before_ = state_.mismatch.meanSquare();
    best_ = state_;
    for (int round = 0; round < rounds && state_.mismatch.residual.size() > 0; ++round) {
      report(static_cast<double>(round) / rounds);
      step();
      if (getenv("LOG"))
        printf("      round %d rms %.4f %% dist %.3f merit %.4f hold %.3g\n", round,
               50 * std::sqrt(state_.mismatch.meanSquare()), std::sqrt(state_.fit.meanSquare) / budget_,
               50 * std::sqrt(merit(state_)), hold_);
      if (merit(state_) < merit(best_))
        best_ = state_;
      else if (isLost())
        goBack();
    }
    return best_.mesh;
  }

  double meanSquareBefore() const { return before_; }
  double meanSquareAfter() const { return best_.mismatch.meanSquare(); }

 private:
  struct State {
    TriangleMesh mesh;
    Mismatch mismatch;
    SurfaceFit fit;
  };

  void measure() {
    target_.bind(state_.mesh);
    std::vector<Mismatch> parts(ModalTarget::kThicknesses);
    parallelFor(parts.size() + 1, 1, [&](size_t k, size_t) {
      if (k < parts.size())
        parts[k] = target_.compare(state_.mesh, k, job_);
      else
        state_.fit = fitSurface(state_.mesh, topology_, samples_, {.evenness = 0, .lines = &part_.lines});
    });
    state_.mismatch = join(parts);
  }

  Eigen::VectorXd gaussNewtonStep() {
    const auto& [mesh, mismatch, fit] = state_;
    Eigen::MatrixXd columns(fit.pull.size(), 1 + mismatch.slope.cols());
    columns << fit.pull, mismatch.slope;
    const TradeOff tradeOff(fit, mismatch, solver_.solve(fit, hold_, std::move(columns)));
    return tradeOff.step(affordable(tradeOff));
  }

  // The worth of residuals that uses up what is left of the budget.
  double affordable(const TradeOff& tradeOff) const {
    const double left = (budget_ * budget_ - state_.fit.meanSquare) * state_.fit.area;
    const double unit = state_.fit.area * budget_ * budget_;
    double low = kLeastWorth * unit, high = kMostWorth * unit;
    if (tradeOff.growth(high) <= left) return high;
    for (int halving = 0; halving < kHalvings; ++halving) {
      const double middle = std::sqrt(low * high);
      (tradeOff.growth(middle) <= left ? low : high) = middle;
    }
    return low;
  }

  void step() {
    const Mismatch was = state_.mismatch;
    TriangleMesh next = guard_.apply(state_.mesh, gaussNewtonStep());
    const Eigen::VectorXd foretold = was.residual + was.slope.transpose() * difference(next, state_.mesh);
    state_.mesh = std::move(next);
    measure();
    const double gain = was.residual.squaredNorm() - state_.mismatch.residual.squaredNorm();
    const double hoped = was.residual.squaredNorm() - foretold.squaredNorm();
    if (gain < kPoorGain * hoped)
      hold_ = std::min(kMostHold, kFirmer * hold_);
    else if (gain > kGoodGain * hoped)
      hold_ = std::max(kLeastHold, hold_ / kLooser);
  }

  // Whether the last step has spoilt it, and not just the search for modes, which may have lost one on the
  // way.
  bool isLost() {
    if (merit(state_) <= kLost * merit(best_)) return false;
    target_.forget();
    measure();
    return merit(state_) > kLost * merit(best_);
  }

  // Needles bend the residuals too much for a linear step: from the best mesh again, with a firmer hold.
  void goBack() {
    state_ = best_;
    target_.forget();
    hold_ = std::min(kMostHold, kFirmer * kFirmer * hold_);
  }

  double merit(const State& state) const {
    const double excess = std::max(1.0, state.fit.meanSquare / (budget_ * budget_));
    return state.mismatch.meanSquare() * excess * excess;
  }

  const FitPart& part_;
  const FitSamples& samples_;
  ModalTarget& target_;
  double budget_;
  Job& job_;
  Topology topology_;
  GuardedStep guard_;
  State state_, best_;
  FitSolver solver_;
  double hold_ = getenv("HOLD") ? atof(getenv("HOLD")) : kFirstHold, before_ = 0;
};

void putBack(const FitPart& part, const std::vector<uint32_t>& corners, MeshAt& result) {
  for (uint32_t v = 0; v < part.vertexOfResult.size(); ++v) {
    if (part.locked[v]) continue;
    const Vec3 p = part.origin + part.diagonal * part.simplified.positions[v];
    result.mesh.positions[part.vertexOfResult[v]] = {static_cast<float>(p.x), static_cast<float>(p.y),
                                                     static_cast<float>(p.z)};
  }
  for (uint32_t t = 0; t < part.triangleOfResult.size(); ++t)
    for (uint32_t c = 0; c < 3; ++c) {
      const uint32_t there = part.triangleOfResult[t], corner = corners[3 * t + c];
      result.mesh.triangles[there][c] = part.vertexOfResult[part.simplified.triangles[t][c]];
      result.flips.corners[3 * there + c] = 3 * part.triangleOfResult[corner / 3] + corner % 3;
    }
}

// What stays the same for all parts; `report` takes the fraction of this part that is done.
struct FitCall {
  const ModalFitOptions& options;
  std::function<void(double)> report;
  Job& job;
};

constexpr double kTargetShare = 0.3;  // of the time, until the original's modes are there

void fitPart(FitPart& part, const FitCall& call, ModalFitResult& fitted) {
  const FitSamples samples =
      sampleForFit(part.original, kSamplesPerTriangle * part.simplified.triangleCount(), part.originalLines);
  const SurfaceFit start =
      fitSurface(part.simplified, buildTopology(part.simplified), samples, {.lines = &part.lines});
  std::vector<uint32_t> corners(3 * size_t{part.simplified.triangleCount()});
  std::iota(corners.begin(), corners.end(), 0u);
  fitted.flips += fitToSurface(part, samples, corners, call.job);
  const ShellMaterial material{call.options.thickness / part.diagonal, call.options.poisson};
  ModalTarget target(part.original, part.simplified, {material, call.options.modeCount}, call.job);
  call.report(kTargetShare);
  if (!target.empty()) {
    const double budget = std::max(kBudget * std::sqrt(start.meanSquare), kLeastBudget);
    ModalSearch search(part, samples, target, budget, call.job);
    part.simplified = search.run(
        kModalRounds, [&](double fraction) { call.report(kTargetShare + (1 - kTargetShare) * fraction); });
    fitted.errorBefore.push_back(50 * std::sqrt(search.meanSquareBefore()));
    fitted.errorAfter.push_back(50 * std::sqrt(search.meanSquareAfter()));
  }
  putBack(part, corners, fitted.result);
}

}  // namespace

ModalFitResult fitModes(const TriangleMesh& original, const MeshAt& simplified,
                        const ModalFitOptions& options, Job& job) {
  WholePhase phase(job, Phase::Fit);
  ModalFitResult fitted{simplified, {}, {}, 0};
  fitted.result.flips.triangles = simplified.mesh.triangles;
  fitted.result.flips.corners.resize(3 * size_t{simplified.mesh.triangleCount()});
  std::iota(fitted.result.flips.corners.begin(), fitted.result.flips.corners.end(), 0u);
  if (simplified.mesh.triangleCount() == original.triangleCount()) return fitted;
  std::vector<FitPart> parts = partsOf(original, simplified, options);
  for (size_t i = 0; i < parts.size(); ++i) {
    const auto report = [&](double fraction) {
      phase.report((static_cast<double>(i) + fraction) / static_cast<double>(parts.size()));
    };
    fitPart(parts[i], {options, report, job}, fitted);
  }
  return fitted;
}

}  // namespace limber
