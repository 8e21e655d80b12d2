#include <gtest/gtest.h>

#include <functional>
#include <numeric>
#include <stdexcept>

#include "mesh/topology.h"
#include "same_topology.h"
#include "simplify/constraints.h"
#include "simplify/simplify.h"
#include "surfaces.h"

namespace limber {
namespace {

constexpr Method kMethods[] = {Method::Qem, Method::Paper, Method::Limber};

History run(const TriangleMesh& mesh, const SimplifyConstraints& constraints, Method method = Method::Qem) {
  Job job;
  return simplify(mesh, {},
                  {.method = method, .qualityWeight = 0.1, .sizeWeight = 0.01, .constraints = constraints},
                  job);
}

// Group 0 where x is below `at`, else 1.
std::vector<uint32_t> halves(const TriangleMesh& mesh, double at) {
  std::vector<uint32_t> groups;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    groups.push_back((mesh.corner(t, 0).x + mesh.corner(t, 1).x + mesh.corner(t, 2).x) / 3 > at);
  return groups;
}

TriangleMesh partOf(const TriangleMesh& mesh, const std::vector<uint8_t>& isIn) {
  TriangleMesh part;
  std::vector<uint32_t> number(mesh.vertexCount(), kNone);
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    if (!isIn[t]) continue;
    Triangle triangle = mesh.triangles[t];
    for (uint32_t& v : triangle) {
      if (number[v] == kNone) {
        number[v] = part.vertexCount();
        part.positions.push_back(mesh.positions[v]);
      }
      v = number[v];
    }
    part.triangles.push_back(triangle);
  }
  return part;
}

// Each group alone is a surface of the same topology as in the input.
void expectGroupsKeepTheirTopology(const TriangleMesh& mesh, const std::vector<uint32_t>& groups,
                                   const MeshAt& at) {
  for (uint32_t group = 0; group <= std::ranges::max(groups); ++group) {
    std::vector<uint8_t> before, after;
    for (uint32_t t = 0; t < mesh.triangleCount(); ++t) before.push_back(groups[t] == group);
    for (const uint32_t t : at.inputOfTriangle) after.push_back(groups[t] == group);
    SCOPED_TRACE("group " + std::to_string(group));
    expectSameTopology(partOf(mesh, before), partOf(at.mesh, after));
  }
}

TEST(SimplifyConstraints, groupsKeepTheirTopologyAtEveryCount) {
  const TriangleMesh meshes[] = {surfaces::inFloats(shapes::sphere(3)),
                                 surfaces::inFloats(shapes::jittered(shapes::torus(20, 12), 0.02, 3)),
                                 surfaces::inFloats(shapes::grid(12, 9)),
                                 surfaces::inFloats(shapes::jittered(surfaces::annulus(24, 6), 0.02, 1))};
  for (const TriangleMesh& mesh : meshes)
    for (const Method method : kMethods) {
      auto groups = halves(mesh, 0.13);
      for (uint32_t t = 0; t < mesh.triangleCount(); ++t) groups[t] += 2 * (mesh.corner(t, 0).y > 0.31);
      const History history = run(mesh, {.groups = groups}, method);
      for (const uint32_t faces : {mesh.triangleCount() / 2, mesh.triangleCount() / 5, 0u})
        expectGroupsKeepTheirTopology(mesh, groups, meshAt(mesh, history, faces));
    }
}

// A sheet of 2 x 1 with a seam at x = 1, which is given by groups, by wedges or as a crease of 60 degrees.
TriangleMesh sheet() {
  return surfaces::inFloats(shapes::grid(16, 8, 2, 1));
}
bool isOnSeam(const Vec3& p) {
  return p.x == 1;
}
void expectSeamStays(const TriangleMesh& mesh, const History& history) {
  for (const uint32_t faces : {128u, 60u, 20u, 6u}) {
    const MeshAt at = meshAt(mesh, history, faces);
    std::vector<Vec3> along;
    for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
      if (!isOnSeam(mesh.positions[v])) continue;
      const Vec3& p = at.mesh.positions[at.vertexOfInput[v]];
      EXPECT_EQ(p.x, 1) << faces;
      EXPECT_EQ(p.z, 0) << faces;
      along.push_back(p);
    }
    // The ends of the seam are junctions with the border.
    EXPECT_EQ(std::ranges::min(along, {}, &Vec3::y).y, 0);
    EXPECT_EQ(std::ranges::max(along, {}, &Vec3::y).y, 1);
  }
}

