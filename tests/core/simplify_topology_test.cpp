#include <gtest/gtest.h>

#include <set>

#include "mesh/manifold.h"
#include "mesh/repair/inspect.h"
#include "mesh/topology.h"
#include "simplify/simplify.h"
#include "surfaces.h"

// No collapse changes the topology of the surface.

namespace limber {
namespace {

struct Run {
  std::string name;
  TriangleMesh mesh;
  History history;
};

// All meshes with both methods; `paper` is guided by fields that vary over the mesh.
std::vector<Run> everyRun() {
  std::vector<Run> runs;
  Job job;
  for (const auto& [name, mesh] : surfaces::everyTopology()) {
    runs.push_back({name + ", qem", mesh, simplify(mesh, {}, {.method = Method::Qem}, job)});
    std::vector<float> strain, curvature;
    for (uint32_t t = 0; t < mesh.triangleCount(); ++t) strain.push_back(static_cast<float>(t % 10) / 10);
    for (uint32_t v = 0; v < mesh.vertexCount(); ++v) curvature.push_back(static_cast<float>(v % 7) / 7);
    const SimplifyOptions options{
        .method = Method::Paper, .strainWeight = 0.05, .curvatureWeight = 1, .qualityWeight = 0.01};
    runs.push_back({name + ", paper", mesh, simplify(mesh, {strain, curvature}, options, job)});
  }
  return runs;
}

TEST(Simplify, keepsComponentsLoopsGenusAndFaultsAtEveryCount) {
  for (const auto& [name, mesh, history] : everyRun()) {
    SCOPED_TRACE(name);
    const Inspection before = inspect(mesh);
    for (uint32_t i = 0; i < history.collapseCount(); ++i) {
      if (i % 7 != 0 && i + 20 < history.collapseCount()) continue;
      const Inspection after = inspect(meshAt(mesh, history, history.trianglesAfter[i]).mesh);
      ASSERT_EQ(after.components, before.components) << "collapse " << i;
      ASSERT_EQ(after.boundaryLoops, before.boundaryLoops) << "collapse " << i;
      ASSERT_EQ(after.genus, before.genus) << "collapse " << i;
      ASSERT_EQ(after.eulerCharacteristic, before.eulerCharacteristic) << "collapse " << i;
      ASSERT_EQ(after.nonManifoldEdges, before.nonManifoldEdges) << "collapse " << i;
      ASSERT_EQ(after.nonManifoldVertices, before.nonManifoldVertices) << "collapse " << i;
      ASSERT_EQ(after.orientationClashes, before.orientationClashes) << "collapse " << i;
    }
  }
}

std::vector<Vec3> unitNormals(const std::vector<Triangle>& triangles, const std::vector<Vec3>& p) {
  std::vector<Vec3> normals;
  for (const Triangle& t : triangles)
    normals.push_back(normalized(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]])));
  return normals;
}

TEST(Simplify, flipsNoFaceAndMakesNoneWithoutAreaOrTwice) {
  for (const auto& [name, mesh, history] : everyRun()) {
    SCOPED_TRACE(name);
    surfaces::Replay replay(mesh, history);
    for (uint32_t i = 0; i < history.collapseCount(); ++i) {
      const auto before = unitNormals(replay.triangles(), replay.positions());
      const auto vanishes = [&](const Triangle& t) {
        return std::ranges::count(t, history.kept[i]) && std::ranges::count(t, history.removed[i]);
      };
      std::vector<Vec3> expected;
      for (size_t t = 0; t < before.size(); ++t)
        if (!vanishes(replay.triangles()[t])) expected.push_back(before[t]);
      replay.step(i);
      const auto after = unitNormals(replay.triangles(), replay.positions());
      ASSERT_EQ(after.size(), expected.size());
      for (size_t t = 0; t < after.size(); ++t) {
        ASSERT_NEAR(length(after[t]), 1, 1e-9) << "no area, collapse " << i;
        ASSERT_GT(dot(after[t], expected[t]), 0.1) << "turned, collapse " << i;
      }
    }
    for (uint32_t faces = mesh.triangleCount(); faces > 0; faces /= 2) {
      std::set<Triangle> seen;
      for (Triangle t : meshAt(mesh, history, faces).mesh.triangles) {
        std::ranges::sort(t);
        ASSERT_TRUE(seen.insert(t).second) << "twice at " << faces;
      }
    }
  }
}

