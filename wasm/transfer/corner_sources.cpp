#include "transfer/corner_sources.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "base/parallel.h"
#include "mesh/topology.h"
#include "query/surface_walk.h"
#include "transfer/chart_sides.h"

namespace limber {
namespace {

constexpr size_t kVerticesPerRange = 16384;
constexpr size_t kVerticesPerCheck = 1024;

// Barycentric coordinates below it are rounding.
constexpr double kNothing = 1e-12;

void checkSize(size_t found, size_t expected, const char* field, const char* item) {
  if (found == 0 || found == expected) return;
  throw std::invalid_argument(std::string("There are ") + std::to_string(found) + " " + field +
                              ", but the mesh has " + std::to_string(expected) + " " + item +
                              ": give one for each.");
}

void check(const TriangleMesh& input, const Charts& charts, const MeshAt& result) {
  checkSize(charts.wedges.size(), 3 * size_t{input.triangleCount()}, "wedges", "corners");
  checkSize(charts.groups.size(), input.triangleCount(), "groups", "triangles");
  const auto belongs = [&](uint32_t t) {
    for (int c = 0; c < 3; ++c) {
      const uint32_t v = input.triangles[result.inputOfTriangle[t]][c];
      if (result.vertexOfInput[v] != result.mesh.triangles[t][c]) return false;
    }
    return true;
  };
  bool fits =
      result.vertexOfInput.size() == input.vertexCount() &&
      result.inputOfTriangle.size() == result.mesh.triangleCount() &&
      std::ranges::all_of(result.inputOfTriangle, [&](uint32_t t) { return t < input.triangleCount(); });
  for (uint32_t t = 0; fits && t < result.mesh.triangleCount(); ++t) fits = belongs(t);
  if (!fits)
    throw std::invalid_argument(
        "The result was made from another mesh: reduce this mesh and ask for the sources of that.");
}

// A point of a seam: `fraction` of the way from the edge's vertex a to b; `end` is the one that was reached.
struct SeamPoint {
  uint32_t edge = kNone, end = kNone;
  double fraction = 0;
  double distance = HUGE_VAL;
};

// What all vertices of the result share.
struct Carried {
  const TriangleMesh& input;
  const MeshAt& result;
  Topology topology;  // of the input
  ChartSides sides;
  std::vector<uint32_t> resultOfTriangle;  // per input triangle: its number in the result, or kNone
};

// Finds the sources of the corners around one vertex of the result after the other; one for each thread.
class SourceFinder {
 public:
  SourceFinder(const Carried& carried, CornerSources& sources)
      : carried_(carried), sources_(sources), walk_(carried.input, carried.topology) {}

  void find(uint32_t vertex);

 private:
  uint32_t inputVertex(Corner corner) const { return vertexAt(carried_.input, corner); }
  void collectSides();
  bool isUntouched() const;
  bool hasAllSides(uint32_t inputVertex, std::span<const uint32_t> wanted) const;
  uint32_t closestJunction() const;
  SeamPoint closestOnSeam(std::span<const uint32_t> wanted) const;
  void considerEdge(uint32_t edge, uint32_t end, std::span<const uint32_t> wanted, SeamPoint& best) const;
  void placeSide(uint32_t side);
  void placeInside(uint32_t side);
  void placeOnSeam(const SeamPoint& point, uint32_t side);
  void placeAtVertex(uint32_t inputVertex, uint32_t side);
  void store(uint32_t side, uint32_t triangle, const double (&barycentric)[3]);
  void storeAt(Corner resultCorner, uint32_t triangle, const double (&barycentric)[3]);

