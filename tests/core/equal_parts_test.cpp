// Equal parts of a body are found, and solved once.

#include "modes/equal_parts.h"

#include <gtest/gtest.h>

#include "mesh/topology.h"
#include "modes/find_modes.h"
#include "shapes.h"
#include "surfaces.h"

namespace limber {
namespace {

TriangleMesh moved(TriangleMesh mesh, const Vec3& by, double scale = 1) {
  for (Vec3& p : mesh.positions) p = scale * p + by;
  return mesh;
}

std::vector<size_t> firstEqual(const TriangleMesh& body, const ModesOptions& options = {}) {
  return firstEqualParts(body, partsOf(body, buildTopology(body), options));
}

TriangleMesh three(const TriangleMesh& a, const TriangleMesh& b, const TriangleMesh& c) {
  return surfaces::inFloats(shapes::together(shapes::together(a, b), c));
}

TEST(EqualParts, AreEqualWhereverTheyStand) {
  const TriangleMesh ball = shapes::sphere(1);
  const TriangleMesh body = three(ball, moved(ball, {1000, 0, 0.3}), moved(ball, {-3, 700.7, 0}));
  EXPECT_EQ(firstEqual(body), (std::vector<size_t>{0, 0, 0}));
}

TEST(EqualParts, AreNotThoseOfAnotherSizeOrShape) {
  const TriangleMesh ball = shapes::sphere(1);
  TriangleMesh dented = moved(ball, {0, 5, 0});
  dented.positions[3] += {0, 0.01, 0};
  EXPECT_EQ(firstEqual(three(ball, moved(ball, {5, 0, 0}, 1.01), dented)), (std::vector<size_t>{0, 1, 2}));
}

TEST(EqualParts, AreNotThoseWithOtherTrianglesOrPins) {
  const TriangleMesh sheet = shapes::grid(3, 3);
  TriangleMesh cut = moved(sheet, {5, 0, 0});
  // The other diagonal of the first cell.
  const uint32_t a = cut.triangles[0][0], b = cut.triangles[0][1], c = cut.triangles[0][2];
  const uint32_t d = cut.triangles[1][2];
  cut.triangles[0] = {a, b, d};
  cut.triangles[1] = {b, c, d};
  ModesOptions options;
  EXPECT_EQ(firstEqual(three(sheet, cut, moved(sheet, {0, 5, 0})), options), (std::vector<size_t>{0, 1, 0}));
  options.pinned = {0};
  EXPECT_EQ(firstEqual(three(sheet, moved(sheet, {5, 0, 0}), moved(sheet, {0, 5, 0})), options),
            (std::vector<size_t>{0, 1, 1}));
}

// The modes that findModes copies equal those of a separate solve of the part.
TEST(EqualParts, HaveTheModesOfTheFirst) {
  Job job;
  const TriangleMesh bar = shapes::box(2, 2, 6, 0.5);
  const TriangleMesh body = three(bar, shapes::sphere(1, 2), moved(bar, {8, 0, 0}));
  ModesOptions options;
  options.model = ElasticModel::Auto;
  options.modeCount = 3;
  options.material = {.young = 1e6, .poisson = 0.3, .density = 1000, .thickness = 0.1};
  const ModeSet all = findModes(body, options, true, job), alone = findModes(bar, options, true, job);
  ASSERT_EQ(all.components.size(), 3u);
  std::vector<double> first, last;
  for (const Mode& mode : all.modes) {
    if (mode.component == 0) first.push_back(mode.omega);
    if (mode.component == 2) last.push_back(mode.omega);
  }
  ASSERT_EQ(first.size(), 3u);
  EXPECT_EQ(first, last);
  for (size_t k = 0; k < first.size(); ++k) EXPECT_NEAR(first[k], alone.modes[k].omega, 1e-6 * first[k]);
  const uint32_t lastVertex = body.vertexCount() - bar.vertexCount();
  for (uint32_t v = 0; v < bar.vertexCount(); ++v)
    for (uint32_t c = 0; c < 3; ++c) EXPECT_EQ(all.shapes[3 * v + c], all.shapes[3 * (lastVertex + v) + c]);
}

}  // namespace
}  // namespace limber
