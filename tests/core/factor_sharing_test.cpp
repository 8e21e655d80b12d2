// Factorisations that share fronts, and the searches for modes that use them.

#include <gtest/gtest.h>

#include <memory>

#include "base/memory.h"
#include "base/parallel.h"
#include "elastic/pins.h"
#include "elastic/solvers/solver_vibration.h"
#include "linear/block_lanczos.h"
#include "linear/factorisation.h"
#include "solver_models.h"
#include "surfaces.h"

namespace limber {
namespace {

using solver_models::constantsOf;
using solver_models::kModels;

struct ThreadCount {
  explicit ThreadCount(int count) { setThreadCount(count); }
  ~ThreadCount() { setThreadCount(1); }
};

std::vector<uint32_t> verticesBeyond(const TriangleMesh& mesh, double y) {
  std::vector<uint32_t> vertices;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    if (y < 0 ? mesh.positions[v].y < y : mesh.positions[v].y > y) vertices.push_back(v);
  return vertices;
}

// A closed body in a solver, free and clamped at its lower and upper end.
struct Body {
  TriangleMesh mesh = surfaces::bumpySphere();
  SolverConstants constants;
  SolverStiffness stiffness;
  std::vector<double> masses;
  std::shared_ptr<const FactorStructure> structure;
  std::vector<std::vector<uint32_t>> pins = {verticesBeyond(mesh, -0.6), verticesBeyond(mesh, 0.7)};

  Body(const SolverModel& model, Job& job)
      : constants(constantsOf(model, mesh)),
        stiffness(mesh, buildTopology(mesh), model, constants),
        masses(solverMasses(mesh, model.mass, constants)),
        structure(structureOf(stiffness, job)) {}

  std::vector<double> ones() const { return std::vector<double>(stiffness.count(), 1.0); }
  SparsePencil pencil(const std::vector<uint32_t>& clamped) const {
    SparsePencil pencil = stiffness.pencil(ones(), masses);
    clampUnknowns(pencil, clamped);
    return pencil;
  }
  SolverVibration vibration(const std::vector<uint32_t>& pinned) const {
    return {{mesh, stiffness, masses, pinned}, structure};
  }
};

template <typename Test>
void forEveryModel(Job& job, const Test& test) {
  for (const auto& [name, model] : kModels) {
    SCOPED_TRACE(name);
    test(Body(model, job));
  }
}

// 18 modes of this clamping, from scratch.
ModeBasis modesOf(const Body& body, const std::vector<uint32_t>& pinned, double scale, Job& job) {
  const SolverVibration vibration = body.vibration(pinned);
  return vibration.solve(body.ones(), 18, scale > 0 ? scale : vibration.estimate(job).firstEigenvalue, job)
      .basis;
}

TEST(FactorSharing, GivesTheSameBitsAsAFactorisationOfItsOwn) {
  Job job;
  forEveryModel(job, [&](const Body& body) {
    constexpr double kShift = -300;
    for (const int threads : {1, 3}) {
      const ThreadCount several(threads);
      const SparsePencil free = body.pencil({});
      const auto base = std::make_shared<Factorisation>(free, body.structure);
      for (const auto& pins : body.pins) base->keepFor(body.stiffness.clampedUnknowns(pins));
      base->factorise(kShift, job);
      for (const auto& pins : body.pins) {
        const std::vector<uint32_t> clamped = body.stiffness.clampedUnknowns(pins);
        const SparsePencil pencil = body.pencil(clamped);
        Factorisation own(pencil, body.structure), shared(pencil, base, clamped);
        own.factorise(kShift, job);
        shared.factorise(kShift, job);
        EXPECT_LT(shared.memory(), own.memory());
        Eigen::MatrixXd x = randomColumns(free.m.size(), 5), y = x;
        own.solve(x, job);
        shared.solve(y, job);
        EXPECT_TRUE((x.array() == y.array()).all());
      }
      // The base itself is as it would be without others that share it.
      Factorisation alone(free, body.structure);
      alone.factorise(kShift, job);
      Eigen::VectorXd x = randomColumns(free.m.size(), 1), y = x;
      alone.solve(x, job);
      base->solve(y, job);
      EXPECT_TRUE((x.array() == y.array()).all());
    }
  });
}

// The sharing of a body in these clampings, whose base is the free body with these modes.
FactorSharing sharingOf(const Body& body, const std::vector<std::vector<uint32_t>>& clampings,
                        const ModeBasis& free, Job& job) {
  FactorSharing sharing;
  for (const auto& pins : clampings) sharing.unknowns.push_back(body.stiffness.clampedUnknowns(pins));
  body.vibration({}).solveFrom(free, {body.ones(), 12, &sharing}, job);
  return sharing;
}

struct Clamped {
  std::vector<uint32_t> pins;
  ModeBasis modes;  // from scratch
};

// Compares 12 modes from a search that may share with those from scratch.
void expectModesOf(const Body& body, const Clamped& clamped, FactorSharing& sharing, Job& job) {
  const ModeBasis found =
      body.vibration(clamped.pins).solveFrom(clamped.modes, {body.ones(), 12, &sharing}, job).basis;
  for (Eigen::Index k = 0; k < 12; ++k)
    EXPECT_NEAR(found.lambda[k] / clamped.modes.lambda[k], 1, kRoughTolerance) << k;
}

TEST(FactorSharing, LeavesTheModesOfClampedBodiesAsTheyAre) {
  Job job;
  forEveryModel(job, [&](const Body& body) {
    const ModeBasis free = modesOf(body, {}, 0, job);
    FactorSharing sharing = sharingOf(body, body.pins, free, job);
    ASSERT_TRUE(sharing.base);
    const double shift = sharing.shift;
    for (const auto& pins : body.pins)
      expectModesOf(body, {pins, modesOf(body, pins, free.lambda[0], job)}, sharing, job);
    EXPECT_EQ(sharing.shift, shift);
  });
}

// A body, its modes in its first clamping, and the sharing with the free body.
struct ClampedBody {
  Body body;
  Clamped clamped;
  FactorSharing sharing;

  explicit ClampedBody(Job& job) : body(kModels[0].second, job) {
    const ModeBasis free = modesOf(body, {}, 0, job);
    clamped = {body.pins[0], modesOf(body, body.pins[0], free.lambda[0], job)};
    sharing = sharingOf(body, {body.pins[0]}, free, job);
  }
};

TEST(FactorSharing, IsGivenUpWhereMemoryIsShort) {
  Job job;
  ClampedBody one(job);
  ASSERT_TRUE(one.sharing.base);
  const uint64_t vector = static_cast<uint64_t>(one.body.stiffness.unknownCount()) * sizeof(double);
  setMemoryLimit(one.body.structure->memory() + 180 * vector);
  expectModesOf(one.body, one.clamped, one.sharing, job);
  setMemoryLimit(0);
  EXPECT_FALSE(one.sharing.base);
}

TEST(FactorSharing, IsNotUsedForAFarSofterBody) {
  Job job;
  ClampedBody one(job);
  // The base was not factorised at this shift: its use would be wrong.
  one.sharing.shift = -1e6 * one.clamped.modes.lambda[0];
  expectModesOf(one.body, one.clamped, one.sharing, job);
}

}  // namespace
}  // namespace limber
