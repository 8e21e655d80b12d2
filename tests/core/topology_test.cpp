#include "mesh/topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "shapes.h"

namespace limber {
namespace {

// All lists of a topology, checked against a plain count with a map.
void expectConsistent(const TriangleMesh& mesh, const Topology& topology) {
  std::map<std::pair<uint32_t, uint32_t>, std::vector<uint32_t>> expected;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    for (int c = 0; c < 3; ++c)
      expected[std::minmax(mesh.triangles[t][c], mesh.triangles[t][(c + 1) % 3])].push_back(t);
  ASSERT_EQ(topology.edges.size(), expected.size());
  size_t e = 0;
  for (const auto& [ends, triangles] : expected) {
    const Topology::Edge& edge = topology.edges[e++];
    EXPECT_EQ(std::pair(edge.a, edge.b), ends);
    const auto found = topology.trianglesAt(edge);
    EXPECT_EQ(std::vector(found.begin(), found.end()), triangles);
  }
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    for (int c = 0; c < 3; ++c) {
      const Topology::Edge& edge = topology.edges[topology.edgeOpposite(Corner(t, c))];
      const auto& triangle = mesh.triangles[t];
      const std::pair<uint32_t, uint32_t> ends = std::minmax(triangle[(c + 1) % 3], triangle[(c + 2) % 3]);
      EXPECT_EQ(std::pair(edge.a, edge.b), ends);
    }
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    std::vector<uint32_t> around;
    for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
      if (std::ranges::count(mesh.triangles[t], v)) around.push_back(t);
    const auto found = topology.trianglesAround(v);
    EXPECT_EQ(std::vector(found.begin(), found.end()), around);
  }
}

TEST(Topology, listsEveryEdgeAndItsTrianglesInOrder) {
  for (const TriangleMesh& mesh : {shapes::sphere(1), shapes::torus(7, 5), shapes::grid(3, 4)})
    expectConsistent(mesh, buildTopology(mesh));
}

TEST(Topology, keepsAllTrianglesOfANonManifoldEdge) {
  TriangleMesh fan;
  fan.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}};
  fan.triangles = {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}};
  const Topology topology = buildTopology(fan);
  expectConsistent(fan, topology);
  EXPECT_EQ(topology.trianglesAt(topology.edges[0]).size(), 3u);
}

TEST(Topology, numbersComponentsByTheirSmallestVertex) {
  TriangleMesh mesh;
  mesh.positions.assign(9, {});
  mesh.triangles = {{8, 3, 4}, {7, 1, 2}, {0, 6, 8}};
  const Topology topology = buildTopology(mesh);
  EXPECT_EQ(topology.componentCount, 3u);  // vertex 5 stands alone
  EXPECT_EQ(topology.componentOfVertex, (std::vector<uint32_t>{0, 1, 1, 0, 0, 2, 0, 1, 0}));
  EXPECT_EQ(componentOfTriangle(mesh, topology), (std::vector<uint32_t>{0, 1, 0}));
}

TEST(Topology, hasNothingForAMeshWithoutTriangles) {
  const Topology topology = buildTopology({});
  EXPECT_TRUE(topology.edges.empty());
  EXPECT_EQ(topology.componentCount, 0u);
  EXPECT_EQ(topology.vertexStart, std::vector<uint32_t>{0});
}

}  // namespace
}  // namespace limber
