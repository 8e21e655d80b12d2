#pragma once

#include <cstdint>
#include <vector>

#include "simulate/colouring.h"
#include "simulate/gather.h"
#include "simulate/particles.h"
#include "simulate/sheet.h"

namespace limber {

// The hinge of an edge from `start` to `end` between the triangle (apex, start, end) and the adjacent one,
// whose third vertex is `flap`; kNone if there is no adjacent triangle, in which case the hinge has no
// effect.
struct RestHinge {
  uint32_t apex, start, end, flap;
  double stiffness;  // N m, >= 0
};

// Bending by hinges: 1/2 k (theta - theta0)^2 on the dihedral angle theta of each interior edge, relative to
// its angle at rest, within (-pi, pi) (Grinspun et al. 2003; Bergou et al. 2006 compare the choices of k).
// Most engines bend this way; elastic/solvers/solver_model.h has their choices of k.
class HingeConstraints {
 public:
  // Rest angles are those of `mesh`, in metres. `particles.motion` must not be reallocated afterwards.
  HingeConstraints(std::vector<RestHinge> hinges, const TriangleMesh& mesh, Particles& particles,
                   const ConstraintOptions& options);

  uint32_t count() const { return static_cast<uint32_t>(hinges_.size()); }
  const Colouring& colouring() const { return colouring_; }
  // Copies the positions at the start of a step, for batches [begin, end).
  void rebase(const Particles& particles, size_t begin, size_t end);
  // One XPBD pass over batches [begin, end).
  void project(size_t begin, size_t end) const;
  // Joules.
  double energy(const std::vector<Vec3>& positions) const;

 private:
  struct Batch {
    Vec3x4 baseStart, baseEnd, baseFlap;  // from the apex, at the start of the step
    Float4 restCosine, restSine;
    Float4 inert;                                           // stiffness times substep^2, kg m2
    Float4 apexWeight, startWeight, endWeight, flapWeight;  // 1/kg; 0 in an empty lane
    MotionLanes apex, start, end, flap;
  };
  struct RestAngle {
    double cosine = 1, sine = 0;
  };
  void setHinge(Batch& batch, const Lane& lane, Particles& particles, double substep);

  std::vector<Batch> batches_;
  std::vector<RestHinge> hinges_;
  std::vector<RestAngle> rest_;  // by hinge
  Colouring colouring_;
};

}  // namespace limber
