#include "mesh/component_frame.h"

#include <gtest/gtest.h>

#include "mesh/pinned_vertices.h"
#include "mesh/topology.h"
#include "shapes.h"

namespace limber {
namespace {

TEST(SplitMesh, givesEveryComponentItsOwnVerticesAndTriangles) {
  const TriangleMesh first = shapes::grid(3, 2), second = shapes::sphere(1);
  const TriangleMesh both = shapes::together(first, second);
  const Topology topology = buildTopology(both);
  const MeshParts split = splitMesh(both, topology.componentOfVertex, topology.componentCount);
  ASSERT_EQ(split.parts.size(), 2u);
  EXPECT_EQ(split.parts[0].mesh.positions, first.positions);
  EXPECT_EQ(split.parts[1].mesh.triangles, second.triangles);
  for (const MeshParts::Part& part : split.parts) {
    for (uint32_t v = 0; v < part.vertices.size(); ++v) EXPECT_EQ(split.localVertex[part.vertices[v]], v);
    for (uint32_t t = 0; t < part.triangles.size(); ++t)
      for (int c = 0; c < 3; ++c) EXPECT_EQ(part.mesh.corner(t, c), both.corner(part.triangles[t], c));
  }
}

TEST(UnitFrame, beginsAtTheOriginAndHasDiagonalOne) {
  TriangleMesh mesh = shapes::box(2, 3, 4, 0.7);
  for (Vec3& p : mesh.positions) p += {5, -6, 7};
  const UnitFrame frame = unitFrame(mesh);
  TriangleMesh moved = mesh;
  moveToFrame(moved, frame);
  EXPECT_EQ(bounds(moved).low, (Vec3{0, 0, 0}));
  EXPECT_NEAR(bounds(moved).diagonal(), 1, 1e-12);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    EXPECT_LT(length(frame.fromFrame(moved.positions[v]) - mesh.positions[v]), 1e-12);
}

TEST(PinnedVertices, areAscendingAndUniqueAndEqualTheirMask) {
  const PinnedVertices pinned({4, 1, 4, 2});
  EXPECT_EQ(pinned.ids(), (std::vector<uint32_t>{1, 2, 4}));
  EXPECT_EQ(pinned.mask(6), (std::vector<uint8_t>{0, 1, 1, 0, 1, 0}));
  EXPECT_EQ(PinnedVertices::fromMask(pinned.mask(6)), pinned);
  const std::span<const uint32_t> ids = pinned;
  EXPECT_EQ(ids.size(), 3u);
  EXPECT_TRUE(PinnedVertices().empty());
}

}  // namespace
}  // namespace limber
