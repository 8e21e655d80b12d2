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

// Bending of constant curvature per triangle, kappa = sum_e (l_e / A) s_e m_e m_e^T, with energy A D / 2 ((1
// - nu) kappa : kappa + nu tr^2 kappa): the Morley element of the modal analysis, made fit for large motion.
// s_e is how far the surface turns across edge e from the triangle's plane to the middle of the edge. Half
// the fold alone, as in other elements without rotations, converges to a plate that depends on the mesh (up
// to 44 % off in frequency). So every edge between two triangles has a turn psi of its own, and s_e =
// tan((theta_e - rest) / 2) +- psi_e, + in one triangle and - in the other. psi measures against the mean of
// both planes, so that rigid motions leave it alone. Its inertia, a quarter of the triangles' mass times
// their height squared, matches the vertices' own, and is felt by waves of the mesh's size alone. On a free
// border s_e is chosen by the triangle itself (no moment), which removes it from the compliance. A triangle
// that is pinned whole is rigid: its edges stay in its plane, so that the neighbour has all of the fold.
class BendingConstraints {
 public:
  // Rest shapes are those of `mesh`, in metres. The particles' motion must stay where it is.
  BendingConstraints(const TriangleMesh& mesh, const Topology& topology, Particles& particles,
                     const ConstraintOptions& options);
  BendingConstraints(const BendingConstraints&) = delete;  // batches point to the turns

  uint32_t count() const { return static_cast<uint32_t>(triangles_.size()); }
  size_t edgeCount() const { return exactPsi_.size(); }
  const Colouring& colouring() const { return colouring_; }
  void rebase(const Particles& particles, size_t begin, size_t end);
  // Moves the turns of edges [begin, end) by their rates, as `advance` does for vertices.
  void advanceTurns(size_t begin, size_t end, const Advance& what, float damping);
  void project(size_t begin, size_t end) const;
  // Joules, of the fields as they are between steps.
  double energy(const std::vector<Vec3>& positions) const;
  bool isFinite() const;

 private:
  // Edge e of a triangle is opposite to corner e, and runs from corner e + 1 to corner e + 2; its flap is the
  // third vertex of the triangle on the other side:
  //
  //            corner e
  //            /      \               .
  //   corner e+1 ---- corner e+2
  //            \      /
  //             flap e
  struct Turn {
    float psi = 0, rate = 0;  // psi before the substep; its change in the substep
  };
  struct Batch {
    Vec3x4 base1, base2, baseFlap[3];   // from corner 0, at the start of the step
    Float4 restCosine[3], restSine[3];  // of the fold
    Float4 share[3];                    // of the fold, in halves: 1, 0 on a border, 2 beside a rigid triangle
    Symmetric3x4 compliance;            // of (s_0, s_1, s_2), over substep^2
    Float4 weight[3], flapWeight[3], turnWeight[3];  // 1/kg, 1/kg, 1/(kg m2)
    Float4 sharedFlap[3];  // w of flap 0 where flap 1 is the same vertex, of 0 and 2, of 1 and 2; otherwise 0
    Float4 side[3];        // the sign of psi in this triangle
    MotionPlaces corner[3], flap[3];
    Turn* edge[3][4];
  };
  // What `energy` needs of a triangle, in double.
  struct Rest {
    std::array<uint32_t, 3> flap;  // kNone on a border
    std::array<uint32_t, 3> edge;
    std::array<double, 3> cosine, sine, side;
    std::array<double, 3> share;      // as in Batch
    std::array<double, 6> stiffness;  // of (s_0, s_1, s_2): 00 01 02 11 12 22; 0 on borders
  };
  struct Hinges;
  static Hinges hingesOf(const Batch& batch);
  static Symmetric3x4 systemOf(const Batch& batch, const Hinges& hinges);
  static void apply(const Batch& batch, const Hinges& hinges, const Float4 (&lambda)[3]);
  void setHinge(Rest& rest, uint32_t e, const Triangle& corner, const TriangleMesh& mesh,
                const Particles& particles);
  void setTriangle(Batch& batch, const Lane& lane, Particles& particles, double substep);

  std::vector<Batch> batches_;
  std::vector<Triangle> triangles_;  // that are not rigid
  std::vector<Rest> rest_;
  std::vector<std::array<double, 6>> compliance_;  // of triangles, 00 01 02 11 12 22
  std::vector<Turn> turns_;                        // of edges, and one per group for empty lanes
  std::vector<double> exactPsi_;
  std::vector<double> turnWeight_;
  Colouring colouring_;
};

}  // namespace limber
