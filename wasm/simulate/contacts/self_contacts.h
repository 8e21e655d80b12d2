#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "simulate/particles.h"

namespace limber {

// Keeps the parts of a body apart that do not lie side by side. Each vertex is the middle of a ball as wide
// as the edges around it are long, on average, and at most three times as wide as the second shortest of them
// is long, so that the ends of needles touch as many others as their spacing lets them. Two vertices that are
// more than two edges away from each other push each other away when their balls meet, or when they come
// closer than at rest where that is less. This suits cloth of even triangles. A coarse mesh, or a fine part
// of an uneven one, can slip through, and so can a part that moves by more than an edge in a step.
//
// A vertex without an edge of any length touches nothing.
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
  // A vertex in a grid that pairs are found with.
  struct Cell {
    uint64_t key;
    uint32_t vertex;
  };
  // The vertices whose balls have nearly the same width, in a grid of cells for balls of that width.
  struct Level {
    double widest = 0;  // metres
    std::vector<Cell> cells;
  };
  // Where to look for pairs in one step.
  struct Search {
    Vec3 low;       // of all vertices
    double travel;  // the furthest that a vertex goes, metres
  };
  void findLevels();
  Search searchOf(const Particles& particles, int substeps) const;
  void findPairs(const Particles& particles, const Search& search, const Level& finer, const Level& coarser);
  void addPair(const Particles& particles, uint32_t a, uint32_t b, double travel);

  // Whether at most two edges lie between them.
  bool areNear(uint32_t a, uint32_t b) const;

  // A vertex and those one edge away from it, ascending.
  std::span<const uint32_t> ringAt(uint32_t v) const {
    return {rings_.begin() + ringStart_[v], rings_.begin() + ringStart_[v + 1]};
  }

  std::vector<Vec3> rest_;
  std::vector<uint32_t> rings_, ringStart_;
  std::vector<double> width_;  // of each vertex's ball, metres
  float friction_;
  std::vector<Level> levels_;  // from fine to coarse
  std::vector<Pair> pairs_;    // by vertex a, then by b
};

}  // namespace limber
