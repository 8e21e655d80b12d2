#include "transfer/carry_pins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "shapes.h"
#include "simulate/scenario.h"
#include "transfer/shape_transfer.h"

namespace limber {
namespace {

// Rows of the fine sheet per row of the coarse one.
constexpr int kRows = 4;

TriangleMesh fineSheet() {
  return shapes::grid(8, 6 * kRows, 1, 6 * kRows);
}

std::vector<uint32_t> below(const TriangleMesh& mesh, double height) {
  std::vector<uint32_t> found;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    if (mesh.positions[v].y <= height) found.push_back(v);
  return found;
}

TriangleMesh coarseSheet() {
  return shapes::grid(2, 6, 1, 6 * kRows);
}

// The pinned vertices of the coarse sheet where the fine one is pinned up to `height`.
std::vector<uint32_t> carriedFrom(double height) {
  const TriangleMesh fine = fineSheet();
  const Pins pins = carryPins(fine, below(fine, height), coarseSheet());
  EXPECT_TRUE(pins.points.empty()) << height;
  return pins.vertices;
}

TEST(CarryPins, aBodyThatIsItsOwnResultKeepsItsPins) {
  const TriangleMesh bar = shapes::box(2, 2, 12, 0.25);
  const Scenario twist = {scenarioKind("twist"), bounds(bar), 1};
  std::vector<uint32_t> pinned = defaultPins(bar, twist);
  const auto middle =
      std::ranges::find_if(bar.positions, [](const Vec3& p) { return std::abs(p.z - 1.5) < 1e-9; });
  pinned.push_back(static_cast<uint32_t>(middle - bar.positions.begin()));
  std::ranges::sort(pinned);
  const Pins pins = carryPins(bar, pinned, bar);
  EXPECT_EQ(pins.vertices, pinned);
  EXPECT_TRUE(pins.points.empty());
}

TEST(CarryPins, theOutlineOfAPinnedRegionIsRoundedToEdgesOfTheResult) {
  const std::vector<uint32_t> one = below(coarseSheet(), kRows), two = below(coarseSheet(), 2 * kRows);
  EXPECT_EQ(carriedFrom(kRows), one);
  EXPECT_EQ(carriedFrom(kRows + 1), one);
  EXPECT_EQ(carriedFrom(2 * kRows - 1), two);
  EXPECT_EQ(carriedFrom(2 * kRows), two);
}

TEST(CarryPins, aPinnedRegionIsOnAverageAsLargeAsThatOfTheOriginal) {
  double sum = 0;
  for (int height = kRows; height < 5 * kRows; ++height) {
    const double rows = static_cast<double>(carriedFrom(height).size()) / 3 - 1;
    sum += kRows * rows - height;
  }
  EXPECT_LE(std::abs(sum / (4 * kRows)), 0.25);
}

TEST(CarryPins, aRowOfPinsBecomesVerticesWhereItCanAndPointsElsewhere) {
  const TriangleMesh fine = shapes::grid(4, 4), coarse = shapes::grid(2, 2);
  const std::vector<uint32_t> bottom = {0, 1, 2, 3, 4};
  const Pins pins = carryPins(fine, bottom, coarse);
  EXPECT_EQ(pins.vertices, (std::vector<uint32_t>{0, 1, 2}));
  EXPECT_EQ(pins.points.size(), 2u);
}

TEST(CarryPins, aRegionTooSmallForATriangleBecomesPoints) {
  const TriangleMesh fine = shapes::grid(8, 8), coarse = shapes::grid(1, 1);
  const std::vector<uint32_t> cell = {9 * 2 + 5, 9 * 2 + 6, 9 * 3 + 5, 9 * 3 + 6};
  const Pins pins = carryPins(fine, cell, coarse);
  EXPECT_TRUE(pins.vertices.empty());
  EXPECT_EQ(pins.points.size(), 4u);
}

TEST(CarryPins, pinsFollowTheBinding) {
  const TriangleMesh fine = shapes::grid(4, 4), coarse = shapes::grid(2, 2);
  std::vector<SurfacePoint> binding(fine.positions.size(), SurfacePoint{kNone, {0, 0, 0}});
  binding[0] = {7, {0, 1, 0}};
  binding[1] = {3, {0.5, 0.25, 0.25}};
  const Pins pins = carryPins(fine, std::vector<uint32_t>{0, 1, 2}, coarse, binding);
  EXPECT_EQ(pins.vertices, (std::vector<uint32_t>{coarse.triangles[7][1]}));
  ASSERT_EQ(pins.points.size(), 1u);
  EXPECT_EQ(pins.points[0].triangle, 3u);
}

TriangleMesh atHeight(TriangleMesh mesh, double z) {
  for (Vec3& p : mesh.positions) p.z = z;
  return mesh;
}

// Two sheets close together whose coarse copies are swapped: only the binding identifies corresponding
// sheets.
TEST(CarryPins, aPinnedRegionStaysOnTheSheetOfItsBinding) {
  const TriangleMesh fine = shapes::grid(4, 4), coarse = shapes::grid(2, 2);
  const TriangleMesh original = shapes::together(fine, atHeight(fine, 0.01));
  const TriangleMesh result = shapes::together(atHeight(coarse, 0.01), coarse);
  std::vector<uint32_t> pinned;
  std::vector<SurfacePoint> binding;
  for (uint32_t v = 0; v < original.vertexCount(); ++v) {
    const bool isUpper = v >= fine.vertexCount();
    const double x = 2 * original.positions[v].x, y = 2 * original.positions[v].y;
    const int column = std::min(static_cast<int>(x), 1), row = std::min(static_cast<int>(y), 1);
    const double u = x - column, w = y - row;
    const uint32_t cell =
        2 * static_cast<uint32_t>(2 * row + column) + (isUpper ? coarse.triangleCount() : 0);
    binding.push_back(u >= w ? SurfacePoint{cell, {1 - u, u - w, w}}
                             : SurfacePoint{cell + 1, {1 - w, u, w - u}});
    if (!isUpper && y <= 1) pinned.push_back(v);
  }
  const Pins pins = carryPins(original, pinned, result, binding);
  EXPECT_EQ(pins.vertices, (std::vector<uint32_t>{0, 1, 2, 3, 4, 5}));
  EXPECT_TRUE(pins.points.empty());
}

// A block that stands on a plate of two triangles a side, all of whose vertices are pinned.
TriangleMesh blockOnPlate(int cells) {
  TriangleMesh block = shapes::box(cells, cells, cells, 1.0 / cells);
  TriangleMesh plate = shapes::box(1, 1, 1, 1);
  for (Vec3& p : plate.positions) p = {4 * p.x - 2, 4 * p.y - 2, 0.1 * (p.z - 1)};
  return shapes::together(plate, block);
}

std::vector<uint32_t> cornersOfPlate() {
  return {0, 1, 2, 3, 4, 5, 6, 7};
}

TEST(CarryPins, aBodyKeepsItsPinsWherePinnedTrianglesTouchAnotherPart) {
  const TriangleMesh body = blockOnPlate(4);
  ASSERT_EQ(shapes::box(1, 1, 1, 1).vertexCount(), cornersOfPlate().size());
  EXPECT_EQ(carryPins(body, cornersOfPlate(), body).vertices, cornersOfPlate());
}

// Only the top of the block is bound, so that the triangles at its base look for their pins themselves.
TEST(CarryPins, aPartOnAPinnedOneIsNotPinnedWhereNothingIsBoundToIt) {
  const TriangleMesh original = blockOnPlate(4), result = blockOnPlate(2);
  const std::vector<ClosestPoint> closest = closestPoints(original, result);
  std::vector<SurfacePoint> binding;
  for (uint32_t v = 0; v < original.vertexCount(); ++v) {
    const bool isBound = v < cornersOfPlate().size() || original.positions[v].z > 0.9;
    binding.push_back(isBound ? SurfacePoint(closest[v]) : SurfacePoint{kNone, {0, 0, 0}});
  }
  const Pins pins = carryPins(original, cornersOfPlate(), result, binding);
  EXPECT_EQ(pins.vertices, cornersOfPlate());
  EXPECT_TRUE(pins.points.empty());
}

TEST(CarryPins, refusesPinsThatAreNotThereAndAMeshWithoutTriangles) {
  const TriangleMesh sheet = shapes::grid(2, 2);
  const std::vector<uint32_t> pinned = {0, 1}, beyond = {9};
  EXPECT_THROW(carryPins(sheet, pinned, TriangleMesh{}), std::invalid_argument);
  EXPECT_THROW(carryPins(sheet, beyond, sheet), std::invalid_argument);
  EXPECT_EQ(carryPins(sheet, {}, TriangleMesh{}).count(), 0u);
}

}  // namespace
}  // namespace limber
