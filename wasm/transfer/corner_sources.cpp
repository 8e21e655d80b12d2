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

// Barycentric coordinates below this are rounding errors and become 0.
constexpr double kNothing = 1e-12;

void checkSize(size_t found, size_t expected, const char* field, const char* item) {
  if (found == 0 || found == expected) return;
  throw std::invalid_argument(std::string("There are ") + std::to_string(found) + " " + field +
                              ", but the mesh has " + std::to_string(expected) + " " + item +
                              ": give one for each.");
}

void check(const TriangleMesh& original, const Charts& charts, const MeshAt& result) {
  checkSize(charts.wedges.size(), 3 * size_t{original.triangleCount()}, "wedges", "corners");
  checkSize(charts.groups.size(), original.triangleCount(), "groups", "triangles");
  const auto belongs = [&](uint32_t t) {
    for (int c = 0; c < 3; ++c) {
      const uint32_t v = original.triangles[result.inputOfTriangle[t]][c];
      if (result.vertexOfInput[v] != result.mesh.triangles[t][c]) return false;
    }
    return true;
  };
  bool fits =
      result.vertexOfInput.size() == original.vertexCount() &&
      result.inputOfTriangle.size() == result.mesh.triangleCount() &&
      std::ranges::all_of(result.inputOfTriangle, [&](uint32_t t) { return t < original.triangleCount(); });
  for (uint32_t t = 0; fits && t < result.mesh.triangleCount(); ++t) fits = belongs(t);
  if (!fits)
    throw std::invalid_argument(
        "The result was made from another mesh: reduce this mesh and ask for the sources of that.");
}

// A point of a seam of the original, at `fraction` of the way from vertex a of an edge to vertex b. `end` is
// the end of the edge in the cluster.
struct SeamPoint {
  uint32_t edge = kNone, end = kNone;
  double fraction = 0;
  double distance = HUGE_VAL;
};

SurfacePoint pointAt(Corner corner) {
  SurfacePoint point{corner.triangle()};
  point.barycentric[corner.index()] = 1;
  return point;
}

// The data that the searches for all vertices of the result share.
struct SourceContext {
  const TriangleMesh& original;
  const MeshAt& result;
  Topology topology;  // of the original
  ChartSides sides;
  std::vector<uint32_t> resultOfTriangle;  // per triangle of the original: its index in the result, or kNone
};

// Finds the sources of the corners around the vertices of the result, one vertex after the other. Each thread
// has its own instance.
class SourceFinder {
 public:
  SourceFinder(const SourceContext& context, CornerSources& sources)
      : context_(context), sources_(sources), walk_(context.original, context.topology) {}

  void find(uint32_t vertex);

 private:
  uint32_t originalVertex(Corner corner) const { return vertexAt(context_.original, corner); }
  void collectUsedSides();
  bool isUntouched() const;
  bool hasAllSides(uint32_t originalVertex, std::span<const uint32_t> wanted) const;
  uint32_t closestJunction() const;
  SeamPoint closestOnSeam(std::span<const uint32_t> wanted) const;
  void considerEdge(uint32_t edge, uint32_t end, std::span<const uint32_t> wanted, SeamPoint& best) const;
  void findForSide(uint32_t side);
  void findInside(uint32_t side);
  void storeOnSeam(const SeamPoint& point, uint32_t side);
  void storeAtVertex(uint32_t originalVertex, uint32_t side);
  void store(uint32_t side, const SurfacePoint& source);
  void storeAt(Corner resultCorner, const SurfacePoint& source);

  const SourceContext& context_;
  CornerSources& sources_;
  SurfaceWalk walk_;
  Vec3 position_;                    // of the vertex of the result
  std::span<const Corner> corners_;  // of the original around that vertex
  std::vector<uint32_t> used_;       // sides that the result has triangles on, ascending
  std::vector<uint32_t> start_;      // triangles where findInside starts
};

void SourceFinder::find(uint32_t vertex) {
  position_ = context_.result.mesh.positions[vertex];
  corners_ = context_.sides.cornersAround(vertex);
  collectUsedSides();
  if (isUntouched()) {
    for (const Corner corner : corners_) {
      const uint32_t t = context_.resultOfTriangle[corner.triangle()];
      if (t != kNone) storeAt(Corner(t, corner.index()), pointAt(corner));
    }
    return;
  }
  if (const uint32_t junction = closestJunction(); junction != kNone) {
    for (const uint32_t side : used_) storeAtVertex(junction, side);
    return;
  }
  const SeamPoint point = closestOnSeam(used_);
  for (const uint32_t side : used_) point.edge != kNone ? storeOnSeam(point, side) : findForSide(side);
}

