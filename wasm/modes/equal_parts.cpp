#include "modes/equal_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

namespace limber {
namespace {

// A hash of the data that is bit-identical for equal parts.
uint64_t hashOf(const Part& part) {
  uint64_t hash = 0x9e3779b97f4a7c15u + static_cast<uint64_t>(part.model);
  const auto add = [&](uint64_t word) {
    hash = (hash ^ word) * 0xff51afd7ed558ccdu;
    hash ^= hash >> 32;
  };
  add(part.mesh.vertexCount());
  for (const Triangle& triangle : part.mesh.triangles)
    for (const uint32_t v : triangle) add(v);
  for (const uint32_t v : part.pinned) add(v);
  return hash;
}

// `tolerance` is a length in units of the body.
bool areEqual(const Part& a, const Part& b, double tolerance) {
  const double inFrame = tolerance / a.diagonal;
  const auto isNear = [&](const Vec3& p, const Vec3& q) {
    return std::abs(p.x - q.x) <= inFrame && std::abs(p.y - q.y) <= inFrame && std::abs(p.z - q.z) <= inFrame;
  };
  return a.model == b.model && a.components.size() == b.components.size() &&
         std::abs(a.diagonal - b.diagonal) <= tolerance && a.pinned == b.pinned &&
         a.mesh.triangles == b.mesh.triangles &&
         std::ranges::equal(a.mesh.positions, b.mesh.positions, isNear);
}

}  // namespace

std::vector<size_t> firstEqualParts(const TriangleMesh& body, const std::vector<Part>& parts) {
  double farthest = 0;
  for (const Vec3& p : body.positions)
    farthest = std::max({farthest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  // A coordinate is off by up to half a float32 step, and so is the corner of the box at which the frame
  // starts.
  const double tolerance = 2 * std::numeric_limits<float>::epsilon() * farthest;
  // Of thousands of leaves, say, all have the same triangles, but few have diagonals that are equally close.
  std::multimap<std::pair<uint64_t, double>, size_t> known;
  std::vector<size_t> first(parts.size());
  for (size_t i = 0; i < parts.size(); ++i) {
    first[i] = i;
    const uint64_t hash = hashOf(parts[i]);
    const double diagonal = parts[i].diagonal;
    const auto end = known.upper_bound({hash, diagonal + tolerance});
    for (auto entry = known.lower_bound({hash, diagonal - tolerance}); entry != end; ++entry)
      if (areEqual(parts[entry->second], parts[i], tolerance)) first[i] = std::min(first[i], entry->second);
    if (first[i] == i) known.emplace(std::pair(hash, diagonal), i);
  }
  return first;
}

}  // namespace limber
