#include "simplify/creases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "base/job.h"
#include "mesh/topology.h"
#include "shapes.h"
#include "simplify/simplify.h"

namespace limber {
namespace {

using namespace shapes;

std::vector<uint8_t> creasesOf(const TriangleMesh& mesh) {
  return findCreases(mesh, buildIncidence(mesh));
}

int countOf(const std::vector<uint8_t>& creases) {
  return std::accumulate(creases.begin(), creases.end(), 0);
}

TEST(Creases, OfABoxAreTheEdgesBetweenItsSides) {
  const TriangleMesh mesh = box(3, 4, 5, 0.1);
  const Topology topology = buildIncidence(mesh);
  const std::vector<uint8_t> creases = findCreases(mesh, topology);
  ASSERT_EQ(creases.size(), topology.edges.size());
  EXPECT_EQ(countOf(creases), 4 * (3 + 4 + 5));
  for (size_t e = 0; e < creases.size(); ++e) {
    const auto triangles = topology.trianglesAt(topology.edges[e]);
    const double cosine =
        dot(normalized(areaNormal(mesh, triangles[0])), normalized(areaNormal(mesh, triangles[1])));
    EXPECT_EQ(creases[e] != 0, cosine < 0.5) << "edge " << e;
  }
}

TEST(Creases, DoNotDependOnUnitsOrOnHowSidesAreCut) {
  TriangleMesh large = box(2, 3, 4, 1e5);
  EXPECT_EQ(creasesOf(large), creasesOf(box(2, 3, 4, 1e-5)));
  EXPECT_EQ(countOf(creasesOf(box(8, 12, 16, 1))), 4 * (8 + 12 + 16));
}

TEST(Creases, AreNotFoundOnRoundSurfacesHoweverCoarseOrRough) {
  for (const int levels : {1, 2, 4}) EXPECT_TRUE(creasesOf(sphere(levels)).empty()) << levels;
  EXPECT_TRUE(creasesOf(torus(24, 12)).empty());
  EXPECT_TRUE(creasesOf(torus(8, 6)).empty());
  EXPECT_TRUE(creasesOf(jittered(sphere(4), 0.02, 1)).empty());
  EXPECT_TRUE(creasesOf(jittered(grid(20, 20), 0.02, 1)).empty());
}

TEST(Creases, AreNotFoundOnAFlatSheet) {
  EXPECT_TRUE(creasesOf(grid(4, 4)).empty());
}

// A strut whose edges across are a twentieth of those along: the price of size takes the short ones first.
TEST(Creases, KeepAThinStrutAsThickAsItIsWithTheMethodLimber) {
  const TriangleMesh strut = box(2, 2, 60, 1);
  SimplifyOptions options;
  options.method = Method::Limber;
  options.qualityWeight = 0.1;
  options.sizeWeight = 0.01;
  options.stopFaces = 40;
  Job job;
  const TriangleMesh result = meshAt(strut, simplify(strut, {}, options, job), 40).mesh;
  EXPECT_LE(result.triangleCount(), 40u);
  double volume = 0;
  for (const auto& [a, b, c] : result.triangles)
    volume += dot(result.positions[a], cross(result.positions[b], result.positions[c])) / 6;
  EXPECT_NEAR(volume, 2 * 2 * 60, 0.01 * 240);
}

}  // namespace
}  // namespace limber
