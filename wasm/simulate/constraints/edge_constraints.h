#pragma once

#include <cstdint>
#include <vector>

#include "mesh/topology.h"
#include "simulate/colouring.h"
#include "simulate/particles.h"
#include "simulate/sheet.h"

namespace limber {

// 1/2 stiffness (|x_a - x_b| - rest)^2
struct Spring {
  uint32_t a, b;
  double rest, stiffness;  // m, N/m
};

// The springs of the paper: one on every edge, with the stiffness E h (area of its triangles) / rest^2, for
// which the springs of a triangle mesh have the energy of a sheet (Van Gelder 1998). That is exact for
// equilateral meshes; on other meshes, springs of any stiffness behave as a different material. `mesh` is in
// metres.
std::vector<Spring> paperSprings(const TriangleMesh& mesh, const Topology& topology, const Sheet& sheet);

// Distance constraints, C = |x_a - x_b| - rest: along edges, as in the paper (section 4), or across them.
class EdgeConstraints {
 public:
  // The ends of each spring belong to one triangle and its neighbours across edges. `particles.motion` must
  // not be reallocated afterwards.
  EdgeConstraints(std::vector<Spring> springs, Particles& particles, const ConstraintOptions& options);

  uint32_t count() const { return static_cast<uint32_t>(springs_.size()); }
  const Colouring& colouring() const { return colouring_; }

  // Copies the positions at the start of a step, for batches [begin, end).
  void rebase(const Particles& particles, size_t begin, size_t end);
  // One XPBD pass (Macklin et al. 2016, Eqs. 17 and 18) with lambda = 0 at the start of each substep (Macklin
  // et al. 2019).
  void project(size_t begin, size_t end) const;
  // Joules.
  double energy(const std::vector<Vec3>& positions) const;

 private:
  struct Batch {
    Float4 base[4];    // x_a - x_b at the start of the step
    Float4 share;      // of the correction that a takes: w_a / (w_a + w_b + compliance / substep^2)
    Float4 restShare;  // the rest length times `share`
    Float4 ratio;      // w_b / w_a, at most 1
    // The two ends, as pointers rather than indices: see gather.h.
    Motion *a[4], *b[4];
  };
  void setSpring(Batch& batch, const Lane& lane, Particles& particles, double substep);

  std::vector<Batch> batches_;
  std::vector<Spring> springs_;
  Colouring colouring_;
};

}  // namespace limber
