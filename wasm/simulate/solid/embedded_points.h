#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "simulate/constraints/point_constraints.h"
#include "simulate/particles.h"
#include "simulate/solid/lattice_body.h"

namespace limber {

// A point that moves with the nodes of a lattice: the sum of weights[i] times the position of nodes[i]. The
// weights sum to 1.
struct EmbeddedPoint {
  std::vector<uint32_t> nodes;
  std::vector<double> weights;

  // Metres, between steps.
  Vec3 position(const Particles& particles) const;
  // How far it moves in a substep, metres.
  Vec3 motion(const Particles& particles) const;
};

EmbeddedPoint embeddedVertex(const LatticeBody& body, uint32_t v);
// The point of a triangle with these barycentric coordinates, as it is drawn: between the triangle's corners.
EmbeddedPoint embeddedPoint(const LatticeBody& body, const Triangle& triangle,
                            const double (&barycentric)[3]);

// Embedded points that are pinned to a target, which moves evenly through the step. Hard constraints: they
// have no compliance. Several of them on the same nodes are solved one after the other, so a target that the
// lattice cannot follow exactly is met on average.
class EmbeddedPins {
 public:
  void add(const Particles& particles, EmbeddedPoint point);
  void clear() { pins_.clear(); }
  size_t count() const { return pins_.size(); }
  Vec3 position(size_t i, const Particles& particles) const { return pins_[i].point.position(particles); }

  // Sets how the target of pin i moves within the step, in metres.
  void rebase(size_t i, const Particles& particles, const PointConstraints::Path& path, int substeps);
  // One pass over all pins, forwards and backwards in turn. `substep` counts from 0 within the step.
  void project(Particles& particles, int substep) const;

 private:
  struct Pin {
    EmbeddedPoint point;
    std::vector<std::pair<float, float>> shares;  // per node: its weight, and w weight / sum w weight^2
    Float4 gap{};                                 // point - target at the start of the step
    Float4 targetMove{};                          // of the target per substep
  };
  static void projectPin(const Pin& pin, Particles& particles, Float4 done);

  std::vector<Pin> pins_;
};

}  // namespace limber
