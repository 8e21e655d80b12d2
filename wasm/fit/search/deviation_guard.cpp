#include "fit/search/deviation_guard.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/parallel.h"
#include "mesh/sampling.h"
#include "mesh/topology.h"
#include "query/surface_walk.h"

namespace limber {
namespace {

constexpr double kMargin =
    0.9;  // fraction of the limit that samples may use, because points between them may be farther
constexpr size_t kSamplesPerRange = 256, kTrianglesPerRange = 256;
// Each triangle is cut into n^2 congruent ones, so that their total is about the wanted number of samples; n
// is at least kFewestCuts for the moving mesh (1 for the original) and at most kMaxCuts.
constexpr double kFewestCuts = 3, kMaxCuts = 24;
constexpr double kMaxFollowed = 0.05;  // of the triangles, whose covers are tracked one by one

int cutsOf(const TriangleMesh& mesh, double parts, double fewest) {
  const double cuts = std::ceil(std::sqrt(parts / std::max(1u, mesh.triangleCount())));
  return static_cast<int>(std::clamp(cuts, fewest, kMaxCuts));
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

Vec3 pointOn(const TriangleMesh& mesh, uint32_t t, const double* weight) {
  return mesh.corner(t, 0) * weight[0] + mesh.corner(t, 1) * weight[1] + mesh.corner(t, 2) * weight[2];
}
Vec3 pointOn(const TriangleMesh& mesh, const SurfacePoint& point) {
  return pointOn(mesh, point.triangle, point.barycentric);
}

// The largest distance of a point of triangle t from p, which is that of a corner.
double farthest(const TriangleMesh& mesh, uint32_t t, const Vec3& p) {
  double square = 0;
  for (int c = 0; c < 3; ++c) square = std::max(square, squaredLength(mesh.corner(t, c) - p));
  return std::sqrt(square);
}

// Covers are points on `surface` for triangles of `mesh`, within `enough` of all of the triangle.
struct Covering {
  const TriangleMesh& mesh;
  const TriangleMesh& surface;
  double enough;
};

// A triangle without a cover, and the triangle of its last cover; kNone if it had none.
struct OpenTriangle {
  uint32_t triangle, coverBefore;
};

// Removes covers that have moved too far from their triangle. Returns the triangles that have none.
std::vector<OpenTriangle> removeFarCovers(const Covering& covering, std::vector<SurfacePoint>& covers) {
  const auto& [mesh, surface, enough] = covering;
  covers.resize(mesh.triangleCount());
  std::vector<uint8_t> isOpen(covers.size(), 0);
  parallelFor(covers.size(), kTrianglesPerRange, [&](size_t from, size_t to) {
    for (auto t = static_cast<uint32_t>(from); t < to; ++t)
      isOpen[t] = covers[t].triangle == kNone || farthest(mesh, t, pointOn(surface, covers[t])) > enough;
  });
  std::vector<OpenTriangle> open;
  for (uint32_t t = 0; t < covers.size(); ++t)
    if (isOpen[t]) open.push_back({t, std::exchange(covers[t], {}).triangle});
  return open;
}

// Looks for new covers near the old ones, on a surface that has moved a little. Returns whether all of the
// open triangles have one afterwards. If many are open, a tree over the surface is faster.
bool followCovers(const Covering& covering, const std::vector<OpenTriangle>& open,
                  std::vector<SurfacePoint>& covers) {
  const auto& [mesh, surface, enough] = covering;
  const bool isNew = std::ranges::any_of(open, [](const auto& t) { return t.coverBefore == kNone; });
  if (isNew || open.size() > kMaxFollowed * mesh.triangleCount()) return false;
  if (open.empty()) return true;
  const Topology topology = buildIncidence(surface);
  SurfaceWalk walk(surface, topology);
  bool isCovered = true;
  for (const auto& [t, before] : open) {
    const Vec3 centre = triangleCentre(mesh, t);
    const ClosestPoint found = walk.closest(centre, {&before, 1}, [](uint32_t, uint32_t) { return true; });
    if (found.distance <= enough - farthest(mesh, t, centre))
      covers[t] = found;
    else
      isCovered = false;
  }
  return isCovered;
}

// Finds covers for triangles without one, with one search each from the centre.
void findCovers(const TriangleMesh& mesh, const ClosestPointTree& surface, double enough,
                std::vector<SurfacePoint>& covers) {
  parallelFor(covers.size(), kTrianglesPerRange, [&](size_t from, size_t to) {
    // Consecutive triangles are mostly neighbours, so the result for one is a good guess for the next.
    uint32_t near = kNone;
    for (auto t = static_cast<uint32_t>(from); t < to; ++t) {
      if (covers[t].triangle != kNone) continue;
      const Vec3 centre = triangleCentre(mesh, t);
      const double slack = enough - farthest(mesh, t, centre);
      if (!(slack > 0)) continue;
      const ClosestPoint found = surface.nearEnough(centre, slack, near);
      near = found.triangle;
      if (found.distance <= slack) covers[t] = found;
    }
  });
}

bool isUnchanged(const std::vector<uint8_t>& isChanged, uint32_t t) {
  return !isChanged.empty() && isChanged[t] == 0;
}

}  // namespace

DeviationGuard::DeviationGuard(const TriangleMesh& original, const ClosestPointTree& tree, double limit,
                               uint32_t samples)
    : original_(original),
      tree_(tree),
      allowed_(kMargin * limit),
      parts_(samples),
      middles_(middles(cutsOf(original, parts_, 1))) {}

// A point this near to a sample is accepted as its surface point, which leaves the rest of the limit for
// motions of the mesh. The closest point is only searched if none is found.
double DeviationGuard::nearEnough() const {
  return allowed_ / 2;
}

std::vector<uint8_t> DeviationGuard::begin(const TriangleMesh& mesh) {
  weights_ = lattice(cutsOf(mesh, parts_, kFewestCuts));
  Marks isFar(mesh.triangleCount(), 0);
  coverOriginal(mesh, isFar);
  coverMesh(mesh, isFar);
  return isFar;
}

// The samples of triangles without a cover, and those of their vertices that belong to no covered triangle.
std::vector<DeviationGuard::OriginalSample> DeviationGuard::uncoveredSamples() const {
  const auto isCovered = [&](uint32_t t) { return coverOfOriginal_[t].triangle != kNone; };
  std::vector<uint32_t> uncovered;
  for (uint32_t t = 0; t < original_.triangleCount(); ++t)
    if (!isCovered(t)) uncovered.push_back(t);
  if (uncovered.empty()) return {};
  std::vector<uint8_t> isOpen(original_.vertexCount(), 0);
  for (const uint32_t t : uncovered)
    for (const uint32_t v : original_.triangles[t]) isOpen[v] = 1;
  for (uint32_t t = 0; t < original_.triangleCount(); ++t)
    if (isCovered(t))
      for (const uint32_t v : original_.triangles[t]) isOpen[v] = 0;
  std::vector<OriginalSample> samples;
  for (uint32_t v = 0; v < original_.vertexCount(); ++v)
    if (isOpen[v]) samples.push_back({original_.positions[v]});
  for (const uint32_t t : uncovered)
    for (const auto& weight : middles_) samples.push_back({pointOn(original_, t, weight.data())});
  return samples;
}

void DeviationGuard::coverOriginal(const TriangleMesh& mesh, Marks& isFar) {
  std::optional<ClosestPointTree> treeOfMesh;
  const Covering covering{original_, mesh, nearEnough()};
  const std::vector<OpenTriangle> open = removeFarCovers(covering, coverOfOriginal_);
  if (!followCovers(covering, open, coverOfOriginal_))
    findCovers(original_, treeOfMesh.emplace(mesh), nearEnough(), coverOfOriginal_);
  originalSamples_ = uncoveredSamples();
  if (originalSamples_.empty()) return;
  if (!treeOfMesh) treeOfMesh.emplace(mesh);
  std::vector<uint32_t> farOf(originalSamples_.size(), kNone);
  // Consecutive samples of a triangle are close together, so the surface point of one is a good guess for the
  // next.
  parallelFor(originalSamples_.size(), kSamplesPerRange, [&](size_t from, size_t to) {
    uint32_t near = kNone;
    for (size_t i = from; i < to; ++i) {
      const ClosestPoint found = treeOfMesh->nearEnough(originalSamples_[i].position, nearEnough(), near);
      near = found.triangle;
      if (found.distance <= allowed_)
        originalSamples_[i].near = found;
      else
        farOf[i] = near;
    }
  });
  for (const uint32_t t : farOf)
    if (t != kNone) isFar[t] = 1;
}

void DeviationGuard::coverMesh(const TriangleMesh& mesh, Marks& isFar) {
  if (!removeFarCovers({mesh, original_, nearEnough()}, coverOfMesh_).empty())
    findCovers(mesh, tree_, nearEnough(), coverOfMesh_);
  firstNear_.assign(mesh.triangleCount(), kNone);
  uint32_t count = 0;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    if (coverOfMesh_[t].triangle != kNone) continue;
    firstNear_[t] = count;
    count += static_cast<uint32_t>(weights_.size());
  }
  meshSamplesNear_.assign(count, {});
  parallelFor(mesh.triangleCount(), kTrianglesPerRange, [&](size_t from, size_t to) {
    uint32_t near = kNone;
    for (auto t = static_cast<uint32_t>(from); t < to; ++t)
      for (size_t i = 0; i < weights_.size() && firstNear_[t] != kNone; ++i) {
        const ClosestPoint found = tree_.nearEnough(pointOn(mesh, t, weights_[i].data()), nearEnough(), near);
        near = found.triangle;
        if (found.distance <= allowed_)
          meshSamplesNear_[firstNear_[t] + i] = found;
        else
          isFar[t] = 1;
      }
  });
}

std::vector<uint8_t> DeviationGuard::tooFar(const TriangleMesh& moved, const Marks& isChanged) const {
  Marks isFar(moved.triangleCount(), 0);
  checkOriginal(moved, isChanged, isFar);
  checkMoved(moved, isChanged, isFar);
  return isFar;
}

// The samples that are now too far from their surface points.
std::vector<DeviationGuard::OriginalSample> DeviationGuard::unclearSamples(const TriangleMesh& moved,
                                                                           const Marks& isChanged) const {
  std::vector<uint8_t> isUnclear(original_.triangleCount(), 0);
  parallelFor(isUnclear.size(), kTrianglesPerRange, [&](size_t from, size_t to) {
    for (auto t = static_cast<uint32_t>(from); t < to; ++t) {
      const SurfacePoint& cover = coverOfOriginal_[t];
      if (cover.triangle != kNone && !isUnchanged(isChanged, cover.triangle))
        isUnclear[t] = farthest(original_, t, pointOn(moved, cover)) > allowed_;
    }
  });
  std::vector<OriginalSample> unclear;
  const auto add = [&](const Vec3& position, const SurfacePoint& near) {
    if (length(pointOn(moved, near) - position) > allowed_) unclear.push_back({position, near});
  };
  for (const auto& [position, near] : originalSamples_)
    if (near.triangle != kNone && !isUnchanged(isChanged, near.triangle)) add(position, near);
  for (uint32_t t = 0; t < original_.triangleCount(); ++t) {
    if (!isUnclear[t]) continue;
    for (int c = 0; c < 3; ++c) add(original_.corner(t, c), coverOfOriginal_[t]);
    for (const auto& weight : middles_) add(pointOn(original_, t, weight.data()), coverOfOriginal_[t]);
  }
  return unclear;
}

// If the surface point has moved too far from its sample, another point may be close enough.
void DeviationGuard::checkOriginal(const TriangleMesh& moved, const Marks& isChanged, Marks& isFar) const {
  const std::vector<OriginalSample> unclear = unclearSamples(moved, isChanged);
  if (unclear.empty()) return;
  const ClosestPointTree tree(moved);
  std::vector<uint32_t> found(unclear.size(), kNone);
  parallelFor(unclear.size(), kSamplesPerRange, [&](size_t from, size_t to) {
    for (size_t i = from; i < to; ++i) {
      const ClosestPoint near = tree.nearEnough(unclear[i].position, allowed_, unclear[i].near.triangle);
      if (near.distance > allowed_) found[i] = near.triangle;
    }
  });
  for (size_t i = 0; i < found.size(); ++i)
    if (found[i] != kNone) isFar[found[i]] = isFar[unclear[i].near.triangle] = 1;
}

bool DeviationGuard::isTooFar(const TriangleMesh& moved, uint32_t t) const {
  const SurfacePoint& cover = coverOfMesh_[t];
  const bool isCovered = cover.triangle != kNone;
  if (isCovered && farthest(moved, t, pointOn(original_, cover)) <= allowed_) return false;
  for (size_t i = 0; i < weights_.size(); ++i) {
    const SurfacePoint& near = isCovered ? cover : meshSamplesNear_[firstNear_[t] + i];
    if (near.triangle == kNone) continue;
    const Vec3 point = pointOn(moved, t, weights_[i].data());
    if (length(point - pointOn(original_, near)) > allowed_ &&
        tree_.nearEnough(point, allowed_, near.triangle).distance > allowed_)
      return true;
  }
  return false;
}

void DeviationGuard::checkMoved(const TriangleMesh& moved, const Marks& isChanged, Marks& isFar) const {
  parallelFor(moved.triangleCount(), kTrianglesPerRange, [&](size_t from, size_t to) {
    for (auto t = static_cast<uint32_t>(from); t < to; ++t)
      if (!isFar[t] && !isUnchanged(isChanged, t)) isFar[t] = isTooFar(moved, t);
  });
}

}  // namespace limber
