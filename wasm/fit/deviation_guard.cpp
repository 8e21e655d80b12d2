#include "fit/deviation_guard.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "mesh/sampling.h"

namespace limber {
namespace {

constexpr double kMargin = 0.9;  // of the limit
constexpr size_t kSamplesPerRange = 256;
// Each triangle is cut into n^2 parts, so that there are about kParts in all, but n lies within [kFewestCuts,
// kMostCuts].
constexpr double kParts = 20000, kFewestCuts = 3, kMostCuts = 24;

int cutsOf(const TriangleMesh& mesh, double fewest) {
  const double cuts = std::ceil(std::sqrt(kParts / std::max(1u, mesh.triangleCount())));
  return static_cast<int>(std::clamp(cuts, fewest, kMostCuts));
}

using Weights = std::vector<std::array<double, 3>>;

// The corners of the n^2 parts.
Weights lattice(int n) {
  Weights weights;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) weights.push_back({1.0 * i / n, 1.0 * j / n, 1.0 * (n - i - j) / n});
  return weights;
}

// Their middles.
Weights middles(int n) {
  Weights weights;
  forEachPart(n, [&](double u, double v) { weights.push_back({u / n, v / n, 1 - (u + v) / n}); });
  return weights;
}

Vec3 pointOn(const TriangleMesh& mesh, uint32_t t, const std::array<double, 3>& weight) {
  return mesh.corner(t, 0) * weight[0] + mesh.corner(t, 1) * weight[1] + mesh.corner(t, 2) * weight[2];
}

}  // namespace

DeviationGuard::DeviationGuard(const TriangleMesh& original, double limit)
    : allowed_(kMargin * limit), tree_(original), originals_(original.positions) {
  const Weights weights = middles(cutsOf(original, 1));
  for (uint32_t t = 0; t < original.triangleCount(); ++t)
    for (const auto& weight : weights) originals_.push_back(pointOn(original, t, weight));
}

Vec3 DeviationGuard::ownPoint(const TriangleMesh& mesh, size_t i) const {
  return pointOn(mesh, static_cast<uint32_t>(i / weights_.size()), weights_[i % weights_.size()]);
}

std::vector<uint8_t> DeviationGuard::begin(const TriangleMesh& mesh) {
  const ClosestPointTree tree(mesh);
  weights_ = lattice(cutsOf(mesh, kFewestCuts));
  original_.resize(originals_.size());
  own_.resize(weights_.size() * mesh.triangleCount());
  parallelFor(original_.size() + own_.size(), kSamplesPerRange, [&](size_t from, size_t to) {
    for (size_t i = from; i < to; ++i) {
      const bool isOwn = i >= original_.size();
      const Vec3 point = isOwn ? ownPoint(mesh, i - original_.size()) : originals_[i];
      const ClosestPoint nearest = (isOwn ? tree_ : tree).closest(point);
      (isOwn ? own_[i - original_.size()] : original_[i]) = {point, nearest};
    }
  });
  std::vector<uint8_t> isFar(mesh.triangleCount(), 0);
  for (const Sample& sample : original_)
    if (sample.nearest.distance > allowed_) isFar[sample.nearest.triangle] = 1;
  for (size_t i = 0; i < own_.size(); ++i)
    if (own_[i].nearest.distance > allowed_) isFar[i / weights_.size()] = 1;
  return isFar;
}

std::vector<uint8_t> DeviationGuard::tooFar(const TriangleMesh& moved) const {
  std::vector<uint8_t> isFar(moved.triangleCount(), 0);
  checkOriginal(moved, isFar);
  checkMoved(moved, isFar);
  return isFar;
}

// Where the nearest point has moved too far from a sample, another one may be near enough.
void DeviationGuard::checkOriginal(const TriangleMesh& moved, std::vector<uint8_t>& isFar) const {
  std::vector<const Sample*> doubtful;
  for (const Sample& sample : original_) {
    const ClosestPoint& nearest = sample.nearest;
    const double* const b = nearest.barycentric;
    if (nearest.distance <= allowed_ &&
        length(pointOn(moved, nearest.triangle, {b[0], b[1], b[2]}) - sample.point) > allowed_)
      doubtful.push_back(&sample);
  }
  if (doubtful.empty()) return;
  const ClosestPointTree tree(moved);
  std::vector<uint32_t> found(doubtful.size(), kNone);
  parallelFor(doubtful.size(), kSamplesPerRange, [&](size_t from, size_t to) {
    for (size_t i = from; i < to; ++i) {
      const ClosestPoint nearest = tree.closest(doubtful[i]->point);
      if (nearest.distance > allowed_) found[i] = nearest.triangle;
    }
  });
  for (size_t i = 0; i < found.size(); ++i)
    if (found[i] != kNone) isFar[found[i]] = isFar[doubtful[i]->nearest.triangle] = 1;
}

void DeviationGuard::checkMoved(const TriangleMesh& moved, std::vector<uint8_t>& isFar) const {
  parallelFor(moved.triangleCount(), kSamplesPerRange, [&](size_t from, size_t to) {
    for (size_t t = from; t < to; ++t)
      for (size_t i = weights_.size() * t; i < weights_.size() * (t + 1) && !isFar[t]; ++i) {
        const Sample& sample = own_[i];
        const Vec3 point = ownPoint(moved, i);
        isFar[t] = sample.nearest.distance <= allowed_ &&
                   length(point - sample.nearest.position) > allowed_ &&
                   tree_.closest(point).distance > allowed_;
      }
  });
}

}  // namespace limber
