#include "transfer/corner_sources.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <stdexcept>

#include "base/parallel.h"
#include "fit/part_writer.h"
#include "reduced.h"
#include "shapes.h"
#include "surfaces.h"

namespace limber {
namespace {

Vec3 sourcePoint(const TriangleMesh& original, const CornerSources& sources, uint32_t corner) {
  Vec3 point;
  for (int c = 0; c < 3; ++c)
    point += original.corner(sources.triangle[corner], c) * sources.barycentric[3 * corner + c];
  return point;
}

Vec3 centreOf(const TriangleMesh& mesh, uint32_t t) {
  return (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3;
}

// A number per triangle, from the position of its centre.
template <typename Rule>
std::vector<uint32_t> groupsOf(const TriangleMesh& mesh, const Rule& rule) {
  std::vector<uint32_t> groups;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) groups.push_back(rule(centreOf(mesh, t)));
  return groups;
}

// A number per corner, from the positions of the triangle's centre and of the vertex.
template <typename Rule>
std::vector<uint32_t> wedgesOf(const TriangleMesh& mesh, const Rule& rule) {
  std::vector<uint32_t> wedges;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    for (const uint32_t v : mesh.triangles[t]) wedges.push_back(rule(centreOf(mesh, t), mesh.positions[v]));
  return wedges;
}

// Wavy, so that no two collapses cost the same.
TriangleMesh wavyGrid(int cells) {
  TriangleMesh mesh = shapes::grid(cells, cells);
  for (Vec3& p : mesh.positions) p.z = 0.05 * std::sin(9 * p.x + 2 * p.y);
  return surfaces::inFloats(mesh);
}

uint32_t rightHalf(const Vec3& centre) {
  return centre.x > 0.5;
}

// The corners at each vertex.
std::map<uint32_t, std::vector<uint32_t>> cornersByVertex(const TriangleMesh& mesh) {
  std::map<uint32_t, std::vector<uint32_t>> corners;
  for (uint32_t corner = 0; corner < 3 * mesh.triangleCount(); ++corner)
    corners[mesh.triangles[corner / 3][corner % 3]].push_back(corner);
  return corners;
}

TEST(CornerSources, areTheCornersThemselvesWhereNothingCollapsed) {
  const TriangleMesh mesh = wavyGrid(6);
  const auto groups = groupsOf(mesh, rightHalf);
  Job job;
  const CornerSources sources =
      sourceOfCorners(mesh, {.wedges = {}, .groups = groups}, reduced(mesh, mesh.triangleCount()), job);
  for (uint32_t corner = 0; corner < sources.triangle.size(); ++corner) {
    ASSERT_EQ(sources.triangle[corner], corner / 3);
    for (uint32_t c = 0; c < 3; ++c) ASSERT_EQ(sources.barycentric[3 * corner + c], c == corner % 3);
  }
}

TEST(CornerSources, reproduceLinearAttributesOfAFlatSheet) {
  const TriangleMesh mesh = surfaces::inFloats(shapes::grid(16, 16));
  const MeshAt result = reduced(mesh, 80);
  Job job;
  const CornerSources sources = sourceOfCorners(mesh, {}, result, job);
  for (const auto& [v, corners] : cornersByVertex(result.mesh))
    for (const uint32_t corner : corners)
      ASSERT_LT(length(sourcePoint(mesh, sources, corner) - result.mesh.positions[v]), 1e-6);
}

TEST(CornerSources, neverLieBeyondASeamAndMeetOnIt) {
  const TriangleMesh mesh = wavyGrid(16);
  const auto groups = groupsOf(mesh, rightHalf);
  const auto wedges = wedgesOf(
      mesh, [](const Vec3& centre, const Vec3& at) { return at.x == 0.5 ? 1 + rightHalf(centre) : 0; });
  for (const Charts& charts :
       {Charts{.wedges = {}, .groups = groups}, Charts{.wedges = wedges, .groups = {}}})
    for (const uint32_t faces : {400u, 150u, 60u, 20u}) {
      const MeshAt result = reduced(mesh, faces);
      Job job;
      const CornerSources sources = sourceOfCorners(mesh, charts, result, job);
      uint32_t shared = 0;
      for (const auto& [v, corners] : cornersByVertex(result.mesh)) {
        std::map<uint32_t, Vec3> pointOfSide;
        for (const uint32_t corner : corners) {
          const uint32_t side = groups[result.inputOfTriangle[corner / 3]];
          ASSERT_EQ(groups[sources.triangle[corner]], side);
          const Vec3 point = sourcePoint(mesh, sources, corner);
          const auto [known, isNew] = pointOfSide.try_emplace(side, point);
          ASSERT_LT(length(known->second - point), 1e-12);
        }
        if (pointOfSide.size() < 2) continue;
        ++shared;
        ASSERT_NEAR(pointOfSide[0].x, 0.5, 1e-7);
        ASSERT_LT(length(pointOfSide[0] - pointOfSide[1]), 1e-7);
      }
      ASSERT_GE(shared, 2u);
    }
}

TEST(CornerSources, ofOneVertexAndSideAreTheSame) {
  const TriangleMesh mesh = surfaces::inFloats(shapes::jittered(shapes::torus(24, 12), 0.02, 3));
  const auto groups = groupsOf(mesh, [](const Vec3& centre) { return uint32_t{centre.z > 0}; });
  const MeshAt result = reduced(mesh, 150);
  Job job;
  const CornerSources sources = sourceOfCorners(mesh, {.wedges = {}, .groups = groups}, result, job);
  uint32_t movedOnSeams = 0;
  for (const auto& [v, corners] : cornersByVertex(result.mesh)) {
    const bool isKept = mesh.positions[result.inputOfVertex[v]] == result.mesh.positions[v];
    std::set<std::pair<uint32_t, float>> found;
    std::set<uint32_t> sides;
    for (const uint32_t corner : corners) {
      found.insert({sources.triangle[corner], sources.barycentric[3 * corner]});
      sides.insert(groups[sources.triangle[corner]]);
    }
    if (isKept) continue;
    ASSERT_LE(found.size(), sides.size());
    movedOnSeams += sides.size() > 1;
  }
  EXPECT_GT(movedOnSeams, 0u) << "otherwise the test shows nothing";
}

TEST(CornerSources, keepThePointWhereThreeChartsMeet) {
  const TriangleMesh mesh = wavyGrid(16);
  const auto groups =
      groupsOf(mesh, [](const Vec3& centre) { return centre.x > 0.5 ? 2 : uint32_t{centre.y > 0.5}; });
  for (const uint32_t faces : {300u, 100u, 40u}) {
    const MeshAt result = reduced(mesh, faces);
    Job job;
    const CornerSources sources = sourceOfCorners(mesh, {.wedges = {}, .groups = groups}, result, job);
    uint32_t threeChartVertices = 0;
    for (const auto& [v, corners] : cornersByVertex(result.mesh)) {
      std::set<uint32_t> sides;
      for (const uint32_t corner : corners) sides.insert(groups[sources.triangle[corner]]);
      if (sides.size() < 3) continue;
      ++threeChartVertices;
      for (const uint32_t corner : corners) {
        const Vec3 point = sourcePoint(mesh, sources, corner);
        ASSERT_EQ(point.x, 0.5);
        ASSERT_EQ(point.y, 0.5);
      }
    }
    ASSERT_EQ(threeChartVertices, 1u) << faces << " faces";
  }
}

TEST(CornerSources, closeACutAtItsTip) {
  const TriangleMesh mesh = wavyGrid(16);
  const auto wedges = wedgesOf(mesh, [](const Vec3& centre, const Vec3& at) {
    return at.x == 0.5 && at.y < 0.5 ? 1 + rightHalf(centre) : 0;
  });
  const MeshAt result = reduced(mesh, 120);
  Job job;
  const CornerSources sources = sourceOfCorners(mesh, {.wedges = wedges, .groups = {}}, result, job);
  std::map<uint32_t, std::set<double>> pointsOfVertex;
  uint32_t tips = 0;
  for (const auto& [v, corners] : cornersByVertex(result.mesh)) {
    const bool hasTip = result.vertexOfInput[8 * 17 + 8] == v;
    const Vec3 first = sourcePoint(mesh, sources, corners[0]);
    for (const uint32_t corner : corners)
      ASSERT_LT(length(sourcePoint(mesh, sources, corner) - first), 1e-6) << "the cut tears open";
    tips += hasTip && first == mesh.positions[8 * 17 + 8];
  }
  EXPECT_EQ(tips, 1u);
}

TEST(CornerSources, areTheSameForAnyNumberOfThreads) {
  const TriangleMesh mesh = surfaces::inFloats(shapes::jittered(shapes::sphere(5), 0.003, 7));
  const auto groups = groupsOf(mesh, [](const Vec3& centre) { return uint32_t{centre.z > 0}; });
  const MeshAt result = reduced(mesh, 4000);
  Job job;
  const CornerSources alone = sourceOfCorners(mesh, {.wedges = {}, .groups = groups}, result, job);
  setThreadCount(3);
  const CornerSources shared = sourceOfCorners(mesh, {.wedges = {}, .groups = groups}, result, job);
  setThreadCount(1);
  EXPECT_EQ(alone.triangle, shared.triangle);
  EXPECT_EQ(alone.barycentric, shared.barycentric);
}

TEST(CornerSources, refuseWhatDoesNotFit) {
  const TriangleMesh mesh = wavyGrid(4);
  const std::vector<uint32_t> tooFew(3, 0);
  Job job;
  EXPECT_THROW(sourceOfCorners(mesh, {.wedges = tooFew, .groups = {}}, reduced(mesh, 20), job),
               std::invalid_argument);
  EXPECT_THROW(sourceOfCorners(wavyGrid(5), {}, reduced(mesh, 20), job), std::invalid_argument);
}

TEST(CornerSources, refuseFlipsOfAnotherResult) {
  const TriangleMesh mesh = wavyGrid(6);
  MeshAt result = reduced(mesh, 40);
  result.flips = unflipped(result.mesh);
  Job job;
  EXPECT_NO_THROW(sourceOfCorners(mesh, {}, result, job));
  MeshAt beyond = result, another = result, shorter = result, longer = result;
  beyond.flips.corners[5] = 3 * result.mesh.triangleCount();
  std::swap(another.flips.corners[0], another.flips.corners[1]);
  shorter.flips.corners.pop_back();
  longer.flips.triangles.push_back({0, 1, 2});
  for (const MeshAt& damaged : {beyond, another, shorter, longer})
    EXPECT_THROW(sourceOfCorners(mesh, {}, damaged, job), std::invalid_argument);
}

}  // namespace
}  // namespace limber
