#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "base/parallel.h"
#include "query/closest_point.h"
#include "reduced.h"
#include "shapes.h"
#include "surfaces.h"
#include "transfer/bind_meshes.h"

namespace limber {
namespace {

Vec3 pointOf(const TriangleMesh& mesh, const Binding& binding, uint32_t v) {
  Vec3 point = normalized(areaNormal(mesh, binding.triangle[v])) * binding.offset[v];
  for (int c = 0; c < 3; ++c) point += mesh.corner(binding.triangle[v], c) * binding.barycentric[3 * v + c];
  return point;
}

// A sheet of the given thickness, bent to half a tube of radius 1 around the y axis, with these numbers of
// cells around it and along it.
TriangleMesh halfTube(int around, int along, double thickness) {
  TriangleMesh mesh = shapes::box(around, along, 1, 1);
  for (Vec3& p : mesh.positions) {
    const double angle = std::numbers::pi * p.x / around, radius = 1 + thickness * p.z;
    p = {-radius * std::cos(angle), p.y / along, radius * std::sin(angle)};
  }
  return surfaces::inFloats(mesh);
}

TEST(Binding, bindsEveryVertexOfAnUnchangedMeshToItself) {
  const TriangleMesh mesh = surfaces::inFloats(shapes::jittered(shapes::torus(16, 8), 0.02, 1));
  Job job;
  const MeshAt result = reduced(mesh, mesh.triangleCount());
  const Binding binding = bindToResult(mesh, result, job);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    ASSERT_LT(length(pointOf(mesh, binding, v) - mesh.positions[v]), 1e-6);
    ASSERT_NEAR(binding.offset[v], 0, 1e-6);
    for (int c = 0; c < 3; ++c)
      ASSERT_NEAR(binding.barycentric[3 * v + c], mesh.triangles[binding.triangle[v]][c] == v, 1e-5);
  }
}

TEST(Binding, liesWithinItsTriangleAndReproducesThePointByItsOffset) {
  const TriangleMesh mesh = surfaces::inFloats(shapes::sphere(3));
  Job job;
  const MeshAt result = reduced(mesh, 120);
  const Binding binding = bindToResult(mesh, result, job);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    float sum = 0;
    for (int c = 0; c < 3; ++c) {
      ASSERT_GE(binding.barycentric[3 * v + c], 0);
      sum += binding.barycentric[3 * v + c];
    }
    ASSERT_NEAR(sum, 1, 1e-6);
    ASSERT_LT(length(pointOf(result.mesh, binding, v) - mesh.positions[v]), 0.02);
    ASSERT_LT(std::abs(binding.offset[v]), 0.1);
  }
}

TEST(Binding, staysOnItsSideOfAThinSheetWhereTheOtherSideIsNearer) {
  const double thickness = 0.005;
  const TriangleMesh mesh = halfTube(48, 12, thickness);
  Job job;
  const MeshAt result = reduced(mesh, 90);
  const Binding binding = bindToResult(mesh, result, job);
  const ClosestPointTree tree(result.mesh);
  const auto outwards = [&](uint32_t t) {
    const Vec3 p = result.mesh.corner(t, 0);
    return dot(normalized(areaNormal(result.mesh, t)), normalized(Vec3{p.x, 0, p.z}));
  };
  uint32_t checked = 0, nearerOnOtherSide = 0;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const Vec3& p = mesh.positions[v];
    if (p.y < 0.01 || p.y > 0.99 || p.z < 0.01) continue;  // the rim belongs to neither side
    const bool isOuter = std::hypot(p.x, p.z) > 1 + thickness / 2;
    ASSERT_EQ(outwards(binding.triangle[v]) > 0, isOuter) << "vertex " << v;
    nearerOnOtherSide += (outwards(tree.closest(p).triangle) > 0) != isOuter;
    ++checked;
  }
  EXPECT_GT(checked, 900u);
  EXPECT_GT(nearerOnOtherSide, 50u);  // otherwise the test proves nothing
}

TEST(Binding, isTheSameForAnyNumberOfThreads) {
  const TriangleMesh mesh = surfaces::inFloats(shapes::jittered(shapes::sphere(5), 0.003, 7));
  Job job;
  const MeshAt result = reduced(mesh, 4000);
  const Binding alone = bindToResult(mesh, result, job);
  setThreadCount(3);
  const Binding shared = bindToResult(mesh, result, job);
  setThreadCount(1);
  EXPECT_EQ(alone.triangle, shared.triangle);
  EXPECT_EQ(alone.barycentric, shared.barycentric);
  EXPECT_EQ(alone.offset, shared.offset);
}

TEST(Binding, followsAResultWhoseVerticesHaveMoved) {
  const TriangleMesh mesh = surfaces::inFloats(shapes::grid(12, 12));
  Job job;
  MeshAt result = reduced(mesh, 60);
  for (Vec3& p : result.mesh.positions) p.z -= 0.25;
  const Binding binding = bindToResult(mesh, result, job);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) ASSERT_NEAR(binding.offset[v], 0.25, 1e-6);
}

TEST(Binding, refusesTheResultOfAnotherMesh) {
  Job job;
  const TriangleMesh mesh = shapes::grid(4, 4);
  EXPECT_THROW(bindToResult(shapes::grid(5, 4), reduced(mesh, 20), job), std::invalid_argument);
}

}  // namespace
}  // namespace limber