  const Carried& carried_;
  CornerSources& sources_;
  SurfaceWalk walk_;
  uint32_t vertex_ = 0;              // of the result
  Vec3 position_;                    // of that
  std::span<const Corner> corners_;  // of the input around it
  std::vector<uint32_t> used_;       // sides that the result has triangles on, ascending
  std::vector<uint32_t> start_;
};

void SourceFinder::find(uint32_t vertex) {
  vertex_ = vertex;
  position_ = carried_.result.mesh.positions[vertex];
  corners_ = carried_.sides.cornersAround(vertex);
  collectSides();
  if (isUntouched()) {
    for (const Corner corner : corners_) {
      double barycentric[3] = {0, 0, 0};
      barycentric[corner.index()] = 1;
      const uint32_t t = carried_.resultOfTriangle[corner.triangle()];
      if (t != kNone) storeAt(Corner(t, corner.index()), corner.triangle(), barycentric);
    }
    return;
  }
  if (const uint32_t junction = closestJunction(); junction != kNone) {
    for (const uint32_t side : used_) placeAtVertex(junction, side);
    return;
  }
  const SeamPoint point = closestOnSeam(used_);
  for (const uint32_t side : used_) point.edge != kNone ? placeOnSeam(point, side) : placeSide(side);
}

void SourceFinder::collectSides() {
  used_.clear();
  for (const Corner corner : corners_)
    if (carried_.resultOfTriangle[corner.triangle()] != kNone) used_.push_back(carried_.sides.sideOf(corner));
  std::ranges::sort(used_);
  used_.erase(std::ranges::unique(used_).begin(), used_.end());
}

bool SourceFinder::isUntouched() const {
  const uint32_t first = inputVertex(corners_[0]);
  return carried_.input.positions[first] == position_ &&
         std::ranges::all_of(corners_, [&](Corner corner) { return inputVertex(corner) == first; });
}

// Whether each of the wanted sides has a triangle at the vertex.
bool SourceFinder::hasAllSides(uint32_t inputVertex, std::span<const uint32_t> wanted) const {
  const auto around = carried_.topology.trianglesAround(inputVertex);
  return std::ranges::all_of(wanted, [&](uint32_t side) {
    return std::ranges::any_of(around, [&](uint32_t t) {
      return carried_.sides.sideOf(cornerAt(carried_.input, t, inputVertex)) == side;
    });
  });
}

// Of the cluster's vertices where seams meet or end and that all used sides share the closest; kNone without.
uint32_t SourceFinder::closestJunction() const {
  uint32_t best = kNone;
  double bestSquared = HUGE_VAL;
  for (const Corner corner : corners_) {
    const uint32_t v = inputVertex(corner);
    const uint32_t seams = carried_.sides.seamCount(v);
    const bool isSeenFirst = carried_.topology.trianglesAround(v)[0] == corner.triangle();
    if (seams == 0 || seams == 2 || !isSeenFirst || !hasAllSides(v, used_)) continue;
    const double squared = squaredLength(carried_.input.positions[v] - position_);
    if (squared > bestSquared || (squared == bestSquared && v > best)) continue;
    best = v;
    bestSquared = squared;
  }
  return best;
}

// The closest point of the seams at the cluster that have all wanted sides beside them.
SeamPoint SourceFinder::closestOnSeam(std::span<const uint32_t> wanted) const {
  SeamPoint best;
  for (const Corner corner : corners_)
    for (const int opposite : {nextIndex(corner.index()), previousIndex(corner.index())}) {
      const uint32_t edge = carried_.topology.edgeOpposite(Corner(corner.triangle(), opposite));
      if (carried_.sides.isSeam(edge)) considerEdge(edge, inputVertex(corner), wanted, best);
    }
  return best;
}

void SourceFinder::considerEdge(uint32_t edge, uint32_t end, std::span<const uint32_t> wanted,
                                SeamPoint& best) const {
  const auto& [input, result, topology, sides, resultOfTriangle] = carried_;
  const auto triangles = topology.trianglesAt(topology.edges[edge]);
  const bool hasAll = std::ranges::all_of(wanted, [&](uint32_t side) {
    return std::ranges::any_of(triangles,
                               [&](uint32_t t) { return sides.sideOf(cornerAt(input, t, end)) == side; });
  });
  if (!hasAll) return;
  const Vec3 &a = input.positions[topology.edges[edge].a], &b = input.positions[topology.edges[edge].b];
  const double squares = squaredLength(b - a);
  const double fraction = squares > 0 ? std::clamp(dot(position_ - a, b - a) / squares, 0.0, 1.0) : 0.0;
  const double distance = length(a + (b - a) * fraction - position_);
  if (distance > best.distance || (distance == best.distance && edge >= best.edge)) return;
  best = {edge, end, fraction, distance};
}

// A side that has no seam point in common with the others.
void SourceFinder::placeSide(uint32_t side) {
  const SeamPoint point = closestOnSeam(std::span(&side, 1));
  point.edge != kNone ? placeOnSeam(point, side) : placeInside(side);
}

void SourceFinder::placeInside(uint32_t side) {
  start_.clear();
  for (const Corner corner : corners_)
    if (carried_.sides.sideOf(corner) == side) start_.push_back(corner.triangle());
  const ClosestPoint found =
      walk_.closest(position_, start_, [&](uint32_t edge, uint32_t) { return !carried_.sides.isSeam(edge); });
  store(side, found.triangle, found.barycentric);
}

void SourceFinder::placeOnSeam(const SeamPoint& point, uint32_t side) {
  const auto& [input, result, topology, sides, resultOfTriangle] = carried_;
  const Topology::Edge& edge = topology.edges[point.edge];
  for (const uint32_t t : topology.trianglesAt(edge)) {
    if (sides.sideOf(cornerAt(input, t, point.end)) != side) continue;
    double barycentric[3] = {0, 0, 0};
    barycentric[cornerAt(input, t, edge.a).index()] = 1 - point.fraction;
    barycentric[cornerAt(input, t, edge.b).index()] = point.fraction;
    return store(side, t, barycentric);
  }
}

void SourceFinder::placeAtVertex(uint32_t inputVertex, uint32_t side) {
  for (const uint32_t t : carried_.topology.trianglesAround(inputVertex)) {
    const Corner corner = cornerAt(carried_.input, t, inputVertex);
    if (carried_.sides.sideOf(corner) != side) continue;
    double barycentric[3] = {0, 0, 0};
    barycentric[corner.index()] = 1;
    return store(side, t, barycentric);
  }
}

// To all corners of the result around the vertex that are on `side`.
void SourceFinder::store(uint32_t side, uint32_t triangle, const double (&barycentric)[3]) {
  for (const Corner corner : corners_) {
    const uint32_t t = carried_.resultOfTriangle[corner.triangle()];
    if (t != kNone && carried_.sides.sideOf(corner) == side)
      storeAt(Corner(t, corner.index()), triangle, barycentric);
  }
}

void SourceFinder::storeAt(Corner resultCorner, uint32_t triangle, const double (&barycentric)[3]) {
  sources_.triangle[resultCorner.flatIndex()] = triangle;
  double kept[3], sum = 0;
  for (int c = 0; c < 3; ++c) sum += kept[c] = barycentric[c] > kNothing ? barycentric[c] : 0;
  for (int c = 0; c < 3; ++c)
    sources_.barycentric[3 * size_t{resultCorner.flatIndex()} + c] = static_cast<float>(kept[c] / sum);
}

std::vector<uint32_t> invert(const std::vector<uint32_t>& inputOfTriangle, uint32_t inputCount) {
  std::vector<uint32_t> resultOfTriangle(inputCount, kNone);
  for (uint32_t t = 0; t < inputOfTriangle.size(); ++t) resultOfTriangle[inputOfTriangle[t]] = t;
  return resultOfTriangle;
}

// Before edges were flipped a corner had the same vertex and the same chart, hence the same source.
CornerSources sourceBeforeFlips(const TriangleMesh& input, const Charts& charts, const MeshAt& result,
                                Job& job) {
  MeshAt before = result;
  before.mesh.triangles = result.flips.triangles;
  before.flips = {};
  const CornerSources found = sourceOfCorners(input, charts, before, job);
  CornerSources sources;
  for (const uint32_t corner : result.flips.corners) {
    sources.triangle.push_back(found.triangle[corner]);
    for (uint32_t c = 0; c < 3; ++c) sources.barycentric.push_back(found.barycentric[3 * corner + c]);
  }
  return sources;
}

}  // namespace

CornerSources sourceOfCorners(const TriangleMesh& input, const Charts& charts, const MeshAt& result,
                              Job& job) {
  if (!result.flips.corners.empty()) return sourceBeforeFlips(input, charts, result, job);
  check(input, charts, result);
  job.begin(Phase::Measure);
  Topology topology = buildTopology(input);
  ChartSides sides(input, topology, charts, result);
  job.report(0.5);
  const Carried carried{input, result, std::move(topology), std::move(sides),
                        invert(result.inputOfTriangle, input.triangleCount())};
  const size_t cornerCount = 3 * size_t{result.mesh.triangleCount()};
  CornerSources sources{std::vector<uint32_t>(cornerCount, kNone), std::vector<float>(3 * cornerCount, 0.0f)};
  parallelFor(result.mesh.vertexCount(), kVerticesPerRange, [&](size_t begin, size_t end) {
    SourceFinder finder(carried, sources);
    for (size_t v = begin; v < end; ++v) {
      if (v % kVerticesPerCheck == 0) job.check();
      finder.find(static_cast<uint32_t>(v));
    }
  });
  job.report(1);
  return sources;
}

}  // namespace limber
