#include "fit/search/guarded_step.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "mesh/quality.h"

namespace limber {

namespace {

constexpr double kStep = 0.2;          // largest displacement, over the smallest height around a vertex
constexpr double kMinCosine = 0.6;     // between a face's normal and the one at the start (53 degrees)
constexpr double kKeptQuality = 0.8;   // of the quality at the start, which a face must keep ...
constexpr double kGoodQuality = 0.45;  // ... if it has no more than this
constexpr double kRounding = 0.01;     // degrees that storing positions as float32 may cost
constexpr int kHalvings = 5;           // of the displacements of a bad face, before they are set to 0
constexpr int kMaxRounds = 50;         // of checks, after which the step is abandoned
constexpr size_t kPerRange = 2048;

double smallestAngle(const TriangleMesh& mesh, uint32_t t) {
  return smallestAngle(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
}

template <class Body>
void forTriangles(const TriangleMesh& mesh, const Body& body) {
  parallelFor(mesh.triangleCount(), kPerRange, [&](size_t begin, size_t end) {
    for (auto t = static_cast<uint32_t>(begin); t < end; ++t) body(t);
  });
}

// Per vertex the smallest height of the triangles around it.
std::vector<double> clearanceOf(const TriangleMesh& mesh) {
  std::vector<double> clearance(mesh.vertexCount(), HUGE_VAL);
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    double longest = 0;
    for (int c = 0; c < 3; ++c)
      longest = std::max(longest, length(mesh.corner(t, (c + 1) % 3) - mesh.corner(t, c)));
    const double height = longest > 0 ? 2 * triangleArea(mesh, t) / longest : 0;
    for (uint32_t v : mesh.triangles[t]) clearance[v] = std::min(clearance[v], height);
  }
  return clearance;
}

// Per face: 1 if one of its corners is marked.
std::vector<uint8_t> trianglesAt(const TriangleMesh& mesh, const std::vector<uint8_t>& isMarked) {
  std::vector<uint8_t> has(mesh.triangleCount(), 0);
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    for (const uint32_t v : mesh.triangles[t]) has[t] |= isMarked[v];
  return has;
}

}  // namespace

GuardedStep::GuardedStep(const TriangleMesh& start, const StepLimits& limits)
    : limits_(limits),
      normal_(start.triangleCount()),
      quality_(start.triangleCount()),
      angle_(start.triangleCount(), 0) {
  forTriangles(start, [&](uint32_t t) {
    normal_[t] = normalized(areaNormal(start, t));
    quality_[t] =
        std::min(kKeptQuality * triangleQuality(start.corner(t, 0), start.corner(t, 1), start.corner(t, 2)),
                 kGoodQuality);
    if (limits.minAngle > 0) angle_[t] = std::min(limits.minAngle + kRounding, smallestAngle(start, t));
  });
}

bool GuardedStep::isSound(const TriangleMesh& mesh, uint32_t t) const {
  if (squaredLength(normal_[t]) == 0) return true;
  return dot(normalized(areaNormal(mesh, t)), normal_[t]) >= kMinCosine &&
         triangleQuality(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)) >= quality_[t] &&
         (angle_[t] == 0 || smallestAngle(mesh, t) >= angle_[t]);
}

// Per vertex: 1 if it or its mirror image is a corner of a marked face; empty if no face is marked.
std::vector<uint8_t> GuardedStep::verticesOf(const TriangleMesh& mesh,
                                             const std::vector<uint8_t>& isMarked) const {
  std::vector<uint8_t> has;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    if (!isMarked[t]) continue;
    has.resize(mesh.vertexCount(), 0);
    for (uint32_t v : mesh.triangles[t]) {
      has[v] = 1;
      if (!limits_.partners.empty()) has[limits_.partners[v]] = 1;
    }
  }
  return has;
}

// Only checks changed faces: a valid face that has not moved since is still valid.
std::vector<uint8_t> GuardedStep::badVertices(const TriangleMesh& moved,
                                              const std::vector<uint8_t>& isChanged) const {
  std::vector<uint8_t> isBad(moved.triangleCount(), 0);
  if (limits_.deviation) isBad = limits_.deviation->tooFar(moved, isChanged);
  forTriangles(moved, [&](uint32_t t) {
    if (isChanged.empty() || isChanged[t]) isBad[t] |= !isSound(moved, t);
  });
  return verticesOf(moved, isBad);
}

std::vector<Vec3> GuardedStep::limitedDisplacements(const TriangleMesh& mesh,
                                                    const Eigen::VectorXd& step) const {
  const std::vector<double> clearance = clearanceOf(mesh);
  std::vector<Vec3> moves(mesh.vertexCount());
  parallelFor(moves.size(), kPerRange, [&](size_t begin, size_t end) {
    for (auto v = static_cast<uint32_t>(begin); v < end; ++v) {
      const auto row = 3 * static_cast<Eigen::Index>(v);
      Vec3& move = moves[v];
      move = {step[row], step[row + 1], step[row + 2]};
      const double size = length(move), most = kStep * clearance[v];
      if (!isFinite(move))
        move = {};
      else if (size > most)
        move *= most / size;
      if (limits_.distanceBounds)
        move = limits_.distanceBounds->limited(v, mesh.positions[v] + move) - mesh.positions[v];
    }
  });
  return moves;
}

TriangleMesh GuardedStep::apply(const TriangleMesh& mesh, const Eigen::VectorXd& step) const {
  const uint32_t n = mesh.vertexCount();
  std::vector<Vec3> moves = limitedDisplacements(mesh, step);
  if (limits_.deviation) {
    const std::vector<uint8_t> stays = verticesOf(mesh, limits_.deviation->begin(mesh));
    for (uint32_t v = 0; v < stays.size(); ++v)
      if (stays[v]) moves[v] = {};
  }
  TriangleMesh moved = mesh;
  std::vector<uint8_t> isChanged;  // per face, since the last round; empty: all
  for (int round = 0; round <= kMaxRounds; ++round) {
    for (uint32_t v = 0; v < n; ++v) moved.positions[v] = mesh.positions[v] + moves[v];
    const std::vector<uint8_t> isBad = badVertices(moved, isChanged);
    if (isBad.empty()) return moved;
    for (uint32_t v = 0; v < n; ++v)
      if (isBad[v]) moves[v] *= round < kHalvings ? 0.5 : 0;
    isChanged = trianglesAt(mesh, isBad);
  }
  return mesh;
}

}  // namespace limber
