#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "simulate/particles.h"

namespace limber {

// Keeps parts of a body apart that are not neighbours on its surface. Each vertex is the centre of a ball
// whose diameter is the mean length of the edges around it, and at most three times the length of the second
// shortest of them, which limits the number of contacts at the ends of needles. Two vertices that are more
// than two edges apart repel each other when their balls meet, or, if their rest distance is less, when they
// come closer than at rest. This suits cloth of regular triangles. A coarse mesh, or a fine part of a
// nonuniform one, can slip through, and so can a part that moves by more than an edge length in a step.
//
// A vertex whose edges all have length 0 touches nothing.
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
    float distance;        // metres: their minimum distance
    float shareA, shareB;  // w / (w_a + w_b)
  };
  // A vertex in a grid for finding pairs.
  struct Cell {
    uint64_t key;
    uint32_t vertex;
  };
  // The vertices whose balls have nearly the same width, in a grid of cells for balls of that width.
  struct Level {
    double widest = 0;  // metres
    std::vector<Cell> cells;
  };
  // The search range for pairs in one step.
  struct Search {
    Vec3 low;       // of all vertices
    double travel;  // the largest motion of a vertex, metres
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
