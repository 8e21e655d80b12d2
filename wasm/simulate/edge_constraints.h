#pragma once

#include <cstdint>
#include <vector>

#include "mesh/topology.h"
#include "simulate/colouring.h"
#include "simulate/particles.h"
#include "simulate/sheet.h"

namespace limber {

// Distance constraints along the edges, C = |x_a - x_b| - rest, as the paper uses them (section 4). The
// spring of an edge has the stiffness E h (area of its triangles) / rest^2: the one that a triangle mesh of
// springs needs to carry the energy of a sheet (Van Gelder 1998). It holds on equilateral meshes; on others
// springs are another material whatever their rule.
class EdgeConstraints {
 public:
  // Rest lengths are those of `mesh`, in metres.
  EdgeConstraints(const TriangleMesh& mesh, const Topology& topology, const Particles& particles,
                  const ConstraintOptions& options);

  uint32_t count() const { return count_; }
  const Colouring& colouring() const { return colouring_; }

  // Takes over the positions at the start of a step, for batches [begin, end).
  void rebase(const Particles& particles, size_t begin, size_t end);
  // One XPBD pass (Macklin et al. 2016, Eqs. 17 and 18, with lambda = 0 as each substep starts).
  void project(Particles& particles, size_t begin, size_t end) const;
  // Joules.
  double energy(const std::vector<Vec3>& positions) const;

 private:
  struct Batch {
    Float4 base[4];         // x_a - x_b at the start of the step
    Float4 rest;            // length
    Float4 shareA, shareB;  // of the correction that each end takes: w / (w_a + w_b + compliance / substep^2)
    uint32_t a[4], b[4];    // vertices
  };
  std::vector<Batch> batches_;
  std::vector<double> stiffness_;  // N/m, [4 * batch + lane]
  std::vector<double> rest_;
  Colouring colouring_;
  uint32_t count_ = 0;
};

}  // namespace limber
