#include "fit/guarded_step.h"

#include <algorithm>
#include <cmath>

#include "mesh/quality.h"

namespace limber {

namespace {

constexpr double kStep = 0.2;          // of the lowest height around a vertex
constexpr double kTurned = 0.6;        // cosine between a face's normal and the one it started with
constexpr double kThinner = 0.8;       // a face may lose this much of its quality ...
constexpr double kGoodQuality = 0.45;  // ... or more, down to this
constexpr double kRounding = 0.01;     // degrees, of positions that are stored as float32
constexpr int kHalvings = 5, kMostRounds = 50;

double smallestAngle(const TriangleMesh& mesh, uint32_t t) {
  return smallestAngle(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
}

// Per vertex: how far it is at least from the opposite side of a triangle around it, or from a neighbour.
std::vector<double> roomAround(const TriangleMesh& mesh) {
  std::vector<double> room(mesh.vertexCount(), HUGE_VAL);
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    double longest = 0;
    for (int c = 0; c < 3; ++c)
      longest = std::max(longest, length(mesh.corner(t, (c + 1) % 3) - mesh.corner(t, c)));
    const double height = longest > 0 ? 2 * triangleArea(mesh, t) / longest : 0;
    for (uint32_t v : mesh.triangles[t]) room[v] = std::min(room[v], height);
  }
  return room;
}

}  // namespace

GuardedStep::GuardedStep(const TriangleMesh& start, const StepLimits& limits) : limits_(limits) {
  for (uint32_t t = 0; t < start.triangleCount(); ++t) {
    normal_.push_back(normalized(areaNormal(start, t)));
    quality_.push_back(
        std::min(kThinner * triangleQuality(start.corner(t, 0), start.corner(t, 1), start.corner(t, 2)),
                 kGoodQuality));
    angle_.push_back(limits.minAngle > 0 ? std::min(limits.minAngle + kRounding, smallestAngle(start, t))
                                         : 0);
  }
}

bool GuardedStep::isSound(const TriangleMesh& mesh, uint32_t t) const {
  if (squaredLength(normal_[t]) == 0) return true;
  return dot(normalized(areaNormal(mesh, t)), normal_[t]) >= kTurned &&
         triangleQuality(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)) >= quality_[t] &&
         (angle_[t] == 0 || smallestAngle(mesh, t) >= angle_[t]);
}

// Per vertex 1 where it or its image has one of these faces; empty where there are none.
std::vector<uint8_t> GuardedStep::verticesOf(const TriangleMesh& mesh,
                                             const std::vector<uint8_t>& isIn) const {
  std::vector<uint8_t> has;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    if (!isIn[t]) continue;
    has.resize(mesh.vertexCount(), 0);
    for (uint32_t v : mesh.triangles[t]) {
      has[v] = 1;
      if (!limits_.partners.empty()) has[limits_.partners[v]] = 1;
    }
  }
  return has;
}

std::vector<uint8_t> GuardedStep::badVertices(const TriangleMesh& moved) const {
  std::vector<uint8_t> isBad(moved.triangleCount(), 0);
  if (limits_.deviation) isBad = limits_.deviation->tooFar(moved);
  for (uint32_t t = 0; t < moved.triangleCount(); ++t) isBad[t] |= !isSound(moved, t);
  return verticesOf(moved, isBad);
}

TriangleMesh GuardedStep::apply(const TriangleMesh& mesh, const Eigen::VectorXd& step) const {
  const uint32_t n = mesh.vertexCount();
  const std::vector<double> room = roomAround(mesh);
  std::vector<Vec3> way(n);
  for (uint32_t v = 0; v < n; ++v) {
    const auto row = 3 * static_cast<Eigen::Index>(v);
    way[v] = {step[row], step[row + 1], step[row + 2]};
    const double size = length(way[v]), most = kStep * room[v];
    if (!isFinite(way[v]))
      way[v] = {};
    else if (size > most)
      way[v] *= most / size;
    if (limits_.reach) way[v] = limits_.reach->limited(v, mesh.positions[v] + way[v]) - mesh.positions[v];
  }
  if (limits_.deviation) {
    const std::vector<uint8_t> stay = verticesOf(mesh, limits_.deviation->begin(mesh));
    for (uint32_t v = 0; v < stay.size(); ++v)
      if (stay[v]) way[v] = {};
  }
  TriangleMesh moved = mesh;
  for (int halving = 0; halving <= kMostRounds; ++halving) {
    for (uint32_t v = 0; v < n; ++v) moved.positions[v] = mesh.positions[v] + way[v];
    const std::vector<uint8_t> isBad = badVertices(moved);
    if (isBad.empty()) return moved;
    for (uint32_t v = 0; v < n; ++v)
      if (isBad[v]) way[v] *= halving < kHalvings ? 0.5 : 0;
  }
  return mesh;
}

}  // namespace limber
