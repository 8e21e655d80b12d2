#include "simplify/history.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "simplify/simplify.h"
#include "surfaces.h"

namespace limber {
namespace {

History historyOf(const TriangleMesh& mesh) {
  Job job;
  return simplify(mesh, {}, {.method = Method::Qem}, job);
}

TEST(History, meshAtEqualsAPlainReplayAfterEveryCollapse) {
  for (const auto& [name, mesh] : surfaces::everyTopology()) {
    SCOPED_TRACE(name);
    const History history = historyOf(mesh);
    surfaces::Replay replay(mesh, history);
    for (uint32_t i = 0; i < history.collapseCount(); ++i) {
      replay.step(i);
      const MeshAt found = meshAt(mesh, history, history.trianglesAfter[i]);
      ASSERT_EQ(found.mesh.triangleCount(), history.trianglesAfter[i]);
      ASSERT_EQ(found.mesh.triangleCount(), replay.triangles().size());
      for (uint32_t t = 0; t < found.mesh.triangleCount(); ++t)
        for (int c = 0; c < 3; ++c) {
          const uint32_t survivor = found.inputOfVertex[found.mesh.triangles[t][c]];
          ASSERT_EQ(survivor, replay.triangles()[t][c]) << "collapse " << i;
          ASSERT_EQ(found.mesh.corner(t, c), replay.positions()[survivor]) << "collapse " << i;
        }
    }
  }
}

TEST(History, meshAtKnowsWhereEveryPartCameFrom) {
  const TriangleMesh mesh = surfaces::inFloats(shapes::jittered(shapes::torus(12, 8), 0.02, 3));
  const History history = historyOf(mesh);
  const MeshAt found = meshAt(mesh, history, 60);
  EXPECT_TRUE(std::ranges::is_sorted(found.inputOfVertex));
  EXPECT_TRUE(std::ranges::is_sorted(found.inputOfTriangle));
  for (uint32_t v = 0; v < found.mesh.vertexCount(); ++v)
    EXPECT_EQ(found.vertexOfInput[found.inputOfVertex[v]], v);
  for (uint32_t t = 0; t < found.mesh.triangleCount(); ++t)
    for (int c = 0; c < 3; ++c)
      EXPECT_EQ(found.vertexOfInput[mesh.triangles[found.inputOfTriangle[t]][c]], found.mesh.triangles[t][c]);
}

TEST(History, meshAtGivesTheLargestMeshThatFits) {
  const TriangleMesh sphere = surfaces::inFloats(shapes::sphere(2));
  const History history = historyOf(sphere);
  for (uint32_t faces = 4; faces <= 320; ++faces)
    EXPECT_EQ(meshAt(sphere, history, faces).mesh.triangleCount(), faces / 2 * 2);
  EXPECT_EQ(meshAt(sphere, history, 0).mesh.triangleCount(), 4u);
  const MeshAt whole = meshAt(sphere, history, 100000);
  EXPECT_EQ(whole.mesh.positions, sphere.positions);
  EXPECT_EQ(whole.mesh.triangles, sphere.triangles);
}

TEST(History, meshAtDropsAnUnusedVertexOfTheInput) {
  TriangleMesh sphere = surfaces::inFloats(shapes::sphere(1));
  sphere.positions.push_back({5, 5, 5});
  const MeshAt found = meshAt(sphere, historyOf(sphere), 40);
  EXPECT_EQ(found.vertexOfInput.back(), kNone);
  EXPECT_EQ(found.mesh.vertexCount(), 22u);
}

TEST(History, ofAnotherMeshIsRefusedWithASentence) {
  const TriangleMesh sphere = surfaces::inFloats(shapes::sphere(1));
  const History good = historyOf(sphere);
  std::vector<History> bad(6, good);
  bad[0].vertexCount++;
  bad[1].kept[0] = 5000;
  bad[2].positions.pop_back();
  std::swap(bad[3].trianglesAfter[1], bad[3].trianglesAfter[2]);
  bad[4].removed.pop_back();
  bad[5].removed.assign(bad[5].removed.size(), bad[5].removed[0]);
  for (size_t i = 0; i < bad.size(); ++i)
    EXPECT_THROW(meshAt(sphere, bad[i], 20), std::invalid_argument) << i;
  EXPECT_THROW(meshAt(shapes::sphere(2), good, 20), std::invalid_argument);
}

}  // namespace
}  // namespace limber
