#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/job.h"
#include "mesh/surface_point.h"
#include "mesh/triangle_mesh.h"
#include "simulate/collision_scene.h"
#include "simulate/simulation_options.h"

namespace limber {

class Helpers;
struct SimulationState;
template <class Sheets>
class SolidSimulation;

// One elastic surface in motion, solved by XPBD with small substeps and one pass per substep (Macklin et al.
// 2016, 2019). Masses are lumped: every vertex has a third of the mass of its triangles, unless a solver of
// the panel specifies masses. The same input gives the same bits on any number of threads.
class Simulation {
 public:
  static constexpr double kStep = kStepSeconds;

  // Starts at rest in the shape of the mesh. Throws std::invalid_argument with a sentence for an option out
  // of range, for a mesh without area, and for a pin that the mesh does not have. Throws Cancelled while the
  // lattice of a solid is built.
  Simulation(const TriangleMesh& mesh, const SimulationOptions& options, const Pins& pins, Job& job);
  // The same, not cancellable.
  Simulation(const TriangleMesh& mesh, const SimulationOptions& options, const Pins& pins = {});
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  // Advances by one step of 1/60 s, with other threads if `helpers` is given. Throws Cancelled, after which
  // the simulation must not be used any more.
  void step(const Job& job, Helpers* helpers = nullptr);
  // An estimate of the seconds that helpers saved in the last step.
  double helpedSeconds() const;

  uint32_t vertexCount() const;
  // In units of the mesh.
  Vec3 position(uint32_t v) const;
  Vec3 position(const SurfacePoint& point) const;
  std::vector<Vec3> positions() const;
  // m/s.
  Vec3 velocity(uint32_t v) const;
  // Sets the velocities of all vertices, in m/s. Pinned vertices ignore theirs.
  void setVelocities(std::span<const Vec3> velocities);

  // m/s2.
  void setGravity(const Vec3& gravity);
  // The velocity of the air, in m/s.
  void setWind(const Vec3& wind);
  // Adds a horizontal floor at this height along y, in units of the mesh.
  void setGround(double height);
  // Replaces all colliders; units of the mesh. Throws std::invalid_argument if a radius is not above 0.
  void setColliders(std::span<const Collider> colliders);
  // Drags a point of the surface towards `target` (units of the mesh), as a hand would: in every step it
  // covers a fifth of the remaining way. A second call moves the target or takes another point; `release`
  // ends it.
  void drag(const SurfacePoint& point, const Vec3& target);
  void release();
  // Sets the positions of the pins at the end of the next step, in units of the mesh: pinned vertices first,
  // then pinned points. Throws std::invalid_argument if their number differs from that of the pins.
  void setPinTargets(std::span<const Vec3> targets);

  // Joules, without the potential of gravity.
  double kineticEnergy() const;
  double elasticEnergy() const;
  // False if any position, velocity or edge rotation is infinite or not a number.
  bool isFinite() const;
  // Whether the body has become useless: it is not finite, the diagonal of a component's bounding box is more
  // than 10 times that of the body at rest, or it is farther away than float32 can represent. Moving away
  // does not count as divergence, and neither do components that fall away from each other.
  bool hasDiverged() const;
  // The mass of the whole body in kg.
  double mass() const;
  // The number of constraints that a substep solves; the bending of a triangle counts as one.
  uint32_t constraintCount() const;
  uint32_t edgeCount() const;

 private:
  std::unique_ptr<SimulationState> state_;
  std::unique_ptr<SolidSimulation<Simulation>> solid_;  // instead of state_ if the model is Solid
};

}  // namespace limber
