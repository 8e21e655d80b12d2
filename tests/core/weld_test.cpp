#include "mesh/weld.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "mesh/welding/close_vertices.h"
#include "mesh/inspect.h"
#include "shapes.h"

namespace limber {
namespace {

struct Soup {
  std::vector<float> positions;
  std::vector<uint32_t> indices;

  uint32_t vertex(float x, float y, float z) {
    positions.insert(positions.end(), {x, y, z});
    return static_cast<uint32_t>(positions.size() / 3 - 1);
  }
  void face(uint32_t a, uint32_t b, uint32_t c) { indices.insert(indices.end(), {a, b, c}); }
};

// Gives every corner a vertex of its own.
Soup shattered(const TriangleMesh& mesh) {
  Soup soup;
  for (const Triangle& t : mesh.triangles)
    for (uint32_t v : t) {
      const Vec3& p = mesh.positions[v];
      soup.indices.push_back(
          soup.vertex(static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)));
    }
  return soup;
}

Soup soupOf(const TriangleMesh& mesh) {
  Soup soup;
  for (const Vec3& p : mesh.positions)
    soup.vertex(static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z));
  for (const Triangle& t : mesh.triangles) soup.face(t[0], t[1], t[2]);
  return soup;
}

WeldResult welded(const Soup& soup, const WeldOptions& options = {}) {
  Job job;
  return weld(soup.positions, soup.indices, options, job);
}

std::string errorOf(const Soup& soup, const WeldOptions& options = {}) {
  try {
    welded(soup, options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Weld, makesAShatteredSphereWholeAgain) {
  const TriangleMesh sphere = shapes::sphere(2);
  const WeldResult result = welded(shattered(sphere));
  EXPECT_EQ(result.mesh.vertexCount(), sphere.vertexCount());
  EXPECT_EQ(result.weldedVertices, 3 * sphere.triangleCount() - sphere.vertexCount());
  EXPECT_EQ(inspect(result.mesh).eulerCharacteristic, 2);
}

TEST(Weld, changesNothingOfACleanMesh) {
  const TriangleMesh torus = shapes::torus(8, 6);
  const WeldResult result = welded(soupOf(torus));
  EXPECT_EQ(result.mesh.triangles, torus.triangles);
  for (uint32_t v = 0; v < torus.vertexCount(); ++v) EXPECT_EQ(result.vertexOfSource[v], v);
  EXPECT_EQ(result.weldedVertices + result.degenerateFaces + result.duplicateFaces + result.flippedFaces, 0u);
}

TEST(Weld, takesMinusZeroForZero) {
  Soup soup;
  soup.face(soup.vertex(0, 0, 0), soup.vertex(1, 0, 0), soup.vertex(0, 1, 0));
  soup.face(soup.vertex(-0.0f, 0, -0.0f), soup.vertex(0, 1, -0.0f), soup.vertex(-1, 0, 0));
  const WeldResult result = welded(soup);
  EXPECT_EQ(result.mesh.vertexCount(), 4u);
  EXPECT_EQ(result.weldedVertices, 2u);
  EXPECT_FALSE(std::signbit(result.mesh.positions[0].x));
}

TEST(Weld, numbersVerticesBySourceAndDropsUnreferencedOnes) {
  Soup soup;
  const uint32_t loose = soup.vertex(9, 9, std::numeric_limits<float>::quiet_NaN());
  const uint32_t a = soup.vertex(0, 0, 0), b = soup.vertex(1, 0, 0), c = soup.vertex(0, 1, 0),
                 twin = soup.vertex(1, 0, 0), d = soup.vertex(1, 1, 0);
  soup.face(d, c, twin);
  soup.face(c, a, b);
  const WeldResult result = welded(soup);
  EXPECT_EQ(result.vertexOfSource[loose], kNone);
  EXPECT_EQ(result.vertexOfSource, (std::vector<uint32_t>{kNone, 0, 1, 2, 1, 3}));
  EXPECT_EQ(result.mesh.triangles, (std::vector<Triangle>{{3, 2, 1}, {2, 0, 1}}));
  EXPECT_EQ(result.sourceOfTriangle, (std::vector<uint32_t>{0, 1}));
}

TEST(Weld, setsAsideDegenerateAndDuplicateFaces) {
  Soup soup;
  const uint32_t a = soup.vertex(0, 0, 0), b = soup.vertex(1, 0, 0), c = soup.vertex(0, 1, 0),
                 onlyHere = soup.vertex(2, 0, 0);
  soup.face(a, a, onlyHere);
  soup.face(a, b, c);
  soup.face(b, c, a);
  soup.face(a, c, b);
  const WeldResult result = welded(soup);
  EXPECT_EQ(result.degenerateFaces, 1u);
  EXPECT_EQ(result.duplicateFaces, 2u);
  EXPECT_EQ(result.sourceOfTriangle, std::vector<uint32_t>{1});
  EXPECT_EQ(result.vertexOfSource[onlyHere], kNone);
  const WeldResult kept = welded(soup, {.keepDuplicates = true});
  EXPECT_EQ(kept.duplicateFaces, 2u);
  EXPECT_EQ(kept.mesh.triangleCount(), 3u);
}

TEST(Weld, keepsAFaceWithoutAreaWhoseVerticesDifferSoThatNoCrackOpens) {
  Soup soup;
  const uint32_t a = soup.vertex(0, 0, 0), b = soup.vertex(1, 0, 0), c = soup.vertex(0, 1, 0),
                 middle = soup.vertex(0.5f, 0, 0);
  soup.face(a, b, c);
  soup.face(b, a, middle);
  const WeldResult result = welded(soup);
  EXPECT_EQ(result.degenerateFaces, 0u);
  EXPECT_EQ(result.mesh.triangleCount(), 2u);
}

TEST(Weld, keepsAThinFaceThatFloatsResolve) {
  Soup soup;
  soup.face(soup.vertex(0, 0, 0), soup.vertex(1, 0, 0), soup.vertex(0.5f, 1e-6f, 0));
  EXPECT_EQ(welded(soup).mesh.triangleCount(), 1u);
}

TEST(Weld, flipsTheSmallerSideOfAComponent) {
  TriangleMesh torus = shapes::torus(8, 6);
  for (uint32_t t : {3u, 4u, 40u}) std::swap(torus.triangles[t][0], torus.triangles[t][2]);
  const WeldResult few = welded(soupOf(torus));
  EXPECT_EQ(few.flippedFaces, 3u);
  EXPECT_EQ(inspect(few.mesh).orientationClashes, 0u);
  // If most faces are flipped, the others are flipped too, for no body is turned inside out as a whole.
  for (Triangle& t : torus.triangles) std::swap(t[0], t[1]);
  EXPECT_EQ(welded(soupOf(torus)).flippedFaces, 3u);
}

TEST(Weld, keepsTheLowestFaceOfATie) {
  Soup soup;
  const uint32_t a = soup.vertex(0, 0, 0), b = soup.vertex(1, 0, 0), c = soup.vertex(0, 1, 0),
                 d = soup.vertex(1, 1, 0);
  soup.face(a, b, c);
  soup.face(b, c, d);
  const WeldResult result = welded(soup);
  EXPECT_EQ(result.flippedFaces, 1u);
  EXPECT_EQ(result.mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}}));
}

