#include "mesh/repair/weld.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include "mesh/repair/close_vertices.h"
#include "mesh/repair/first_occurrence.h"
#include "mesh/repair/orientation.h"
#include "mesh/topology.h"

namespace limber {
namespace {

// The input triangle soup.
struct Soup {
  std::span<const float> positions;
  std::span<const uint32_t> indices;

  uint32_t vertexCount() const { return static_cast<uint32_t>(positions.size() / 3); }
  uint32_t faceCount() const { return static_cast<uint32_t>(indices.size() / 3); }
  // Adding 0 turns -0 into +0.
  Vec3 position(uint32_t v) const {
    return {positions[3 * v] + 0.0f, positions[3 * v + 1] + 0.0f, positions[3 * v + 2] + 0.0f};
  }
  FirstOccurrence::Key bits(uint32_t v) const {
    FirstOccurrence::Key key;
    for (int c = 0; c < 3; ++c) key[c] = std::bit_cast<uint32_t>(positions[3 * v + c] + 0.0f);
    return key;
  }
};

void checkOptions(const WeldOptions& options) {
  if (!(options.tolerance >= 0) || !std::isfinite(options.tolerance))
    throw std::invalid_argument("The welding tolerance must be a number of percent that is not negative.");
}

// Returns per vertex whether a face uses it. Throws std::invalid_argument for an invalid face.
std::vector<uint8_t> checkFaces(const Soup& soup) {
  if (soup.positions.size() % 3 != 0 || soup.indices.size() % 3 != 0)
    throw std::invalid_argument("Positions and indices must come in threes; the mesh has " +
                                std::to_string(soup.positions.size()) + " coordinates and " +
                                std::to_string(soup.indices.size()) + " indices: export it again.");
  std::vector<uint8_t> referenced(soup.vertexCount(), 0);
  for (size_t i = 0; i < soup.indices.size(); ++i) {
    const uint32_t v = soup.indices[i];
    if (v >= soup.vertexCount())
      throw std::invalid_argument("Face " + std::to_string(i / 3 + 1) + " uses vertex " +
                                  std::to_string(uint64_t{v} + 1) + ", but there are only " +
                                  std::to_string(soup.vertexCount()) +
                                  " vertices: the file is damaged, export it again.");
    referenced[v] = 1;
  }
  for (uint32_t v = 0; v < soup.vertexCount(); ++v)
    if (referenced[v] && !isFinite(soup.position(v)))
      throw std::invalid_argument(
          "The position of vertex " + std::to_string(uint64_t{v} + 1) +
          " is not a finite number: repair the mesh where it was made, or remove the faces at that vertex.");
  return referenced;
}

// Per referenced vertex the lowest vertex that it is welded to; other vertices represent themselves.
std::vector<uint32_t> findRepresentatives(const Soup& soup, const std::vector<uint8_t>& referenced,
                                          double tolerance, Job& job) {
  std::vector<uint32_t> representative(soup.vertexCount());
  std::iota(representative.begin(), representative.end(), 0);
  FirstOccurrence sameBits(soup.vertexCount());
  std::vector<uint32_t> distinct;
  for (uint32_t v = 0; v < soup.vertexCount(); ++v) {
    if (!referenced[v]) continue;
    representative[v] = sameBits.insert(soup.bits(v), v);
    if (representative[v] == v) distinct.push_back(v);
  }
  if (tolerance == 0) return representative;

  TriangleMesh points;
  for (uint32_t v : distinct) points.positions.push_back(soup.position(v));
  const double distance = tolerance / 100 * bounds(points).diagonal();
  const auto united = uniteCloseVertices(points.positions, distance, job);
  std::vector<uint32_t> moved(soup.vertexCount());
  for (size_t i = 0; i < distinct.size(); ++i) moved[distinct[i]] = distinct[united[i]];
  for (uint32_t v = 0; v < soup.vertexCount(); ++v)
    if (referenced[v]) representative[v] = moved[representative[v]];
  return representative;
}

bool isDegenerate(const Triangle& face) {
  return face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
}

// Collects the faces that remain, in source order, with representatives as their vertices.
void collectFaces(const Soup& soup, const std::vector<uint32_t>& representative, bool keepDuplicates,
                  WeldResult& result) {
  FirstOccurrence sameVertices(soup.faceCount());
  for (uint32_t t = 0; t < soup.faceCount(); ++t) {
    Triangle face;
    for (int c = 0; c < 3; ++c) face[c] = representative[soup.indices[3 * t + c]];
    if (isDegenerate(face)) {
      ++result.degenerateFaces;
      continue;
    }
    Triangle sorted = face;
    std::ranges::sort(sorted);
    const bool duplicate = sameVertices.insert(sorted, t) != t;
    result.duplicateFaces += duplicate;
    if (duplicate && !keepDuplicates) continue;
    result.mesh.triangles.push_back(face);
    result.sourceOfTriangle.push_back(t);
  }
}

// Numbers the vertices that the remaining faces use, in the order of their representatives.
void numberVertices(const Soup& soup, const std::vector<uint8_t>& referenced,
                    const std::vector<uint32_t>& representative, WeldResult& result) {
  std::vector<uint8_t> needed(soup.vertexCount(), 0);
  for (const Triangle& face : result.mesh.triangles)
    for (uint32_t v : face) needed[v] = 1;
  result.vertexOfSource.assign(soup.vertexCount(), kNone);
  for (uint32_t v = 0; v < soup.vertexCount(); ++v) {
    if (!referenced[v]) continue;
    result.weldedVertices += representative[v] != v;
    if (needed[v]) {
      result.vertexOfSource[v] = result.mesh.vertexCount();
      result.mesh.positions.push_back(soup.position(v));
    }
    result.vertexOfSource[v] = result.vertexOfSource[representative[v]];
  }
  for (Triangle& face : result.mesh.triangles)
    for (uint32_t& v : face) v = result.vertexOfSource[v];
}

void agreeOnWinding(WeldResult& result) {
  const Orientation orientation = orient(result.mesh, buildIncidence(result.mesh));
  result.flippedFaces = orientation.flippedCount;
  for (uint32_t t = 0; t < result.mesh.triangleCount(); ++t)
    if (orientation.flipped[t]) std::swap(result.mesh.triangles[t][1], result.mesh.triangles[t][2]);
}

}  // namespace

WeldResult weld(std::span<const float> positions, std::span<const uint32_t> indices,
                const WeldOptions& options, Job& job) {
  job.begin(Phase::Weld);
  checkOptions(options);
  const Soup soup{positions, indices};
  const auto referenced = checkFaces(soup);
  const auto representative = findRepresentatives(soup, referenced, options.tolerance, job);
  job.report(0.4);
  WeldResult result;
  collectFaces(soup, representative, options.keepDuplicates, result);
  job.report(0.6);
  numberVertices(soup, referenced, representative, result);
  job.report(0.7);
  agreeOnWinding(result);
  job.report(1);
  return result;
}

}  // namespace limber
