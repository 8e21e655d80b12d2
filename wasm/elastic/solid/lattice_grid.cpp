#include "elastic/solid/lattice_grid.h"

#include <algorithm>
#include <cmath>

namespace limber {

namespace {

constexpr double kMarginLow = 1.3e-6, kMarginHigh = 0.7e-6;  // of a cell
constexpr double kMaxCells = 4e6;                            // in the box, filled or empty
constexpr double kCoarsening = 1.1;     // factor on the side of a cell until they are few enough
constexpr double kSmallestSide = 1e-4;  // of a cell, of the bounding diagonal
constexpr int kBisections = 60;

// An estimate of the cells that contain a part of a body. Averaged over all directions, a plane cuts 1.5
// cells per squared cell side of its area, and half of these lie mostly outside.
constexpr double kCellsOfSurface = 0.75;
double filledCells(double volume, double area, double side) {
  return volume / (side * side * side) + kCellsOfSurface * area / (side * side);
}

// The side of a cell for which `targetCells` cells are expected to contain a part of the body.
double cellSide(const TriangleMesh& body, uint32_t targetCells) {
  double volume = 0, area = 0;
  for (uint32_t t = 0; t < body.triangleCount(); ++t) {
    volume += dot(body.corner(t, 0), cross(body.corner(t, 1), body.corner(t, 2))) / 6;
    area += triangleArea(body, t);
  }
  volume = std::abs(volume);
  double high = bounds(body).diagonal(), low = high * kSmallestSide;
  for (int step = 0; step < kBisections; ++step) {
    const double middle = std::sqrt(low * high);
    (filledCells(volume, area, middle) > targetCells ? low : high) = middle;
  }
  return high;
}

}  // namespace

double longestSide(const Vec3& cell) {
  return std::max({cell.x, cell.y, cell.z});
}

int LatticeGrid::along(int axis, double coordinate) const {
  return std::clamp(static_cast<int>(std::floor(coordinate)), 0, count[axis] - 1);
}

LatticeGrid latticeGrid(const TriangleMesh& body, uint32_t targetCells) {
  const double side = cellSide(body, targetCells);
  return latticeGrid(body, Vec3{side, side, side});
}

LatticeGrid latticeGrid(const TriangleMesh& body, const Vec3& cellSize) {
  const Bounds box = bounds(body);
  const Vec3 size = box.high - box.low;
  LatticeGrid grid;
  for (double factor = 1;; factor *= kCoarsening) {
    for (int axis = 0; axis < 3; ++axis) {
      const double count = std::min(size[axis] / (factor * cellSize[axis]), kMaxCells);
      grid.count[axis] = std::max(1, static_cast<int>(std::lround(count)));
    }
    // The product of the counts can exceed the range of size_t.
    if (1.0 * grid.count[0] * grid.count[1] * grid.count[2] <= kMaxCells) break;
  }
  for (int axis = 0; axis < 3; ++axis) {
    grid.size[axis] = size[axis] * (1 + (kMarginLow + kMarginHigh) / grid.count[axis]) / grid.count[axis];
    grid.origin[axis] = box.low[axis] - kMarginLow * grid.size[axis];
  }
  return grid;
}

std::vector<Vec3> inLatticeUnits(const TriangleMesh& body, const LatticeGrid& grid) {
  std::vector<Vec3> points;
  points.reserve(body.positions.size());
  for (const Vec3& p : body.positions) {
    const Vec3 offset = p - grid.origin;
    points.push_back({offset.x / grid.size.x, offset.y / grid.size.y, offset.z / grid.size.z});
  }
  return points;
}

}  // namespace limber
