#include "simulate/solid/solid_simulation.h"

#include "mesh/topology.h"

namespace limber {

namespace {

// A body has diverged when its bounding box grows beyond this many times its diagonal at rest.
constexpr double kDivergedGrowth = 10;

}  // namespace

SolidSimulation::SolidSimulation(const TriangleMesh& mesh, const SimulationOptions& options, const Pins& pins)
    : unit_(options.material.unit), restDiagonal_(bounds(mesh).diagonal()) {
  const Topology topology = buildTopology(mesh);
  const std::vector<uint8_t> solidComponent = solidComponents(mesh);
  edgeCount_ = static_cast<uint32_t>(topology.edges.size());
  std::vector<uint32_t> partOfVertex;
  for (const uint32_t component : topology.componentOfVertex) {
    isSolid_.push_back(solidComponent[component]);
    partOfVertex.push_back(solidComponent[component]);
  }
  const MeshParts split = splitMesh(mesh, partOfVertex, 2);
  localVertex_ = split.localVertex;
  isSolidTriangle_.assign(mesh.triangleCount(), 0);
  localTriangle_.resize(mesh.triangleCount());
  for (uint8_t part = 0; part < 2; ++part)
    for (uint32_t t = 0; t < split.parts[part].triangles.size(); ++t) {
      isSolidTriangle_[split.parts[part].triangles[t]] = part;
      localTriangle_[split.parts[part].triangles[t]] = t;
    }
  Pins ofSheets, ofSolids;
  splitPins(pins, ofSheets, ofSolids);
  SimulationOptions asShell = options;
  asShell.model = SimulationModel::Shell;
  const TriangleMesh &sheets = split.parts[0].mesh, &solids = split.parts[1].mesh;
  if (sheets.vertexCount()) sheets_ = std::make_unique<Simulation>(sheets, asShell, ofSheets);
  if (solids.vertexCount()) solids_ = std::make_unique<SolidState>(solids, options, ofSolids);
}

void SolidSimulation::splitPins(const Pins& pins, Pins& ofSheets, Pins& ofSolids) {
  uint32_t pin = 0;
  for (const uint32_t v : pins.vertices) {
    (isSolid_[v] ? ofSolids : ofSheets).vertices.push_back(localVertex_[v]);
    (isSolid_[v] ? solidPins_ : sheetPins_).push_back(pin++);
  }
  for (const SurfacePoint& point : pins.points) {
    const bool solid = isSolidTriangle_[point.triangle];
    (solid ? ofSolids : ofSheets).points.push_back(local(point));
    (solid ? solidPins_ : sheetPins_).push_back(pin++);
  }
}

SurfacePoint SolidSimulation::local(const SurfacePoint& point) const {
  SurfacePoint own = point;
  own.triangle = localTriangle_[point.triangle];
  return own;
}

void SolidSimulation::step(const Job& job, Helpers* helpers) {
  if (sheets_) sheets_->step(job, helpers);
  if (solids_) solids_->step(job, helpers);
}

double SolidSimulation::helpedSeconds() const {
  return (sheets_ ? sheets_->helpedSeconds() : 0) + (solids_ ? solids_->helpedSeconds() : 0);
}

Vec3 SolidSimulation::position(uint32_t v) const {
  return isSolid_[v] ? solids_->position(localVertex_[v]) : sheets_->position(localVertex_[v]);
}

Vec3 SolidSimulation::position(const SurfacePoint& point) const {
  return isSolidTriangle_[point.triangle] ? solids_->position(local(point)) : sheets_->position(local(point));
}

Vec3 SolidSimulation::velocity(uint32_t v) const {
  return isSolid_[v] ? solids_->velocity(localVertex_[v]) : sheets_->velocity(localVertex_[v]);
}

void SolidSimulation::setVelocities(std::span<const Vec3> velocities) {
  std::vector<Vec3> ofSheets, ofSolids;  // local vertices are numbered in the order of the whole mesh
  for (uint32_t v = 0; v < vertexCount(); ++v) (isSolid_[v] ? ofSolids : ofSheets).push_back(velocities[v]);
  if (sheets_) sheets_->setVelocities(ofSheets);
  if (solids_) solids_->setVelocities(ofSolids);
}

void SolidSimulation::setGravity(const Vec3& gravity) {
  if (sheets_) sheets_->setGravity(gravity);
  if (solids_) solids_->gravity = gravity;
}

void SolidSimulation::setWind(const Vec3& wind) {
  if (sheets_) sheets_->setWind(wind);
  if (solids_) solids_->wind = wind;
}

void SolidSimulation::setGround(double height) {
  if (sheets_) sheets_->setGround(height);
  if (solids_) solids_->collisionScene.ground = height * unit_;
}

void SolidSimulation::setColliders(std::span<const Collider> colliders) {
  if (sheets_) sheets_->setColliders(colliders);
  if (!solids_) return;
  solids_->collisionScene.colliders.clear();
  for (const Collider& c : colliders)
    solids_->collisionScene.colliders.push_back({c.from * unit_, c.to * unit_, c.radius * unit_});
}

void SolidSimulation::drag(const SurfacePoint& point, const Vec3& target) {
  release();
  if (isSolidTriangle_[point.triangle])
    solids_->drag(local(point), target);
  else
    sheets_->drag(local(point), target);
}

void SolidSimulation::release() {
  if (sheets_) sheets_->release();
  if (solids_) solids_->release();
}

void SolidSimulation::setPinTargets(std::span<const Vec3> targets) {
  const auto of = [&](const std::vector<uint32_t>& pins) {
    std::vector<Vec3> own;
    for (const uint32_t pin : pins) own.push_back(targets[pin]);
    return own;
  };
  if (sheets_) sheets_->setPinTargets(of(sheetPins_));
  if (solids_) solids_->setPinTargets(of(solidPins_));
}

double SolidSimulation::kineticEnergy() const {
  return (sheets_ ? sheets_->kineticEnergy() : 0) + (solids_ ? solids_->kineticEnergy() : 0);
}

double SolidSimulation::elasticEnergy() const {
  return (sheets_ ? sheets_->elasticEnergy() : 0) + (solids_ ? solids_->elasticEnergy() : 0);
}

bool SolidSimulation::isFinite() const {
  return (!sheets_ || sheets_->isFinite()) && (!solids_ || solids_->isFinite());
}

bool SolidSimulation::hasDiverged() const {
  if (!isFinite()) return true;
  TriangleMesh now;
  for (uint32_t v = 0; v < vertexCount(); ++v) now.positions.push_back(position(v));
  return bounds(now).diagonal() > kDivergedGrowth * restDiagonal_;
}

double SolidSimulation::mass() const {
  return (sheets_ ? sheets_->mass() : 0) + (solids_ ? solids_->mass() : 0);
}

uint32_t SolidSimulation::constraintCount() const {
  return (sheets_ ? sheets_->constraintCount() : 0) + (solids_ ? solids_->constraintCount() : 0);
}

}  // namespace limber
