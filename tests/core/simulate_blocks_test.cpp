// Bodies cut into blocks for threads.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "shapes.h"
#include "simulate/blocks.h"
#include "simulate/constraints/bending_rest.h"

namespace limber {
namespace {

TriangleMesh twoSheets() {
  return shapes::together(shapes::grid(9, 5), shapes::grid(3, 14));
}

TEST(Blocks, groupsOfAKindShareNoVertexOfAnyTriangleAndItsNeighbours) {
  for (const TriangleMesh& mesh : {shapes::torus(24, 8), twoSheets(), shapes::grid(2, 2)}) {
    const auto flaps = flapsOf(mesh, buildTopology(mesh));
    const Blocks blocks = blocksOf(mesh, flaps, 5);
    EXPECT_EQ(blocks.start.back(), mesh.vertexCount());
    std::vector<std::array<std::set<uint32_t>, 2>> groupsOf(mesh.vertexCount());  // blocks, borders
    for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
      std::vector<uint32_t> stencil(mesh.triangles[t].begin(), mesh.triangles[t].end());
      stencil.insert(stencil.end(), flaps.begin() + 3 * t, flaps.begin() + 3 * t + 3);
      const uint32_t group = blocks.groupOf(stencil);
      ASSERT_LT(group, blocks.groupCount());
      for (const uint32_t v : stencil)
        if (v != kNone) groupsOf[v][group >= blocks.count()].insert(group);
    }
    for (const auto& groups : groupsOf)
      for (const auto& ofKind : groups) EXPECT_LE(ofKind.size(), 1u);
  }
}

TEST(Blocks, theOrderFromEndToEndIsOneOfAllVerticesAndKeepsNeighboursClose) {
  const TriangleMesh strip = shapes::grid(2, 60);
  const auto order = orderFromEndToEnd({flattened(strip.triangles), 3}, strip.vertexCount());
  std::vector<uint32_t> slotOf(strip.vertexCount(), kNone);
  for (uint32_t i = 0; i < order.size(); ++i) slotOf[order[i]] = i;
  EXPECT_EQ(std::count(slotOf.begin(), slotOf.end(), kNone), 0);
  for (const Triangle& t : strip.triangles)
    for (const uint32_t v : t)
      for (const uint32_t w : t) EXPECT_LE(slotOf[v], slotOf[w] + 6);  // two rows
}

TEST(Blocks, aLongBodyHasABorderBetweenEveryTwoBlocks) {
  TriangleMesh strip = shapes::grid(60, 2);
  EXPECT_EQ(blocksOf(strip, flapsOf(strip, buildTopology(strip)), 1).borderCount, 0u);
  const auto order = orderFromEndToEnd({flattened(strip.triangles), 3}, strip.vertexCount());
  TriangleMesh ordered = strip;
  for (uint32_t i = 0; i < order.size(); ++i) {
    ordered.positions[i] = strip.positions[order[i]];
    for (size_t t = 0; t < strip.triangles.size(); ++t)
      for (int c = 0; c < 3; ++c)
        if (strip.triangles[t][c] == order[i]) ordered.triangles[t][c] = i;
  }
  EXPECT_EQ(blocksOf(ordered, flapsOf(ordered, buildTopology(ordered)), 4).borderCount, 3u);
}

}  // namespace
}  // namespace limber
