#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "simulate/colouring.h"
#include "simulate/gather.h"
#include "simulate/particles.h"
#include "simulate/solid/lattice_body.h"

namespace limber {

// The elasticity of the cells of a lattice.
//
// The mean deformation gradient F over the filled part of a cell, of volume V, has the stable neo-Hookean
// energy of Macklin and Mueller 2021, V (mu / 2 |F|^2 + lambda / 2 (det F - 1 - mu / lambda)^2): a deviatoric
// constraint |F| of compliance 1 / (mu V) and a hydrostatic one det F - 1 - mu / lambda of compliance
// 1 / (lambda V). With lambda = lambda_Lame + mu it is Hooke's law at rest (Smith, de Goes and Kim 2018).
// Deviation: both constraints are solved together, so that a body at rest stays exactly at rest, and with an
// upper bound on the Hessian of all of F instead of its projection onto the two gradients, so that shear is
// implicit too and stiff bodies do not oscillate.
//
// The four hourglass amplitudes q_i of the cell (lattice_body.h) have the energy 1/2 q^T H q in axes that
// rotate with F: the Gram-Schmidt basis of its columns. H is the stiffness of the element of the solid modes
// without that of its mean strain, so at rest the stiffness of both is the same. All twelve components are
// solved together.
//
// Linear and angular momentum are conserved.
class CellConstraints {
 public:
  struct Options {
    double young, poisson;  // Pa
    const Blocks& blocks;
    double substep;  // seconds
    uint32_t order;  // see `colour`
  };

  // `particles.motion` must not be reallocated afterwards.
  CellConstraints(const LatticeBody& body, Particles& particles, const Options& options);

  uint32_t count() const { return static_cast<uint32_t>(cells_.size()); }
  const Colouring& colouring() const { return colouring_; }
  // Copies the positions at the start of a step, for batches [begin, end).
  void rebase(const Particles& particles, size_t begin, size_t end);
  // One XPBD pass over batches [begin, end).
  void project(size_t begin, size_t end) const;
  // Joules, 0 at rest.
  double energy(const std::vector<Vec3>& positions) const;

 private:
  // Entries of a symmetric matrix of size 12, row by row up to the diagonal.
  static constexpr int kPacked = 12 * 13 / 2;

  struct Batch {
    Vec3x4 base[8];      // amplitudes by mask at the start of the step; mask 0 is not used
    Float4 moments[6];   // CellRest::moments
    Float4 scale[3];     // 1 / (4 size): F = scale (linear amplitudes + moments of the others)
    Float4 mobility[6];  // xx, yy, zz, yz, zx, xy of sum w_k grad_k grad_k^T over the corners, times `share`
    Float4 share;        // of -(mu V substep^2)^-1 times the stress that is applied, see makeStrain
    Float4 response[kPacked];  // multipliers of the hourglass amplitudes in the rotated axes, per amplitude
    Float4 weight[8];          // w of the corners, 1/kg; 0 in an empty lane
    MotionLanes corner[8];
  };
  void setCell(Batch& batch, const Lane& lane, const LatticeBody& body, Particles& particles);
  void projectBatch(const Batch& batch) const;

  std::vector<Batch> batches_;
  std::vector<std::array<uint32_t, 8>> cells_;
  std::vector<CellRest> rest_;
  double mu_, lambda_;  // Pa
  double substep_;      // seconds
  Colouring colouring_;
};

}  // namespace limber