void SourceFinder::collectUsedSides() {
  used_.clear();
  for (const Corner corner : corners_)
    if (context_.resultOfTriangle[corner.triangle()] != kNone) used_.push_back(context_.sides.sideOf(corner));
  std::ranges::sort(used_);
  used_.erase(std::ranges::unique(used_).begin(), used_.end());
}

bool SourceFinder::isUntouched() const {
  const uint32_t first = originalVertex(corners_[0]);
  return context_.original.positions[first] == position_ &&
         std::ranges::all_of(corners_, [&](Corner corner) { return originalVertex(corner) == first; });
}

// Whether all of the wanted sides have a corner at the vertex.
bool SourceFinder::hasAllSides(uint32_t originalVertex, std::span<const uint32_t> wanted) const {
  const auto around = context_.topology.trianglesAround(originalVertex);
  return std::ranges::all_of(wanted, [&](uint32_t side) {
    return std::ranges::any_of(around, [&](uint32_t t) {
      return context_.sides.sideOf(cornerAt(context_.original, t, originalVertex)) == side;
    });
  });
}

// The closest vertex of the cluster where seams meet or end and where all used sides have a corner; kNone
// without one.
uint32_t SourceFinder::closestJunction() const {
  uint32_t best = kNone;
  double bestSquared = HUGE_VAL;
  for (const Corner corner : corners_) {
    const uint32_t v = originalVertex(corner);
    const uint32_t seams = context_.sides.seamCount(v);
    const bool isSeenFirst = context_.topology.trianglesAround(v)[0] == corner.triangle();
    if (seams == 0 || seams == 2 || !isSeenFirst || !hasAllSides(v, used_)) continue;
    const double squared = squaredLength(context_.original.positions[v] - position_);
    if (squared > bestSquared || (squared == bestSquared && v > best)) continue;
    best = v;
    bestSquared = squared;
  }
  return best;
}

// The closest point of those seams at the cluster that all wanted sides adjoin. Its edge is kNone without
// one.
SeamPoint SourceFinder::closestOnSeam(std::span<const uint32_t> wanted) const {
  SeamPoint best;
  for (const Corner corner : corners_)
    for (const int opposite : {nextIndex(corner.index()), previousIndex(corner.index())}) {
      const uint32_t edge = context_.topology.edgeOpposite(Corner(corner.triangle(), opposite));
      if (context_.sides.isSeam(edge)) considerEdge(edge, originalVertex(corner), wanted, best);
    }
  return best;
}

void SourceFinder::considerEdge(uint32_t edge, uint32_t end, std::span<const uint32_t> wanted,
                                SeamPoint& best) const {
  const auto& [original, result, topology, sides, resultOfTriangle] = context_;
  const auto triangles = topology.trianglesAt(topology.edges[edge]);
  const bool hasAll = std::ranges::all_of(wanted, [&](uint32_t side) {
    return std::ranges::any_of(triangles,
                               [&](uint32_t t) { return sides.sideOf(cornerAt(original, t, end)) == side; });
  });
  if (!hasAll) return;
  const Vec3 &a = original.positions[topology.edges[edge].a], &b = original.positions[topology.edges[edge].b];
  const double squares = squaredLength(b - a);
  const double fraction = squares > 0 ? std::clamp(dot(position_ - a, b - a) / squares, 0.0, 1.0) : 0.0;
  const double distance = length(a + (b - a) * fraction - position_);
  if (distance > best.distance || (distance == best.distance && edge >= best.edge)) return;
  best = {edge, end, fraction, distance};
}

// For a side that shares no seam point with the others.
void SourceFinder::findForSide(uint32_t side) {
  const SeamPoint point = closestOnSeam(std::span(&side, 1));
  point.edge != kNone ? storeOnSeam(point, side) : findInside(side);
}

void SourceFinder::findInside(uint32_t side) {
  start_.clear();
  for (const Corner corner : corners_)
    if (context_.sides.sideOf(corner) == side) start_.push_back(corner.triangle());
  const ClosestPoint found =
      walk_.closest(position_, start_, [&](uint32_t edge, uint32_t) { return !context_.sides.isSeam(edge); });
  store(side, found);
}

