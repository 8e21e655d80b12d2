#include "simulate/blocks.h"

#include <algorithm>
#include <array>

#include "base/disjoint_sets.h"

namespace limber {

namespace {

// Appends the component of a vertex to an order, breadth first from that vertex. A component can be passed
// over a second time, from another vertex.
class BreadthFirst {
 public:
  BreadthFirst(const TriangleMesh& mesh, const Topology& topology)
      : mesh_(mesh), topology_(topology), pass_(mesh.vertexCount(), 0) {}

  void append(uint32_t first, std::vector<uint32_t>& order) {
    const uint32_t pass = pass_[first] + 1;
    pass_[first] = pass;
    order.push_back(first);
    for (size_t next = order.size() - 1; next < order.size(); ++next)
      for (const uint32_t t : topology_.trianglesAround(order[next]))
        for (const uint32_t v : mesh_.triangles[t]) {
          if (pass_[v] == pass) continue;
          pass_[v] = pass;
          order.push_back(v);
        }
  }
  bool isNew(uint32_t v) const { return pass_[v] == 0; }

 private:
  const TriangleMesh& mesh_;
  const Topology& topology_;
  std::vector<uint32_t> pass_;
};

using Stencil = std::array<uint32_t, 6>;

Stencil stencilOf(const TriangleMesh& mesh, std::span<const uint32_t> flaps, uint32_t t) {
  const Triangle& corner = mesh.triangles[t];
  const auto flap = flaps.subspan(3 * size_t{t}, 3);
  return {corner[0], corner[1], corner[2], flap[0], flap[1], flap[2]};
}

}  // namespace

uint32_t Blocks::groupOf(std::span<const uint32_t> vertices) const {
  const uint32_t block = blockOf[vertices[0]];
  const bool isInner = std::all_of(vertices.begin(), vertices.end(),
                                   [&](uint32_t v) { return v == kNone || blockOf[v] == block; });
  return isInner ? block : count() + borderOf[vertices[0]];
}

std::vector<uint32_t> orderFromEndToEnd(const TriangleMesh& mesh, const Topology& topology) {
  BreadthFirst search(mesh, topology);
  std::vector<uint32_t> order;
  order.reserve(mesh.vertexCount());
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    if (!search.isNew(v)) continue;
    const size_t component = order.size();
    search.append(v, order);
    const uint32_t end = order.back();
    order.resize(component);
    search.append(end, order);
  }
  return order;
}

Blocks blocksOf(const TriangleMesh& mesh, std::span<const uint32_t> flaps, uint32_t count) {
  const uint32_t vertexCount = mesh.vertexCount();
  Blocks blocks;
  blocks.blockOf.resize(vertexCount);
  for (uint32_t b = 0; b <= count; ++b)
    blocks.start.push_back(static_cast<uint32_t>(uint64_t{vertexCount} * b / count));
  for (uint32_t b = 0; b < count; ++b)
    std::fill(blocks.blockOf.begin() + blocks.start[b], blocks.blockOf.begin() + blocks.start[b + 1], b);
  blocks.borderOf.assign(vertexCount, kNone);
  DisjointSets sets(vertexCount);
  std::vector<uint32_t> crossing;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const Stencil stencil = stencilOf(mesh, flaps, t);
    const auto crosses = [&](uint32_t v) {
      return v != kNone && blocks.blockOf[v] != blocks.blockOf[stencil[0]];
    };
    if (std::none_of(stencil.begin(), stencil.end(), crosses)) continue;
    crossing.push_back(t);
    for (const uint32_t v : stencil)
      if (v != kNone) sets.unite(stencil[0], v);
  }
  for (const uint32_t t : crossing)
    for (const uint32_t v : stencilOf(mesh, flaps, t)) {
      if (v == kNone || blocks.borderOf[v] != kNone) continue;
      uint32_t& border = blocks.borderOf[sets.rootOf(v)];
      if (border == kNone) border = blocks.borderCount++;
      blocks.borderOf[v] = border;
    }
  return blocks;
}

}  // namespace limber
