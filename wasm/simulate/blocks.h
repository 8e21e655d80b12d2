#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/topology.h"

namespace limber {

// A body cut into slices, called blocks, for threads. Constraints whose vertices all lie in one block form
// the group of that block; constraints that cross from one block to another form the group of a border. Two
// blocks share no vertex, and the constraints of two borders share none either. So all blocks can be solved
// at the same time, and then all borders, each in its own order, with the same result on any number of
// threads.
struct Blocks {
  std::vector<uint32_t> start;     // vertices of block b: [start[b], start[b + 1])
  std::vector<uint32_t> blockOf;   // by vertex
  std::vector<uint32_t> borderOf;  // by vertex; kNone where no stencil across a border has the vertex
  uint32_t borderCount = 0;

  uint32_t count() const { return static_cast<uint32_t>(start.size()) - 1; }
  uint32_t groupCount() const { return count() + borderCount; }  // blocks, then borders
  // The group of a constraint on these vertices, which belong to one triangle and its neighbours across
  // edges. Entries of kNone are skipped; the first entry must be a vertex.
  uint32_t groupOf(std::span<const uint32_t> vertices) const;
};

// The vertices in breadth-first order from one end of each component to the other, order[slot] = vertex.
// Slices of this order have short borders, whatever the shape of the body and the order of the mesh.
std::vector<uint32_t> orderFromEndToEnd(const TriangleMesh& mesh, const Topology& topology);

// Cuts the vertices in the order of their indices into `count` blocks of equal size. `flaps` is that of
// flapsOf.
Blocks blocksOf(const TriangleMesh& mesh, std::span<const uint32_t> flaps, uint32_t count);

}  // namespace limber
