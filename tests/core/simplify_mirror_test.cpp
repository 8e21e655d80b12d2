#include <gtest/gtest.h>

#include <stdexcept>
#include <utility>

#include "mirrored.h"
#include "same_topology.h"
#include "simplify/simplify.h"
#include "simplify/symmetry/mirror.h"

namespace limber {
namespace {

using mirrored::box, mirrored::Doubled, mirrored::facesOf, mirrored::sheet;

constexpr Method kMethods[] = {Method::Qem, Method::Paper, Method::Limber};

History run(const Doubled& whole, Method method, uint32_t stopFaces, double maxDeviation = 0) {
  Job job;
  SimplifyOptions options{.method = method, .qualityWeight = 0.1, .sizeWeight = 0.01, .stopFaces = stopFaces};
  options.constraints.mirror = whole.mirror;
  options.maxDeviation = maxDeviation;
  return simplify(whole.mesh, {}, options, job);
}

TEST(Mirror, bothSidesStayImagesOfEachOtherBitByBit) {
  for (const Doubled& whole : {sheet(), box()})
    for (const Method method : kMethods)
      for (const uint32_t faces : {300u, 120u, 40u, 0u}) {
        const TriangleMesh mesh = meshAt(whole.mesh, run(whole, method, faces), 0).mesh;
        EXPECT_EQ(facesOf(mesh, 1), facesOf(mesh, -1)) << faces;
      }
}

TEST(Mirror, keepsTopologyAndReachesFarDown) {
  for (const Doubled& whole : {sheet(), box()})
    for (const Method method : kMethods) {
      const TriangleMesh floor = meshAt(whole.mesh, run(whole, method, 0), 0).mesh;
      expectSameTopology(whole.mesh, floor);
      EXPECT_LT(floor.triangleCount(), 40u);
    }
}

TEST(Mirror, isKeptTogetherWithALargestDeviation) {
  const Doubled whole = box();
  const TriangleMesh mesh = meshAt(whole.mesh, run(whole, Method::Limber, 0, 0.05), 0).mesh;
  EXPECT_EQ(facesOf(mesh, 1), facesOf(mesh, -1));
  EXPECT_LT(mesh.triangleCount(), whole.mesh.triangleCount() / 2);
}

// A vertex on the border lies on the plane, and no edge of it does.
Doubled fan() {
  const TriangleMesh mesh = {{{0, 0, 0},
                              {1, 0, 0},
                              {-1, 0, 0},
                              {1, 1, 0},
                              {-1, 1, 0},
                              {2, 0, 0},
                              {-2, 0, 0},
                              {2, 1.5, 0},
                              {-2, 1.5, 0},
                              {0, 2, 0}},
                             {{0, 1, 3},
                              {0, 3, 4},
                              {0, 4, 2},
                              {1, 5, 3},
                              {2, 4, 6},
                              {5, 7, 3},
                              {6, 4, 8},
                              {3, 7, 9},
                              {4, 9, 8},
                              {3, 9, 4}}};
  return {mesh, {0, 2, 1, 4, 3, 6, 5, 8, 7, 9}};
}

TEST(Mirror, verticesOnThePlaneStayOnIt) {
  for (const Doubled& whole : {fan(), sheet(), box()})
    for (const Method method : kMethods) {
      const History history = run(whole, method, 0);
      for (uint32_t i = 0; i < history.collapseCount(); ++i)
        if (whole.mirror[history.kept[i]] == history.kept[i]) {
          EXPECT_EQ(history.positions[3 * i], 0) << i;
        }
    }
}

// The base of a bipyramid of three sides lies on the plane.
TEST(Mirror, doesNotCollapseATetrahedron) {
  const Doubled whole = {{{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0.3, 0.3}, {-1, 0.3, 0.3}},
                          {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}}},
                         {0, 1, 2, 4, 3}};
  for (const Method method : kMethods)
    EXPECT_EQ(meshAt(whole.mesh, run(whole, method, 0), 0).mesh.triangleCount(), 6u);
}

// Corners of a square of two triangles, whose common edge lies on the plane.
TEST(Mirror, doesNotCollapseALoneTriangle) {
  const Doubled whole = {{{{0, 0, 0}, {0, 1, 0}, {1, 0.5, 0}, {-1, 0.5, 0}}, {{0, 2, 1}, {0, 1, 3}}},
                         {0, 1, 3, 2}};
  for (const Method method : kMethods)
    EXPECT_EQ(meshAt(whole.mesh, run(whole, method, 0), 0).mesh.triangleCount(), 2u);
}

// The image of a step into the plane is carried out after the samples of the step have moved.
TEST(Mirror, closedBodiesStayClosedWithAndWithoutALargestDeviation) {
  for (const auto& [levels, height] : {std::pair(1, 1.0), {2, 1.0}, {2, 0.1}, {3, 0.1}, {3, 0.3}})
    for (const double deviation : {0.0, 0.03, 0.05, 0.1, 0.2}) {
      const Doubled whole = mirrored::ball(levels, height);
      const TriangleMesh mesh = meshAt(whole.mesh, run(whole, Method::Limber, 0, deviation), 0).mesh;
      expectSameTopology(whole.mesh, mesh);
      EXPECT_EQ(facesOf(mesh, 1), facesOf(mesh, -1));
      EXPECT_GE(mesh.triangleCount(), 4u);
    }
}

// With vertices that are fixed on only one side, or that differ slightly from the images of their partners.
TEST(Mirror, verticesThatAreHeldStayWhereTheyAre) {
  for (Doubled whole : {sheet(), box()})
    for (const Method method : kMethods) {
      Job job;
      SimplifyOptions options{.method = method, .qualityWeight = 0.1, .sizeWeight = 0.01};
      options.constraints.mirror = whole.mirror;
      std::vector<uint8_t> locked(whole.mesh.vertexCount(), 0);
      for (uint32_t v = 0; v < whole.mesh.vertexCount(); ++v) {
        Vec3& p = whole.mesh.positions[v];
        if (p.x > 0) p.y += 0x1p-16;
        locked[v] = v % 7 == 0 && p.x > 0;
        if (v % 5 == 0) locked[v] = locked[whole.mirror[v]] = 1;
      }
      options.constraints.locked = locked;
      const MeshAt floor = meshAt(whole.mesh, simplify(whole.mesh, {}, options, job), 0);
      EXPECT_LT(floor.mesh.triangleCount(), whole.mesh.triangleCount() / 2);
      for (uint32_t v = 0; v < whole.mesh.vertexCount(); ++v) {
        if (!locked[v]) continue;
        EXPECT_EQ(floor.inputOfVertex[floor.vertexOfInput[v]], v);
        EXPECT_TRUE(floor.mesh.positions[floor.vertexOfInput[v]] == whole.mesh.positions[v]) << v;
      }
    }
}

TEST(Mirror, whatIsNoSymmetryIsRefusedWithASentence) {
  const Doubled good = sheet();
  std::vector<Doubled> bad(4, good);
  std::swap(bad[0].mirror[1], bad[0].mirror[2]);
  bad[1].mesh.positions[5].z += 0.1;
  bad[2].mesh.triangles.pop_back();
  bad[3].mirror.pop_back();
  for (const Doubled& whole : bad) EXPECT_THROW(run(whole, Method::Qem, 0), std::invalid_argument);
}

}  // namespace
}  // namespace limber
