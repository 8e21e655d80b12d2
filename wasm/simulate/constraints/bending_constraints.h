#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/topology.h"
#include "simulate/colouring.h"
#include "simulate/gather.h"
#include "simulate/particles.h"
#include "simulate/sheet.h"

namespace limber {

// Bending by the Morley element of the modal analysis (Morley 1968), extended to large motion. Its curvature
// is constant in a triangle, kappa = sum_e (l_e / A) s_e m_e m_e^T, with the energy A D / 2 ((1 - nu) kappa :
// kappa + nu tr^2 kappa). Here s_e is the rotation of the surface from the plane of the triangle to the
// middle of edge e.
//
// If s_e were just half the fold, as in hinge elements (Grinspun et al. 2003), frequencies of a plate would
// depend on the mesh and be up to 44 % off. Every edge between two triangles therefore has its own rotation
// psi, and s_e = tan((theta_e - rest) / 2) +- psi_e, with + in one triangle and - in the other. psi is
// measured relative to the mean of both planes, so rigid motions do not change it. Its inertia is
// kRotationInertia (0.05) times the mass of both triangles times their height squared: small enough to affect
// only waves of the size of the mesh elements.
//
// On a border s_e is free (no moment acts there), which removes it from the compliance. A triangle whose
// three corners are pinned is rigid: its edges stay in its plane, so the adjacent triangle takes the whole
// fold.
class BendingConstraints {
 public:
  // Rest shapes are those of `mesh`, in metres. `particles.motion` must not be reallocated afterwards.
  BendingConstraints(const TriangleMesh& mesh, const Topology& topology, Particles& particles,
                     const ConstraintOptions& options);
  BendingConstraints(const BendingConstraints&) = delete;  // batches contain pointers to the rotations

  uint32_t count() const { return static_cast<uint32_t>(rest_.size()); }
  size_t edgeCount() const { return exactPsi_.size(); }
  const Colouring& colouring() const { return colouring_; }
  // Copies the positions at the start of a step, for batches [begin, end).
  void rebase(const Particles& particles, size_t begin, size_t end);
  // Advances the rotations of edges [begin, end) by their rates, as `advance` moves vertices.
  void advanceRotations(size_t begin, size_t end, const Advance& what, float damping);
  // One XPBD pass over batches [begin, end); s_0, s_1 and s_2 of a triangle are solved together.
  void project(size_t begin, size_t end) const;
  // Joules; only valid between steps.
  double energy(const std::vector<Vec3>& positions) const;
  bool isFinite() const;

 private:
  // Edge e of a triangle lies opposite to corner e and runs from corner e + 1 to corner e + 2. Its flap is
  // the third vertex of the triangle on the other side:
  //
  //            corner e
  //            /      \               .
  //   corner e+1 ---- corner e+2
  //            \      /
  //             flap e
  struct EdgeRotation {
    float psi = 0, rate = 0;  // rad: psi at the start of the substep, and its change in the substep
  };
  struct Batch {
    Vec3x4 base1, base2, baseFlap[3];   // from corner 0, at the start of the step
    Float4 restCosine[3], restSine[3];  // of the fold at rest
    Float4 share[3];          // of the fold, in halves: 1; 0 on a border; 2 next to a rigid triangle
    Symmetric3x4 compliance;  // of (s_0, s_1, s_2), divided by substep^2
    Float4 weight[3], flapWeight[3], rotationWeight[3];  // 1/kg, 1/kg, 1/(kg m2)
    Float4 sharedFlap[3];  // [e]: w of flap e if flap (e + 1) % 3 is the same vertex; otherwise 0
    Float4 side[3];        // the sign of psi in this triangle, +1 or -1
    MotionLanes corner[3], flap[3];
    EdgeRotation* edge[3][4];
  };
  // A triangle at rest, in double.
  struct Rest {
    Triangle corner;
    std::array<uint32_t, 3> flap;  // kNone on a border
    std::array<uint32_t, 3> edge;
    std::array<double, 3> cosine, sine, side;
    std::array<double, 3> share;      // as in Batch
    std::array<double, 6> stiffness;  // of (s_0, s_1, s_2), entries 00 01 02 11 12 22; 0 on borders
  };
  struct Hinges;
  static Hinges hingesOf(const Batch& batch);
  static Symmetric3x4 systemOf(const Batch& batch, const Hinges& hinges);
  static void apply(const Batch& batch, const Hinges& hinges, const Float4 (&lambda)[3]);
  void setHinge(Rest& rest, uint32_t e, const TriangleMesh& mesh, const Particles& particles);
  void setTriangle(Batch& batch, const Lane& lane, Particles& particles, double substep);
  void setEdge(Batch& batch, const Lane& lane, uint32_t e, Particles& particles);
  void setCompliance(Batch& batch, const Lane& lane, double substep) const;
  const Rest& restOf(const Lane& lane) const;

  std::vector<Batch> batches_;
  std::vector<Rest> rest_;                         // of all triangles that are not rigid
  std::vector<std::array<double, 6>> compliance_;  // per triangle, entries 00 01 02 11 12 22
  std::vector<EdgeRotation> rotations_;            // per edge, then one per group for empty lanes
  std::vector<double> exactPsi_;
  std::vector<double> rotationWeight_;
  Colouring colouring_;
};

}  // namespace limber