TEST(Simplify, endsAtTheSmallestForms) {
  Job job;
  const auto floorOf = [&](const TriangleMesh& mesh) {
    return meshAt(mesh, simplify(mesh, {}, {.method = Method::Qem}, job), 0).mesh.triangleCount();
  };
  EXPECT_EQ(floorOf(surfaces::inFloats(shapes::sphere(3))), 4u);
  EXPECT_EQ(floorOf(surfaces::inFloats(shapes::box(3, 4, 5, 0.25))), 4u);
  EXPECT_EQ(floorOf(surfaces::inFloats(shapes::grid(7, 5))), 1u);
  EXPECT_EQ(floorOf(shapes::together(shapes::sphere(1), shapes::grid(2, 3))), 5u);
  EXPECT_LE(floorOf(surfaces::inFloats(shapes::torus(24, 12))), 24u);
  EXPECT_LE(floorOf(surfaces::inFloats(surfaces::annulus(14, 3))), 8u);
}

TEST(Simplify, leavesTheSmallestFormsAsTheyAre) {
  TriangleMesh triangle, tetrahedron;
  triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.triangles = {{0, 1, 2}};
  tetrahedron.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  tetrahedron.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  Job job;
  for (const TriangleMesh& mesh : {triangle, tetrahedron, TriangleMesh{}}) {
    const History history = simplify(mesh, {}, {.method = Method::Qem}, job);
    EXPECT_EQ(history.collapseCount(), 0u);
    EXPECT_EQ(history.refused.topology, buildTopology(mesh).edges.size());
    EXPECT_EQ(meshAt(mesh, history, 0).mesh.triangles, mesh.triangles);
  }
}

TEST(Simplify, saysForEveryEdgeOfTheFloorWhyItStays) {
  for (const auto& [name, mesh, history] : everyRun()) {
    SCOPED_TRACE(name);
    const TriangleMesh floor = meshAt(mesh, history, 0).mesh;
    const auto& [topology, flip, lock, angle, deviation] = history.refused;
    EXPECT_EQ(topology + flip + lock + angle + deviation, buildTopology(floor).edges.size());
    if (inspect(mesh).genus.has_value()) {
      EXPECT_EQ(lock, 0u);
    }
  }
}

// Ends of non-manifold edges, non-manifold vertices and ends of orientation clashes must not move.
TEST(Simplify, leavesNonManifoldVerticesUntouched) {
  for (const auto& [name, mesh, history] : everyRun()) {
    SCOPED_TRACE(name);
    const auto kinds = classifyVertices(mesh, buildTopology(mesh));
    const auto isLocked = [&](uint32_t v) {
      return kinds[v] == VertexKind::NonManifold || kinds[v] == VertexKind::NonManifoldEdge;
    };
    for (uint32_t i = 0; i < history.collapseCount(); ++i) {
      ASSERT_FALSE(isLocked(history.kept[i])) << "collapse " << i;
      ASSERT_FALSE(isLocked(history.removed[i])) << "collapse " << i;
    }
  }
}

TEST(Simplify, keepsTheOutlineOfAFlatSheetUntilACornerMustGo) {
  const TriangleMesh sheet = shapes::grid(16, 8, 2, 1);
  Job job;
  const History history = simplify(sheet, {}, {.method = Method::Qem}, job);
  for (uint32_t faces = sheet.triangleCount(); faces >= 2; --faces) {
    const TriangleMesh mesh = meshAt(sheet, history, faces).mesh;
    double area = 0;
    std::set<std::pair<double, double>> corners;
    for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
      EXPECT_GT(areaNormal(mesh, t).z, 0);
      area += triangleArea(mesh, t);
    }
    for (const Vec3& p : mesh.positions) {
      EXPECT_EQ(p.z, 0);
      if ((p.x == 0 || p.x == 2) && (p.y == 0 || p.y == 1)) corners.insert({p.x, p.y});
    }
    ASSERT_EQ(corners.size(), 4u) << faces;
    ASSERT_NEAR(area, 2, 1e-12) << faces;
  }
}

TEST(Simplify, keepsAVertexOfABorderWhereAnInnerOneJoinsIt) {
  const TriangleMesh mesh = surfaces::inFloats(shapes::jittered(surfaces::annulus(20, 4), 0.02, 5));
  Job job;
  const History history = simplify(mesh, {}, {.method = Method::Qem}, job);
  std::vector<uint8_t> onBorder;
  for (VertexKind kind : classifyVertices(mesh, buildTopology(mesh)))
    onBorder.push_back(kind == VertexKind::Border);
  surfaces::Replay replay(mesh, history);
  uint32_t joined = 0;
  for (uint32_t i = 0; i < history.collapseCount(); ++i) {
    const Vec3 before = replay.positions()[history.kept[i]];
    replay.step(i);
    if (onBorder[history.removed[i]]) {
      ASSERT_TRUE(onBorder[history.kept[i]]) << "collapse " << i;
    } else if (onBorder[history.kept[i]]) {
      ASSERT_EQ(replay.positions()[history.kept[i]], before) << "collapse " << i;
      ++joined;
    }
  }
  EXPECT_GT(joined, 10u);
}

}  // namespace
}  // namespace limber
