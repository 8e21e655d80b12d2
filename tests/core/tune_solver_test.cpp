// Tuning coarse meshes to their originals.

#include "fit/tune/tune_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "base/memory.h"
#include "base/parallel.h"
#include "elastic/solvers/solver_constraints.h"
#include "fit/tune/modes/clamped_modes.h"
#include "fit/tune/modes/mode_matching.h"
#include "mesh/topology.h"
#include "reduced.h"
#include "shapes.h"
#include "solver_models.h"
#include "surfaces.h"

namespace limber {
namespace {

using solver_models::constantsOf;
using solver_models::kModels;

TuneOptions optionsFor(const SolverModel& model, const TriangleMesh& original, TuneKind kind) {
  TuneOptions options;
  options.model = model;
  options.original = options.result = constantsOf(model, original);
  options.tune = kind;
  return options;
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

// A smooth closed body and a coarse mesh of it.
const TriangleMesh& body() {
  static const TriangleMesh mesh = surfaces::bumpySphere();
  return mesh;
}
const TriangleMesh& coarseBody() {
  static const TriangleMesh mesh = reduced(body(), 500).mesh;
  return mesh;
}

void expectUntuned(const Tuned& tuned, FrequencyStatus status) {
  EXPECT_TRUE(std::isnan(tuned.frequencies.errorTuned));
  EXPECT_EQ(tuned.frequencyStatus, status);
  EXPECT_EQ(tuned.bendFactor, 1);
  EXPECT_EQ(tuned.stretchFactor, 1);
}

std::string refusalOf(const TriangleMesh& original, const TriangleMesh& result) {
  Job job;
  try {
    tuneSolver(original, result, optionsFor(kModels[1].second, original, TuneKind::Global), job);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(TuneSolver, LeavesAMeshThatIsTheOriginalAlone) {
  Job job;
  for (const auto& [name, model] : kModels) {
    SCOPED_TRACE(name);
    const Tuned tuned =
        tuneSolver(coarseBody(), coarseBody(), optionsFor(model, coarseBody(), TuneKind::Global), job);
    EXPECT_NEAR(tuned.stretchFactor, 1, 1e-3);
    EXPECT_NEAR(tuned.bendFactor, 1, 1e-3);
    EXPECT_LT(tuned.frequencies.errorUntouched, 0.02);
    EXPECT_LT(tuned.frequencies.errorOtherPins, 0.02);
  }
}

TEST(TuneSolver, FindsTheStiffnessThatWasTypedInWrongly) {
  Job job;
  TuneOptions options = optionsFor(kModels[1].second, coarseBody(), TuneKind::Global);
  options.result.stretch *= 2;
  options.result.secondStretch *= 2;
  options.result.bend /= 3;
  const Tuned tuned = tuneSolver(coarseBody(), coarseBody(), options, job);
  EXPECT_NEAR(tuned.stretchFactor, 0.5, 0.005);
  EXPECT_NEAR(tuned.bendFactor, 3, 0.03);
}

TEST(TuneSolver, WithTwoFactorsNearsFrequenciesThatWereNotFitted) {
  Job job;
  // In these solvers stiffness depends on the size of the edges.
  for (const size_t m : {2, 4}) {
    const auto& [name, model] = kModels[m];
    SCOPED_TRACE(name);
    const Tuned tuned = tuneSolver(body(), coarseBody(), optionsFor(model, body(), TuneKind::Global), job);
    EXPECT_LT(tuned.frequencies.errorTuned, tuned.frequencies.errorUntouched);
    EXPECT_LT(tuned.frequencies.errorUnseen, tuned.frequencies.errorUntouched);
    EXPECT_LT(tuned.frequencies.errorOtherPins, tuned.frequencies.errorUntouched);
    EXPECT_TRUE(tuned.stretchFactors.empty());
    EXPECT_TRUE(tuned.stretchField.empty());
  }
}

TEST(TuneSolver, WithAFactorPerConstraintReachesTheFittedFrequencies) {
  Job job;
  for (const auto& [name, model] : kModels) {
    SCOPED_TRACE(name);
    const Tuned tuned =
        tuneSolver(body(), coarseBody(), optionsFor(model, body(), TuneKind::Constraint), job);
    EXPECT_LT(tuned.frequencies.errorTuned, 0.5);
    const auto check = [](const std::vector<double>& factors) {
      for (const double factor : factors) {
        ASSERT_GE(factor, 0.1 * (1 - 1e-12));
        ASSERT_LE(factor, 10 * (1 + 1e-12));
      }
    };
    check(tuned.stretchFactors);
    check(tuned.bendFactors);
    EXPECT_FALSE(tuned.stretchFactors.empty());
    EXPECT_EQ(tuned.stretchFactor, 1);
    const bool isMembrane = model.stretch == StretchElement::Membrane;
    EXPECT_EQ(tuned.stretchVertices.size(), (isMembrane ? 3 : 2) * tuned.stretchFactors.size());
    const size_t corners = model.bend == BendElement::Morley         ? 3
                           : model.bend == BendElement::CrossSprings ? 2
                                                                     : 4;
    EXPECT_EQ(tuned.bendVertices.size(), corners * tuned.bendFactors.size());
  }
}

TEST(TuneSolver, WithFieldsIsNoWorseThanWithTwoFactors) {
  Job job;
  const SolverModel& model = kModels[4].second;
  const Tuned global = tuneSolver(body(), coarseBody(), optionsFor(model, body(), TuneKind::Global), job);
  const Tuned fields = tuneSolver(body(), coarseBody(), optionsFor(model, body(), TuneKind::Vertex), job);
  ASSERT_EQ(fields.stretchField.size(), coarseBody().vertexCount());
  ASSERT_EQ(fields.bendField.size(), coarseBody().vertexCount());
  EXPECT_NEAR(sum(fields.stretchField) / coarseBody().vertexCount(), 1, 1e-9);
  EXPECT_NEAR(sum(fields.bendField) / coarseBody().vertexCount(), 1, 1e-9);
  EXPECT_LT(fields.frequencies.errorTuned, 1.05 * global.frequencies.errorTuned);
  // Neighbours differ far less than the field as a whole.
  const auto [least, most] = std::ranges::minmax(fields.bendField);
  EXPECT_GT(most - least, 0.01);
  double largest = 0;
  for (const auto& edge : buildTopology(coarseBody()).edges)
    largest = std::max(largest, std::abs(fields.bendField[edge.a] - fields.bendField[edge.b]));
  EXPECT_LT(largest, 0.6 * (most - least));
}

TEST(TuneSolver, KeepsFieldsToTheRangeOfFactors) {
  TuneOptions options = optionsFor(kModels[1].second, body(), TuneKind::Vertex);
  options.result.bend /= 30;
  Job job;
  const Tuned tuned = tuneSolver(body(), coarseBody(), options, job);
  EXPECT_GT(tuned.bendFactor, 9);
  EXPECT_LE(tuned.bendFactor * std::ranges::max(tuned.bendField), 10 * (1 + 1e-9));
}

TEST(TuneSolver, KeepsTheMassOfTheOriginal) {
  Job job;
  for (const MassRule rule : {MassRule::Area, MassRule::Vertex}) {
    TuneOptions options = optionsFor(kModels[1].second, body(), TuneKind::Global);
    options.tunedMass = rule;
    const Tuned tuned = tuneSolver(body(), coarseBody(), options, job);
    const double total = sum(solverMasses(body(), options.model.mass, options.original));
    EXPECT_NEAR(sum(tuned.masses), total, 1e-12 * total);
    EXPECT_GT(*std::ranges::min_element(tuned.masses), 0);
    if (rule == MassRule::Vertex)
      EXPECT_DOUBLE_EQ(tuned.masses.front(), tuned.masses.back());
    else
      EXPECT_LT(*std::ranges::min_element(tuned.masses), *std::ranges::max_element(tuned.masses));
  }
}

TEST(TuneSolver, LeavesTheStretchOfOpenSheetsAlone) {
  Job job;
  TriangleMesh sheet = shapes::grid(24, 18, 1.4, 1);
  for (Vec3& p : sheet.positions) p.z = 0.2 * std::sin(2 * p.x) * std::cos(3 * p.y);
  const TriangleMesh coarse = reduced(surfaces::inFloats(sheet), 216).mesh;
  const Tuned tuned = tuneSolver(surfaces::inFloats(sheet), coarse,
                                 optionsFor(kModels[2].second, sheet, TuneKind::Global), job);
  EXPECT_EQ(tuned.stretchFactor, 1);
  EXPECT_LT(std::abs(std::log(tuned.bendFactor * 2)), 0.3);  // edges are twice as long
  EXPECT_LT(tuned.frequencies.errorTuned, tuned.frequencies.errorUntouched);
}

TEST(TuneSolver, FitsNothingToAFlatSheetOfSprings) {
  Job job;
  const TriangleMesh sheet = surfaces::inFloats(shapes::grid(16, 12, 1.3, 1));
  const TriangleMesh coarse = surfaces::inFloats(shapes::grid(8, 6, 1.3, 1));
  const Tuned tuned =
      tuneSolver(sheet, coarse, optionsFor(kModels[4].second, sheet, TuneKind::Constraint), job);
  EXPECT_TRUE(std::isnan(tuned.frequencies.errorTuned));
  EXPECT_EQ(tuned.frequencyStatus, FrequencyStatus::NoResistance);
  EXPECT_TRUE(std::isnan(tuned.frequencies.errorUntouched));
  EXPECT_TRUE(std::ranges::all_of(tuned.bendFactors, [](double factor) { return factor == 1; }));
  EXPECT_FALSE(tuned.bendFactors.empty());
  const double total = sum(solverMasses(sheet, MassRule::Area, constantsOf(kModels[4].second, sheet)));
  EXPECT_NEAR(sum(tuned.masses), total, 1e-12 * total);
}

// Hundreds of motions without resistance: no search for modes converges among them.
TEST(TuneSolver, FitsNothingToALargeFlatSheetOfSprings) {
  Job job;
  const TriangleMesh sheet = surfaces::inFloats(shapes::grid(40, 40));
  const TriangleMesh coarse = surfaces::inFloats(shapes::grid(20, 20));
  for (const bool isPinned : {false, true}) {
    TuneOptions options = optionsFor(kModels[4].second, sheet, TuneKind::Global);
    if (isPinned) {
      options.pinnedOriginal = {0, 40};
      options.pinnedResult = {0, 20};
    }
    const Tuned tuned = tuneSolver(sheet, coarse, options, job);
    expectUntuned(tuned, FrequencyStatus::NoResistance);
  }
}

// No hinge spans an edge of three sheets, so that they swing about it without resistance.
TEST(TuneSolver, FitsNothingToSheetsThatSwingAboutAnEdge) {
  Job job;
  for (const int sheets : {3, 4, 90}) {
    const TriangleMesh original = surfaces::sheetsAroundAnEdge(sheets, 8),
                       coarse = surfaces::sheetsAroundAnEdge(sheets, 4);
    for (const int model : {1, 2, 3}) {
      SCOPED_TRACE(kModels[model].first);
      const Tuned tuned =
          tuneSolver(original, coarse, optionsFor(kModels[model].second, original, TuneKind::Global), job);
      expectUntuned(tuned, FrequencyStatus::NoResistance);
    }
  }
}

// Hinges of no stiffness join triangles, but resist nothing.
TEST(TuneSolver, FitsNothingToASheetWhoseHingesResistNothing) {
  Job job;
  for (const double height : {0.0, 0.2}) {
    TriangleMesh sheet = shapes::grid(40, 40), coarse = shapes::grid(20, 20);
    for (TriangleMesh* mesh : {&sheet, &coarse})
      for (Vec3& p : mesh->positions) p.z = height * std::sin(3 * p.x) * std::cos(2 * p.y);
    for (const int model : {1, 2, 3}) {
      SCOPED_TRACE(kModels[model].first);
      TuneOptions options = optionsFor(kModels[model].second, sheet, TuneKind::Global);
      options.original.bend = options.result.bend = 0;
      const Tuned tuned = tuneSolver(sheet, coarse, options, job);
      expectUntuned(tuned, FrequencyStatus::NoResistance);
    }
  }
}

TEST(TuneSolver, RefusesBeforeItTakesMoreMemoryThanThereIs) {
  Job job;
  const TuneOptions options = optionsFor(kModels[1].second, body(), TuneKind::Global);
  setMemoryLimit(1'000'000);
  try {
    tuneSolver(body(), coarseBody(), options, job);
    ADD_FAILURE() << "it was not refused";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("but only 1 MB are left"), std::string::npos);
  }
  setMemoryLimit(0);
}

// The bending stiffness is that of rounding: no search converges to modes of it.
TEST(TuneSolver, FitsNothingWhereNoSearchForModesConverges) {
  Job job;
  const TriangleMesh sheet = shapes::grid(24, 16, 1.3, 1), coarse = shapes::grid(12, 8, 1.3, 1);
  for (const int model : {0, 1, 2}) {
    SCOPED_TRACE(kModels[model].first);
    TuneOptions options = optionsFor(kModels[model].second, sheet, TuneKind::Global);
    options.original.bend *= 1e-12;
    options.result.bend *= 1e-12;
    const Tuned tuned = tuneSolver(sheet, coarse, options, job);
    expectUntuned(tuned, FrequencyStatus::NoConvergence);
  }
}

TEST(PartModesPair, isDefiniteAgainWhereModesThatHadLostTheirResistanceRegainIt) {
  Job job;
  const SolverModel model = kModels[1].second;
  const TriangleMesh sheet = shapes::grid(24, 16, 1.3, 1), coarse = shapes::grid(16, 12, 1.3, 1);
  const SolverConstants constants = constantsOf(model, sheet);
  const SolverStiffness stiffness(coarse, buildTopology(coarse), model, constants);
  const auto pairs = pairParts({sheet, coarse, model, constants, constants, stiffness}, job);
  const std::vector<double> original = solverMasses(sheet, model.mass, constants),
                            result = solverMasses(coarse, model.mass, constants);
  PartModesPair modes(pairs[0], {0, {}, {}}, {original, result}, 10);
  modes.solveResult(0, job);
  FactorSharing alone;
  modes.solveOriginal(alone, job);
  ASSERT_TRUE(modes.isDefinite());
  const double first = modes.firstEigenvalue();

  std::vector<double> factors(stiffness.count(), 1.0);
  std::fill(factors.begin() + stiffness.stretchCount(), factors.end(), 1e-14);
  modes.follow(factors, 10, job);
  EXPECT_FALSE(modes.isDefinite());
  modes.follow(std::vector<double>(stiffness.count(), 1.0), 10, job);
  EXPECT_TRUE(modes.isDefinite());
  EXPECT_NEAR(modes.firstEigenvalue(), first, 1e-3 * first);
}

TEST(TuneSolver, SolvesEveryPartOnItsOwn) {
  Job job;
  TriangleMesh other = coarseBody();
  for (Vec3& p : other.positions) p = {p.x + 5, 1.2 * p.y, p.z};
  const TriangleMesh two = shapes::together(coarseBody(), other);
  const TriangleMesh coarse = reduced(two, 400).mesh;
  const Tuned tuned = tuneSolver(two, coarse, optionsFor(kModels[3].second, two, TuneKind::Constraint), job);
  EXPECT_LT(tuned.frequencies.errorTuned, 0.5);
}

TEST(TuneSolver, FitsThePinsOfTheUser) {
  Job job;
  TuneOptions options = optionsFor(kModels[2].second, body(), TuneKind::Global);
  const auto pinsOf = [](const TriangleMesh& mesh) {
    std::vector<uint32_t> pins;
    for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
      if (mesh.positions[v].y > 0.6) pins.push_back(v);
    return pins;
  };
  const Tuned without = tuneSolver(body(), coarseBody(), options, job);
  options.pinnedOriginal = pinsOf(body());
  options.pinnedResult = pinsOf(coarseBody());
  const Tuned with = tuneSolver(body(), coarseBody(), options, job);
  EXPECT_NE(with.bendFactor, without.bendFactor);
  EXPECT_LT(with.frequencies.errorTuned, with.frequencies.errorUntouched);
  options.pinnedResult = {coarseBody().vertexCount()};
  EXPECT_THROW(tuneSolver(body(), coarseBody(), options, job), std::invalid_argument);
}

TEST(TuneSolver, GivesTheSameBytesForAnyNumberOfThreads) {
  Job job;
  const TuneOptions options = optionsFor(kModels[4].second, body(), TuneKind::Constraint);
  const Tuned one = tuneSolver(body(), coarseBody(), options, job);
  setThreadCount(4);
  const Tuned four = tuneSolver(body(), coarseBody(), options, job);
  setThreadCount(1);
  EXPECT_EQ(one.stretchFactors, four.stretchFactors);
  EXPECT_EQ(one.bendFactors, four.bendFactors);
  EXPECT_EQ(one.masses, four.masses);
}

TEST(TuneSolver, HandsOverWhatMovesBest) {
  Job job;
  TuneOptions options = optionsFor(kModels[2].second, coarseBody(), TuneKind::Global);
  options.runsTrial = true;
  options.result.bend /= 3;
  const Tuned same = tuneSolver(coarseBody(), coarseBody(), options, job);
  ASSERT_TRUE(same.motion.has_value());
  EXPECT_EQ(same.motion->scene, "sway");
  EXPECT_LT(same.motion->tuned, 0.05 * same.motion->untouched);
  EXPECT_EQ(same.motion->kept, KeptParameters::Tuned);
  EXPECT_NEAR(same.bendFactor, 3, 0.03);

  options = optionsFor(kModels[2].second, body(), TuneKind::Global);
  options.runsTrial = true;
  const Tuned other = tuneSolver(body(), coarseBody(), options, job);
  ASSERT_TRUE(other.motion.has_value());
  const bool isBetter = other.motion->tuned <= other.motion->untouched + other.motion->noiseFloor;
  EXPECT_EQ(other.motion->kept, isBetter ? KeptParameters::Tuned : KeptParameters::Untouched);
  EXPECT_EQ(other.bendFactor == 1, !isBetter);
}

// Beside a body that is as it was lies a sheet that has lost the waves which stiffened it.
TEST(TuneSolver, WithdrawsFactorsThatWorsenFrequenciesOnAverageWhereNoMotionDecides) {
  const auto beside = [](TriangleMesh sheet, double waves) {
    for (Vec3& p : sheet.positions) p = {p.x + 2, p.y, waves * std::sin(12 * p.x)};
    return shapes::together(body(), sheet);
  };
  const TriangleMesh original = beside(shapes::grid(24, 24, 1, 1), 0.06),
                     result = beside(shapes::grid(8, 8, 1, 1), 0.001);
  Job job;
  const TuneOptions options = optionsFor(kModels[3].second, original, TuneKind::Global);
  const Tuned tuned = tuneSolver(original, result, options, job);
  EXPECT_EQ(tuned.kept, KeptParameters::Untouched);
  EXPECT_EQ(tuned.bendFactor, 1);
  EXPECT_EQ(tuned.stretchFactor, 1);
  EXPECT_LT(tuned.frequencies.errorTuned, 0.01);  // of the body, which the factors would have moved
}

TEST(TuneSolver, TriesMorleysElementWithTwoFactorsAlone) {
  Job job;
  TuneOptions options = optionsFor(kModels[0].second, body(), TuneKind::Global);
  options.runsTrial = true;
  EXPECT_TRUE(tuneSolver(body(), coarseBody(), options, job).motion.has_value());
  options.tune = TuneKind::Constraint;
  EXPECT_FALSE(tuneSolver(body(), coarseBody(), options, job).motion.has_value());
}

TEST(TuneSolver, RefusesWhatDoesNotBelongTogether) {
  const auto moved = [](double scale, const Vec3& by) {
    TriangleMesh mesh = coarseBody();
    for (Vec3& p : mesh.positions) p = scale * p + by;
    return mesh;
  };
  EXPECT_EQ(refusalOf(body(), coarseBody()), "");
  EXPECT_NE(refusalOf(body(), moved(1.2, {})).find("times as large"), std::string::npos);
  EXPECT_NE(refusalOf(body(), moved(1, {0.5, 0, 0})).find("place and pose"), std::string::npos);
  EXPECT_NE(refusalOf(coarseBody(), body()).find("faces"), std::string::npos);
  EXPECT_NE(refusalOf(body(), {}).find("no usable triangle"), std::string::npos);
  EXPECT_NE(refusalOf({}, coarseBody()).find("no usable triangle"), std::string::npos);
  const TriangleMesh halves = shapes::together(reduced(body(), 300).mesh, shapes::sphere(1, 0.4));
  EXPECT_NE(refusalOf(body(), halves).find("parts"), std::string::npos);
}

// The same mesh with its vertices and triangles in another order.
TriangleMesh renumbered(const TriangleMesh& mesh, uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<uint32_t> idOf(mesh.vertexCount());
  std::iota(idOf.begin(), idOf.end(), 0);
  std::ranges::shuffle(idOf, random);
  TriangleMesh other;
  other.positions.resize(mesh.vertexCount());
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) other.positions[idOf[v]] = mesh.positions[v];
  for (const auto& [a, b, c] : mesh.triangles) other.triangles.push_back({idOf[a], idOf[b], idOf[c]});
  std::ranges::shuffle(other.triangles, random);
  return other;
}

// Its modes come in pairs that any mixture describes.
TEST(TuneSolver, DoesNotDependOnTheMixtureOfModesOfASymmetricBody) {
  const TriangleMesh ring = surfaces::inFloats(shapes::torus(48, 20)),
                     coarseRing = surfaces::inFloats(shapes::torus(24, 10));
  for (const size_t m : {1, 3}) {
    SCOPED_TRACE(kModels[m].first);
    Job job;
    const TuneOptions options = optionsFor(kModels[m].second, ring, TuneKind::Global);
    const Tuned first = tuneSolver(ring, coarseRing, options, job);
    EXPECT_GT(std::abs(std::log(first.bendFactor)), 0.02);
    for (const uint32_t seed : {1, 2, 3}) {
      const Tuned other = tuneSolver(renumbered(ring, seed), renumbered(coarseRing, seed + 10), options, job);
      EXPECT_NEAR(other.stretchFactor / first.stretchFactor, 1, 0.01);
      EXPECT_NEAR(other.bendFactor / first.bendFactor, 1, 0.01);
    }
  }
}

TEST(TuneSolver, CanBeCancelled) {
  Job job;
  job.requestCancel();
  EXPECT_THROW(tuneSolver(body(), coarseBody(), optionsFor(kModels[1].second, body(), TuneKind::Global), job),
               Cancelled);
}

TEST(MatchModes, FollowsShapesWhereModesCrossAndOrderElsewhere) {
  Eigen::MatrixXd overlap = Eigen::MatrixXd::Zero(5, 4);
  overlap(1, 0) = overlap(0, 1) = 0.95;  // these two have crossed
  overlap(2, 2) = overlap(3, 2) = 0.7;   // these two come in a mixture
  overlap(2, 3) = -0.7, overlap(3, 3) = 0.7;
  const std::vector<ModeRange> alone = {{0, 1}, {1, 2}, {2, 3}, {3, 4}};
  EXPECT_EQ(matchModes(overlap, alone), (std::vector<Eigen::Index>{1, 0, 2, 3}));
}

TEST(MatchModes, DoesNotDependOnTheMixtureWithinACluster) {
  for (const double angle : {0.0, 0.3, 0.785, 1.2, 1.6}) {
    const double c = 0.95 * std::cos(angle), s = 0.95 * std::sin(angle);
    Eigen::MatrixXd overlap = Eigen::MatrixXd::Zero(4, 3);
    overlap(0, 2) = 0.95;  // has sunk below the pair
    overlap(1, 0) = c, overlap(1, 1) = s;
    overlap(3, 0) = -s, overlap(3, 1) = c;
    EXPECT_EQ(matchModes(overlap, {{0, 2}, {2, 3}}), (std::vector<Eigen::Index>{1, 3, 0}));
  }
}

TEST(ModeClusters, JoinNearlyEqualEigenvalues) {
  const std::vector<ModeRange> clusters = modeClusters(Eigen::Vector<double, 6>(1, 1.005, 1.009, 1.02, 3, 3));
  ASSERT_EQ(clusters.size(), 3u);
  EXPECT_EQ(clusters[0].last, 3);
  EXPECT_EQ(clusters[1].first, 3);
  EXPECT_EQ(clusters[2].first, 4);
  EXPECT_EQ(clusters[2].last, 6);
}

}  // namespace
}  // namespace limber