TEST(SimplifyConstraints, aSeamBetweenGroupsDoesNotMove) {
  const TriangleMesh mesh = sheet();
  const auto groups = halves(mesh, 1);
  const History history = run(mesh, {.groups = groups});
  expectSeamStays(mesh, history);
  EXPECT_LE(meshAt(mesh, history, 0).mesh.triangleCount(), 6u);
}

TEST(SimplifyConstraints, aSeamOfWedgesDoesNotMove) {
  const TriangleMesh mesh = sheet();
  const auto groups = halves(mesh, 1);
  std::vector<uint32_t> wedges;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    for (const uint32_t v : mesh.triangles[t])
      wedges.push_back(v + (isOnSeam(mesh.positions[v]) ? mesh.vertexCount() * groups[t] : 0));
  const History byWedges = run(mesh, {.wedges = wedges}), byGroups = run(mesh, {.groups = groups});
  expectSeamStays(mesh, byWedges);
  EXPECT_EQ(byWedges.kept, byGroups.kept);
}

TEST(SimplifyConstraints, aCreaseDoesNotMove) {
  TriangleMesh mesh = sheet();
  for (Vec3& p : mesh.positions) p.z = std::max(0.0, p.x - 1);
  expectSeamStays(mesh, run(mesh, {.creaseAngle = 40}));
  const History without = run(mesh, {}), blunt = run(mesh, {.creaseAngle = 50});
  EXPECT_EQ(blunt.kept, without.kept);
}

TEST(SimplifyConstraints, aTriangleWithoutAreaMakesNoCrease) {
  // The middle of a diagonal is a corner of three triangles, of which one lies on the diagonal.
  TriangleMesh mesh = shapes::grid(8, 8);
  const Triangle whole = mesh.triangles[64];
  const auto middle = mesh.vertexCount();
  mesh.positions.push_back((mesh.positions[whole[0]] + mesh.positions[whole[1]]) * 0.5);
  mesh.triangles[64] = {whole[0], middle, whole[2]};
  mesh.triangles.push_back({middle, whole[1], whole[2]});
  mesh.triangles.push_back({whole[0], whole[1], middle});
  ASSERT_EQ(triangleArea(mesh, mesh.triangleCount() - 1), 0);
  EXPECT_EQ(run(mesh, {.creaseAngle = 30}).kept, run(mesh, {}).kept);
}

TEST(SimplifyConstraints, theTipOfACutStaysWhereItIs) {
  const TriangleMesh mesh = sheet();
  // The seam runs from the border to the middle of the sheet.
  const auto groups = halves(mesh, 1);
  std::vector<uint32_t> wedges;
  uint32_t tip = kNone;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    for (const uint32_t v : mesh.triangles[t]) {
      const Vec3& p = mesh.positions[v];
      wedges.push_back(v + (isOnSeam(p) && p.y < 0.5 ? mesh.vertexCount() * groups[t] : 0));
      if (isOnSeam(p) && p.y == 0.5) tip = v;
    }
  const MeshAt floor = meshAt(mesh, run(mesh, {.wedges = wedges}), 0);
  EXPECT_EQ(floor.inputOfVertex[floor.vertexOfInput[tip]], tip);
  EXPECT_EQ(floor.mesh.positions[floor.vertexOfInput[tip]], mesh.positions[tip]);
}

TEST(SimplifyConstraints, lockedVerticesAreNeitherMovedNorRemoved) {
  for (const auto& [name, mesh] : surfaces::everyTopology())
    for (const Method method : kMethods) {
      SCOPED_TRACE(name);
      std::vector<uint8_t> locked(mesh.vertexCount());
      for (uint32_t v = 0; v < mesh.vertexCount(); v += 5) locked[v] = 1;
      const History history = run(mesh, {.locked = locked}, method);
      const MeshAt floor = meshAt(mesh, history, 0);
      for (uint32_t v = 0; v < mesh.vertexCount(); v += 5) {
        ASSERT_EQ(floor.inputOfVertex[floor.vertexOfInput[v]], v);
        ASSERT_EQ(floor.mesh.positions[floor.vertexOfInput[v]], mesh.positions[v]);
      }
    }
}

TEST(SimplifyConstraints, everyVertexLockedLeavesTheMeshAsItIs) {
  const TriangleMesh mesh = surfaces::inFloats(shapes::sphere(1));
  const std::vector<uint8_t> locked(mesh.vertexCount(), 1);
  const History history = run(mesh, {.locked = locked});
  EXPECT_EQ(history.collapseCount(), 0u);
  EXPECT_EQ(history.refused.lock, 120u);
}

