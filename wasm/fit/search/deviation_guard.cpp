#include "fit/search/deviation_guard.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "mesh/sampling.h"

namespace limber {
namespace {

constexpr double kMargin =
    0.9;  // fraction of the limit that samples may use: points between them are farther
constexpr size_t kSamplesPerRange = 256, kTrianglesPerRange = 64;
// Each triangle is cut into n^2 congruent ones, so that there are about as many in all as samples are wanted;
// n is at least kFewestCuts for the moving mesh (1 for the original) and at most kMostCuts.
constexpr double kFewestCuts = 3, kMostCuts = 24;

int cutsOf(const TriangleMesh& mesh, double parts, double fewest) {
  const double cuts = std::ceil(std::sqrt(parts / std::max(1u, mesh.triangleCount())));
  return static_cast<int>(std::clamp(cuts, fewest, kMostCuts));
}

using Weights = std::vector<std::array<double, 3>>;

// Barycentric coordinates of the corners of the n^2 congruent triangles that a triangle is cut into.
Weights lattice(int n) {
  Weights weights;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) weights.push_back({1.0 * i / n, 1.0 * j / n, 1.0 * (n - i - j) / n});
  return weights;
}

// Barycentric coordinates of their centres.
Weights middles(int n) {
  Weights weights;
  forEachPart(n, [&](double u, double v) { weights.push_back({u / n, v / n, 1 - (u + v) / n}); });
  return weights;
}

Vec3 pointOn(const TriangleMesh& mesh, uint32_t t, const std::array<double, 3>& weight) {
  return mesh.corner(t, 0) * weight[0] + mesh.corner(t, 1) * weight[1] + mesh.corner(t, 2) * weight[2];
}

}  // namespace

DeviationGuard::DeviationGuard(const TriangleMesh& original, double limit, uint32_t samples)
    : allowed_(kMargin * limit), parts_(samples), tree_(original), originalPoints_(original.positions) {
  const Weights weights = middles(cutsOf(original, parts_, 1));
  for (uint32_t t = 0; t < original.triangleCount(); ++t)
    for (const auto& weight : weights) originalPoints_.push_back(pointOn(original, t, weight));
}

Vec3 DeviationGuard::meshPoint(const TriangleMesh& mesh, size_t i) const {
  return pointOn(mesh, static_cast<uint32_t>(i / weights_.size()), weights_[i % weights_.size()]);
}

// A point this near to a sample serves as its surface point: what is left of the limit is for the mesh to
// move in. The closest point is searched only where none is found.
double DeviationGuard::nearEnough() const {
  return allowed_ / 2;
}

std::vector<uint8_t> DeviationGuard::begin(const TriangleMesh& mesh) {
  const ClosestPointTree tree(mesh);
  weights_ = lattice(cutsOf(mesh, parts_, kFewestCuts));
  meshPointsNear_.assign(originalPoints_.size(), {});
  originalPointsNear_.assign(weights_.size() * mesh.triangleCount(), {});
  std::vector<uint8_t> isFar(mesh.triangleCount(), 0);
  std::vector<uint32_t> farOf(originalPoints_.size(), kNone);
  // Samples follow one another over a triangle, so that the surface point of one is a good guess for the
  // next.
  parallelFor(meshPointsNear_.size(), kSamplesPerRange, [&](size_t from, size_t to) {
    uint32_t near = kNone;
    for (size_t i = from; i < to; ++i) {
      const ClosestPoint found = tree.nearEnough(originalPoints_[i], nearEnough(), near);
      near = found.triangle;
      if (found.distance <= allowed_)
        meshPointsNear_[i] = found;
      else
        farOf[i] = near;
    }
  });
  for (const uint32_t t : farOf)
    if (t != kNone) isFar[t] = 1;
  parallelFor(mesh.triangleCount(), kTrianglesPerRange, [&](size_t from, size_t to) {
    uint32_t near = kNone;
    for (size_t i = weights_.size() * from; i < weights_.size() * to; ++i) {
      const ClosestPoint found = tree_.nearEnough(meshPoint(mesh, i), nearEnough(), near);
      near = found.triangle;
      if (found.distance <= allowed_)
        originalPointsNear_[i] = {found.position, near};
      else
        isFar[i / weights_.size()] = 1;
    }
  });
  return isFar;
}

std::vector<uint8_t> DeviationGuard::tooFar(const TriangleMesh& moved) const {
  std::vector<uint8_t> isFar(moved.triangleCount(), 0);
  checkOriginal(moved, isFar);
  checkMoved(moved, isFar);
  return isFar;
}

// Where the surface point has moved too far from its sample, another point may be close enough.
void DeviationGuard::checkOriginal(const TriangleMesh& moved, std::vector<uint8_t>& isFar) const {
  std::vector<size_t> unclear;
  for (size_t i = 0; i < meshPointsNear_.size(); ++i) {
    const auto& [triangle, b] = meshPointsNear_[i];
    if (triangle != kNone &&
        length(pointOn(moved, triangle, {b[0], b[1], b[2]}) - originalPoints_[i]) > allowed_)
      unclear.push_back(i);
  }
  if (unclear.empty()) return;
  const ClosestPointTree tree(moved);
  std::vector<uint32_t> found(unclear.size(), kNone);
  parallelFor(unclear.size(), kSamplesPerRange, [&](size_t from, size_t to) {
    for (size_t i = from; i < to; ++i) {
      const ClosestPoint near =
          tree.nearEnough(originalPoints_[unclear[i]], allowed_, meshPointsNear_[unclear[i]].triangle);
      if (near.distance > allowed_) found[i] = near.triangle;
    }
  });
  for (size_t i = 0; i < found.size(); ++i)
    if (found[i] != kNone) isFar[found[i]] = isFar[meshPointsNear_[unclear[i]].triangle] = 1;
}

void DeviationGuard::checkMoved(const TriangleMesh& moved, std::vector<uint8_t>& isFar) const {
  parallelFor(moved.triangleCount(), kTrianglesPerRange, [&](size_t from, size_t to) {
    for (size_t t = from; t < to; ++t)
      for (size_t i = weights_.size() * t; i < weights_.size() * (t + 1) && !isFar[t]; ++i) {
        const auto& [near, triangle] = originalPointsNear_[i];
        if (triangle == kNone) continue;
        const Vec3 point = meshPoint(moved, i);
        isFar[t] = length(point - near) > allowed_ &&
                   tree_.nearEnough(point, allowed_, triangle).distance > allowed_;
      }
  });
}

}  // namespace limber
