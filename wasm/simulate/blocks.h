#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace limber {

// The vertices of constraints: constraint i has those from vertices[stride i] to vertices[stride (i + 1) -
// 1]. Entries of kNone are skipped; the first one of each constraint must be a vertex.
struct Stencils {
  std::span<const uint32_t> vertices;
  uint32_t stride;

  uint32_t count() const { return static_cast<uint32_t>(vertices.size() / stride); }
  std::span<const uint32_t> of(uint32_t i) const { return vertices.subspan(size_t{i} * stride, stride); }
};

// The vertices of stencils one after the other, in the layout of Stencils.
template <size_t N>
std::vector<uint32_t> flattened(const std::vector<std::array<uint32_t, N>>& stencils) {
  std::vector<uint32_t> vertices;
  vertices.reserve(N * stencils.size());
  for (const auto& own : stencils) vertices.insert(vertices.end(), own.begin(), own.end());
  return vertices;
}

// A body cut into slices, called blocks, for threads. Constraints whose vertices all lie in one block form
// the group of that block; constraints that cross from one block to another form the group of a border. Two
// blocks share no vertex, and the constraints of two borders share none either. All blocks can therefore be
// solved in parallel, and then all borders, each sequentially in its own order, with the same result on any
// number of threads.
struct Blocks {
  std::vector<uint32_t> start;     // vertices of block b: [start[b], start[b + 1])
  std::vector<uint32_t> blockOf;   // by vertex
  std::vector<uint32_t> borderOf;  // by vertex; kNone if no stencil across a border has the vertex
  uint32_t borderCount = 0;

  uint32_t count() const { return static_cast<uint32_t>(start.size()) - 1; }
  uint32_t groupCount() const { return count() + borderCount; }  // blocks, then borders
  // The group of a constraint on these vertices, which belong to one of the stencils that the blocks were
  // made for. Entries of kNone are skipped; the first entry must be a vertex.
  uint32_t groupOf(std::span<const uint32_t> vertices) const;
};

// The vertices in breadth-first order from one end of each connected part to the other, order[slot] = vertex;
// vertices are connected if they share a stencil. Slices of this order have short borders for any shape of
// the body and any order of its vertices. No entry is kNone.
std::vector<uint32_t> orderFromEndToEnd(const Stencils& stencils, uint32_t vertexCount);

// Bodies with fewer vertices than `least` are one block; others are cut into blocks of about `size` vertices.
struct BlockSizes {
  uint32_t least, size;
};
// The number of blocks of a body with this many vertices, at most 32.
uint32_t blockCountOf(uint32_t vertexCount, const BlockSizes& sizes);

// Cuts the vertices in the order of their indices into `count` blocks of equal size.
Blocks blocksOf(const Stencils& stencils, uint32_t vertexCount, uint32_t count);

// The same for the vertices of a mesh. A stencil is that of a triangle with its neighbours across edges;
// `flaps` is that of flapsOf.
Blocks blocksOf(const TriangleMesh& mesh, std::span<const uint32_t> flaps, uint32_t count);

}  // namespace limber
