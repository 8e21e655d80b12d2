#include "fields/curvature.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shapes.h"

namespace limber {
namespace {

Curvature curvatureOf(const TriangleMesh& mesh) {
  Job job;
  return meanCurvature(mesh, buildTopology(mesh), job);
}

// A tube around z, open at both ends.
TriangleMesh tube(int around, int along, double radius, double height) {
  TriangleMesh mesh = shapes::grid(around, along, 2 * std::numbers::pi, height);
  TriangleMesh closed;
  for (int j = 0; j <= along; ++j)
    for (int i = 0; i < around; ++i) {
      const Vec3 p = mesh.positions[static_cast<size_t>(j * (around + 1) + i)];
      closed.positions.push_back({radius * std::cos(p.x), radius * std::sin(p.x), p.y});
    }
  const auto wrap = [&](uint32_t v) {
    const auto width = static_cast<uint32_t>(around + 1);
    return v / width * static_cast<uint32_t>(around) + v % width % static_cast<uint32_t>(around);
  };
  for (const Triangle& t : mesh.triangles) closed.triangles.push_back({wrap(t[0]), wrap(t[1]), wrap(t[2])});
  return closed;
}

// The half of a mesh above a height, with the vertices it needs.
TriangleMesh above(const TriangleMesh& mesh, double z) {
  TriangleMesh half;
  std::vector<uint32_t> index(mesh.vertexCount(), kNone);
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    if (std::min({mesh.corner(t, 0).z, mesh.corner(t, 1).z, mesh.corner(t, 2).z}) < z) continue;
    Triangle kept;
    for (int c = 0; c < 3; ++c) {
      uint32_t& at = index[mesh.triangles[t][c]];
      if (at == kNone) {
        at = half.vertexCount();
        half.positions.push_back(mesh.corner(t, c));
      }
      kept[c] = at;
    }
    half.triangles.push_back(kept);
  }
  return half;
}

TEST(Curvature, ofASphereIsOneOverItsRadius) {
  for (double radius : {0.5, 2.0})
    for (float value : curvatureOf(shapes::sphere(4, radius)).vertex) EXPECT_NEAR(value * radius, 1, 0.02);
}

TEST(Curvature, ofATubeIsHalfOfOneOverItsRadiusUpToItsRims) {
  for (float value : curvatureOf(tube(64, 40, 2, 5)).vertex) EXPECT_NEAR(value, 0.25, 0.005);
}

TEST(Curvature, ofAFlatSheetIsZeroUpToItsBorder) {
  for (float value : curvatureOf(shapes::grid(7, 5)).vertex) EXPECT_NEAR(value, 0, 1e-6);
}

TEST(Curvature, ofAHalfSphereIsOneOverItsRadiusAtTheRimToo) {
  for (float value : curvatureOf(above(shapes::sphere(4), 0.05)).vertex) EXPECT_NEAR(value, 1, 0.03);
}

TEST(Curvature, halvesWhenTheMeshDoubles) {
  TriangleMesh mesh = shapes::jittered(shapes::torus(20, 10), 0.01, 2);
  const auto before = curvatureOf(mesh).vertex;
  for (Vec3& p : mesh.positions) p *= 2;
  const auto after = curvatureOf(mesh).vertex;
  for (size_t v = 0; v < before.size(); ++v) EXPECT_NEAR(after[v], before[v] / 2, 1e-6 + 1e-5 * before[v]);
}

TEST(Curvature, ofATriangleIsTheMeanOfItsVertices) {
  const TriangleMesh mesh = shapes::torus(12, 8);
  const Curvature curvature = curvatureOf(mesh);
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    EXPECT_FLOAT_EQ(curvature.triangle[t],
                    (curvature.vertex[a] + curvature.vertex[b] + curvature.vertex[c]) / 3);
  }
}

TEST(Curvature, staysFiniteOnNeedles) {
  TriangleMesh mesh = shapes::grid(2, 2);
  mesh.positions[4] = mesh.positions[0] + Vec3{1e-9, 0, 0};
  for (float value : curvatureOf(mesh).vertex) EXPECT_TRUE(std::isfinite(value));
}

}  // namespace
}  // namespace limber
