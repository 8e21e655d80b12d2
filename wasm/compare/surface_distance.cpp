#include "compare/surface_distance.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "base/parallel.h"
#include "mesh/surface_samples.h"
#include "query/closest_point.h"

namespace limber {

namespace {

constexpr size_t kGrain = 512;  // points of a range for one thread
constexpr uint64_t kSamplesPerTriangle = 10, kFewestSamples = 10'000, kMostSamples = 500'000;

// The distance of each point to a surface. Points that follow one another should lie close together: the
// triangle closest to one is where the search for the next begins.
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

// The largest distance of the points to a surface, or `atLeast` where that is larger.
double largestDistance(const std::vector<Vec3>& points, const ClosestPointTree& tree, double atLeast,
                       Job& job) {
  std::vector<double> largest((points.size() + kGrain - 1) / kGrain, atLeast);
  parallelFor(points.size(), kGrain, [&](size_t begin, size_t end) {
    job.check();
    double& found = largest[begin / kGrain];
    uint32_t near = kNone;
    for (size_t i = begin; i < end; ++i) {
      const ClosestPoint closest = tree.nearEnough(points[i], found, near);
      found = std::max(found, closest.distance);
      near = closest.triangle;
    }
  });
  return std::accumulate(largest.begin(), largest.end(), atLeast,
                         [](double a, double b) { return std::max(a, b); });
}

double largest(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (double value : values) sum += value;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

// Every vertex as a triangle with three equal corners, so that the tree finds nearest vertices.
TriangleMesh asPoints(const TriangleMesh& mesh) {
  TriangleMesh points;
  points.positions = mesh.positions;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) points.triangles.push_back({v, v, v});
  return points;
}

uint32_t sampleCount(const TriangleMesh& a, const TriangleMesh& b, uint32_t wanted) {
  if (wanted > 0) return wanted;
  const uint64_t proportional = kSamplesPerTriangle * std::max(a.triangleCount(), b.triangleCount());
  return static_cast<uint32_t>(std::clamp(proportional, kFewestSamples, kMostSamples));
}

// The distances from one surface to the other.
struct OneSided {
  double hausdorff, mean;
};

OneSided measureFrom(const TriangleMesh& from, const ClosestPointTree& to, uint32_t samples, Job& job) {
  const auto sampled = distances(sampleSurface(from, samples).positions, to, job);
  return {largestDistance(from.positions, to, largest(sampled), job), mean(sampled)};
}

}  // namespace

SurfaceDistance measureSurfaceDistance(const TriangleMesh& a, const TriangleMesh& b,
                                       const SurfaceDistanceOptions& options, Job& job) {
  job.begin(Phase::Measure);
  if (a.triangles.empty() || b.triangles.empty()) return {};
  const uint32_t samples = sampleCount(a, b, options.samples);
  const ClosestPointTree treeA(a), treeB(b);
  job.report(0.1);
  const OneSided fromA = measureFrom(a, treeB, samples, job);
  job.report(0.4);
  const OneSided fromB = measureFrom(b, treeA, samples, job);
  job.report(0.7);
  const TriangleMesh pointsA = asPoints(a), pointsB = asPoints(b);
  const ClosestPointTree pointTreeA(pointsA), pointTreeB(pointsB);
  SurfaceDistance distance;
  distance.hausdorff = std::max(fromA.hausdorff, fromB.hausdorff);
  distance.mean = (fromA.mean + fromB.mean) / 2;
  distance.vertexHausdorff = largestDistance(a.positions, pointTreeB, 0, job);
  distance.vertexHausdorff = largestDistance(b.positions, pointTreeA, distance.vertexHausdorff, job);
  job.report(1);
  return distance;
}

double measureHausdorff(const TriangleMesh& a, const TriangleMesh& b, const SurfaceDistanceOptions& options,
                        Job& job) {
  job.begin(Phase::Measure);
  if (a.triangles.empty() || b.triangles.empty()) return 0;
  const uint32_t samples = sampleCount(a, b, options.samples);
  double largest = 0;
  const auto measure = [&](const TriangleMesh& from, const TriangleMesh& to) {
    const ClosestPointTree tree(to);
    largest = largestDistance(from.positions, tree, largest, job);
    largest = largestDistance(sampleSurface(from, samples).positions, tree, largest, job);
  };
  measure(a, b);
  job.report(0.5);
  measure(b, a);
  job.report(1);
  return largest;
}

}  // namespace limber
