#pragma once

#include <optional>
#include <vector>

#include "mesh/topology.h"
#include "simulate/blocks.h"
#include "simulate/constraints/bending_constraints.h"
#include "simulate/constraints/edge_constraints.h"
#include "simulate/constraints/hinge_constraints.h"
#include "simulate/constraints/membrane_constraints.h"
#include "simulate/constraints/point_constraints.h"
#include "simulate/constraints/volume_constraints.h"
#include "simulate/contacts/contacts.h"
#include "simulate/contacts/self_contacts.h"
#include "simulate/contacts/triangle_contacts.h"
#include "simulate/particles.h"
#include "simulate/schedule.h"
#include "simulate/simulation_options.h"

namespace limber {

// The whole state of a simulation, in SI units. It must not be moved: the phases of its schedule point into
// it.
struct SimulationState {
  SimulationState(const TriangleMesh& source, const SimulationOptions& options, const Pins& pins);
  SimulationState(const SimulationState&) = delete;
  SimulationState& operator=(const SimulationState&) = delete;

  void step(const Job& job, Helpers* helpers);
  std::vector<Vec3> velocities() const;
  Vec3 velocity(uint32_t v) const;
  uint32_t constraintCount() const;
  double elasticEnergy() const;

  SimulationOptions options;
  // Internally, vertices are renumbered so that blocks are ranges: vertex v of the caller has the slot
  // slotOf[v].
  uint32_t blockCount;
  std::vector<uint32_t> slotOf;
  TriangleMesh mesh;    // at rest, in metres, by slots
  double restDiagonal;  // metres
  Topology topology;
  Blocks blocks;
  std::optional<SimulatedSolver> solver;  // by slots
  Sheet sheet;
  double substep;              // seconds
  std::vector<double> masses;  // kg
  bool closed;                 // no border
  Particles particles;
  std::optional<EdgeConstraints> edges, crossSprings;
  std::optional<MembraneConstraints> membrane;
  std::optional<BendingConstraints> bending;
  std::optional<HingeConstraints> hinges;
  std::optional<VolumeConstraints> volume;
  Contacts contacts;
  TriangleContacts triangleContacts;
  std::optional<SelfContacts> selfContacts;
  CollisionScene collisionScene;  // metres
  Pins pins;                      // by slots
  PointConstraints pinnedPoints;
  std::vector<Vec3> pinTargets;  // metres, at the end of the step
  std::vector<Vec3> pinStarts;   // metres, of pinned points at the start of the step
  PointConstraints dragged;      // no point or one
  Vec3 dragTarget;
  Vec3 gravity, wind;
  double helpedSeconds = 0;  // of the last step

 private:
  void makeParticles();
  void makeConstraints();
  void makeBending(const ConstraintOptions& made);
  void makePins();
  void startBlock(size_t block);
  void projectContacts(size_t group);
  void startGroup(size_t group);
  void projectGroup(size_t group);
  void advanceBlock(size_t block, const Advance& what);
  void finishBlock(size_t block);
  void makeSchedule();
  ContactDistance contactDistanceNow() const {
    return contactDistance(restDiagonal, gravity, options.substeps);
  }
  void startPins();
  void startWind();

  std::vector<size_t> edgeStart_;  // edges of block b: [edgeStart_[b], edgeStart_[b + 1])
  Schedule schedule_;
  size_t pointPhase_ = 0, contactPhase_ = 0;  // indices in schedule_.repeated
  std::vector<Vec3> windAcceleration_;        // m/s2 per slot; empty without wind
  ThreadChoice threadChoice_;
};

}  // namespace limber