TEST(SimplifyConstraints, fixedBordersKeepEveryVertexOfTheBorder) {
  const TriangleMesh mesh = surfaces::inFloats(shapes::jittered(surfaces::annulus(20, 5), 0.02, 9));
  const MeshAt floor = meshAt(mesh, run(mesh, {.borders = Borders::Fixed}), 0);
  EXPECT_LT(floor.mesh.vertexCount(), 45u);
  for (const Topology topology = buildTopology(mesh); const auto& edge : topology.edges)
    if (edge.useCount == 1) {
      ASSERT_EQ(floor.mesh.positions[floor.vertexOfInput[edge.a]], mesh.positions[edge.a]);
      ASSERT_EQ(floor.mesh.positions[floor.vertexOfInput[edge.b]], mesh.positions[edge.b]);
    }
}

TEST(SimplifyConstraints, keepWeightsKeepMoreVerticesWhereTheyAreHigh) {
  const TriangleMesh mesh = surfaces::inFloats(shapes::jittered(shapes::sphere(4), 0.002, 1));
  std::vector<float> keep;
  for (const Vec3& p : mesh.positions) keep.push_back(p.z > 0 ? 1 : 0);
  for (const Method method : kMethods) {
    const auto upper = [&](const SimplifyConstraints& constraints) {
      const TriangleMesh half = meshAt(mesh, run(mesh, constraints, method), mesh.triangleCount() / 4).mesh;
      const auto count = std::ranges::count_if(half.positions, [](const Vec3& p) { return p.z > 0; });
      return static_cast<double>(count) / half.vertexCount();
    };
    EXPECT_NEAR(upper({}), 0.5, 0.1);
    EXPECT_GT(upper({.keep = keep}), 0.75);
  }
}

// The lower fifth of the sheet, one vertex inside, and two sets that overlap.
std::vector<uint32_t> pinsOf(const TriangleMesh& mesh) {
  std::vector<uint32_t> sets(mesh.vertexCount());
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const Vec3& p = mesh.positions[v];
    sets[v] = (p.y < 0.3 ? 1u : 0u) | (p.x < 0.4 ? 2u : 0u) | (p.x == 1.5 && p.y == 0.625 ? 1u << 31 : 0u);
  }
  return sets;
}

TEST(SimplifyConstraints, survivorsCarryThePinnedSetsOfThoseThatHaveBecomeThem) {
  const TriangleMesh mesh = surfaces::inFloats(shapes::grid(32, 16, 2, 1));
  const auto sets = pinsOf(mesh);
  for (const Method method : kMethods) {
    const History history = run(mesh, {.pinnedSets = sets}, method);
    for (const uint32_t faces : {500u, 100u, 0u}) {
      const MeshAt at = meshAt(mesh, history, faces);
      std::vector<uint8_t> wasPinned(at.mesh.vertexCount());
      for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
        const uint32_t survivor = at.vertexOfInput[v];
        if (sets[v] == 0) continue;
        ASSERT_EQ(sets[at.inputOfVertex[survivor]], sets[v]);
        wasPinned[survivor] = 1;
      }
      for (uint32_t v = 0; v < at.mesh.vertexCount(); ++v)
        ASSERT_EQ(wasPinned[v] != 0, sets[at.inputOfVertex[v]] != 0);
    }
  }
}

TEST(SimplifyConstraints, aPinnedSetKeepsItsOutline) {
  const TriangleMesh mesh = surfaces::inFloats(shapes::grid(32, 16, 2, 1));
  const auto sets = pinsOf(mesh);
  const MeshAt floor = meshAt(mesh, run(mesh, {.pinnedSets = sets}), 0);
  EXPECT_LT(floor.mesh.triangleCount(), 60u);
  Bounds before[2], after[2];
  for (int set = 0; set < 2; ++set) {
    for (Bounds* box : {&before[set], &after[set]}) *box = {{9, 9, 9}, {-9, -9, -9}};
    const auto add = [](Bounds& box, const Vec3& p) {
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), 0};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), 0};
    };
    for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
      if (sets[v] >> set & 1) add(before[set], mesh.positions[v]);
    for (uint32_t v = 0; v < floor.mesh.vertexCount(); ++v)
      if (sets[floor.inputOfVertex[v]] >> set & 1) add(after[set], floor.mesh.positions[v]);
    EXPECT_EQ(after[set].low, before[set].low);
    EXPECT_EQ(after[set].high, before[set].high);
  }
}

