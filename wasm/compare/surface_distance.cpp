#include "compare/surface_distance.h"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <optional>
#include <vector>

#include "base/parallel.h"
#include "mesh/surface_samples.h"
#include "query/closest_point.h"

namespace limber {

namespace {

constexpr size_t kGrain = 512;  // points of a range for one thread
constexpr uint64_t kSamplesPerTriangle = 10, kFewestSamples = 10'000, kMaxSamples = 500'000;

// The distance of each point to a surface. Consecutive points should lie close together: the search for each
// begins at the triangle closest to the previous one.
std::vector<double> distances(const std::vector<Vec3>& points, const ClosestPointTree& tree, Job& job) {
  std::vector<double> out(points.size());
  parallelFor(points.size(), kGrain, [&](size_t begin, size_t end) {
    job.check();
    uint32_t near = kNone;
    for (size_t i = begin; i < end; ++i) {
      const ClosestPoint found = tree.closest(points[i], near);
      out[i] = found.distance;
      near = found.triangle;
    }
  });
  return out;
}

// The largest distance of the points to a surface, or `atLeast` if that is larger. `find(point, enough,
// near)` finds the nearest point, or any point that is at most `enough` away.
template <class Find>
double largestDistance(const std::vector<Vec3>& points, const Find& find, double atLeast, Job& job) {
  std::vector<double> largest((points.size() + kGrain - 1) / kGrain, atLeast);
  parallelFor(points.size(), kGrain, [&](size_t begin, size_t end) {
    job.check();
    double& found = largest[begin / kGrain];
    uint32_t near = kNone;
    for (size_t i = begin; i < end; ++i) {
      const ClosestPoint closest = find(points[i], found, near);
      found = std::max(found, closest.distance);
      near = closest.triangle;
    }
  });
  return std::accumulate(largest.begin(), largest.end(), atLeast,
                         [](double a, double b) { return std::max(a, b); });
}

auto pointsOf(const ClosestPointTree& tree) {
  return [&](const Vec3& p, double enough, uint32_t near) { return tree.nearEnough(p, enough, near); };
}
auto cornersOf(const ClosestPointTree& tree) {
  return [&](const Vec3& p, double enough, uint32_t near) { return tree.nearestCorner(p, enough, near); };
}

double largest(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

// Whether no point is farther away from a surface than `limit`.
bool areWithin(const std::vector<Vec3>& points, const ClosestPointTree& tree, double limit, Job& job) {
  std::atomic<bool> isWithin = true;
  parallelFor(points.size(), kGrain, [&](size_t begin, size_t end) {
    job.check();
    uint32_t near = kNone;
    for (size_t i = begin; i < end && isWithin; ++i) {
      const ClosestPoint found = tree.nearEnough(points[i], limit, near);
      if (found.distance > limit) isWithin = false;
      near = found.triangle;
    }
  });
  return isWithin;
}

// Built in parallel.
struct TwoTrees {
  TwoTrees(const TriangleMesh& a, const TriangleMesh& b) {
    parallelFor(2, 1, [&](size_t i, size_t) { trees[i].emplace(i == 0 ? a : b); });
  }
  const ClosestPointTree& ofA() const { return *trees[0]; }
  const ClosestPointTree& ofB() const { return *trees[1]; }

  std::optional<ClosestPointTree> trees[2];
};

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (double value : values) sum += value;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

uint32_t sampleCount(const TriangleMesh& a, const TriangleMesh& b, uint32_t wanted) {
  if (wanted > 0) return wanted;
  const uint64_t proportional = kSamplesPerTriangle * std::max(a.triangleCount(), b.triangleCount());
  return static_cast<uint32_t>(std::clamp(proportional, kFewestSamples, kMaxSamples));
}

// The largest distance of two surfaces often occurs on an edge. About half as many points as `samples`, the
// points on the surface.
std::vector<Vec3> edgePoints(const TriangleMesh& mesh, size_t samples) {
  double total = 0;
  for (const Triangle& t : mesh.triangles)
    for (size_t c = 0; c < 3; ++c) total += length(mesh.positions[t[c]] - mesh.positions[t[(c + 1) % 3]]);
  return samples > 0 && total > 0 ? sampleEdges(mesh, total / static_cast<double>(samples))
                                  : std::vector<Vec3>();
}

// The distances from one surface to the other.
struct OneSided {
  double hausdorff, mean;
};

OneSided measureFrom(const TriangleMesh& from, const ClosestPointTree& to, uint32_t samples, Job& job) {
  const auto positions = sampleSurface(from, samples).positions;
  const auto sampled = distances(positions, to, job);
  double hausdorff = largestDistance(from.positions, pointsOf(to), largest(sampled), job);
  hausdorff = largestDistance(edgePoints(from, positions.size()), pointsOf(to), hausdorff, job);
  return {hausdorff, mean(sampled)};
}

}  // namespace

SurfaceDistance measureSurfaceDistance(const TriangleMesh& a, const TriangleMesh& b,
                                       const SurfaceDistanceOptions& options, Job& job) {
  job.begin(Phase::Measure);
  if (a.triangles.empty() || b.triangles.empty()) return {};
  const uint32_t samples = sampleCount(a, b, options.samples);
  const TwoTrees trees(a, b);
  job.report(0.1);
  const OneSided fromA = measureFrom(a, trees.ofB(), samples, job);
  job.report(0.4);
  const OneSided fromB = measureFrom(b, trees.ofA(), samples, job);
  job.report(0.7);
  SurfaceDistance distance;
  distance.hausdorff = std::max(fromA.hausdorff, fromB.hausdorff);
  distance.mean = (fromA.mean + fromB.mean) / 2;
  distance.vertexHausdorff = largestDistance(a.positions, cornersOf(trees.ofB()), 0, job);
  distance.vertexHausdorff =
      largestDistance(b.positions, cornersOf(trees.ofA()), distance.vertexHausdorff, job);
  job.report(1);
  return distance;
}

double measureHausdorff(const TriangleMesh& a, const TriangleMesh& b, const SurfaceDistanceOptions& options,
                        Job& job) {
  job.begin(Phase::Measure);
  if (a.triangles.empty() || b.triangles.empty()) return 0;
  const uint32_t samples = sampleCount(a, b, options.samples);
  const TwoTrees trees(a, b);
  double largest = 0;
  const auto measure = [&](const TriangleMesh& from, const ClosestPointTree& to) {
    largest = largestDistance(from.positions, pointsOf(to), largest, job);
    const auto positions = sampleSurface(from, samples).positions;
    largest = largestDistance(positions, pointsOf(to), largest, job);
    largest = largestDistance(edgePoints(from, positions.size()), pointsOf(to), largest, job);
  };
  measure(a, trees.ofB());
  job.report(0.5);
  measure(b, trees.ofA());
  job.report(1);
  return largest;
}

bool isWithinHausdorff(const TriangleMesh& a, const TriangleMesh& b, double limit,
                       const SurfaceDistanceOptions& options, Job& job) {
  job.begin(Phase::Measure);
  if (a.triangles.empty() || b.triangles.empty()) return 0 <= limit;
  const uint32_t samples = sampleCount(a, b, options.samples);
  const TwoTrees trees(a, b);
  const auto isWithin = [&](const TriangleMesh& from, const ClosestPointTree& to) {
    if (!areWithin(from.positions, to, limit, job)) return false;
    const auto positions = sampleSurface(from, samples).positions;
    return areWithin(positions, to, limit, job) &&
           areWithin(edgePoints(from, positions.size()), to, limit, job);
  };
  const bool areBoth = isWithin(a, trees.ofB()) && isWithin(b, trees.ofA());
  job.report(1);
  return areBoth;
}

}  // namespace limber
