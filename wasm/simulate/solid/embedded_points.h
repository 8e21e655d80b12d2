#pragma once

#include <Eigen/SparseCholesky>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "simulate/constraints/point_constraints.h"
#include "simulate/particles.h"
#include "simulate/solid/lattice_body.h"

namespace limber {

// A point that moves with the nodes of a lattice: the sum of weights[i] times the position of nodes[i]. The
// weights sum to 1.
struct LatticePoint {
  std::vector<uint32_t> nodes;
  std::vector<double> weights;

  // Metres, between steps.
  Vec3 position(const Particles& particles) const;
  // Its motion in a substep, metres.
  Vec3 motion(const Particles& particles) const;
};

LatticePoint embeddedVertex(const LatticeBody& body, uint32_t v);
// The point of a triangle with these barycentric coordinates, interpolated between its embedded corners, as
// it is drawn.
LatticePoint embeddedPoint(const LatticeBody& body, const Triangle& triangle, const double (&barycentric)[3]);

// Embedded points that are pinned to a target, which moves uniformly during the step. All targets are met at
// once: the nodes move with the least sum of mass times squared displacement that meets them, or comes
// closest. If pins were solved one after the other, a plane of pins would give way under the weight that
// hangs on it.
class EmbeddedPins {
 public:
  // Replaces all points.
  void set(const Particles& particles, std::vector<LatticePoint> points);
  void clear() { pins_.clear(); }
  size_t count() const { return pins_.size(); }
  Vec3 position(size_t i, const Particles& particles) const { return pins_[i].point.position(particles); }

  // Sets how the target of pin i moves within the step, in metres.
  void rebase(size_t i, const Particles& particles, const PointConstraints::Path& path, int substeps);
  // Moves the nodes onto the targets. `substep` counts from 0 within the step.
  void project(Particles& particles, int substep);

 private:
  struct Pin {
    LatticePoint point;
    std::vector<uint32_t> rows;  // per node of the point: its index in nodes_
    Vec3 gap, targetMove;  // metres: point - target at the start of the step, and the motion of the target
  };

  std::vector<Pin> pins_;
  std::vector<uint32_t> nodes_;  // nodes that pins move
  // Of W^T W + epsilon M over nodes_, with the weights W of the pins and the masses M.
  std::unique_ptr<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>> factor_;
  Eigen::MatrixXd way_;  // per node of nodes_, metres
};

}  // namespace limber
