#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "mesh/component_frame.h"
#include "simulate/simulation.h"
#include "simulate/solid/solid_state.h"

namespace limber {

// A body whose closed components move as solids and whose open ones as shells, each with a solver of its own.
// The functions are those of Simulation, which leads here when its model is Solid; vertices, triangles and
// pins are those of the whole body.
class SolidSimulation {
 public:
  SolidSimulation(const TriangleMesh& mesh, const SimulationOptions& options, const Pins& pins);

  void step(const Job& job, Helpers* helpers);
  double helpedSeconds() const;
  uint32_t vertexCount() const { return static_cast<uint32_t>(isSolid_.size()); }
  uint32_t triangleCount() const { return static_cast<uint32_t>(localTriangle_.size()); }
  size_t pinCount() const { return sheetPins_.size() + solidPins_.size(); }
  Vec3 position(uint32_t v) const;
  Vec3 position(const SurfacePoint& point) const;
  Vec3 velocity(uint32_t v) const;
  void setVelocities(std::span<const Vec3> velocities);
  void setGravity(const Vec3& gravity);
  void setWind(const Vec3& wind);
  void setGround(double height);
  void setColliders(std::span<const Collider> colliders);
  void drag(const SurfacePoint& point, const Vec3& target);
  void release();
  void setPinTargets(std::span<const Vec3> targets);
  double kineticEnergy() const;
  double elasticEnergy() const;
  bool isFinite() const;
  bool hasDiverged() const;
  double mass() const;
  uint32_t constraintCount() const;
  uint32_t edgeCount() const { return edgeCount_; }

 private:
  // The pins of the shells and of the solids, and for each pin of the body which of them it is.
  void splitPins(const Pins& pins, Pins& ofSheets, Pins& ofSolids);
  // The point of the sheets or of the solids, by where the triangle is.
  SurfacePoint local(const SurfacePoint& point) const;

  double unit_, restDiagonal_;  // metres per unit of the mesh; units of the mesh
  uint32_t edgeCount_;
  std::vector<uint8_t> isSolid_;          // per vertex
  std::vector<uint32_t> localVertex_;     // per vertex: its number in the sheets or in the solids
  std::vector<uint8_t> isSolidTriangle_;  // per triangle
  std::vector<uint32_t> localTriangle_;
  std::vector<uint32_t> sheetPins_, solidPins_;  // the pins of the body that are theirs, in their order
  std::unique_ptr<Simulation> sheets_;           // null where all components are closed
  std::unique_ptr<SolidState> solids_;           // null where none is
};

}  // namespace limber
