#include "modes/find_modes.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "base/memory.h"
#include "base/parallel.h"
#include "elastic/displacement.h"
#include "elastic/part_modes.h"
#include "elastic/pins.h"
#include "fields/guidance.h"
#include "mesh/eigen_vec3.h"
#include "mesh/topology.h"
#include "modes/coarse_part.h"
#include "shapes.h"

namespace limber {
namespace {

// A bumpy torus of 9,600 vertices: above the limit of the exact solve.
TriangleMesh largeMesh() {
  TriangleMesh mesh = shapes::torus(160, 60);
  for (Vec3& p : mesh.positions) p *= 1 + 0.05 * std::sin(5 * p.x) * std::cos(4 * p.y + p.z);
  return mesh;
}

ModesOptions shellOptions(const TriangleMesh& mesh, int modeCount) {
  return {ElasticModel::Shell, modeCount, {1e6, 0.3, 1000, 0.02 * bounds(mesh).diagonal(), 1}};
}

Eigen::MatrixXd columnsOf(const ModeSet& set, size_t vertexCount) {
  const auto rows = static_cast<Eigen::Index>(3 * vertexCount);
  Eigen::MatrixXd columns =
      Eigen::Map<const Eigen::MatrixXf>(set.shapes.data(), rows, set.modesPerComponent).cast<double>();
  return columns.colwise().normalized();
}

TEST(CoarseSolve, agreesWithTheExactOne) {
  const TriangleMesh mesh = largeMesh();
  Job job;
  setThreadCount(2);
  const ModeSet coarse = findModes(mesh, shellOptions(mesh, 6), false, job);
  const ModeSet exact = findModes(mesh, shellOptions(mesh, 6), true, job);
  setThreadCount(1);
  EXPECT_EQ(exact.components[0].coarseVertices, 0u);
  EXPECT_GE(coarse.components[0].coarseVertices, 7900u);
  EXPECT_EQ(coarse.components[0].zeroModesFound, 6u);
  ASSERT_EQ(coarse.modes.size(), 6u);
  const Eigen::MatrixXd a = columnsOf(coarse, mesh.vertexCount()), b = columnsOf(exact, mesh.vertexCount());
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(b);
  const Eigen::MatrixXd basis = qr.householderQ() * Eigen::MatrixXd::Identity(b.rows(), b.cols());
  for (Eigen::Index k = 0; k < 6; ++k) {
    const auto i = static_cast<size_t>(k);
    EXPECT_NEAR(coarse.modes[i].omega / exact.modes[i].omega, 1, 1e-3);
    EXPECT_GT((basis.transpose() * a.col(k)).squaredNorm(), 0.999);
  }
}

TEST(CoarseSolve, carriesPinsOver) {
  const TriangleMesh mesh = shapes::grid(100, 90, 1, 0.9);
  ModesOptions options = shellOptions(mesh, 3);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    if (mesh.positions[v].x < 0.05) options.pinned.push_back(v);
  Job job;
  const ModeSet coarse = findModes(mesh, options, false, job), exact = findModes(mesh, options, true, job);
  EXPECT_GT(coarse.components[0].coarseVertices, 0u);
  EXPECT_EQ(coarse.components[0].zeroModesExpected, 0u);
  EXPECT_EQ(coarse.components[0].zeroModesFound, 0u);
  for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(coarse.modes[k].omega / exact.modes[k].omega, 1, 1e-3);
  for (uint32_t v : options.pinned)
    for (size_t c = 0; c < 3; ++c) EXPECT_EQ(coarse.shapes[3 * v + c], 0.0f);
}

// Three corners of a triangle, two vertices and a straight edge of a curved sheet: 0, 1 and 1 rigid motions.
TEST(CoarseSolve, leavesTheRigidMotionsThatThePinsLeave) {
  TriangleMesh mesh = shapes::grid(100, 90, 1, 0.9);
  for (Vec3& p : mesh.positions) p.z = 0.3 * p.x * p.x * std::cos(2 * p.y);
  const uint32_t middle = mesh.vertexCount() / 2;
  std::vector<uint32_t> edge;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    if (mesh.positions[v].x == 0) edge.push_back(v);
  const Triangle* corners = nullptr;
  for (const Triangle& t : mesh.triangles)
    if (t[0] == middle) corners = &t;
  ASSERT_NE(corners, nullptr);
  const std::vector<std::vector<uint32_t>> pins = {
      {corners->begin(), corners->end()}, {middle, (*corners)[1]}, edge};
  for (const std::vector<uint32_t>& pinned : pins) {
    SCOPED_TRACE(pinned.size());
    ModesOptions options = shellOptions(mesh, 3);
    options.pinned = pinned;
    Job job;
    const ModeSet coarse = findModes(mesh, options, false, job), exact = findModes(mesh, options, true, job);
    EXPECT_GT(coarse.components[0].coarseVertices, 0u);
    EXPECT_EQ(coarse.components[0].zeroModesExpected, exact.components[0].zeroModesExpected);
    EXPECT_EQ(coarse.components[0].zeroModesFound, exact.components[0].zeroModesFound);
    for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(coarse.modes[k].omega / exact.modes[k].omega, 1, 1e-3);
  }
}

// A copy so coarse that adjacent pins have been merged into one vertex.
TEST(CoarsePart, leavesTheRigidMotionsThatThePinsLeave) {
  TriangleMesh mesh = shapes::grid(60, 50, 1, 0.9);
  for (Vec3& p : mesh.positions) p.z = 0.3 * p.x * p.x * std::cos(2 * p.y);
  Job job;
  size_t merged = 0;
  for (uint32_t t = 0; t < mesh.triangleCount(); t += 97)
    for (const size_t count : {3u, 2u}) {
      Part part;
      part.model = ElasticModel::Shell;
      part.mesh = mesh;
      part.pinned.assign(mesh.triangles[t].begin(), mesh.triangles[t].begin() + count);
      const CoarsePart coarse = coarsen(part, 300, job);
      std::set<uint32_t> own;
      for (const uint32_t v : part.pinned) own.insert(coarse.vertexOfInput[v]);
      EXPECT_EQ(rigidMotionsLeft(coarse.part.mesh, coarse.part.pinned), count == 3 ? 0u : 1u);
      EXPECT_LE(coarse.part.pinned.size(), count);
      if (own.size() < count) ++merged;
    }
  EXPECT_GT(merged, 20u);
}

TEST(SmallParts, areSolvedInParallelWithTheSameResultAndRisingProgress) {
  TriangleMesh mesh = shapes::torus(90, 50);  // above the limit of small parts
  for (int i = 0; i < 5; ++i) {
    TriangleMesh box = shapes::box(3 + i, 2, 2, 0.2);
    for (Vec3& p : box.positions) p.x += 3 + 2 * i;
    mesh = shapes::together(mesh, box);
  }
  const ModesOptions options = shellOptions(mesh, 4);
  const auto solve = [&](int threads, std::vector<double>& progress) {
    Job job;
    job.observer = [&](Phase, double fraction) { progress.push_back(fraction); };
    setThreadCount(threads);
    ModeSet set = findModes(mesh, options, false, job);
    setThreadCount(1);
    return set;
  };
  std::vector<double> alone, together;
  const ModeSet one = solve(1, alone), four = solve(4, together);
  ASSERT_EQ(one.components.size(), 6u);
  EXPECT_EQ(one.shapes, four.shapes);
  ASSERT_EQ(one.modes.size(), 24u);
  for (size_t k = 0; k < one.modes.size(); ++k) EXPECT_EQ(one.modes[k].omega, four.modes[k].omega);
  EXPECT_TRUE(std::is_sorted(alone.end() - 5, alone.end()));
  EXPECT_EQ(alone.back(), 1);
}

// Of the first four modes of each component.
std::vector<float> strainRank(const TriangleMesh& mesh, const ModeSet& set) {
  Job job;
  std::vector<double> omega(set.components.size() * set.modesPerComponent);
  for (const Mode& mode : set.modes)
    omega[mode.component * set.modesPerComponent + mode.ordinal] = mode.omega;
  return strainGuidance(mesh, set.shapes, omega, {.ordinals = {0, 1, 2, 3}, .weights = {}}, job).rank;
}

double correlation(const std::vector<float>& a, const std::vector<float>& b) {
  const auto centred = [](const std::vector<float>& values) {
    const Eigen::VectorXd all =
        Eigen::Map<const Eigen::VectorXf>(values.data(), static_cast<Eigen::Index>(values.size()))
            .cast<double>();
    return Eigen::VectorXd(all.array() - all.mean());
  };
  const Eigen::VectorXd x = centred(a), y = centred(b);
  return x.dot(y) / (x.norm() * y.norm());
}

TEST(ModesThatGuide, comeFromACopyThatRanksStrainAlike) {
  Job job;
  TriangleMesh sheet = shapes::grid(60, 40, 1.5, 1);
  for (Vec3& p : sheet.positions) p.z = 0.1 * std::sin(4 * p.x) * std::cos(3 * p.y);
  ModesOptions options = shellOptions(sheet, 4);
  const ModeSet own = findModes(sheet, options, false, job);
  options.guidedParts = 1;
  const ModeSet guiding = findModes(sheet, options, false, job);
  EXPECT_EQ(own.components[0].coarseVertices, 0u);
  EXPECT_NEAR(guiding.components[0].coarseVertices, 1000, 50);
  EXPECT_EQ(guiding.components[0].zeroModesFound, 6u);
  for (size_t k = 0; k < 4; ++k) EXPECT_NEAR(guiding.modes[k].omega / own.modes[k].omega, 1, 0.02);
  EXPECT_GT(correlation(strainRank(sheet, own), strainRank(sheet, guiding)), 0.9);
  EXPECT_EQ(findModes(sheet, options, true, job).components[0].coarseVertices, 0u);
}

TEST(ModesThatGuide, comeFromALatticeNoFinerThanTheTriangles) {
  const auto cells = [](int boxCells, uint32_t guidedParts) {
    Part part;
    part.mesh = shapes::box(boxCells, boxCells, boxCells, 1.0 / boxCells);  // 12 boxCells^2 triangles
    ModesOptions options;
    options.guidedParts = guidedParts;
    return latticeCells(part, options);
  };
  for (const int size : {2, 6, 30}) EXPECT_EQ(cells(size, 0), cells(2, 0)) << "modes for their own sake";
  EXPECT_EQ(cells(2, 1), 64u);
  EXPECT_NEAR(cells(6, 1), std::pow(2 * 36, 1.5), 1);
  EXPECT_EQ(cells(30, 1), 1200u);
  EXPECT_EQ(cells(6, 50), cells(6, 1));
}

TEST(ExactSolve, refusesBeforeItTakesMoreMemoryThanThereIs) {
  const TriangleMesh mesh = shapes::torus(60, 30);
  Job job;
  setMemoryLimit(2'000'000);
  try {
    findModes(mesh, shellOptions(mesh, 6), true, job);
    ADD_FAILURE() << "it was not refused";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("but only 2 MB are left: use the coarse solve"),
              std::string::npos);
  }
  setMemoryLimit(0);
  EXPECT_EQ(findModes(mesh, shellOptions(mesh, 6), true, job).modes.size(), 6u);
}

// The largest error of the prolongation of a rotation from a copy with that many vertices, relative to the
// axis. A rotation is a linear displacement that also rotates the normal.
double rotationError(const TriangleMesh& mesh, uint32_t vertices) {
  Job job;
  ModesOptions options;
  options.model = ElasticModel::Shell;
  const std::vector<Part> parts = partsOf(mesh, buildTopology(mesh), options);
  const CoarsePart coarse = coarsen(parts[0], vertices, job);
  EXPECT_NEAR(coarse.part.mesh.vertexCount(), vertices, 5);
  const Vec3 axis{0.3, -0.5, 0.8};
  Eigen::MatrixXd displacement(3 * static_cast<Eigen::Index>(coarse.part.mesh.vertexCount()), 1);
  for (uint32_t v = 0; v < coarse.part.mesh.vertexCount(); ++v)
    displacement.middleRows<3>(3 * v) = eigen(cross(axis, coarse.part.mesh.positions[v]));
  const Eigen::MatrixXd fine = Prolongation(parts[0], coarse).prolong(displacement, job);
  double worst = 0;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    worst = std::max(worst, length(displacementAt(fine.col(0), v) - cross(axis, parts[0].mesh.positions[v])));
  return worst / length(axis);
}

TEST(Prolongation, isExactForLinearDisplacements) {
  EXPECT_LT(rotationError(shapes::sphere(4), 600), 1e-4);
}

TEST(Prolongation, isExactAroundAHubOfManyNeedles) {
  constexpr uint32_t kNeedles = 4000;
  TriangleMesh fan;
  fan.positions = {{0, 0, 0}};
  for (uint32_t i = 0; i < kNeedles; ++i) {
    const double angle = 2 * std::numbers::pi * i / kNeedles;
    fan.positions.push_back({std::cos(angle), std::sin(angle), 0});
    fan.triangles.push_back({0, 1 + i, 1 + (i + 1) % kNeedles});
  }
  EXPECT_LT(rotationError(fan, 1000), 1e-4);
}

}  // namespace
}  // namespace limber
