#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "simulate/particles.h"

namespace limber {

// Keeps the parts of a body apart that do not lie side by side. Two vertices that are more than two edges
// away from each other push each other away when they come closer than the mean edge length, or than they are
// at rest where that is less. This suits cloth of
// even triangles. A coarse or uneven mesh can slip through itself, and so can a part that moves by more than
// an edge in a step.
class SelfContacts {
 public:
  // `mesh` at rest, in metres.
  SelfContacts(const TriangleMesh& mesh, double friction);

  // Finds the pairs of vertices that may touch within the step.
  void rebase(const Particles& particles, int substeps);
  // One pass over all pairs, in order.
  void project(Particles& particles) const;
  size_t count() const { return pairs_.size(); }

 private:
  struct Pair {
    uint32_t a, b;
    Float4 base;           // x_a - x_b at the start of the step
    float distance;        // metres, that they are kept apart
    float shareA, shareB;  // w / (w_a + w_b)
  };
  // A vertex in the grid that pairs are found with.
  struct Cell {
    uint64_t key;
    uint32_t vertex;
  };
  void addPair(const Particles& particles, uint32_t a, uint32_t b, double searchDistance);

  // Whether at most two edges lie between them.
  bool areNear(uint32_t a, uint32_t b) const;

  // A vertex and those one edge away from it, ascending.
  std::span<const uint32_t> ringAt(uint32_t v) const {
    return {rings_.begin() + ringStart_[v], rings_.begin() + ringStart_[v + 1]};
  }

  std::vector<Vec3> rest_;
  std::vector<uint32_t> rings_, ringStart_;
  double distance_ = 0;
  float friction_;
  std::vector<Pair> pairs_;
  std::vector<Cell> cells_;
};

}  // namespace limber
