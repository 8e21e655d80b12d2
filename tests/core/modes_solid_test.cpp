#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "base/parallel.h"
#include "elastic/solid/lattice_grid.h"
#include "elastic/solid/solid.h"
#include "linear/eigensolver.h"
#include "shapes.h"
#include "surfaces.h"

namespace limber {
namespace {

// The modes of a free body in its own units, with E = rho = 1 and nu = 0.3.
struct Vibration {
  uint32_t zeroCount;
  std::vector<double> omega;  // elastic angular frequencies
  double mass;
};

Vibration vibrate(TriangleMesh body, uint32_t targetCells, int count = 6, double scale = 0.1) {
  Job job;
  const Bounds box = bounds(body);
  const double diagonal = box.diagonal();
  for (Vec3& p : body.positions) p = (p - box.low) / diagonal;
  const SolidModel solid = solidModel(body, {0.3, targetCells}, job);
  const EigenSolution solution = solveEigenproblem(solid.pencil, {count, 6, scale}, job);
  Vibration result{solution.nullity, {}, solid.pencil.m.sum() / 3 * std::pow(diagonal, 3)};
  for (double lambda : solution.basis.lambda) result.omega.push_back(std::sqrt(lambda) / diagonal);
  return result;
}

double volumeOf(const TriangleMesh& mesh) {
  double volume = 0;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    volume += dot(mesh.corner(t, 0), cross(mesh.corner(t, 1), mesh.corner(t, 2))) / 6;
  return volume;
}

TriangleMesh turned(TriangleMesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

TriangleMesh rotated(TriangleMesh mesh, double aboutZ, double aboutX) {
  for (Vec3& p : mesh.positions) {
    p = {std::cos(aboutZ) * p.x - std::sin(aboutZ) * p.y, std::sin(aboutZ) * p.x + std::cos(aboutZ) * p.y,
         p.z};
    p = {p.x, std::cos(aboutX) * p.y - std::sin(aboutX) * p.z,
         std::sin(aboutX) * p.y + std::cos(aboutX) * p.z};
  }
  return mesh;
}

// The surface of those cells of a box grid with the given planes that `isFilled(i, j, k)` picks, welded.
template <typename IsFilled>
TriangleMesh blocks(const std::array<std::vector<double>, 3>& planes, const IsFilled& isFilled) {
  std::set<surfaces::Voxel> filled;
  for (int i = 0; i + 1 < static_cast<int>(planes[0].size()); ++i)
    for (int j = 0; j + 1 < static_cast<int>(planes[1].size()); ++j)
      for (int k = 0; k + 1 < static_cast<int>(planes[2].size()); ++k)
        if (isFilled(i, j, k)) filled.insert({i, j, k});
  TriangleMesh mesh = surfaces::voxelSurface(filled);
  for (Vec3& p : mesh.positions)
    for (int axis = 0; axis < 3; ++axis) p[axis] = planes[axis][static_cast<size_t>(std::lround(p[axis]))];
  return mesh;
}

const TriangleMesh kBar = shapes::box(8, 8, 24, 0.125);

// Beam theory for the bar of 1 x 1 x 3: Timoshenko's free beam with Cowper's shear coefficient (first and
// second bending), Saint-Venant's torsion (J = 0.14058), a rod with Love's lateral inertia.
constexpr double kBend = 0.5477, kTwist = 0.5965, kStretch = 1.0387, kSecondBend = 1.1206;

// Counts whose product overflows 32 bits to a few cells, as for a thin wire along the diagonal of its box.
TEST(LatticeGrid, hasFewCellsWhereTheyWouldBeBeyond32Bits) {
  const TriangleMesh box = {{{0, 0, 0}, {0.741, 0.5, 0.622}, {0.741, 0, 0}}, {{0, 1, 2}}};
  const LatticeGrid grid = latticeGrid(box, Vec3{0.741 / 1965, 0.5 / 1326, 0.622 / 1649});
  const double cells = 1.0 * grid.count[0] * grid.count[1] * grid.count[2];
  EXPECT_LE(cells, 4e6);
  EXPECT_GT(cells, 2e6);
}

TEST(SolidModes, aBarBendsTwistsAndStretchesAsBeamTheorySays) {
  const Vibration bar = vibrate(kBar, 400);
  EXPECT_EQ(bar.zeroCount, 6u);
  EXPECT_NEAR(bar.mass, 3, 1e-4);
  const std::vector<double> expected = {kBend, kBend, kTwist, kStretch, kSecondBend, kSecondBend};
  for (size_t k = 0; k < 6; ++k) EXPECT_NEAR(bar.omega[k] / expected[k], 1, 0.02) << "mode " << k + 1;
}

TEST(SolidModes, aBarAskewToTheLatticeVibratesAlike) {
  const Vibration bar = vibrate(kBar, 1600), askew = vibrate(rotated(kBar, 0.4, 0.7), 1600);
  EXPECT_EQ(askew.zeroCount, 6u);
  EXPECT_NEAR(askew.mass, 3, 0.01);
  for (size_t k = 0; k < 6; ++k) EXPECT_NEAR(askew.omega[k] / bar.omega[k], 1, 0.03) << "mode " << k + 1;
}

TEST(SolidModes, aSphereVibratesAsLambSays) {
  // Of the unit sphere: five torsional and five spheroidal modes of degree 2, three spheroidal of degree 1.
  std::vector<double> exact(5, 1.5511);
  exact.insert(exact.end(), 5, 1.6411);
  exact.insert(exact.end(), 3, 2.1892);
  const TriangleMesh ball = shapes::sphere(4);
  const Vibration coarse = vibrate(ball, 250, 13), fine = vibrate(ball, 1200, 13);
  EXPECT_EQ(fine.zeroCount, 6u);
  EXPECT_NEAR(fine.mass / volumeOf(ball), 1, 0.005);
  for (size_t k = 0; k < 13; ++k) {
    EXPECT_NEAR(fine.omega[k] / exact[k], 1, 0.025) << "mode " << k + 1;
    EXPECT_LT(std::abs(fine.omega[k] - exact[k]), std::abs(coarse.omega[k] - exact[k])) << "mode " << k + 1;
  }
}

TEST(SolidModes, everyConnectedBodyHasSixZeroModes) {
  for (const TriangleMesh& body :
       {shapes::torus(24, 12), shapes::torus(40, 6, 1, 0.03), surfaces::doubleTorus(),
        shapes::jittered(kBar, 0.02, 4), turned(shapes::sphere(2)), shapes::box(1, 1, 40, 0.1),
        shapes::box(20, 20, 1, 0.05)})
    for (uint32_t cells : {30u, 300u}) EXPECT_EQ(vibrate(body, cells).zeroCount, 6u);
}

TEST(SolidModes, aCavityTakesMassAndStiffnessAway) {
  const TriangleMesh ball = shapes::sphere(3);
  const TriangleMesh hollow = shapes::together(ball, turned(shapes::sphere(3, 0.7)));
  const Vibration full = vibrate(ball, 600), empty = vibrate(hollow, 600);
  EXPECT_EQ(empty.zeroCount, 6u);
  EXPECT_NEAR(empty.mass / volumeOf(hollow), 1, 0.01);
  EXPECT_LT(empty.omega[0], 0.9 * full.omega[0]);
}

TEST(SolidModes, aCavitySmallerThanACellDoesNotComeLoose) {
  TriangleMesh bubble = turned(shapes::sphere(1, 0.002));
  for (Vec3& p : bubble.positions) p += Vec3{0.03, 0.02, 0.01};
  EXPECT_EQ(vibrate(shapes::together(shapes::sphere(2), bubble), 60).zeroCount, 6u);
}

// Two prongs, 1 apart from each other in the middle, joined at one end.
TriangleMesh fork(double gap) {
  return blocks({{{0, 1, 1 + gap, 2 + gap}, {0, 1}, {0, 1, 4, 8}}},
                [](int i, int, int k) { return i != 1 || k == 0; });
}

TEST(SolidModes, closeProngsOfAForkDoNotFuse) {
  const double block = vibrate(shapes::box(2, 1, 8, 1), 600).omega[0];
  const Vibration wide = vibrate(fork(0.5), 600), narrow = vibrate(fork(0.004), 600);
  EXPECT_EQ(narrow.zeroCount, 6u);
  EXPECT_LT(narrow.omega[0], 0.6 * block);
  EXPECT_NEAR(narrow.omega[0] / wide.omega[0], 1, 0.1);
}

// Two blocks, nearly cubes of side 1, and a strut of length 2 and square section between them.
TriangleMesh dumbbell(double thickness) {
  const double low = 0.5 - thickness / 2, high = 0.5 + thickness / 2;
  return blocks({{{0, low, high, 1}, {0, low, high, 1}, {0, 1.07, 3.07, 4.14}}},
                [](int i, int j, int k) { return k != 1 || (i == 1 && j == 1); });
}

TEST(SolidModes, aStrutThinnerThanACellBendsWithItsOwnThickness) {
  // The two cubes (about: mass 1, inertia 1/6) rotate against each other: G J / 2 by 2 angles in torsion (J =
  // 0.1406 t^4), E I / 2 by 2 angles in bending. Cells are 1/2 wide, so the range of thicknesses changes
  // these by 10^4.
  for (double t : {0.2, 0.1, 0.05, 0.02}) {
    const double twist = std::sqrt(0.1406 / 2.6 * 6) * t * t, bend = std::sqrt(6.0 / 12) * t * t;
    const Vibration bell = vibrate(dumbbell(t), 60, 3, 18 * twist * twist);
    EXPECT_EQ(bell.zeroCount, 6u);
    EXPECT_NEAR(bell.mass / (2.14 + 2 * t * t), 1, 0.03) << "thickness " << t;
    EXPECT_NEAR(std::log(bell.omega[0] / twist), 0, std::log(2.2)) << "thickness " << t;
    EXPECT_NEAR(std::log(bell.omega[1] / bend), 0, std::log(2.2)) << "thickness " << t;
    EXPECT_NEAR(bell.omega[2] / bell.omega[1], 1, 0.02);
  }
}

TEST(SolidModes, aFrameOfThinStrutsIsOneBody) {
  // The twelve edges of a cube. Their stiffness falls with t^4 and their mass with t^2.
  const auto frame = [](double t) {
    const std::vector<double> planes = {0, t, 1 - t, 1};
    return blocks({planes, planes, planes},
                  [](int i, int j, int k) { return (i == 1) + (j == 1) + (k == 1) < 2; });
  };
  for (double angle : {0.0, 0.5}) {
    std::vector<double> first;
    for (double t : {0.05, 0.01}) {
      const TriangleMesh mesh = rotated(frame(t), angle, 2 * angle);
      const Vibration vibration = vibrate(mesh, 300);
      EXPECT_EQ(vibration.zeroCount, 6u);
      EXPECT_NEAR(vibration.mass / volumeOf(mesh), 1, 0.03);
      first.push_back(vibration.omega[0] / t);
    }
    EXPECT_NEAR(first[1] / first[0], 1, 0.25);
  }
}

TEST(SolidModes, everyVertexIsAConvexCombinationOfEightNodes) {
  Job job;
  TriangleMesh body = shapes::torus(24, 12);
  const Bounds box = bounds(body);
  for (Vec3& p : body.positions) p = (p - box.low) / box.diagonal();
  const SolidModel solid = solidModel(body, {0.3, 300}, job);
  ASSERT_EQ(solid.embeddingWeights.size(), 8 * body.positions.size());
  for (size_t v = 0; v < body.positions.size(); ++v) {
    double total = 0;
    std::set<uint32_t> nodes;
    for (size_t k = 8 * v; k < 8 * v + 8; ++k) {
      EXPECT_GE(solid.embeddingWeights[k], 0);
      total += solid.embeddingWeights[k];
      nodes.insert(solid.embeddingNodes[k]);
    }
    EXPECT_NEAR(total, 1, 1e-12);
    EXPECT_EQ(nodes.size(), 8u);
  }
}

TEST(SolidModes, threadsChangeNoBit) {
  Job job;
  const auto build = [&](int threads) {
    setThreadCount(threads);
    return solidModel(shapes::jittered(shapes::sphere(3, 0.3), 0.002, 1), {0.3, 300}, job);
  };
  const SolidModel one = build(1), three = build(3);
  setThreadCount(1);
  ASSERT_EQ(one.pencil.k.nonZeros(), three.pencil.k.nonZeros());
  EXPECT_TRUE(std::equal(one.pencil.k.valuePtr(), one.pencil.k.valuePtr() + one.pencil.k.nonZeros(),
                         three.pencil.k.valuePtr()));
  EXPECT_TRUE(one.pencil.m == three.pencil.m);
  EXPECT_EQ(one.embeddingNodes, three.embeddingNodes);
}

TEST(SolidModes, aRequestToCancelIsHeard) {
  Job job;
  job.requestCancel();
  EXPECT_THROW(solidModel(kBar, {0.3, 100}, job), Cancelled);
}

}  // namespace
}  // namespace limber
