#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "simulate/particles.h"

namespace limber {

// Keeps the sheets of a body apart: vertices that come closer than the mean edge's length, or than they are
// at rest where that is less, push each other away. Good for cloth of even triangles; a coarse or uneven mesh
// can slip through itself, and so can what moves by more than an edge in a step.
class SelfContacts {
 public:
  // `mesh` at rest, in metres.
  SelfContacts(const TriangleMesh& mesh, double friction);

  // Finds the pairs that may touch within the step.
  void rebase(const Particles& particles, int substeps);
  void project(Particles& particles) const;
  size_t count() const { return pairs_.size(); }

 private:
  struct Pair {
    uint32_t a, b;
    Float4 base;  // x_a - x_b at the start of the step
    float distance;
    float shareA, shareB;  // w / (w_a + w_b)
  };
  struct Cell {
    uint64_t key;
    uint32_t vertex;
  };
  void addPair(const Particles& particles, uint32_t a, uint32_t b, double reach);

  std::vector<Vec3> rest_;
  double distance_ = 0;
  float friction_;
  std::vector<Pair> pairs_;
  std::vector<Cell> cells_;
};

}  // namespace limber