// A rough sheet in a plane, so that positions alone cost nothing, with an attribute over it.
TriangleMesh roughSheet() {
  TriangleMesh mesh = shapes::jittered(shapes::grid(32, 16, 2, 1), 0.01, 8);
  for (Vec3& p : mesh.positions) p = {std::round(1024 * p.x) / 1024, std::round(1024 * p.y) / 1024, 0};
  return mesh;
}

TEST(SimplifyConstraints, attributesKeepVerticesWhereTheyBend) {
  const TriangleMesh mesh = roughSheet();
  std::vector<float> ramp;
  for (const Vec3& p : mesh.positions)
    ramp.push_back(
        static_cast<float>(p.x < 1 ? 0.1 * p.x : 0.1 + 0.05 * std::sin(9 * (p.x - 1)) * std::sin(8 * p.y)));
  for (const Method method : kMethods) {
    const History history = run(mesh, {.attributes = ramp, .attributeDimension = 1}, method);
    const TriangleMesh quarter = meshAt(mesh, history, mesh.triangleCount() / 4).mesh;
    const auto right = std::ranges::count_if(quarter.positions, [](const Vec3& p) { return p.x > 1; });
    EXPECT_GT(right, 0.6 * quarter.vertexCount());
  }
}

TEST(SimplifyConstraints, attributesThatAreLinearOnEachSideOfASeamCostNothing) {
  const TriangleMesh mesh = roughSheet();
  const auto groups = halves(mesh, 1);
  std::vector<uint32_t> wedges;
  std::vector<float> values(4 * mesh.vertexCount());
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    for (const uint32_t v : mesh.triangles[t]) {
      wedges.push_back(v + mesh.vertexCount() * groups[t]);
      const Vec3& p = mesh.positions[v];
      values[2 * wedges.back()] = static_cast<float>(groups[t] ? p.x : 2 - p.y);
      values[2 * wedges.back() + 1] = static_cast<float>(groups[t] ? 3 * p.y : p.x);
    }
  const SimplifyConstraints plain{.wedges = wedges};
  const SimplifyConstraints linear{.wedges = wedges, .attributes = values, .attributeDimension = 2};
  // Rounding noise moves the first of these vertices only after many collapses.
  const History a = run(mesh, linear, Method::Limber), b = run(mesh, plain, Method::Limber);
  for (size_t i = 0; i < 100; ++i) ASSERT_EQ(a.removed[i], b.removed[i]) << i;
}

TEST(SimplifyConstraints, textureCoordinatesCostAsMuchAsTheirTrianglesWeigh) {
  const TriangleMesh mesh = roughSheet();
  std::vector<float> waves;
  for (const Vec3& p : mesh.positions)
    for (const double u : {std::sin(9 * p.x) * std::sin(8 * p.y), std::cos(9 * p.x)})
      waves.push_back(static_cast<float>(0.05 * u));
  const auto shareOfRight = [&](double left, double right) {
    std::vector<float> weights;
    for (const auto& [a, b, c] : mesh.triangles)
      weights.push_back(static_cast<float>(mesh.positions[a].x + mesh.positions[b].x < 2 ? left : right));
    const SimplifyConstraints constraints{
        .attributes = waves, .textureWeights = weights, .attributeDimension = 2};
    const TriangleMesh quarter =
        meshAt(mesh, run(mesh, constraints, Method::Limber), mesh.triangleCount() / 4).mesh;
    const auto count = std::ranges::count_if(quarter.positions, [](const Vec3& p) { return p.x > 1; });
    return static_cast<double>(count) / quarter.vertexCount();
  };
  EXPECT_NEAR(shareOfRight(1, 1), 0.5, 0.1);
  EXPECT_GT(shareOfRight(0, 1), 0.65);
  EXPECT_LT(shareOfRight(1, 0), 0.35);
}

TEST(SimplifyConstraints, textureWeightsOfOneChangeNothing) {
  const TriangleMesh mesh = roughSheet();
  std::vector<float> waves;
  for (const Vec3& p : mesh.positions)
    for (const double u : {0.05 * std::sin(9 * p.x), 0.1 * p.y, 0.02 * std::cos(8 * p.y)})
      waves.push_back(static_cast<float>(u));
  const std::vector<float> ones(mesh.triangleCount(), 1);
  const History a = run(mesh, {.attributes = waves, .attributeDimension = 3});
  const History b = run(mesh, {.attributes = waves, .textureWeights = ones, .attributeDimension = 3});
  EXPECT_EQ(a.removed, b.removed);
}

