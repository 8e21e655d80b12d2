#include "modes/find_modes.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/memory.h"
#include "base/parallel.h"
#include "elastic/displacement.h"
#include "elastic/part_modes.h"
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

TEST(SmallParts, areSolvedSideBySideWithTheSameResultAndRisingProgress) {
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

TEST(Prolongation, isExactForLinearDisplacements) {
  TriangleMesh mesh = shapes::sphere(4);
  const Topology topology = buildTopology(mesh);
  Job job;
  ModesOptions options;
  options.model = ElasticModel::Shell;
  const std::vector<Part> parts = partsOf(mesh, topology, options);
  const CoarsePart coarse = coarsen(parts[0], 600, job);
  EXPECT_NEAR(coarse.part.mesh.vertexCount(), 600, 5);
  // A rotation about an axis: linear, and the normal turns with the surface.
  const Vec3 axis{0.3, -0.5, 0.8};
  Eigen::MatrixXd displacement(3 * static_cast<Eigen::Index>(coarse.part.mesh.vertexCount()), 1);
  for (uint32_t v = 0; v < coarse.part.mesh.vertexCount(); ++v)
    displacement.middleRows<3>(3 * v) = eigen(cross(axis, coarse.part.mesh.positions[v]));
  const Eigen::MatrixXd fine = Prolongation(parts[0], coarse).prolong(displacement, job);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    EXPECT_LT(length(displacementAt(fine.col(0), v) - cross(axis, parts[0].mesh.positions[v])),
              1e-4 * length(axis));
}

}  // namespace
}  // namespace limber