void SourceFinder::storeOnSeam(const SeamPoint& point, uint32_t side) {
  const auto& [original, result, topology, sides, resultOfTriangle] = context_;
  const Topology::Edge& edge = topology.edges[point.edge];
  for (const uint32_t t : topology.trianglesAt(edge)) {
    if (sides.sideOf(cornerAt(original, t, point.end)) != side) continue;
    SurfacePoint source{t};
    source.barycentric[cornerAt(original, t, edge.a).index()] = 1 - point.fraction;
    source.barycentric[cornerAt(original, t, edge.b).index()] = point.fraction;
    return store(side, source);
  }
}

void SourceFinder::storeAtVertex(uint32_t originalVertex, uint32_t side) {
  for (const uint32_t t : context_.topology.trianglesAround(originalVertex)) {
    const Corner corner = cornerAt(context_.original, t, originalVertex);
    if (context_.sides.sideOf(corner) != side) continue;
    return store(side, pointAt(corner));
  }
}

// Gives a source to all corners of the result around the vertex that are on `side`.
void SourceFinder::store(uint32_t side, const SurfacePoint& source) {
  for (const Corner corner : corners_) {
    const uint32_t t = context_.resultOfTriangle[corner.triangle()];
    if (t != kNone && context_.sides.sideOf(corner) == side) storeAt(Corner(t, corner.index()), source);
  }
}

void SourceFinder::storeAt(Corner resultCorner, const SurfacePoint& source) {
  sources_.triangle[resultCorner.flatIndex()] = source.triangle;
  double kept[3], sum = 0;
  for (int c = 0; c < 3; ++c) sum += kept[c] = source.barycentric[c] > kNothing ? source.barycentric[c] : 0;
  for (int c = 0; c < 3; ++c)
    sources_.barycentric[3 * size_t{resultCorner.flatIndex()} + c] = static_cast<float>(kept[c] / sum);
}

std::vector<uint32_t> invert(const std::vector<uint32_t>& inputOfTriangle, uint32_t originalCount) {
  std::vector<uint32_t> resultOfTriangle(originalCount, kNone);
  for (uint32_t t = 0; t < inputOfTriangle.size(); ++t) resultOfTriangle[inputOfTriangle[t]] = t;
  return resultOfTriangle;
}

void checkFlips(const MeshAt& result) {
  const auto& [triangles, corners] = result.flips;
  bool fits = triangles.size() == result.mesh.triangleCount() && corners.size() == 3 * triangles.size();
  for (uint32_t corner = 0; fits && corner < corners.size(); ++corner) {
    const uint32_t before = corners[corner];
    fits = before < corners.size() &&
           triangles[before / 3][before % 3] == result.mesh.triangles[corner / 3][corner % 3];
  }
  if (!fits)
    throw std::invalid_argument(
        "The flipped edges belong to another result: ask for the sources of a result as it was fitted.");
}

// A corner keeps the source that it had before edges were flipped, because flips change neither its vertex
// nor its chart.
CornerSources sourceBeforeFlips(const TriangleMesh& original, const Charts& charts, const MeshAt& result,
                                Job& job) {
  checkFlips(result);
  MeshAt before = result;
  before.mesh.triangles = result.flips.triangles;
  before.flips = {};
  const CornerSources found = sourceOfCorners(original, charts, before, job);
  CornerSources sources;
  for (const uint32_t corner : result.flips.corners) {
    sources.triangle.push_back(found.triangle[corner]);
    for (uint32_t c = 0; c < 3; ++c) sources.barycentric.push_back(found.barycentric[3 * corner + c]);
  }
  return sources;
}

}  // namespace

CornerSources sourceOfCorners(const TriangleMesh& original, const Charts& charts, const MeshAt& result,
                              Job& job) {
  if (!result.flips.corners.empty()) return sourceBeforeFlips(original, charts, result, job);
  check(original, charts, result);
  job.begin(Phase::Measure);
  Topology topology = buildTopology(original);
  ChartSides sides(original, topology, charts, result);
  job.report(0.5);
  const SourceContext context{original, result, std::move(topology), std::move(sides),
                              invert(result.inputOfTriangle, original.triangleCount())};
  const size_t cornerCount = 3 * size_t{result.mesh.triangleCount()};
  CornerSources sources{std::vector<uint32_t>(cornerCount, kNone), std::vector<float>(3 * cornerCount, 0.0f)};
  parallelFor(result.mesh.vertexCount(), kVerticesPerRange, [&](size_t begin, size_t end) {
    SourceFinder finder(context, sources);
    for (size_t v = begin; v < end; ++v) {
      if (v % kVerticesPerCheck == 0) job.check();
      finder.find(static_cast<uint32_t>(v));
    }
  });
  job.report(1);
  return sources;
}

}  // namespace limber
