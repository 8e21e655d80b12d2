#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <stdexcept>
#include <thread>

#include "base/parallel.h"
#include "elastic/laplacian.h"
#include "elastic/modes.h"
#include "elastic/shell.h"
#include "linear/eigensolver.h"
#include "linear/factorisation.h"
#include "linear/ordering/front_tree.h"
#include "linear/ordering/ordering.h"
#include "shapes.h"

namespace limber {
namespace {

SparsePencil shellOf(const TriangleMesh& mesh) {
  return shellPencil({mesh, buildTopology(mesh), 0.02, 0.3});
}

Eigen::VectorXd anyVector(Eigen::Index size) {
  Eigen::VectorXd x(size);
  for (Eigen::Index i = 0; i < size; ++i) x[i] = std::sin(1.7 * static_cast<double>(i) + 0.3);
  return x;
}

TEST(EliminationOrder, takesEveryNodeOnceAndItsFrontsPointOnlyForwards) {
  const TriangleMesh torus = shapes::torus(20, 10);
  for (const TriangleMesh& mesh : {torus, shapes::together(shapes::sphere(3), torus), shapes::grid(1, 1)}) {
    const SparsePencil pencil = shellOf(mesh);
    const NodeGraph graph = nodeGraph(pencil);
    Job job;
    const std::vector<FrontNodes> fronts = buildFrontTree(graph, eliminationOrder(graph, job), job);
    std::vector<uint32_t> frontOf(pencil.nodeCount(), UINT32_MAX);
    for (uint32_t f = 0; f < fronts.size(); ++f) {
      for (uint32_t node : fronts[f].pivots) {
        EXPECT_EQ(frontOf[node], UINT32_MAX);
        frontOf[node] = f;
      }
      for (uint32_t child : fronts[f].children) EXPECT_LT(child, f);
    }
    for (uint32_t f = 0; f < fronts.size(); ++f)
      for (uint32_t node : fronts[f].boundary) EXPECT_GT(frontOf[node], f);
    EXPECT_EQ(std::count(frontOf.begin(), frontOf.end(), UINT32_MAX), 0);
  }
}

// No separator divides nodes that are all coupled with each other, whatever their number.
TEST(EliminationOrder, takesEveryNodeOfAMeshWhoseVerticesAreAllNeighbours) {
  for (const uint32_t vertexCount : {11u, 24u, 70u}) {
    TriangleMesh mesh;
    for (uint32_t v = 0; v < vertexCount; ++v)
      mesh.positions.push_back({1.0 * v, 1.0 * v * v, 0.1 * v * v * v});
    for (uint32_t a = 0; a < vertexCount; ++a)
      for (uint32_t b = a + 1; b + 1 < vertexCount; ++b) mesh.triangles.push_back({a, b, b + 1});
    Job job;
    std::vector<uint32_t> order = eliminationOrder(nodeGraph(shellPattern(mesh, buildTopology(mesh))), job);
    std::ranges::sort(order);
    EXPECT_EQ(std::ranges::adjacent_find(order), order.end());
    EXPECT_EQ(order.size(), vertexCount + buildTopology(mesh).edges.size());
  }
}

// Sets of thousands of nodes are cut on several threads.
TEST(EliminationOrder, isTheSameForAnyNumberOfThreads) {
  const TriangleMesh mesh = shapes::grid(80, 80);
  const NodeGraph graph = nodeGraph(shellPattern(mesh, buildTopology(mesh)));
  Job job;
  const std::vector<uint32_t> expected = eliminationOrder(graph, job);
  std::vector<uint32_t> sorted = expected;
  std::ranges::sort(sorted);
  EXPECT_EQ(std::ranges::adjacent_find(sorted), sorted.end());
  EXPECT_EQ(sorted.size(), graph.nodeCount());
  for (const int threads : {2, 3}) {
    setThreadCount(threads);
    EXPECT_EQ(eliminationOrder(graph, job), expected) << threads;
  }
  setThreadCount(1);
}

TEST(Factorisation, countsTheNonzerosThatAnEliminationLeaves) {
  // Compared with a symbolic elimination of the matrix, entry by entry, in the order of the factorisation.
  const SparsePencil pencil = shellOf(shapes::torus(12, 7));
  const NodeGraph graph = nodeGraph(pencil);
  Job job;
  const std::vector<FrontNodes> fronts = buildFrontTree(graph, eliminationOrder(graph, job), job);
  std::vector<uint32_t> order;
  for (const FrontNodes& front : fronts) order.insert(order.end(), front.pivots.begin(), front.pivots.end());
  std::vector<std::set<uint32_t>> later(graph.nodeCount());
  std::vector<uint32_t> position(graph.nodeCount());
  for (uint32_t p = 0; p < order.size(); ++p) position[order[p]] = p;
  for (uint32_t i = 0; i < graph.nodeCount(); ++i)
    for (uint32_t j : graph.around(i))
      if (position[j] > position[i]) later[position[i]].insert(position[j]);
  uint64_t expected = 0;
  for (uint32_t p = 0; p < order.size(); ++p) {
    const uint64_t weight = graph.weight[order[p]];
    expected += weight * (weight + 1) / 2;
    for (uint32_t q : later[p]) expected += weight * graph.weight[order[q]];
    if (later[p].empty()) continue;
    const uint32_t parent = *later[p].begin();
    later[parent].insert(std::next(later[p].begin()), later[p].end());
  }
  EXPECT_EQ(Factorisation(pencil, job).structure().nonzeros(), expected);
}

TEST(EliminationOrder, keepsTheFactorOfARegularSheetNearNestedDissectionsOwn) {
  // 31 n log2(n) / 4 is George's bound for a square grid with n nodes. Three unknowns per node make nine
  // entries of each entry.
  const SparsePencil pencil = shellOf(shapes::grid(48, 48));
  Job job;
  const double n = 49 * 49;
  EXPECT_LT(static_cast<double>(Factorisation(pencil, job).structure().nonzeros()),
            9 * 31 * n * std::log2(n) / 4);
}

// Also in wasm, where a size has 32 bits: a size beyond the memory must not overflow to a small one.
TEST(Factorisation, knowsHowManyBytesItTakesHoweverManyTheseAre) {
  FactorStructure structure;
  structure.valueCount = uint64_t{1} << 33;
  structure.workRows = structure.unknownCount = 1000;
  EXPECT_EQ(structure.memory(), sizeof(double) * ((uint64_t{1} << 33) + 2000));
}

TEST(Factorisation, takesTheStructureOfAPencilThatDiffersInValuesAlone) {
  const TriangleMesh mesh = shapes::torus(14, 9), moved = shapes::jittered(mesh, 0.1, 3);
  const SparsePencil pencil = shellOf(mesh), other = shellOf(moved);
  Job job;
  const auto structure = std::make_shared<const FactorStructure>(factorStructure(pencil, job));
  Factorisation given(other, structure), own(other, job);
  given.factorise(-0.01, job);
  own.factorise(-0.01, job);
  Eigen::VectorXd x = anyVector(other.unknownCount()), y = x;
  given.solve(x, job);
  own.solve(y, job);
  EXPECT_LT((x - y).norm(), 1e-9 * y.norm());
}

TEST(Factorisation, solvesAsADenseSolverDoes) {
  for (const TriangleMesh& mesh : {shapes::grid(6, 5), shapes::jittered(shapes::sphere(2), 0.05, 1)}) {
    const SparsePencil pencil = shellOf(mesh);
    const double shift = -0.01;
    Job job;
    Factorisation factorisation(pencil, job);
    factorisation.factorise(shift, job);
    Eigen::MatrixXd dense = pencil.k;
    dense.diagonal() -= shift * pencil.m;
    const Eigen::VectorXd b = anyVector(pencil.m.size());
    Eigen::VectorXd x = b;
    factorisation.solve(x, job);
    EXPECT_LT((dense * x - b).norm(), 1e-8 * b.norm());
    EXPECT_LT((x - dense.ldlt().solve(b)).norm(), 1e-6 * x.norm());
    EXPECT_EQ(factorisation.negativePivots(), 0u);
  }
}

TEST(Factorisation, refusesPivotsThatAreNotFinite) {
  const SparsePencil pencil = shellOf(shapes::grid(6, 5));
  Job job;
  for (const double shift : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    Factorisation factorisation(pencil, job);
    EXPECT_THROW(factorisation.factorise(shift, job), std::runtime_error);
  }
}

TEST(Factorisation, countsTheEigenvaluesBelowAShift) {
  const SparsePencil pencil = shellOf(shapes::jittered(shapes::grid(5, 4), 0.02, 2));
  // All unknowns get the mass 1 here, so that a dense solver gives the eigenvalues.
  SparsePencil massive = pencil;
  massive.m.setOnes();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> dense(Eigen::MatrixXd(massive.k));
  Job job;
  Factorisation factorisation(massive, job);
  for (int below : {6, 9, 20, 60}) {
    const double shift = (dense.eigenvalues()[below - 1] + dense.eigenvalues()[below]) / 2;
    factorisation.factorise(shift, job);
    EXPECT_EQ(factorisation.negativePivots(), (dense.eigenvalues().array() < shift).count());
  }
}

TEST(Factorisation, isTheSameToTheBitForAnyNumberOfThreads) {
  const SparsePencil pencil = shellOf(shapes::sphere(4));
  const auto solveWith = [&](int threads) {
    setThreadCount(threads);
    Job job;
    Factorisation factorisation(pencil, job);
    factorisation.factorise(-0.1, job);
    setThreadCount(1);
    Eigen::VectorXd x = anyVector(pencil.m.size());
    factorisation.solve(x, job);
    return x;
  };
  const Eigen::VectorXd one = solveWith(1);
  EXPECT_TRUE(solveWith(2) == one);
  EXPECT_TRUE(solveWith(4) == one);
}

TEST(LaplacianModes, ofAPathOfSquaresAreCosines) {
  // The scalar modes of a long strip vary along it and are listed once per axis.
  Job job;
  const TriangleMesh strip = shapes::grid(60, 3, 20, 1);
  const ModeSet set = computeModes(strip, {ElasticModel::Laplacian, 6, unitMaterial(0.1)}, job);
  EXPECT_EQ(set.components[0].zeroModesExpected, 3u);
  EXPECT_EQ(set.components[0].zeroModesFound, 3u);
  ASSERT_EQ(set.modes.size(), 6u);
  for (int k = 0; k < 6; ++k) {
    EXPECT_EQ(set.modes[k].axis, k % 3);
    EXPECT_LE(set.modes[k].residual, 1e-7);
  }
  EXPECT_NEAR(set.modes[3].omega / set.modes[0].omega, 2, 0.05);
  // The shortest principal axis is the normal of the strip, so mode 1 moves along z only, like cos(pi x / L).
  const uint32_t n = strip.vertexCount();
  for (uint32_t v = 0; v < n; ++v) {
    EXPECT_NEAR(set.shapes[3 * v], 0, 1e-6);
    EXPECT_NEAR(std::abs(set.shapes[3 * v + 2]),
                std::abs(std::cos(std::numbers::pi * strip.positions[v].x / 20)), 0.05);
  }
}

// Most modes of a torus come in pairs, of which a single start vector finds only one.
TEST(RoughSearch, missesNoPairAndIsGoodToFourDigits) {
  TriangleMesh mesh = shapes::torus(24, 12);
  const double diagonal = bounds(mesh).diagonal();
  for (Vec3& p : mesh.positions) p = p / diagonal;
  const SparsePencil pencil = shellOf(mesh);
  Job job;
  EigenOptions options{20, 6, roughFirstEigenvalue(0.02, false)};
  const EigenSolution exact = solveEigenproblem(pencil, options, job);
  options.isRough = true;
  const EigenSolution rough = solveEigenproblem(pencil, options, job);
  EXPECT_TRUE(rough.residual.empty());
  ASSERT_EQ(rough.basis.lambda.size(), 20);
  for (Eigen::Index k = 0; k < 20; ++k)
    EXPECT_NEAR(rough.basis.lambda[k], exact.basis.lambda[k], 1e-4 * exact.basis.lambda[k]) << k;
}

// 2,500 equal oscillators, of which a single start vector finds one: inertia counts all others as missing. A
// search for all of them at once would take hours.
TEST(RoughSearch, looksForAFewOfThousandsOfMissingPairsAtATime) {
  constexpr int kCount = 3000, kEqual = 2500;
  SparsePencil pencil;
  pencil.k.resize(kCount, kCount);
  pencil.m = Eigen::VectorXd::Ones(kCount);
  pencil.firstUnknown = {0};
  for (int i = 0; i < kCount; ++i) {
    pencil.k.insert(i, i) = i < kEqual ? 1 : i - kEqual + 2;
    pencil.firstUnknown.push_back(static_cast<uint32_t>(i + 1));
  }
  pencil.k.makeCompressed();
  Job job;
  EigenOptions options{12, 0, 1};
  options.isRough = true;
  const EigenSolution found = solveEigenproblem(pencil, options, job);
  ASSERT_EQ(found.basis.lambda.size(), 12);
  for (Eigen::Index k = 0; k < 12; ++k) EXPECT_NEAR(found.basis.lambda[k], 1, 1e-4) << k;
  const Eigen::MatrixXd product = found.basis.phi.transpose() * found.basis.phi;
  EXPECT_LT((product - Eigen::MatrixXd::Identity(12, 12)).norm(), 1e-6);
}

// Pairs of equal masses, each joined by a spring of another stiffness and free to move: the eigenvalues are 0
// and twice the stiffness.
SparsePencil loosePairs(int count) {
  SparsePencil pencil;
  pencil.k.resize(2 * count, 2 * count);
  pencil.m = Eigen::VectorXd::Ones(2 * count);
  pencil.firstUnknown = {0};
  for (int i = 0; i < count; ++i) {
    const double k = 1 + 0.01 * i;
    pencil.k.insert(2 * i, 2 * i) = pencil.k.insert(2 * i + 1, 2 * i + 1) = k;
    pencil.k.insert(2 * i, 2 * i + 1) = pencil.k.insert(2 * i + 1, 2 * i) = -k;
    for (const int end : {1, 2}) pencil.firstUnknown.push_back(static_cast<uint32_t>(2 * i + end));
  }
  pencil.k.makeCompressed();
  return pencil;
}

TEST(Eigensolver, countsAZeroEigenvalueAsOftenAsItIsRepeated) {
  Job job;
  for (const int count : {70, 400})
    for (const bool isRough : {false, true})
      for (const double scale : {1.0, 0.01, 100.0}) {
        SCOPED_TRACE(testing::Message() << count << " zeros, scale " << scale << ", rough " << isRough);
        EigenOptions options{5, 6, scale};
        options.isRough = isRough;
        const EigenSolution found = solveEigenproblem(loosePairs(count), options, job);
        EXPECT_EQ(found.nullity, static_cast<uint32_t>(count));
        ASSERT_EQ(found.basis.lambda.size(), 5);
        for (int k = 0; k < 5; ++k) EXPECT_NEAR(found.basis.lambda[k], 2 + 0.02 * k, 2e-4);
      }
}

TEST(Eigensolver, countsAPencilOfZerosAlone) {
  SparsePencil pencil = loosePairs(100);
  pencil.k.coeffs().setZero();
  Job job;
  const EigenSolution found = solveEigenproblem(pencil, {5, 6, 1}, job);
  EXPECT_EQ(found.nullity, 200u);
  EXPECT_EQ(found.basis.lambda.size(), 0);
}

// With a shift of that size all of the lowest eigenvalues look like zeros.
TEST(Eigensolver, findsEigenvaluesFarBelowTheScale) {
  Job job;
  const TriangleMesh strip = shapes::grid(60, 3, 20, 1);
  const SparsePencil pencil = laplacianPencil(strip, buildTopology(strip));
  const EigenSolution expected = solveEigenproblem(pencil, {5, 1, 1e-2}, job);
  for (const double scale : {1e4, 1e8}) {
    const EigenSolution found = solveEigenproblem(pencil, {5, 1, scale}, job);
    EXPECT_EQ(found.nullity, 1u);
    ASSERT_EQ(found.basis.lambda.size(), 5);
    for (int k = 0; k < 5; ++k)
      EXPECT_NEAR(found.basis.lambda[k], expected.basis.lambda[k], 1e-8 * expected.basis.lambda[k]);
  }
}

TEST(ShellModes, areTheSameToTheBitForAnyNumberOfThreads) {
  const TriangleMesh mesh = shapes::jittered(shapes::torus(24, 12), 0.01, 6);
  const auto shapesWith = [&](int threads) {
    setThreadCount(threads);
    Job job;
    const auto shapes = computeModes(mesh, {ElasticModel::Shell, 8, unitMaterial(0.05)}, job).shapes;
    setThreadCount(1);
    return shapes;
  };
  const auto one = shapesWith(1);
  EXPECT_EQ(shapesWith(2), one);
  EXPECT_EQ(shapesWith(4), one);
}

#if LIMBER_THREADS
TEST(ShellModes, areCancelledFromAnotherThread) {
  Job job;
  std::thread other([&] {
    while (job.words[1].load() != static_cast<int32_t>(Phase::Factorise)) std::this_thread::yield();
    job.requestCancel();
  });
  EXPECT_THROW(computeModes(shapes::sphere(5), {ElasticModel::Shell, 12, unitMaterial(0.02)}, job),
               Cancelled);
  other.join();
}
#endif

}  // namespace
}  // namespace limber
