#include "mesh/repair/inspect.h"

#include <gtest/gtest.h>

#include "shapes.h"

namespace limber {
namespace {

TriangleMesh withFaces(uint32_t vertexCount, std::vector<Triangle> triangles) {
  TriangleMesh mesh;
  for (uint32_t v = 0; v < vertexCount; ++v) mesh.positions.push_back({std::cos(v), std::sin(v), 0.1 * v});
  mesh.triangles = std::move(triangles);
  return mesh;
}

TEST(Inspect, knowsSphereTorusAndSheet) {
  const Inspection sphere = inspect(shapes::sphere(2)), torus = inspect(shapes::torus(8, 6));
  EXPECT_EQ(sphere.eulerCharacteristic, 2);
  EXPECT_EQ(sphere.genus, 0);
  EXPECT_EQ(sphere.boundaryLoops, 0u);
  EXPECT_EQ(torus.eulerCharacteristic, 0);
  EXPECT_EQ(torus.genus, 1);
  const Inspection sheet = inspect(shapes::grid(4, 3));
  EXPECT_EQ(sheet.eulerCharacteristic, 1);
  EXPECT_EQ(sheet.genus, 0);
  EXPECT_EQ(sheet.boundaryLoops, 1u);
  EXPECT_EQ(sheet.vertices, 20u);
  EXPECT_EQ(sheet.faces, 24u);
}

TEST(Inspect, sumsTheGenusOverComponents) {
  const auto mesh = shapes::together(shapes::together(shapes::torus(8, 6), shapes::torus(7, 5)),
                                     shapes::together(shapes::sphere(1), shapes::grid(2, 2)));
  const Inspection found = inspect(mesh);
  EXPECT_EQ(found.components, 4u);
  EXPECT_EQ(found.solidComponents, 3u);
  EXPECT_EQ(found.genus, 2);
  EXPECT_EQ(found.boundaryLoops, 1u);
}

TEST(Inspect, countsEachHoleOfASheet) {
  TriangleMesh sheet = shapes::grid(6, 6);
  // Removes two triangles that touch neither each other nor the border.
  sheet.triangles.erase(sheet.triangles.begin() + 50);
  sheet.triangles.erase(sheet.triangles.begin() + 16);
  const Inspection found = inspect(sheet);
  EXPECT_EQ(found.boundaryLoops, 3u);
  EXPECT_EQ(found.eulerCharacteristic, -1);
  EXPECT_EQ(found.genus, 0);
}

TEST(Inspect, followsTheFansWhereTwoHolesShareACorner) {
  // A closed ring of six triangles around vertex 0 without the first and the fourth: two fans, whose borders
  // are two loops that touch in vertex 0.
  const auto mesh = withFaces(7, {{0, 2, 3}, {0, 3, 4}, {0, 5, 6}, {0, 6, 1}});
  const Inspection found = inspect(mesh);
  EXPECT_EQ(found.nonManifoldVertices, 1u);
  EXPECT_EQ(found.boundaryLoops, 2u);
  EXPECT_EQ(found.components, 1u);
  EXPECT_FALSE(found.genus.has_value());
}

TEST(Inspect, findsAVertexThatJoinsTwoClosedBodies) {
  TriangleMesh mesh = shapes::together(shapes::sphere(0), shapes::sphere(0));
  for (Triangle& t : mesh.triangles)
    for (uint32_t& v : t) v = v == 12 ? 0 : v > 12 ? v - 1 : v;
  mesh.positions.pop_back();
  const Inspection found = inspect(mesh);
  EXPECT_EQ(found.nonManifoldVertices, 1u);
  EXPECT_EQ(found.nonManifoldEdges, 0u);
  EXPECT_EQ(found.eulerCharacteristic, 3);
}

TEST(Inspect, countsANonManifoldEdgeButNotItsEnds) {
  const Inspection found = inspect(withFaces(5, {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}}));
  EXPECT_EQ(found.nonManifoldEdges, 1u);
  EXPECT_EQ(found.nonManifoldVertices, 0u);
  EXPECT_EQ(found.boundaryLoops, 1u);
  EXPECT_FALSE(found.genus.has_value());
}

TEST(Inspect, findsTheClashOfAMoebiusStripAndGivesItNoGenus) {
  const Inspection found = inspect(withFaces(5, {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 0, 4}, {4, 0, 1}}));
  EXPECT_EQ(found.orientationClashes, 1u);
  EXPECT_EQ(found.eulerCharacteristic, 0);
  EXPECT_EQ(found.boundaryLoops, 1u);
  EXPECT_FALSE(found.genus.has_value());
}

TEST(Inspect, givesAGenusToAnOrientableSurfaceWhateverItsWinding) {
  TriangleMesh torus = shapes::torus(8, 6);
  std::swap(torus.triangles[5][0], torus.triangles[5][1]);
  const Inspection found = inspect(torus);
  EXPECT_EQ(found.orientationClashes, 3u);
  EXPECT_EQ(found.genus, 1);
}

TEST(Inspect, findsNoSolidInAClosedComponentWithoutVolume) {
  TriangleMesh flat = shapes::sphere(2);
  EXPECT_EQ(inspect(flat).solidComponents, 1u);
  for (Vec3& p : flat.positions) p.z = 0;
  EXPECT_EQ(inspect(flat).solidComponents, 0u);
}

TEST(Inspect, hasZeroesForAnEmptyMesh) {
  const Inspection found = inspect({});
  EXPECT_EQ(found.faces, 0u);
  EXPECT_EQ(found.components, 0u);
  EXPECT_EQ(found.eulerCharacteristic, 0);
}

}  // namespace
}  // namespace limber