TEST(SimplifyConstraints, aSeamGivesUpMoreOfItsVerticesThanAnOutline) {
  const TriangleMesh mesh = shapes::jittered(shapes::sphere(4), 0.2, 5);
  const auto groups = halves(mesh, 0);
  std::vector<uint32_t> wedges, sides(mesh.vertexCount());
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    for (const uint32_t v : mesh.triangles[t]) {
      wedges.push_back(v + mesh.vertexCount() * groups[t]);
      sides[v] |= 1u << groups[t];
    }
  const auto goneFromLine = [&](const SimplifyConstraints& constraints) {
    const History history = run(mesh, constraints);
    const auto half = std::span(history.removed).first(mesh.vertexCount() / 2);
    return std::ranges::count_if(half, [&](uint32_t v) { return sides[v] == 3; });
  };
  EXPECT_GT(goneFromLine({.wedges = wedges}), 1.5 * goneFromLine({.groups = groups}));
}

// Displacements of a sheet in the plane z = 0, [3 * v + c]: waves along z where `across` is true, else along
// x.
std::vector<float> wavesOf(const TriangleMesh& mesh, const std::function<bool(const Vec3&)>& across) {
  std::vector<float> waves(3 * size_t{mesh.vertexCount()});
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const Vec3& p = mesh.positions[v];
    waves[3 * size_t{v} + (across(p) ? 2 : 0)] =
        static_cast<float>(0.05 * std::sin(9 * p.x) * std::sin(8 * p.y));
  }
  return waves;
}

TEST(SimplifyConstraints, displacementsAcrossTheSurfaceKeepMoreVerticesThanThoseWithinIt) {
  const TriangleMesh mesh = roughSheet();
  const std::vector<float> waves = wavesOf(mesh, [](const Vec3& p) { return p.x > 1; });
  const auto shareOfRight = [&](uint32_t displacementFields) {
    const SimplifyConstraints constraints{
        .attributes = waves, .attributeDimension = 3, .displacementFields = displacementFields};
    const History history = run(mesh, constraints, Method::Qem);
    const TriangleMesh quarter = meshAt(mesh, history, mesh.triangleCount() / 4).mesh;
    const auto right = std::ranges::count_if(quarter.positions, [](const Vec3& p) { return p.x > 1; });
    return static_cast<double>(right) / quarter.vertexCount();
  };
  EXPECT_NEAR(shareOfRight(0), 0.5, 0.05);
  EXPECT_GT(shareOfRight(1), 0.6);
}

TEST(SimplifyConstraints, anAffineMotionOfASheetCostsNothing) {
  const TriangleMesh mesh = roughSheet();
  std::vector<float> affine;
  for (const Vec3& p : mesh.positions)
    for (const double value : {0.25 * p.y, 0.5 * p.x - 0.125 * p.z, 0.5 + 0.25 * p.z})
      affine.push_back(static_cast<float>(value));
  const SimplifyConstraints moving{.attributes = affine, .attributeDimension = 3, .displacementFields = 1};
  const History a = run(mesh, moving, Method::Limber), b = run(mesh, {}, Method::Limber);
  for (size_t i = 0; i < 100; ++i) ASSERT_EQ(a.removed[i], b.removed[i]) << i;
}

TEST(SimplifyConstraints, listsThatDoNotFitAreRefusedWithASentence) {
  const TriangleMesh mesh = shapes::sphere(1);
  const std::vector<uint32_t> numbers(7);
  const std::vector<float> floats(mesh.vertexCount(), 2);
  const std::vector<float> tooLarge(mesh.triangleCount(), 1.5F);
  const std::vector<uint8_t> bytes(7);
  const std::vector<uint32_t> lastWedge(3 * size_t{mesh.triangleCount()}, UINT32_MAX);
  const SimplifyConstraints bad[] = {{.wedges = numbers},
                                     {.groups = numbers},
                                     {.locked = bytes},
                                     {.keep = floats},
                                     {.pinnedSets = numbers},
                                     {.textureWeights = floats},
                                     {.textureWeights = tooLarge},
                                     {.attributes = floats, .attributeDimension = 9},
                                     {.creaseAngle = 181},
                                     {.attributes = floats, .attributeDimension = 2},
                                     {.attributes = floats, .attributeDimension = 1, .displacementFields = 1},
                                     {.wedges = lastWedge, .attributes = floats, .attributeDimension = 1}};
  for (const SimplifyConstraints& constraints : bad)
    EXPECT_THROW(run(mesh, constraints), std::invalid_argument);
  try {
    run(mesh, {.groups = numbers});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "The list of groups has 7 values, but the mesh has 80 triangles: make it for this mesh.");
  }
}

}  // namespace
}  // namespace limber
