// The stiffness matrices of the solver models.

#include "elastic/solvers/solver_stiffness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "base/memory.h"
#include "base/parallel.h"
#include "elastic/shell.h"
#include "elastic/solvers/solver_vibration.h"
#include "shapes.h"
#include "solver_models.h"
#include "surfaces.h"

namespace limber {
namespace {

using solver_models::constantsOf;
using solver_models::kModels;

std::vector<double> ones(const SolverStiffness& stiffness) {
  return std::vector<double>(stiffness.count(), 1.0);
}

// Factors that differ from constraint to constraint.
std::vector<double> uneven(const SolverStiffness& stiffness) {
  std::vector<double> factors;
  for (uint32_t c = 0; c < stiffness.count(); ++c) factors.push_back(1 + 0.5 * std::sin(1.7 * c));
  return factors;
}

TriangleMesh smallBody() {
  TriangleMesh mesh = shapes::jittered(shapes::torus(9, 7), 0.02, 5);
  for (Vec3& p : mesh.positions) p = {1.4 * p.x, p.y, 0.8 * p.z};
  return mesh;
}

// The energy of the constraints of SolverConstraints after vertex displacements, times their factors.
double energyOf(const SolverConstraints& constraints, const std::vector<double>& factors,
                const std::vector<Vec3>& positions) {
  double sum = 0;
  for (uint32_t c = 0; c < constraints.count(); ++c) sum += factors[c] * constraints.energyAt(c, positions);
  return sum;
}

// A free body in a solver, with the constants of solver_models. Keeps a reference to the mesh.
struct FreeBody {
  SolverStiffness stiffness;
  SolverVibration vibration;

