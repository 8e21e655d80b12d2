#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/topology.h"

namespace limber {

// A body cut into slices for threads. Its constraints fall into groups: one for each block, whose constraints
// reach no other block, and one for each border, whose constraints reach across it and touch no other border.
// Two blocks share no vertex, and two borders neither; so all blocks may be solved at the same time, and then
// all borders, each in its own order, with the same result.
struct Blocks {
  std::vector<uint32_t> start;     // vertices of block b: [start[b], start[b + 1])
  std::vector<uint32_t> blockOf;   // by vertex
  std::vector<uint32_t> borderOf;  // by vertex; kNone where no stencil that crosses a border comes
  uint32_t borderCount = 0;

  uint32_t count() const { return static_cast<uint32_t>(start.size()) - 1; }
  uint32_t groupCount() const { return count() + borderCount; }  // blocks, then borders
  // Of a constraint on these vertices (kNone is none), all of one triangle or its neighbours across edges.
  uint32_t groupOf(std::span<const uint32_t> vertices) const;
};

// Vertices from one end of each component to the other, [place] = vertex, breadth first: slices of this order
// have short borders, whatever the body's shape and whatever the order of the mesh.
std::vector<uint32_t> orderFromEndToEnd(const TriangleMesh& mesh, const Topology& topology);

// Cuts the vertices, as they are numbered, into `count` blocks of the same size. `flaps` as of flapsOf.
Blocks blocksOf(const TriangleMesh& mesh, std::span<const uint32_t> flaps, uint32_t count);

}  // namespace limber
