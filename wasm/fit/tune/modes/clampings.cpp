#include "fit/tune/modes/clampings.h"

#include <algorithm>

#include "elastic/pins.h"
#include "mesh/component_frame.h"
#include "mesh/pinned_vertices.h"
#include "transfer/carry_pins.h"

namespace limber {
namespace {

constexpr double kEndShare = 0.1;  // of the longest side

// The vertices of a mesh at an end of the longest side of a box.
std::vector<uint32_t> verticesAtEnd(const TriangleMesh& mesh, const Bounds& box, bool isLower) {
  const Vec3 size = box.high - box.low;
  int axis = 0;
  for (int c = 1; c < 3; ++c)
    if (size[c] > size[axis]) axis = c;
  std::vector<uint32_t> vertices;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const double height = mesh.positions[v][axis];
    const double depth = isLower ? height - box.low[axis] : box.high[axis] - height;
    if (depth <= kEndShare * size[axis]) vertices.push_back(v);
  }
  return vertices;
}

// Pins of a part of the original, carried over; a point within a triangle becomes its closest corner.
std::vector<uint32_t> carriedVertices(const PartPair& pair, const std::vector<uint32_t>& pinned) {
  const Pins pins = carryPins(pair.original.mesh, pinned, pair.result.mesh);
  std::vector<uint32_t> vertices = pins.vertices;
  for (const SurfacePoint& point : pins.points) {
    const auto corner = std::max_element(point.barycentric, point.barycentric + 3) - point.barycentric;
    vertices.push_back(pair.result.mesh.triangles[point.triangle][static_cast<size_t>(corner)]);
  }
  return PinnedVertices(std::move(vertices)).ids();
}

// The vertices of a part that are pinned in its body.
std::vector<uint32_t> pinnedOfPart(const SolverPart& part, const std::vector<uint32_t>& pinned) {
  std::vector<uint32_t> some;
  for (uint32_t v = 0; v < part.vertices.size(); ++v)
    if (std::ranges::binary_search(pinned, part.vertices[v])) some.push_back(v);
  return some;
}

bool leavesNoMotion(const TriangleMesh& mesh, const std::vector<uint32_t>& pinned) {
  if (pinned.size() >= mesh.vertexCount()) return false;  // nothing is left to vibrate
  const UnitFrame frame = unitFrame(mesh);
  std::vector<Vec3> points;
  for (const uint32_t v : pinned) points.push_back(frame.toFrame(mesh.positions[v]));
  return rigidMotionsLeft(points) == 0;
}

void addPart(const PartPair& pair, PartPins pins, Clamping& clamping) {
  if (leavesNoMotion(pair.original.mesh, pins.original) && leavesNoMotion(pair.result.mesh, pins.result))
    clamping.parts.push_back(std::move(pins));
}

Clamping clampedEnd(const std::deque<PartPair>& pairs, const Bounds& box, ClampKind kind) {
  Clamping clamping{kind, {}};
  for (size_t i = 0; i < pairs.size(); ++i) {
    std::vector<uint32_t> pinned = verticesAtEnd(pairs[i].original.mesh, box, kind == ClampKind::LowerEnd);
    if (pinned.empty()) continue;
    std::vector<uint32_t> carried = carriedVertices(pairs[i], pinned);
    addPart(pairs[i], {i, std::move(pinned), std::move(carried)}, clamping);
  }
  return clamping;
}

Clamping userPins(const std::deque<PartPair>& pairs, const TuneOptions& options) {
  Clamping clamping{ClampKind::UserPins, {}};
  const std::vector<uint32_t> original = PinnedVertices(options.pinnedOriginal).ids(),
                              result = PinnedVertices(options.pinnedResult).ids();
  for (size_t i = 0; i < pairs.size(); ++i)
    addPart(pairs[i], {i, pinnedOfPart(pairs[i].original, original), pinnedOfPart(pairs[i].result, result)},
            clamping);
  return clamping;
}

}  // namespace

std::vector<Clamping> findClampings(const TriangleMesh& original, const std::deque<PartPair>& pairs,
                                    const TuneOptions& options) {
  const Bounds box = bounds(original);
  std::vector<Clamping> all(1);
  for (size_t i = 0; i < pairs.size(); ++i) all[0].parts.push_back({i, {}, {}});
  for (Clamping clamping : {clampedEnd(pairs, box, ClampKind::LowerEnd), userPins(pairs, options),
                            clampedEnd(pairs, box, ClampKind::OtherEnd)})
    if (!clamping.parts.empty()) all.push_back(std::move(clamping));
  return all;
}

}  // namespace limber
