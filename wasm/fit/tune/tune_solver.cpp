#include "fit/tune/tune_solver.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "fit/tune/modes/tuned_masses.h"
#include "fit/tune/steps/tune_problem.h"
#include "fit/tune/steps/tune_steps.h"
#include "fit/tune/tune_checks.h"
#include "fit/tune/tune_trial.h"
#include "mesh/topology.h"
#include "mesh/vertex_areas.h"

namespace limber {
namespace {

// Progress after the stages of a run.
constexpr double kPrepared = 0.05, kSolved = 0.5, kTuned = 0.8;
constexpr double kRounding = 100 * kRoughTolerance;  // of errors of frequencies, in %

// How many times as long the edges of the result are as those of the original, from the mean areas of
// triangles.
double lengthRatio(const TriangleMesh& original, const TriangleMesh& result) {
  const auto meanArea = [](const TriangleMesh& mesh) { return surfaceArea(mesh) / mesh.triangleCount(); };
  return std::sqrt(meanArea(result) / meanArea(original));
}

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

// The factors of a run in all forms of Tuned, and the factor of every constraint.
struct Tuning {
  GlobalFactors global;
  std::vector<double> stretchField, bendField, stretchFactors, bendFactors;
  std::vector<double> all;
};

Tuning tune(TuneProblem& problem, const TuneConstraints& constraints, TuneKind kind, Job& job) {
  Tuning tuning{tuneGlobally(problem, constraints, job), {}, {}, {}, {}, {}};
  if (kind == TuneKind::Vertex) {
    VertexFields fields = tuneFields(problem, constraints, tuning.global, job);
    tuning.global = fields.factors;
    tuning.stretchField = std::move(fields.stretch);
    tuning.bendField = std::move(fields.bend);
  }
  if (kind == TuneKind::Constraint) {
    const std::vector<double> factors = tuneConstraints(problem, constraints, tuning.global, job);
    const auto bends = factors.begin() + static_cast<ptrdiff_t>(constraints.stretchCount);
    tuning.stretchFactors.assign(factors.begin(), bends);
    tuning.bendFactors.assign(bends, factors.end());
    tuning.global = {};
  }
  tuning.all = problem.factors();
  return tuning;
}

// Factors of 1 in the form of the tuning kind.
Tuning untouchedOf(TuneKind kind, const TuneConstraints& constraints) {
  Tuning tuning;
  tuning.all.assign(constraints.all.size(), 1.0);
  if (kind == TuneKind::Vertex)
    tuning.stretchField = tuning.bendField = std::vector<double>(constraints.mesh.vertexCount(), 1.0);
  if (kind == TuneKind::Constraint) {
    tuning.stretchFactors.assign(constraints.stretchCount, 1.0);
    tuning.bendFactors.assign(constraints.all.size() - constraints.stretchCount, 1.0);
  }
  return tuning;
}

// A tuning and the quality of its modes.
struct Attempt {
  Tuning tuning;
  TunedFrequencies frequencies;
  double fittedError = 0;
};

// The attempt that a problem has been moved to. `untouched`: the error without anything tuned.
Attempt attemptAt(const TuneProblem& problem, Tuning tuning, double untouched, Job& job) {
  return {std::move(tuning),
          {untouched, problem.freeError(), problem.unseenError(), problem.otherPinsError(job)},
          problem.fittedError()};
}

// On an open mesh with global factors, stretching may be tuned as well if the trial favours it.
std::vector<Attempt> attempts(TuneProblem& problem, TuneConstraints constraints, const TuneOptions& options,
                              Job& job) {
  const double untouched =
      problem.freeErrorWith(solverMasses(constraints.mesh, options.model.mass, options.result), job);
  std::vector<Attempt> all;
  const auto attempt = [&] {
    Tuning tuning = tune(problem, constraints, options.tune, job);
    all.push_back(attemptAt(problem, std::move(tuning), untouched, job));
  };
  attempt();
  if (constraints.tunesStretch || !options.runsTrial || options.tune != TuneKind::Global) return all;
  constraints.tunesStretch = true;
  problem.moveTo(std::vector<double>(constraints.all.size(), 1.0), job);
  attempt();
  return all;
}

// The attempt to return: the first one, or the one that moves best.
Attempt chosen(std::vector<Attempt> all, const TrialBodies& bodies, Tuned& tuned, Job& job) {
  if (!bodies.options.runsTrial) return std::move(all[0]);
  std::vector<TuneCandidate> candidates;
  const bool isGlobal = bodies.options.tune == TuneKind::Global;
  for (const Attempt& attempt : all)
    candidates.push_back(isGlobal ? TuneCandidate{attempt.tuning.global.stretch, attempt.tuning.global.bend}
                                  : TuneCandidate{1, 1, attempt.tuning.all});
  TrialOutcome outcome = tryMotion(bodies, candidates, job);
  tuned.motion = std::move(outcome.motion);
  tuned.motionRefusal = std::move(outcome.refusal);
  return std::move(all[outcome.best]);
}

// Writes everything that follows from the constraints and factors.
void write(Attempt attempt, Tuned& tuned) {
  tuned.frequencies = attempt.frequencies;
  tuned.stretchFactor = attempt.tuning.global.stretch;
  tuned.bendFactor = attempt.tuning.global.bend;
  tuned.stretchField = std::move(attempt.tuning.stretchField);
  tuned.bendField = std::move(attempt.tuning.bendField);
  tuned.stretchFactors = std::move(attempt.tuning.stretchFactors);
  tuned.bendFactors = std::move(attempt.tuning.bendFactors);
}

void listVertices(const std::vector<SolverConstraint>& constraints, Tuned& tuned) {
  for (const SolverConstraint& constraint : constraints) {
    auto& vertices = constraint.kind == ConstraintKind::Stretch ? tuned.stretchVertices : tuned.bendVertices;
    vertices.insert(vertices.end(), constraint.vertices.begin(),
                    constraint.vertices.begin() + constraint.vertexCount);
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
  const std::vector<double> masses = solverMasses(original, options.model.mass, options.original);
  Tuned tuned;
  tuned.masses = options.tunedMass == MassRule::Vertex ? equalMasses(masses, result.vertexCount())
                                                       : carryMasses(pairs, result, masses);
  const std::vector<SolverConstraint> all = constraintsOf(stiffness);
  listVertices(all, tuned);
  whole.report(kPrepared);
  TuneProblem problem({pairs, findClampings(original, pairs, options), {masses, tuned.masses}, all.size()},
                      job);
  whole.report(kSolved);
  const TuneConstraints constraints{result,
                                    all,
                                    stiffness.stretchCount(),
                                    !hasBorder(buildTopology(original)),
                                    FactorRange{},
                                    bendRange(options.model.bend, lengthRatio(original, result))};
  const Tuning untouched = untouchedOf(options.tune, constraints);
  tuned.frequencyStatus = problem.status();
  if (!problem.isDefinite()) {
    write({untouched, {}}, tuned);
    return tuned;
  }
  const double withoutFactors = problem.fittedError();
  std::vector<Attempt> found = attempts(problem, constraints, options, job);
  whole.report(kTuned);
  Attempt best = chosen(std::move(found), {original, result, options, tuned.masses}, tuned, job);
  if (tuned.motion) {
    tuned.kept = tuned.motion->kept;
    if (tuned.kept == KeptParameters::Untouched) best.tuning = untouched;
  } else if (best.fittedError > withoutFactors + kRounding) {
    tuned.kept = KeptParameters::Untouched;
    problem.moveTo(untouched.all, job);
    best = attemptAt(problem, untouched, best.frequencies.errorUntouched, job);
  }
  write(std::move(best), tuned);
  return tuned;
}

}  // namespace limber
