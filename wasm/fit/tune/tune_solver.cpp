#include "fit/tune/tune_solver.h"

#include <algorithm>
#include <numeric>

#include "fit/tune/tune_checks.h"
#include "fit/tune/tune_problem.h"
#include "fit/tune/tune_steps.h"
#include "fit/tune/tuned_masses.h"
#include "mesh/topology.h"

namespace limber {
namespace {

// Progress after the stages of a run.
constexpr double kPrepared = 0.05, kSolved = 0.6, kTuned = 0.9;

bool hasBorder(const Topology& topology) {
  return std::ranges::any_of(topology.edges, [](const Topology::Edge& edge) { return edge.useCount == 1; });
}

std::vector<double> equalMasses(const std::vector<double>& original, uint32_t count) {
  return std::vector<double>(count, std::accumulate(original.begin(), original.end(), 0.0) / count);
}

std::vector<SolverConstraint> constraintsOf(const SolverStiffness& stiffness) {
  std::vector<SolverConstraint> all;
  for (uint32_t c = 0; c < stiffness.count(); ++c) all.push_back(stiffness[c]);
  return all;
}

void listVertices(const std::vector<SolverConstraint>& constraints, Tuned& tuned) {
  for (const SolverConstraint& constraint : constraints) {
    auto& vertices = constraint.kind == ConstraintKind::Stretch ? tuned.stretchVertices : tuned.bendVertices;
    vertices.insert(vertices.end(), constraint.vertices.begin(),
                    constraint.vertices.begin() + constraint.vertexCount);
  }
}

void tuneFinely(TuneProblem& problem, const TuneConstraints& constraints, const TriangleMesh& mesh,
                TuneKind kind, Tuned& tuned, Job& job) {
  const GlobalFactors start{tuned.stretchFactor, tuned.bendFactor};
  if (kind == TuneKind::Vertex) {
    VertexFields fields = tuneFields(problem, constraints, mesh, start, job);
    tuned.stretchFactor = fields.factors.stretch;
    tuned.bendFactor = fields.factors.bend;
    tuned.stretchField = std::move(fields.stretch);
    tuned.bendField = std::move(fields.bend);
  }
  if (kind == TuneKind::Constraint) {
    const std::vector<double> factors = tuneConstraints(problem, constraints, start, job);
    const auto first = factors.begin() + static_cast<ptrdiff_t>(constraints.stretchCount);
    tuned.stretchFactors.assign(factors.begin(), first);
    tuned.bendFactors.assign(first, factors.end());
    tuned.stretchFactor = tuned.bendFactor = 1;
  }
}

}  // namespace

Tuned tuneSolver(const TriangleMesh& original, const TriangleMesh& result, const TuneOptions& options,
                 Job& job) {
  requireTunable(original, result, options);
  WholePhase whole(job, Phase::Fit);
  const SolverStiffness stiffness(result, buildTopology(result), options.model, options.result);
  const std::deque<PartPair> pairs =
      pairParts({original, result, options.model, options.original, options.result, stiffness}, job);
  const std::vector<double> originalMasses = solverMasses(original, options.model.mass, options.original);
  Tuned tuned;
  tuned.masses = options.tunedMass == MassRule::Vertex ? equalMasses(originalMasses, result.vertexCount())
                                                       : carryMasses(pairs, result, originalMasses);
  const std::vector<SolverConstraint> all = constraintsOf(stiffness);
  listVertices(all, tuned);
  whole.report(kPrepared);
  TuneProblem problem(pairs, findClampings(original, pairs, options), {originalMasses, tuned.masses},
                      all.size(), job);
  if (!problem.isDefinite()) return tuned;
  whole.report(kSolved);
  tuned.frequencies.errorUntouched =
      problem.freeErrorWith(solverMasses(result, options.model.mass, options.result), job);
  const TuneConstraints constraints{all, stiffness.stretchCount(), !hasBorder(buildTopology(original))};
  const GlobalFactors global = tuneGlobally(problem, constraints, job);
  tuned.stretchFactor = global.stretch;
  tuned.bendFactor = global.bend;
  tuneFinely(problem, constraints, result, options.tune, tuned, job);
  whole.report(kTuned);
  tuned.frequencies.errorTuned = problem.freeError();
  tuned.frequencies.errorUnseen = problem.unseenError();
  tuned.frequencies.errorOtherPins = problem.otherPinsError(job);
  return tuned;
}

}  // namespace limber
