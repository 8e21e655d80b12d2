#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "simulate/colouring.h"
#include "simulate/gather.h"
#include "simulate/particles.h"
#include "simulate/sheet.h"

namespace limber {

// One constraint of three components per triangle: its Green-Lagrange strain (E_xx, E_yy, 2 E_xy) is 0. The
// compliance is that of plane stress, so the energy is that of a St. Venant-Kirchhoff sheet, A h / 2 E : C :
// E, on any mesh. The three components are solved together.
class MembraneConstraints {
 public:
  // Rest shapes are those of `mesh`, in metres; `factors` are by triangle. `particles.motion` must not be
  // reallocated afterwards.
  MembraneConstraints(const TriangleMesh& mesh, StiffnessFactors factors, Particles& particles,
                      const ConstraintOptions& options);

  uint32_t count() const { return count_; }
  const Colouring& colouring() const { return colouring_; }
  // Copies the positions at the start of a step, for batches [begin, end).
  void rebase(const Particles& particles, size_t begin, size_t end);
  // One XPBD pass over batches [begin, end).
  void project(size_t begin, size_t end) const;
  // Joules.
  double energy(const std::vector<Vec3>& positions) const;

 private:
  struct Batch {
    Vec3x4 base1, base2;  // edges from corner 0 to corners 1 and 2 at the start of the step
    Float4 xx, xy, yy;    // (xx xy; 0 yy) is the inverse of (x1 x2; 0 y2), whose columns are the rest edges
    Float4 mass11, mass12, mass22;  // sum over the corners of w grad_i grad_j
    Float4 compliance;              // 1 / (factor area E h substep^2)
    Float4 weight[3];               // w of the corners, 1/kg; 0 in an empty lane
    MotionLanes corner[3];
  };
  void setTriangle(Batch& batch, const Lane& lane, Particles& particles, double substep);

  std::vector<Batch> batches_;
  std::vector<Triangle> triangles_;
  struct Rest {
    double area, xx, xy, yy;
    double factor;  // on the stiffness
  };
  std::vector<Rest> rest_;  // by triangle
  Sheet sheet_;
  Colouring colouring_;
  uint32_t count_ = 0;
};

}  // namespace limber