  FreeBody(const TriangleMesh& mesh, const SolverModel& model, Job& job)
      : stiffness(mesh, buildTopology(mesh), model, constantsOf(model, mesh)),
        vibration({mesh, stiffness, solverMasses(mesh, model.mass, constantsOf(model, mesh)), {}},
                  structureOf(stiffness, job)) {}
};

TEST(SolverStiffness, IsTheSecondDerivativeOfTheEnergy) {
  const TriangleMesh mesh = smallBody();
  const Topology topology = buildTopology(mesh);
  for (const auto& [name, model] : kModels) {
    if (model.bend == BendElement::Morley) continue;
    SCOPED_TRACE(name);
    const SolverConstants constants = constantsOf(model, mesh);
    const SolverStiffness stiffness(mesh, topology, model, constants);
    const SolverConstraints constraints(mesh, topology, model, constants);
    const std::vector<double> factors = uneven(stiffness);
    const SparsePencil pencil = stiffness.pencil(factors, std::vector<double>(mesh.vertexCount(), 1.0));
    Eigen::VectorXd u(pencil.unknownCount());
    for (Eigen::Index i = 0; i < u.size(); ++i) u[i] = std::sin(0.9 * static_cast<double>(i * i % 101));
    const auto energyAt = [&](double step) {
      std::vector<Vec3> positions(constraints.rest().begin(), constraints.rest().end());
      for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
        positions[v] += step * Vec3{u[3 * v], u[3 * v + 1], u[3 * v + 2]};
      return energyOf(constraints, factors, positions);
    };
    const double h = 1e-5, second = (energyAt(h) + energyAt(-h)) / (h * h);  // the energy at rest is 0
    EXPECT_NEAR(second, u.dot(pencil.k * u), 1e-6 * second);
  }
}

TEST(SolverStiffness, OfMorleysElementIsThatOfTheShell) {
  const TriangleMesh mesh = smallBody();
  const Topology topology = buildTopology(mesh);
  const double thickness = 0.03, poisson = 0.3, young = 2e5;
  const double plane = young * thickness / (1 - poisson * poisson);
  SolverConstants constants;
  constants.stretch = plane * (1 - poisson) / 2;
  constants.secondStretch = plane * poisson;
  constants.bend = plane * thickness * thickness / 12;
  constants.surfaceDensity = 1;
  const SolverModel model{StretchElement::Membrane, BendElement::Morley, MassRule::Area};
  const SolverStiffness stiffness(mesh, topology, model, constants);
  const SparsePencil pencil =
      stiffness.pencil(ones(stiffness), solverMasses(mesh, MassRule::Area, constants));
  const SparsePencil shell = shellPencil({mesh, topology, thickness, poisson});
  const Eigen::SparseMatrix<double> difference = pencil.k - young * shell.k;
  EXPECT_LT(difference.norm(), 1e-12 * pencil.k.norm());
  EXPECT_EQ(stiffness.stretchCount(), mesh.triangleCount());
  EXPECT_EQ(stiffness.count(), 2 * mesh.triangleCount());
}

TEST(SolverStiffness, LetsRigidMotionsPass) {
  const TriangleMesh mesh = smallBody();
  const Topology topology = buildTopology(mesh);
  for (const auto& [name, model] : kModels) {
    if (model.bend == BendElement::Morley) continue;  // its edges turn too
    SCOPED_TRACE(name);
    const SolverStiffness stiffness(mesh, topology, model, constantsOf(model, mesh));
    const SparsePencil pencil =
        stiffness.pencil(uneven(stiffness), std::vector<double>(mesh.vertexCount(), 1.0));
    const Eigen::MatrixXd rigid = rigidMotions(mesh);
    EXPECT_LT((pencil.k * rigid).norm(), 1e-12 * pencil.k.norm() * rigid.norm());
  }
}

TEST(SolverStiffness, HasExactlySixMotionsWithoutResistanceInEveryModel) {
  const TriangleMesh mesh = surfaces::bumpySphere();
  Job job;
  for (const auto& [name, model] : kModels) {
    SCOPED_TRACE(name);
    const auto& [stiffness, vibration] = FreeBody(mesh, model, job);
    const EigenSolution solution =
        vibration.solve(ones(stiffness), 10, vibration.estimate(job).firstEigenvalue, job);
    EXPECT_EQ(solution.nullity, 6u);
    EXPECT_EQ(vibration.estimate(job).noiseCount, 0u);
  }
}

TEST(SolverStiffness, IsLinearInItsFactors) {
  const TriangleMesh mesh = smallBody();
  const Topology topology = buildTopology(mesh);
  for (const auto& [name, model] : kModels) {
    SCOPED_TRACE(name);
    const SolverStiffness stiffness(mesh, topology, model, constantsOf(model, mesh));
    const std::vector<double> masses(mesh.vertexCount(), 1.0), a = uneven(stiffness), b = ones(stiffness);
    std::vector<double> sum(a.size());
    for (size_t c = 0; c < a.size(); ++c) sum[c] = 2 * a[c] + 3 * b[c];
    const Eigen::SparseMatrix<double> whole = stiffness.pencil(sum, masses).k,
                                      parts = 2 * stiffness.pencil(a, masses).k +
                                              3 * stiffness.pencil(b, masses).k;
    EXPECT_LT((whole - parts).norm(), 1e-12 * whole.norm());
  }
}

TEST(SolverStiffness, EnergiesAreTheDerivativesOfEigenvalues) {
  const TriangleMesh mesh = smallBody();
  const Topology topology = buildTopology(mesh);
  Job job;
  for (const auto& [name, model] : kModels) {
    SCOPED_TRACE(name);
    const SolverConstants constants = constantsOf(model, mesh);
    const SolverStiffness stiffness(mesh, topology, model, constants);
    const auto structure = structureOf(stiffness, job);
    const std::vector<double> masses = solverMasses(mesh, model.mass, constants);
    const auto solve = [&](const std::vector<double>& factors) {
      EigenOptions options;
      options.pairCount = 6;
      options.scale = 1e3;
      options.structure = structure;
      return solveEigenproblem(stiffness.pencil(factors, masses), options, job).basis;
    };
    const std::vector<double> factors = uneven(stiffness);
    const ModeBasis basis = solve(factors);
    const Eigen::MatrixXd energies = stiffness.energies(basis.phi);
    const Eigen::RowVectorXd whole =
        Eigen::Map<const Eigen::VectorXd>(factors.data(), stiffness.count()).transpose() * energies;
    for (Eigen::Index i = 0; i < 6; ++i) EXPECT_NEAR(whole[i], basis.lambda[i], 1e-6 * basis.lambda[i]);
    // A bundle of constraints of both kinds changes by different amounts.
    std::vector<double> direction(factors.size()), more = factors, less = factors;
    for (size_t c = 0; c < direction.size(); ++c) direction[c] = std::cos(0.37 * static_cast<double>(c));
    const double h = 1e-4;
    for (size_t c = 0; c < direction.size(); ++c) {
      more[c] += h * direction[c];
      less[c] -= h * direction[c];
    }
    const Eigen::VectorXd differences = (solve(more).lambda - solve(less).lambda) / (2 * h);
    const Eigen::RowVectorXd derivatives =
        Eigen::Map<const Eigen::VectorXd>(direction.data(), stiffness.count()).transpose() * energies;
    for (Eigen::Index i = 0; i < 6; ++i)
      EXPECT_NEAR(differences[i], derivatives[i], 1e-5 * basis.lambda[i]) << "mode " << i;
  }
}

TEST(SolverStiffness, FollowsTheUnitOfTheMesh) {
  TriangleMesh mesh = smallBody();
  const SolverModel model{StretchElement::Membrane, BendElement::Morley, MassRule::Area};
  SolverConstants constants = constantsOf(model, mesh);
  const SolverStiffness inMetres(mesh, buildTopology(mesh), model, constants);
  for (Vec3& p : mesh.positions) p *= 1000;
  constants.unit = 1e-3;
  const SolverStiffness inMillimetres(mesh, buildTopology(mesh), model, constants);
  const std::vector<double> masses(mesh.vertexCount(), 1.0);
  const Eigen::SparseMatrix<double> a = inMetres.pencil(ones(inMetres), masses).k,
                                    b = inMillimetres.pencil(ones(inMillimetres), masses).k;
  EXPECT_LT((a - b).norm(), 1e-9 * a.norm());
}

// Calls check(stiffness, vibration) for a free body in every model.
template <class Check>
void forEveryFreeBody(Job& job, const Check& check) {
  const TriangleMesh mesh = surfaces::bumpySphere();
  for (const auto& [name, model] : kModels) {
    SCOPED_TRACE(name);
    const auto& [stiffness, vibration] = FreeBody(mesh, model, job);
    check(stiffness, vibration);
  }
}

ModeBasis solved(const SolverStiffness& stiffness, const SolverVibration& vibration, int count, Job& job) {
  return vibration.solve(ones(stiffness), count, vibration.estimate(job).firstEigenvalue, job).basis;
}

void expectNear(const ModeBasis& found, const ModeBasis& expected) {
  for (Eigen::Index i = 0; i < 12; ++i)
    EXPECT_NEAR(found.lambda[i] / expected.lambda[i], 1, 1e-3) << "mode " << i;
}

TEST(SolverVibration, FollowsModesFromNearOnes) {
  Job job;
  forEveryFreeBody(job, [&](const auto& stiffness, const auto& vibration) {
    const ModeBasis start = solved(stiffness, vibration, 12, job);
    expectNear(vibration.follow(uneven(stiffness), start, 12, job),
               vibration.solve(uneven(stiffness), 12, start.lambda[0], job).basis);
  });
}

// The modes without `count` of them, from mode `first` on.
ModeBasis without(const ModeBasis& modes, Eigen::Index first, Eigen::Index count) {
  const Eigen::Index rest = modes.modeCount() - first - count;
  ModeBasis some{Eigen::VectorXd(first + rest), Eigen::MatrixXd(modes.phi.rows(), first + rest)};
  some.lambda << modes.lambda.head(first), modes.lambda.tail(rest);
  some.phi << modes.phi.leftCols(first), modes.phi.rightCols(rest);
  return some;
}

TEST(SolverVibration, FindsWhatIsMissingInAStart) {
  Job job;
  forEveryFreeBody(job, [&](const auto& stiffness, const auto& vibration) {
    const ModeBasis start = solved(stiffness, vibration, 18, job),
                    expected = vibration.solve(uneven(stiffness), 12, start.lambda[0], job).basis;
    for (const int missing : {1, 3}) {
      const EigenSolution found =
          vibration.solveFrom(without(start, 4, missing), {uneven(stiffness), 12}, job);
      EXPECT_EQ(found.nullity, 6u);
      expectNear(found.basis, expected);
    }
  });
}

TEST(SolverVibration, FindsWhatIsMissingInAStartOfAPinnedBody) {
  const TriangleMesh mesh = surfaces::bumpySphere();
  std::vector<uint32_t> pinned;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    if (mesh.positions[v].y < -0.6) pinned.push_back(v);
  Job job;
  for (const auto& [name, model] : kModels) {
    SCOPED_TRACE(name);
    const SolverConstants constants = constantsOf(model, mesh);
    const SolverStiffness stiffness(mesh, buildTopology(mesh), model, constants);
    const SolverVibration vibration({mesh, stiffness, solverMasses(mesh, model.mass, constants), pinned},
                                    structureOf(stiffness, job));
    const ModeBasis start = solved(stiffness, vibration, 18, job);
    for (const int first : {0, 5})
      expectNear(vibration.solveFrom(without(start, first, 2), {ones(stiffness), 12}, job).basis, start);
  }
}

TEST(SolverVibration, SolvesFromScratchWhereARefinementDoesNotFitIntoMemory) {
  const TriangleMesh mesh = surfaces::bumpySphere();
  Job job;
  const auto& [stiffness, vibration] = FreeBody(mesh, kModels[0].second, job);
  const ModeBasis start = solved(stiffness, vibration, 18, job);
  const uint64_t vector = static_cast<uint64_t>(stiffness.unknownCount()) * sizeof(double);
  setMemoryLimit(structureOf(stiffness, job)->memory() + 180 * vector);
  const EigenSolution found = vibration.solveFrom(start, {ones(stiffness), 12}, job);
  setMemoryLimit(0);
  expectNear(found.basis, start);
}

TEST(SolverVibration, EstimatesTheFirstEigenvalue) {
  Job job;
  forEveryFreeBody(job, [&](const auto& stiffness, const auto& vibration) {
    const double rough = vibration.estimate(job).firstEigenvalue;
    const double first = vibration.solve(ones(stiffness), 12, rough, job).basis.lambda[0];
    EXPECT_GT(rough, 0.1 * first);
    EXPECT_LT(rough, 10 * first);
  });
}

TEST(SolverVibration, FindsAFlatSheetOfSpringsWithoutResistance) {
  const TriangleMesh mesh = surfaces::inFloats(shapes::grid(12, 9, 1.3, 0.9));
  const SolverModel springs{StretchElement::EdgeSprings, BendElement::CrossSprings, MassRule::Area};
  Job job;
  const auto& [stiffness, vibration] = FreeBody(mesh, springs, job);
  // Every vertex moves out of the plane without resistance; three of these motions are rigid.
  EXPECT_GE(vibration.estimate(job).noiseCount, mesh.vertexCount() - 3);
}

// Each sheet but one swings about the shared edge. Hinges only span edges with two triangles, Morley's
// element all edges.
TEST(SolverVibration, CountsSheetsThatSwingAboutAnEdge) {
  Job job;
  for (const int sheets : {3, 7}) {
    const TriangleMesh mesh = surfaces::inFloats(surfaces::sheetsAroundAnEdge(sheets, 4));
    for (const auto& [name, model] : kModels) {
      if (model.bend == BendElement::CrossSprings) continue;
      SCOPED_TRACE(name);
      const auto& [stiffness, vibration] = FreeBody(mesh, model, job);
      const bool isMorley = model.bend == BendElement::Morley;
      EXPECT_EQ(vibration.estimate(job).noiseCount, isMorley ? 0u : sheets - 1u);
    }
  }
}

// Two sheets that share a corner rotate about it in three ways.
TEST(SolverVibration, CountsSheetsThatTurnAboutAVertex) {
  Job job;
  TriangleMesh mesh = shapes::grid(6, 6);
  const uint32_t last = mesh.vertexCount() - 1;
  const TriangleMesh sheet = mesh;
  for (uint32_t v = 1; v <= last; ++v) mesh.positions.push_back(sheet.positions[v] + sheet.positions[last]);
  for (Triangle t : sheet.triangles) {
    for (uint32_t& v : t) v += last;
    mesh.triangles.push_back(t);
  }
  for (const auto& [name, model] : kModels) {
    if (model.bend == BendElement::CrossSprings) continue;
    SCOPED_TRACE(name);
    const auto& [stiffness, vibration] = FreeBody(mesh, model, job);
    EXPECT_EQ(vibration.estimate(job).noiseCount, 3u);
  }
}

TEST(SolverStiffness, IsTheSameToTheBitForAnyNumberOfThreads) {
  const TriangleMesh mesh = shapes::sphere(4);
  for (const auto& [name, model] : kModels) {
    SCOPED_TRACE(name);
    const SolverStiffness stiffness(mesh, buildTopology(mesh), model, constantsOf(model, mesh));
    const std::vector<double> masses(mesh.vertexCount(), 1.0);
    const Eigen::SparseMatrix<double> one = stiffness.pencil(uneven(stiffness), masses).k;
    setThreadCount(4);
    const Eigen::SparseMatrix<double> four = stiffness.pencil(uneven(stiffness), masses).k;
    setThreadCount(1);
    EXPECT_TRUE(one.coeffs().isApprox(four.coeffs(), 0));
    EXPECT_EQ(Eigen::SparseMatrix<double>(one - Eigen::SparseMatrix<double>(one.transpose())).norm(), 0);
  }
}

}  // namespace
}  // namespace limber
