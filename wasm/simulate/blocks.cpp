#include "simulate/blocks.h"

#include <algorithm>

#include "base/disjoint_sets.h"

namespace limber {

namespace {

constexpr uint32_t kMaxBlocks = 32;

// Appends the connected part of a vertex to an order, breadth first from that vertex. A part can be traversed
// a second time, from another vertex.
class BreadthFirst {
 public:
  BreadthFirst(const Stencils& stencils, uint32_t vertexCount)
      : stencils_(stencils), start_(vertexCount + 1, 0), pass_(vertexCount, 0) {
    for (const uint32_t v : stencils.vertices) ++start_[v + 1];
    for (uint32_t v = 0; v < vertexCount; ++v) start_[v + 1] += start_[v];
    around_.resize(start_.back());
    std::vector<uint32_t> next(start_.begin(), start_.end() - 1);
    for (uint32_t i = 0; i < stencils.count(); ++i)
      for (const uint32_t v : stencils.of(i)) around_[next[v]++] = i;
  }

  void append(uint32_t first, std::vector<uint32_t>& order) {
    const uint32_t pass = pass_[first] + 1;
    pass_[first] = pass;
    order.push_back(first);
    for (size_t next = order.size() - 1; next < order.size(); ++next) {
      const uint32_t v = order[next];
      for (uint32_t at = start_[v]; at < start_[v + 1]; ++at)
        for (const uint32_t other : stencils_.of(around_[at])) {
          if (pass_[other] == pass) continue;
          pass_[other] = pass;
          order.push_back(other);
        }
    }
  }
  bool isNew(uint32_t v) const { return pass_[v] == 0; }

 private:
  const Stencils& stencils_;
  std::vector<uint32_t> start_,
      around_;  // stencils around v: around_[start_[v]] to around_[start_[v + 1] - 1]
  std::vector<uint32_t> pass_;
};

}  // namespace

uint32_t Blocks::groupOf(std::span<const uint32_t> vertices) const {
  const uint32_t block = blockOf[vertices[0]];
  const bool isInner = std::all_of(vertices.begin(), vertices.end(),
                                   [&](uint32_t v) { return v == kNone || blockOf[v] == block; });
  return isInner ? block : count() + borderOf[vertices[0]];
}

std::vector<uint32_t> orderFromEndToEnd(const Stencils& stencils, uint32_t vertexCount) {
  BreadthFirst search(stencils, vertexCount);
  std::vector<uint32_t> order;
  order.reserve(vertexCount);
  for (uint32_t v = 0; v < vertexCount; ++v) {
    if (!search.isNew(v)) continue;
    const size_t part = order.size();
    search.append(v, order);
    const uint32_t end = order.back();
    order.resize(part);
    search.append(end, order);
  }
  return order;
}

uint32_t blockCountOf(uint32_t vertexCount, const BlockSizes& sizes) {
  return vertexCount < sizes.least ? 1 : std::min(vertexCount / sizes.size, kMaxBlocks);
}

Blocks blocksOf(const Stencils& stencils, uint32_t vertexCount, uint32_t count) {
  Blocks blocks;
  blocks.blockOf.resize(vertexCount);
  for (uint32_t b = 0; b <= count; ++b)
    blocks.start.push_back(static_cast<uint32_t>(uint64_t{vertexCount} * b / count));
  for (uint32_t b = 0; b < count; ++b)
    std::fill(blocks.blockOf.begin() + blocks.start[b], blocks.blockOf.begin() + blocks.start[b + 1], b);
  blocks.borderOf.assign(vertexCount, kNone);
  DisjointSets sets(vertexCount);
  std::vector<uint32_t> crossing;
  for (uint32_t i = 0; i < stencils.count(); ++i) {
    const auto own = stencils.of(i);
    const auto crosses = [&](uint32_t v) {
      return v != kNone && blocks.blockOf[v] != blocks.blockOf[own[0]];
    };
    if (std::ranges::none_of(own, crosses)) continue;
    crossing.push_back(i);
    for (const uint32_t v : own)
      if (v != kNone) sets.unite(own[0], v);
  }
  for (const uint32_t i : crossing)
    for (const uint32_t v : stencils.of(i)) {
      if (v == kNone || blocks.borderOf[v] != kNone) continue;
      uint32_t& border = blocks.borderOf[sets.rootOf(v)];
      if (border == kNone) border = blocks.borderCount++;
      blocks.borderOf[v] = border;
    }
  return blocks;
}

Blocks blocksOf(const TriangleMesh& mesh, std::span<const uint32_t> flaps, uint32_t count) {
  std::vector<uint32_t> vertices;
  vertices.reserve(6 * mesh.triangles.size());
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto across = flaps.subspan(3 * size_t{t}, 3);
    vertices.insert(vertices.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
    vertices.insert(vertices.end(), across.begin(), across.end());
  }
  return blocksOf({vertices, 6}, mesh.vertexCount(), count);
}

}  // namespace limber
