#include "simulate/simulation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "simulate/simulation_state.h"
#include "simulate/solid/solid_simulation.h"

namespace limber {

namespace {

// A body has diverged when the bounding box of a component grows beyond this many times the diagonal of the
// body at rest.
constexpr double kDivergedGrowth = 10;

// Per component. Every component has a vertex.
std::vector<Bounds> boxesOf(const std::vector<Vec3>& positions,
                            const std::vector<uint32_t>& componentOfVertex) {
  std::vector<Bounds> boxes;
  std::vector<uint8_t> isSeen;
  for (size_t v = 0; v < positions.size(); ++v) {
    const uint32_t component = componentOfVertex[v];
    if (component >= boxes.size()) {
      boxes.resize(component + 1);
      isSeen.resize(component + 1, 0);
    }
    if (!isSeen[component]) boxes[component] = {positions[v], positions[v]};
    isSeen[component] = 1;
    boxes[component].include(positions[v]);
  }
  return boxes;
}

bool fitsFloat32(const Vec3& p) {
  constexpr double kMax = std::numeric_limits<float>::max();
  return std::abs(p.x) <= kMax && std::abs(p.y) <= kMax && std::abs(p.z) <= kMax;
}

void requireOptions(const SimulationOptions& options) {
  const auto& [young, poisson, density, thickness, unit] = options.material;
  const auto require = [](bool isMet, const std::string& sentence) {
    if (!isMet) throw std::invalid_argument(sentence);
  };
  const auto positive = [](double value) { return std::isfinite(value) && value > 0; };
  require(positive(young), "Young's modulus must be above 0 Pa.");
  require(poisson > -1 && poisson < 0.5, "Poisson's ratio must lie between -1 and 0.5.");
  require(positive(density), "The density must be above 0 kg/m3.");
  require(positive(thickness), "The thickness must be above 0.");
  require(positive(unit), "The unit must be above 0 metres.");
  require(options.substeps >= 1 && options.substeps <= kMaxSubsteps, "A step has 1 to 10,000 substeps.");
  require(std::isfinite(options.friction) && options.friction >= 0, "The friction must be at least 0.");
  require(std::isfinite(options.damping) && options.damping >= 0,
          "The damping must be at least 0 per second.");
}

void requireSolverOf(const SimulationOptions& options, const TriangleMesh& mesh) {
  if (!options.solver) return;
  if (options.solver->constants.unit != options.material.unit)
    throw std::invalid_argument("The solver and the material have different units: give them the same.");
  requireSolver(*options.solver, mesh);
}

void requirePins(const TriangleMesh& mesh, const Pins& pins) {
  for (const uint32_t v : pins.vertices)
    if (v >= mesh.vertexCount())
      throw std::invalid_argument("Vertex " + std::to_string(v) + " is pinned, but the mesh has " +
                                  std::to_string(mesh.vertexCount()) + " vertices: pin others.");
  for (const SurfacePoint& point : pins.points)
    if (point.triangle >= mesh.triangleCount())
      throw std::invalid_argument("A pin lies in triangle " + std::to_string(point.triangle) +
                                  ", but the mesh has " + std::to_string(mesh.triangleCount()) +
                                  " triangles: pin others.");
}

}  // namespace

Simulation::Simulation(const TriangleMesh& mesh, const SimulationOptions& options, const Pins& pins,
                       Job& job) {
  requireOptions(options);
  requireSolverOf(options, mesh);
  requirePins(mesh, pins);
  if (options.model == SimulationModel::Solid && !options.solver)
    solid_ = std::make_unique<SolidSimulation<Simulation>>(mesh, options, pins, job);
  else
    state_ = std::make_unique<SimulationState>(mesh, options, pins);
}

Simulation::Simulation(const TriangleMesh& mesh, const SimulationOptions& options, const Pins& pins) {
  Job job;
  *this = Simulation(mesh, options, pins, job);
}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::step(const Job& job, Helpers* helpers) {
  if (solid_) return solid_->step(job, helpers);
  state_->step(job, helpers);
}

double Simulation::helpedSeconds() const {
  if (solid_) return solid_->helpedSeconds();
  return state_->helpedSeconds;
}

uint32_t Simulation::vertexCount() const {
  if (solid_) return solid_->vertexCount();
  return state_->particles.count();
}

Vec3 Simulation::position(uint32_t v) const {
  if (solid_) return solid_->position(v);
  return state_->particles.positions[state_->slotOf[v]] / state_->options.material.unit;
}

std::vector<Vec3> Simulation::positions() const {
  std::vector<Vec3> positions(vertexCount());
  for (uint32_t v = 0; v < vertexCount(); ++v) positions[v] = position(v);
  return positions;
}

Vec3 Simulation::position(const SurfacePoint& point) const {
  if (solid_) return solid_->position(point);
  return positionOf(point, state_->mesh.triangles, state_->particles.positions) /
         state_->options.material.unit;
}

Vec3 Simulation::velocity(uint32_t v) const {
  if (solid_) return solid_->velocity(v);
  return state_->velocity(state_->slotOf[v]);
}

void Simulation::setVelocities(std::span<const Vec3> velocities) {
  if (solid_) return solid_->setVelocities(velocities);
  Particles& particles = state_->particles;
  for (uint32_t v = 0; v < vertexCount(); ++v) {
    const uint32_t slot = state_->slotOf[v];
    if (particles.inverseMass[slot] == 0) continue;
    particles.motion[slot].q = toFloat4(velocities[v] * state_->substep);
    particles.lost[slot].q = Float4{};
  }
}

void Simulation::setGravity(const Vec3& gravity) {
  if (solid_) return solid_->setGravity(gravity);
  state_->gravity = gravity;
}

void Simulation::setWind(const Vec3& wind) {
  if (solid_) return solid_->setWind(wind);
  state_->wind = wind;
}

void Simulation::setGround(double height) {
  if (solid_) return solid_->setGround(height);
  state_->collisionScene.ground = height * state_->options.material.unit;
}

void Simulation::setColliders(std::span<const Collider> colliders) {
  for (const Collider& c : colliders)
    if (!(c.radius > 0)) throw std::invalid_argument("The radius of a collider must be above 0.");
  if (solid_) return solid_->setColliders(colliders);
  const double unit = state_->options.material.unit;
  state_->collisionScene.colliders.clear();
  for (const Collider& c : colliders)
    state_->collisionScene.colliders.push_back({c.from * unit, c.to * unit, c.radius * unit});
}

void Simulation::drag(const SurfacePoint& point, const Vec3& target) {
  const uint32_t triangleCount = solid_ ? solid_->triangleCount() : state_->mesh.triangleCount();
  if (point.triangle >= triangleCount)
    throw std::invalid_argument("The dragged point lies in a triangle that the mesh does not have.");
  if (solid_) return solid_->drag(point, target);
  state_->dragged.clear();
  state_->dragged.add(state_->mesh, state_->particles, point);
  state_->dragTarget = target * state_->options.material.unit;
}

void Simulation::release() {
  if (solid_) return solid_->release();
  state_->dragged.clear();
}

void Simulation::setPinTargets(std::span<const Vec3> targets) {
  const size_t pinCount = solid_ ? solid_->pinCount() : state_->pins.count();
  if (targets.size() != pinCount)
    throw std::invalid_argument("There are " + std::to_string(pinCount) + " pins, but " +
                                std::to_string(targets.size()) + " targets: give one for each.");
  if (solid_) return solid_->setPinTargets(targets);
  for (size_t i = 0; i < targets.size(); ++i)
    state_->pinTargets[i] = targets[i] * state_->options.material.unit;
}

double Simulation::kineticEnergy() const {
  if (solid_) return solid_->kineticEnergy();
  double sum = 0;
  for (uint32_t slot = 0; slot < vertexCount(); ++slot)
    sum += 0.5 * state_->masses[slot] * squaredLength(state_->velocity(slot));
  return sum;
}

double Simulation::elasticEnergy() const {
  if (solid_) return solid_->elasticEnergy();
  return state_->elasticEnergy();
}

bool Simulation::isFinite() const {
  if (solid_) return solid_->isFinite();
  const Particles& particles = state_->particles;
  for (uint32_t slot = 0; slot < vertexCount(); ++slot)
    if (!limber::isFinite(particles.positions[slot]) || !limber::isFinite(state_->velocity(slot)))
      return false;
  return !state_->bending || state_->bending->isFinite();
}

bool Simulation::hasDiverged() const {
  if (!isFinite()) return true;
  const double most = kDivergedGrowth * (solid_ ? solid_->restDiagonal() : state_->restDiagonal);
  const double unit = solid_ ? 1 : state_->options.material.unit;
  const std::vector<Bounds> boxes =
      solid_ ? boxesOf(positions(), solid_->componentOfVertex())
             : boxesOf(state_->particles.positions, state_->topology.componentOfVertex);
  return std::ranges::any_of(boxes, [&](const Bounds& box) {
    return box.diagonal() > most || !fitsFloat32(box.low / unit) || !fitsFloat32(box.high / unit);
  });
}

double Simulation::mass() const {
  if (solid_) return solid_->mass();
  double sum = 0;
  for (const double mass : state_->masses) sum += mass;
  return sum;
}

uint32_t Simulation::constraintCount() const {
  if (solid_) return solid_->constraintCount();
  return state_->constraintCount();
}

uint32_t Simulation::edgeCount() const {
  if (solid_) return solid_->edgeCount();
  return static_cast<uint32_t>(state_->topology.edges.size());
}

}  // namespace limber