TEST(Weld, leavesAMoebiusStripAsItIs) {
  Soup soup;
  for (int v = 0; v < 5; ++v)
    soup.vertex(std::cos(static_cast<float>(v)), std::sin(static_cast<float>(v)), v * 0.1f);
  for (uint32_t v = 0; v < 5; ++v) soup.face(v, (v + 1) % 5, (v + 2) % 5);
  const WeldResult result = welded(soup);
  EXPECT_EQ(result.flippedFaces, 0u);
  EXPECT_GT(inspect(result.mesh).orientationClashes, 0u);
}

TEST(Weld, closesACrackOnlyWithATolerance) {
  TriangleMesh sphere = shapes::sphere(2);
  Soup soup = shattered(sphere);
  for (size_t i = 0; i < soup.positions.size(); ++i) soup.positions[i] += i % 7 == 0 ? 1e-5f : 0;
  EXPECT_GT(inspect(welded(soup).mesh).boundaryLoops, 0u);
  const WeldResult closed = welded(soup, {.tolerance = 0.01});
  EXPECT_EQ(closed.mesh.vertexCount(), sphere.vertexCount());
  EXPECT_EQ(inspect(closed.mesh).boundaryLoops, 0u);
}

TEST(Weld, unitesChainsOfClosePointsLikeAPlainComparisonOfAllPairs) {
  for (uint32_t seed : {1u, 2u, 3u}) {
    std::mt19937 random(seed);
    std::vector<Vec3> points(400);
    for (Vec3& p : points) p = Vec3{random() * 1e-9, random() * 1e-9, random() * 1e-9} - Vec3{2, 2, 2};
    Job job;
    const double distance = 0.3;
    const auto found = uniteCloseVertices(points, distance, job);
    std::vector<uint32_t> expected(points.size());
    for (uint32_t i = 0; i < points.size(); ++i) expected[i] = i;
    for (bool changed = true; changed;) {
      changed = false;
      for (uint32_t i = 0; i < points.size(); ++i)
        for (uint32_t j = 0; j < i; ++j)
          if (expected[i] != expected[j] && length(points[i] - points[j]) < distance) {
            expected[i] = expected[j] = std::min(expected[i], expected[j]);
            changed = true;
          }
    }
    EXPECT_EQ(found, expected) << "seed " << seed;
  }
}

TEST(Weld, isNoErrorWithoutUsableFaces) {
  Soup soup;
  soup.face(soup.vertex(0, 0, 0), soup.vertex(1, 0, 0), soup.vertex(1, 0, 0));
  const WeldResult result = welded(soup);
  EXPECT_EQ(result.mesh.vertexCount(), 0u);
  EXPECT_EQ(result.mesh.triangleCount(), 0u);
  EXPECT_EQ(welded(Soup{}).mesh.vertexCount(), 0u);
}

TEST(Weld, saysWhatIsWrongWithASoupItCannotRead) {
  Soup soup;
  soup.face(soup.vertex(0, 0, 0), soup.vertex(1, 0, 0), 7);
  EXPECT_EQ(errorOf(soup),
            "Face 1 uses vertex 8, but there are only 2 vertices: the file is damaged, export it again.");
  soup.indices[2] = soup.vertex(0, std::numeric_limits<float>::infinity(), 0);
  EXPECT_NE(errorOf(soup).find("vertex 3 is not a finite number"), std::string::npos);
  soup.indices.pop_back();
  EXPECT_NE(errorOf(soup).find("must come in threes"), std::string::npos);
  EXPECT_NE(errorOf(Soup{}, {.tolerance = -1}).find("tolerance"), std::string::npos);
}

TEST(Weld, stopsWhenItIsCancelled) {
  Job job;
  job.requestCancel();
  EXPECT_THROW(weld({}, {}, {}, job), Cancelled);
}

}  // namespace
}  // namespace limber
