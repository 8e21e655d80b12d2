#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace limber {

// Constraints in batches of four that share no vertex, and batches in colours whose batches share none
// either: the batches of one colour may be solved at the same time, in any order, with the same result.
struct Colouring {
  using Batch = std::array<uint32_t, 4>;  // constraints; kNone in an empty lane, never in the first
  std::vector<Batch> batches;
  std::vector<uint32_t> colourStart;  // batches of colour c: [colourStart[c], colourStart[c + 1])

  uint32_t colourCount() const { return static_cast<uint32_t>(colourStart.size()) - 1; }
};

// Constraint i has the vertices vertices[i * stride .. (i + 1) * stride); kNone is none. Greedy: each
// constraint takes the first colour that none of its vertices has. `order` 0 visits the constraints as they
// come, any other number in an order of its own.
Colouring colour(std::span<const uint32_t> vertices, uint32_t stride, uint32_t vertexCount, uint32_t order);

}  // namespace limber
