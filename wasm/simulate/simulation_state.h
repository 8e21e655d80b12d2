#pragma once

#include <optional>
#include <vector>

#include "mesh/topology.h"
#include "simulate/bending_constraints.h"
#include "simulate/contacts.h"
#include "simulate/edge_constraints.h"
#include "simulate/membrane_constraints.h"
#include "simulate/particles.h"
#include "simulate/point_constraints.h"
#include "simulate/schedule.h"
#include "simulate/self_contacts.h"
#include "simulate/simulation.h"
#include "simulate/volume_constraints.h"

namespace limber {

// A simulation in SI units. It must not move: its stages point into it.
struct Simulation::State {
  State(const TriangleMesh& source, const SimulationOptions& options, const Pins& pins);
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  void step(const Job& job);
  std::vector<Vec3> velocities() const;
  Vec3 velocity(uint32_t v) const;
  uint32_t constraintCount() const;
  double elasticEnergy() const;

  SimulationOptions options;
  TriangleMesh mesh;  // at rest, in metres
  Topology topology;
  double substep;              // seconds
  std::vector<double> masses;  // kg
  bool closed;                 // no border
  Particles particles;
  std::optional<EdgeConstraints> edges;
  std::optional<MembraneConstraints> membrane;
  std::optional<BendingConstraints> bending;
  std::optional<VolumeConstraints> volume;
  Contacts contacts;
  std::optional<SelfContacts> selfContacts;
  Obstacles obstacles;
  Pins pins;
  PointConstraints heldPoints;
  std::vector<Vec3> pinTargets;  // at the end of the step
  std::vector<Vec3> pinStarts;   // of points, at its start
  PointConstraints dragged;      // none or one
  Vec3 dragTarget;
  Vec3 gravity, wind;

 private:
  void makeParticles();
  void makeConstraints();
  void makePins();
  template <class Constraints>
  void addStages(Constraints& constraints);
  void makeStages();
  void setAccelerations();
  void startPins();

  std::vector<Stage> rebasing_, substepping_;
  ThreadChoice threadChoice_;
};

}  // namespace limber
