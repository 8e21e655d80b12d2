#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "simulate/solid/solid_split.h"
#include "simulate/solid/solid_state.h"

namespace limber {

// A body whose closed components move as solids and whose open ones as shells, each with a solver of its own.
// In a body with solids, open components without area, and therefore without mass, do not move. The functions
// are those of Simulation, which forwards to this class if its model is Solid; vertices, triangles and pins
// are those of the whole body. `Sheets` is Simulation, which this file cannot include.
template <class Sheets>
class SolidSimulation {
 public:
  SolidSimulation(const TriangleMesh& mesh, const SimulationOptions& options, const Pins& pins, Job& job)
      : split_(mesh), unit_(options.material.unit) {
    split_.splitPins(pins);
    SimulationOptions asShell = options;
    asShell.model = SimulationModel::Shell;
    if (split_.sheets.vertexCount() && (split_.sheetArea > 0 || split_.solids.vertexCount() == 0))
      sheets_ = std::make_unique<Sheets>(split_.sheets, asShell, split_.sheetPins, job);
    if (split_.solids.vertexCount())
      solids_ = std::make_unique<SolidState>(split_.solids, options, split_.solidPins, job);
  }

  void step(const Job& job, Helpers* helpers) {
    if (sheets_) sheets_->step(job, helpers);
    if (solids_) solids_->step(job, helpers);
  }
  double helpedSeconds() const {
    return sum<double>([](const auto& part) { return part.helpedSeconds(); });
  }
  uint32_t vertexCount() const { return static_cast<uint32_t>(split_.localVertex.size()); }
  uint32_t triangleCount() const { return static_cast<uint32_t>(split_.localTriangle.size()); }
  size_t pinCount() const { return split_.sheetPins.count() + split_.solidPins.count(); }
  uint32_t edgeCount() const { return split_.edgeCount; }

  Vec3 position(uint32_t v) const {
    const uint32_t local = split_.localVertex[v];
    if (split_.isSolidVertex[v]) return solids_->position(local);
    return sheets_ ? sheets_->position(local) : split_.sheets.positions[local];
  }
  Vec3 position(const SurfacePoint& point) const {
    const SurfacePoint local = split_.local(point);
    if (split_.isSolidTriangle[point.triangle]) return solids_->position(local);
    if (sheets_) return sheets_->position(local);
    return positionOf(local, split_.sheets.triangles, split_.sheets.positions);
  }
  Vec3 velocity(uint32_t v) const {
    const uint32_t local = split_.localVertex[v];
    if (split_.isSolidVertex[v]) return solids_->velocity(local);
    return sheets_ ? sheets_->velocity(local) : Vec3{};
  }
  void setVelocities(std::span<const Vec3> velocities) {
    if (sheets_) sheets_->setVelocities(SolidSplit::chosen(velocities, split_.sheetVertices));
    if (solids_) solids_->setVelocities(SolidSplit::chosen(velocities, split_.solidVertices));
  }
  void setPinTargets(std::span<const Vec3> targets) {
    if (sheets_) sheets_->setPinTargets(SolidSplit::chosen(targets, split_.sheetPinIndices));
    if (solids_) solids_->setPinTargets(SolidSplit::chosen(targets, split_.solidPinIndices));
  }

  void setGravity(const Vec3& gravity) {
    if (sheets_) sheets_->setGravity(gravity);
    if (solids_) solids_->gravity = gravity;
  }
  void setWind(const Vec3& wind) {
    if (sheets_) sheets_->setWind(wind);
    if (solids_) solids_->wind = wind;
  }
  void setGround(double height) {
    if (sheets_) sheets_->setGround(height);
    if (solids_) solids_->collisionScene.ground = height * unit_;
  }
  void setColliders(std::span<const Collider> colliders) {
    if (sheets_) sheets_->setColliders(colliders);
    if (!solids_) return;
    solids_->collisionScene.colliders.clear();
    for (const Collider& c : colliders)
      solids_->collisionScene.colliders.push_back({c.from * unit_, c.to * unit_, c.radius * unit_});
  }
  void drag(const SurfacePoint& point, const Vec3& target) {
    release();
    if (split_.isSolidTriangle[point.triangle])
      solids_->drag(split_.local(point), target);
    else if (sheets_)
      sheets_->drag(split_.local(point), target);
  }
  void release() {
    if (sheets_) sheets_->release();
    if (solids_) solids_->release();
  }

  double kineticEnergy() const {
    return sum<double>([](const auto& part) { return part.kineticEnergy(); });
  }
  double elasticEnergy() const {
    return sum<double>([](const auto& part) { return part.elasticEnergy(); });
  }
  double mass() const {
    return sum<double>([](const auto& part) { return part.mass(); });
  }
  uint32_t constraintCount() const {
    return sum<uint32_t>([](const auto& part) { return part.constraintCount(); });
  }
  bool isFinite() const { return (!sheets_ || sheets_->isFinite()) && (!solids_ || solids_->isFinite()); }
  double restDiagonal() const { return split_.diagonal; }  // units of the mesh
  const std::vector<uint32_t>& componentOfVertex() const { return split_.componentOfVertex; }

 private:
  template <class Number, class Read>
  Number sum(Read read) const {
    return (sheets_ ? read(*sheets_) : Number{}) + (solids_ ? read(*solids_) : Number{});
  }

  SolidSplit split_;
  double unit_;                         // metres per unit of the mesh
  std::unique_ptr<Sheets> sheets_;      // null if no component is open, or if the open ones have no area
  std::unique_ptr<SolidState> solids_;  // null if no component is closed
};

}  // namespace limber
