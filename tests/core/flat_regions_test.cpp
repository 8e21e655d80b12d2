#include "fit/surface/flat_regions.h"

#include <gtest/gtest.h>

#include <Eigen/SparseCore>
#include <cmath>
#include <random>

#include "shapes.h"

namespace limber {
namespace {

FlatRegions regionsOf(const TriangleMesh& mesh) {
  return {mesh, ClosestPointTree(mesh), mesh, buildTopology(mesh)};
}

// The remainder of a displacement of only vertex v.
Eigen::Vector3d flattened(const FlatRegions& regions, const TriangleMesh& mesh, uint32_t v,
                          const Eigen::Vector3d& displacement) {
  Eigen::MatrixXd steps = Eigen::MatrixXd::Zero(3 * mesh.vertexCount(), 1);
  steps.block<3, 1>(3 * v, 0) = displacement;
  regions.flatten(steps);
  return steps.block<3, 1>(3 * v, 0);
}

// Whether displacements in random directions are left unchanged. Reproducible: the seed is fixed.
bool isFree(const FlatRegions& regions, const TriangleMesh& mesh) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const Eigen::MatrixXd wanted =
      Eigen::MatrixXd::NullaryExpr(3 * mesh.vertexCount(), 2, [&] { return coordinate(random); });
  Eigen::MatrixXd steps = wanted;
  regions.flatten(steps);
  return steps == wanted;
}

TriangleMesh rotated(TriangleMesh mesh) {
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  for (Vec3& p : mesh.positions) {
    const Eigen::Vector3d q = rotation * Eigen::Vector3d(p.x, p.y, p.z);
    p = {static_cast<float>(q.x()), static_cast<float>(q.y()), static_cast<float>(q.z())};
  }
  return mesh;
}

TEST(FlatRegions, letVerticesOfABoxMoveAlongItsSidesAndEdgesAlone) {
  const TriangleMesh mesh = shapes::box(3, 4, 5, 1);
  const FlatRegions regions = regionsOf(mesh);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const Vec3& p = mesh.positions[v];
    Eigen::Vector3d expected(1, 2, 3);
    if (p.x == 0 || p.x == 3) expected.x() = 0;
    if (p.y == 0 || p.y == 4) expected.y() = 0;
    if (p.z == 0 || p.z == 5) expected.z() = 0;
    EXPECT_LT((flattened(regions, mesh, v, {1, 2, 3}) - expected).norm(), 1e-12) << v;
  }
}

TEST(FlatRegions, areFoundInAnyOrientationAndWithTheRoundingOfFloat32) {
  const TriangleMesh mesh = rotated(shapes::box(3, 3, 3, 0.1)), straight = shapes::box(3, 3, 3, 0.1);
  const FlatRegions regions = regionsOf(mesh);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    int sides = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double at = straight.positions[v][axis];
      sides += std::abs(at) < 1e-9 || std::abs(at - 0.3) < 1e-9;
    }
    const Eigen::Vector3d left = flattened(regions, mesh, v, {0.3, 1, -0.7});
    EXPECT_EQ(left.norm() < 1e-12, sides == 3) << v;
    EXPECT_LT(left.norm(), std::sqrt(0.3 * 0.3 + 1 + 0.7 * 0.7)) << v;
  }
}

TEST(FlatRegions, areFoundOnBothSidesOfASheetWithoutThickness) {
  const TriangleMesh front = shapes::grid(4, 4);
  TriangleMesh back = front;
  for (Triangle& triangle : back.triangles) std::swap(triangle[1], triangle[2]);
  const TriangleMesh mesh = shapes::together(front, back);
  const FlatRegions regions = regionsOf(mesh);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    EXPECT_LT((flattened(regions, mesh, v, {1, 2, 3}) - Eigen::Vector3d(1, 2, 0)).norm(), 1e-12) << v;
}

TEST(FlatRegions, doNotAffectCurvedSurfaces) {
  EXPECT_TRUE(isFree(regionsOf(shapes::sphere(3)), shapes::sphere(3)));
  EXPECT_TRUE(isFree(regionsOf(shapes::torus(24, 12)), shapes::torus(24, 12)));
  // No side of this box has a vertex inside it.
  EXPECT_TRUE(isFree(regionsOf(shapes::box(1, 1, 1, 1)), shapes::box(1, 1, 1, 1)));
}

TEST(FlatRegions, doNotAffectFlatResultsOfCurvedOriginals) {
  const TriangleMesh mesh = shapes::grid(6, 6);
  TriangleMesh original = shapes::grid(24, 24);
  for (Vec3& p : original.positions) p.z = 0.05 * std::sin(5 * p.x + 2 * p.y);
  EXPECT_TRUE(isFree({original, ClosestPointTree(original), mesh, buildTopology(mesh)}, mesh));
  EXPECT_FALSE(isFree(regionsOf(mesh), mesh));
}

TEST(FlatRegions, penaliseDisplacementsOutOfTheirPlanes) {
  const TriangleMesh mesh = shapes::grid(4, 4);
  const auto count = static_cast<Eigen::Index>(3 * mesh.vertexCount());
  const Eigen::Matrix3d block = Eigen::Matrix3d::Constant(0.1) + 2 * Eigen::Matrix3d::Identity();
  BlockMatrix blocks{.start = {0}, .column = {}, .blocks = {}};
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    blocks.column.push_back(v);
    blocks.blocks.push_back(block);
    blocks.start.push_back(v + 1);
  }
  regionsOf(mesh).stiffen(blocks);
  Eigen::SparseMatrix<double> hessian;
  blocks.writeTo(hessian);
  const Eigen::VectorXd step = Eigen::MatrixXd(hessian).ldlt().solve(Eigen::VectorXd::Ones(count));
  for (Eigen::Index v = 0; v < count; v += 3) {
    EXPECT_NEAR(step[v], step[v + 1], 1e-9);
    EXPECT_GT(step[v], 0.4);
    EXPECT_LT(std::abs(step[v + 2]), 1e-3);
  }
}

}  // namespace
}  // namespace limber
