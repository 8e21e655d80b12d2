#include "pipeline/modal_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "modes/factorisation.h"
#include "modes/pins.h"
#include "pipeline/chart_sides.h"
#include "pipeline/delaunay_flips.h"
#include "pipeline/guarded_step.h"
#include "pipeline/modal_target.h"
#include "pipeline/surface_fit.h"

namespace limber {

namespace {

constexpr int kSurfaceRounds = 3, kModalRounds = 12;
constexpr uint32_t kSamplesPerTriangle = 6;
constexpr double kClip = 0.1;          // of a residual, in a step
constexpr uint32_t kFewestFaces = 12;  // smaller components stay as they are
constexpr uint32_t kMostVertices =
    20000;  // as do larger ones, which are off by little and would take minutes

// The root mean square distance may grow to this much of the simplified mesh's, or to this part of the
// diagonal.
constexpr double kBudget = 1.3, kLeastBudget = 2e-4;
// A residual of 1 % is worth 0.3 budgets of distance at first; then the worth is steered so that the budget
// is used up.
constexpr double kFirstWorth = 0.3 / 0.01, kLeastChange = 0.3, kMostChange = 1.5;
// How firmly vertices hold their places: more where a step gains less than foretold.
constexpr double kFirstHold = 0.01, kLeastHold = 0.003, kMostHold = 10;
constexpr double kPoorGain = 0.3, kGoodGain = 0.7, kFirmer = 3, kLooser = 2;
constexpr double kRetreat = 0.1;  // of the worth
constexpr double kLost = 1.5;     // a mesh with this much of the best merit is given up

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

// A solved step of the quadratic model: A dx = g, and A^-1 times further columns.
struct Solved {
  Eigen::VectorXd step;
  Eigen::MatrixXd columns;
};

Solved solve(SurfaceFit& fit, const Eigen::MatrixXd& columns, const std::vector<uint8_t>& locked, Job& job) {
  StiffnessModel model;
  for (uint32_t v = 0; v <= locked.size(); ++v) model.firstUnknown.push_back(3 * v);
  model.mass = Eigen::VectorXd::Zero(fit.pull.size());
  model.stiffness = std::move(fit.stiffness);
  std::vector<uint32_t> held;
  for (uint32_t v = 0; v < locked.size(); ++v)
    if (locked[v]) held.insert(held.end(), {3 * v, 3 * v + 1, 3 * v + 2});
  if (!held.empty()) holdUnknowns(model, held);
  Eigen::MatrixXd right(fit.pull.size(), 1 + columns.cols());
  right << fit.pull, columns;
  for (uint32_t row : held) right.row(row).setZero();
  Factorisation factorisation(model, job);
  factorisation.factorise(0, job);
  factorisation.solve(right, job);
  return {right.col(0), right.rightCols(columns.cols())};
}

// Edges flipped to Delaunay, vertices fitted to the surface.
uint32_t fitToSurface(FitPart& part, const FitSamples& samples, std::vector<uint32_t>& corners, Job& job) {
  uint32_t flips = 0;
  for (int round = 0; round < kSurfaceRounds; ++round) {
    flips += flipToDelaunay(part.simplified, part.lines, corners);
    const Topology topology = buildTopology(part.simplified);
    SurfaceFit fit = fitSurface(part.simplified, topology, samples, {.lines = &part.lines});
    const Solved solved = solve(fit, Eigen::MatrixXd(fit.pull.size(), 0), part.locked, job);
    part.simplified = GuardedStep(part.simplified, topology).apply(part.simplified, solved.step);
  }
  return flips;
}

// The minimum of dx^T A dx - 2 g^T dx + worth |r + J dx|^2, by Woodbury: J has few rows.
Eigen::VectorXd gaussNewtonStep(SurfaceFit& fit, const Mismatch& mismatch, double worth,
                                const std::vector<uint8_t>& locked, Job& job) {
  const Solved solved = solve(fit, mismatch.slope, locked, job);
  const Eigen::Index count = mismatch.residual.size();
  const Eigen::MatrixXd small =
      Eigen::MatrixXd::Identity(count, count) / worth + mismatch.slope.transpose() * solved.columns;
  const Eigen::VectorXd clipped = mismatch.residual.cwiseMax(-kClip).cwiseMin(kClip);
  return solved.step -
         solved.columns * small.ldlt().solve(clipped + mismatch.slope.transpose() * solved.step);
}

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
        guard_(part.simplified, topology_) {
    state_.mesh = part.simplified;
    measure();
    worth_ = state_.fit.area * (kFirstWorth * budget_) * (kFirstWorth * budget_);
  }

  // The best mesh of all rounds: the least mismatch, where distances beyond the budget count against it.
  TriangleMesh run(int rounds, const std::function<void(double)>& report) {
    before_ = state_.mismatch.meanSquare();
    best_ = state_;
    for (int round = 0; round < rounds && state_.mismatch.residual.size() > 0; ++round) {
      report(static_cast<double>(round) / rounds);
      step();
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
    state_.mismatch = target_.compare(state_.mesh, topology_, job_);
    fit();
  }

  void fit() {
    state_.fit =
        fitSurface(state_.mesh, topology_, samples_, {.evenness = 0, .hold = hold_, .lines = &part_.lines});
  }

  void step() {
    const Mismatch was = state_.mismatch;
    TriangleMesh next =
        guard_.apply(state_.mesh, gaussNewtonStep(state_.fit, was, worth_, part_.locked, job_));
    const Eigen::VectorXd foretold = was.residual + was.slope.transpose() * difference(next, state_.mesh);
    state_.mesh = std::move(next);
    measure();
    const double gain = was.residual.squaredNorm() - state_.mismatch.residual.squaredNorm();
    const double hoped = was.residual.squaredNorm() - foretold.squaredNorm();
    if (gain < kPoorGain * hoped)
      hold_ = std::min(kMostHold, kFirmer * hold_);
    else if (gain > kGoodGain * hoped)
      hold_ = std::max(kLeastHold, hold_ / kLooser);
    if (state_.fit.meanSquare > 0)
      worth_ *= std::clamp(budget_ * budget_ / state_.fit.meanSquare, kLeastChange, kMostChange);
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
    worth_ *= kRetreat;
    hold_ = std::min(kMostHold, kFirmer * hold_);
    fit();
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
  double hold_ = kFirstHold, worth_ = 0, before_ = 0;
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
  ModalTarget target(part.original, material, call.options.modeCount, call.job);
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
