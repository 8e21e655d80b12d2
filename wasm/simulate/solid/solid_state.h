#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "simulate/blocks.h"
#include "simulate/collision_scene.h"
#include "simulate/particles.h"
#include "simulate/schedule.h"
#include "simulate/simulation_options.h"
#include "simulate/solid/cell_constraints.h"
#include "simulate/solid/embedded_contacts.h"
#include "simulate/solid/embedded_points.h"
#include "simulate/solid/lattice_body.h"

namespace limber {

// Closed bodies in motion as solids: a lattice whose nodes are the particles, and the surface embedded in it.
// In SI units, except for positions that callers pass or receive, which are in units of the mesh, as in
// Simulation. It must not be moved: the phases of its schedule point into it.
class SolidState {
 public:
  // Every component of `mesh` must be closed; `options` and `pins` must be valid for it.
  SolidState(const TriangleMesh& mesh, const SimulationOptions& options, const Pins& pins, Job& job);
  SolidState(const SolidState&) = delete;
  SolidState& operator=(const SolidState&) = delete;

  void step(const Job& job, Helpers* helpers);
  double helpedSeconds() const { return helpedSeconds_; }

  // The same as in Simulation.
  Vec3 position(uint32_t v) const;
  Vec3 position(const SurfacePoint& point) const;
  Vec3 velocity(uint32_t v) const;
  // Nodes get the velocities that best fit those of the vertices, see fitVelocities.
  void setVelocities(std::span<const Vec3> velocities);
  void setPinTargets(std::span<const Vec3> targets);
  void drag(const SurfacePoint& point, const Vec3& target);
  void release() { dragged_.clear(); }
  double kineticEnergy() const;
  double elasticEnergy() const { return cells_->energy(particles_.positions); }
  bool isFinite() const;
  double mass() const;
  uint32_t constraintCount() const { return cells_->count(); }
  // The nodes of the lattice, in SI units.
  const Particles& particles() const { return particles_; }
  double substep() const { return substep_; }

  Vec3 gravity, wind;             // m/s2, m/s
  CollisionScene collisionScene;  // metres

 private:
  void makeBody(Job& job);
  void makeParticles();
  void makePins();
  void makeSchedule();
  void startGroup(size_t group);
  void startPins();
  void startWind();
  void advanceBlock(size_t block, const Advance& what);
  void finishBlock(size_t block);
  void projectGroup(size_t group) const;

  SimulationOptions options_;
  TriangleMesh surface_;         // at rest, in units of the mesh; refined, the vertices of the caller first
  std::vector<Triangle> drawn_;  // the triangles of the caller
  uint32_t vertexCount_;         // of the caller
  Pins pins_;
  std::vector<uint32_t> pinnedVertices_;  // those of `pins_`, then those on refined pinned faces
  std::vector<std::array<uint32_t, 2>> pinnedParents_;  // of the latter: indices in pinnedVertices_
  LatticeBody body_;
  double restDiagonal_;  // metres
  Blocks blocks_;
  double substep_;  // seconds
  Particles particles_;
  std::optional<CellConstraints> cells_;
  std::optional<EmbeddedContacts> contacts_;
  std::vector<LatticePoint> vertices_;  // by vertex of the caller
  std::vector<double> surfaceMasses_;   // kg, by vertex of the caller: the masses that the air accelerates
  EmbeddedPins fixed_, dragged_;        // pinned vertices, then pinned points; no point or one
  std::vector<Vec3> pinTargets_, pinStarts_;  // metres, of fixed_
  Vec3 dragTarget_;
  std::vector<Vec3> windAcceleration_;  // m/s2 per node; empty without wind
  Schedule schedule_;
  size_t pointPhase_ = 0, contactPhase_ = 0;  // indices in schedule_.repeated
  ThreadChoice threadChoice_;
  double helpedSeconds_ = 0;
};

}  // namespace limber
