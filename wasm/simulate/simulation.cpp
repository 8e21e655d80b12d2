#include "simulate/simulation.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

#include "mesh/topology.h"
#include "simulate/bending_constraints.h"
#include "simulate/edge_constraints.h"
#include "simulate/membrane_constraints.h"
#include "simulate/particles.h"
#include "simulate/point_constraints.h"
#include "simulate/schedule.h"
#include "simulate/triangle_rest.h"

namespace limber {

namespace {

// From this many constraints on, a body's stages are long enough for several threads.
constexpr uint32_t kThreadedConstraints = 10000;
constexpr size_t kBatchGrain = 128, kVertexGrain = 4096;

void requireOptions(const SimulationOptions& options) {
  const auto require = [](bool holds, const std::string& sentence) {
    if (!holds) throw std::invalid_argument(sentence);
  };
  const auto positive = [](double value) { return std::isfinite(value) && value > 0; };
  require(positive(options.young), "Young's modulus must be above 0 Pa.");
  require(options.poisson > -1 && options.poisson < 0.5, "Poisson's ratio must lie between -1 and 0.5.");
  require(positive(options.density), "The density must be above 0 kg/m3.");
  require(positive(options.thickness), "The thickness must be above 0.");
  require(positive(options.unit), "The unit must be above 0 metres.");
  require(options.substeps >= 1 && options.substeps <= 100000, "A step has 1 to 100,000 substeps.");
  require(std::isfinite(options.damping) && options.damping >= 0,
          "The damping must be at least 0 per second.");
}

void requirePins(const TriangleMesh& mesh, const Pins& pins) {
  for (const uint32_t v : pins.vertices)
    if (v >= mesh.vertexCount())
      throw std::invalid_argument("Vertex " + std::to_string(v) + " is pinned, but the mesh has " +
                                  std::to_string(mesh.vertexCount()) + " vertices: pin others.");
  for (const SurfaceAnchor& point : pins.points)
    if (point.triangle >= mesh.triangleCount())
      throw std::invalid_argument("A pin lies in triangle " + std::to_string(point.triangle) +
                                  ", but the mesh has " + std::to_string(mesh.triangleCount()) +
                                  " triangles: pin others.");
}

TriangleMesh inMetres(TriangleMesh mesh, double unit) {
  for (Vec3& p : mesh.positions) p *= unit;
  return mesh;
}

// A third of the triangles' mass around each vertex; a vertex with next to none gets 1e-9 of the mean.
std::vector<double> lumpedMasses(const TriangleMesh& mesh, double arealDensity) {
  std::vector<double> masses(mesh.vertexCount(), 0.0);
  double sum = 0;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const double third = arealDensity * triangleArea(mesh, t) / 3;
    for (const uint32_t v : mesh.triangles[t]) masses[v] += third;
    sum += 3 * third;
  }
  if (!(sum > 0) || !std::isfinite(sum))
    throw std::invalid_argument("The mesh has no area to simulate: give it triangles that are not flat.");
  const double least = 1e-9 * sum / mesh.vertexCount();
  for (double& mass : masses) mass = std::max(mass, least);
  return masses;
}

}  // namespace

struct Simulation::State {
  SimulationOptions options;
  TriangleMesh mesh;  // metres
  Topology topology;
  double substep;
  std::vector<double> masses;
  Particles particles;
  std::optional<EdgeConstraints> edges;
  std::optional<MembraneConstraints> membrane;
  std::optional<BendingConstraints> bending;
  PointConstraints heldPoints;
  Pins pins;
  std::vector<Vec3> pinTargets;  // metres, at the end of the step
  std::vector<Vec3> pinStarts;   // of points, at its start
  Vec3 gravity;
  std::vector<Stage> rebasing, substepping;

  State(const TriangleMesh& source, const SimulationOptions& given, const Pins& givenPins)
      : options(given),
        mesh(inMetres(source, given.unit)),
        topology(buildTopology(mesh)),
        substep(kStep / given.substeps),
        masses(lumpedMasses(mesh, given.density * given.thickness * given.unit)),
        pins(givenPins) {
    makeParticles();
    makeConstraints();
    makePins();
    makeStages();
  }

  void makeParticles() {
    const size_t slots = mesh.positions.size() + 1;
    particles.positions = mesh.positions;
    particles.positions.push_back({});
    particles.inverseMass.assign(slots, 0.0);
    for (size_t v = 0; v < masses.size(); ++v) particles.inverseMass[v] = 1 / masses[v];
    for (const uint32_t v : pins.vertices) particles.inverseMass[v] = 0;
    particles.motion.assign(slots, Motion{});
    particles.lost.assign(slots, Motion{});
    particles.acceleration.assign(slots, Float4{});
    particles.damping.assign(slots, 0.0f);
    const auto damping = static_cast<float>(std::min(options.damping * substep, 1.0));
    for (size_t v = 0; v < masses.size(); ++v)
      if (particles.inverseMass[v] > 0) particles.damping[v] = damping;
  }

  void makeConstraints() {
    const Sheet sheet = {options.young, options.poisson, options.thickness * options.unit};
    if (options.material == Material::Springs) {
      edges.emplace(mesh, topology, particles, sheet.stretching(), substep, options.order);
      return;
    }
    membrane.emplace(mesh, particles, sheet, substep, options.order);
    bending.emplace(mesh, topology, particles, sheet, options.density, substep, options.order);
  }

  void makePins() {
    for (const SurfaceAnchor& point : pins.points) heldPoints.add(mesh, particles, point, 0);
    for (const uint32_t v : pins.vertices) pinTargets.push_back(particles.positions[v]);
    for (size_t i = 0; i < pins.points.size(); ++i) {
      pinTargets.push_back(heldPoints.position(i, particles));
      pinStarts.push_back(pinTargets.back());
    }
  }

  template <class Constraints>
  void addStages(Constraints& constraints) {
    const Colouring& colouring = constraints.colouring();
    rebasing.push_back({colouring.batches.size(), kBatchGrain,
                        [&](size_t begin, size_t end, int) { constraints.rebase(particles, begin, end); }});
    for (uint32_t c = 0; c < colouring.colourCount(); ++c) {
      const size_t first = colouring.colourStart[c];
      substepping.push_back(
          {colouring.colourStart[c + 1] - first, kBatchGrain, [&, first](size_t begin, size_t end, int) {
             constraints.project(particles, first + begin, first + end);
           }});
    }
  }

  void makeStages() {
    substepping.push_back({particles.count(), kVertexGrain, [this](size_t begin, size_t end, int repeat) {
                             advance(particles, static_cast<uint32_t>(begin), static_cast<uint32_t>(end),
                                     {repeat > 0, true});
                           }});
    if (bending)
      substepping.push_back(
          {bending->edgeCount(), kVertexGrain, [this](size_t begin, size_t end, int repeat) {
             bending->advanceTurns(begin, end, {repeat > 0, true}, turnDamping());
           }});
    if (edges) addStages(*edges);
    if (membrane) addStages(*membrane);
    if (bending) addStages(*bending);
    if (heldPoints.count())
      substepping.push_back(
          {1, 1, [this](size_t, size_t, int repeat) { heldPoints.project(particles, repeat); }});
  }

  float turnDamping() const { return static_cast<float>(std::min(options.damping * substep, 1.0)); }

  uint32_t constraintCount() const {
    if (edges) return edges->count();
    return membrane->count() + bending->count();
  }

  void startStep(const Job& job, bool threaded) {
    const double squared = substep * substep;
    const Vec3 a = gravity * squared;
    const Float4 fall = {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z), 0};
    for (uint32_t v = 0; v < particles.count(); ++v)
      particles.acceleration[v] = particles.inverseMass[v] > 0 ? fall : Float4{};
    for (size_t i = 0; i < pins.vertices.size(); ++i) {
      const uint32_t v = pins.vertices[i];
      const Vec3 move = (pinTargets[i] - particles.positions[v]) / options.substeps;
      particles.motion[v].q =
          Float4{static_cast<float>(move.x), static_cast<float>(move.y), static_cast<float>(move.z), 0};
    }
    for (size_t i = 0; i < pins.points.size(); ++i) {
      const Vec3& target = pinTargets[pins.vertices.size() + i];
      heldPoints.rebase(i, particles, pinStarts[i], target, options.substeps);
      pinStarts[i] = target;
    }
    runStages(rebasing, 1, threaded, job);
  }

  void step(const Job& job) {
    const bool threaded = constraintCount() >= kThreadedConstraints;
    startStep(job, threaded);
    runStages(substepping, options.substeps, threaded, job);
    advance(particles, 0, particles.count(), {true, false});
    if (bending) bending->advanceTurns(0, bending->edgeCount(), {true, false}, 0);
    finishStep(particles, 0, particles.count());
    for (size_t i = 0; i < pins.vertices.size(); ++i) particles.positions[pins.vertices[i]] = pinTargets[i];
  }
};

Simulation::Simulation(const TriangleMesh& mesh, const SimulationOptions& options, const Pins& pins) {
  requireOptions(options);
  requirePins(mesh, pins);
  state_ = std::make_unique<State>(mesh, options, pins);
}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::step(const Job& job) {
  state_->step(job);
}

uint32_t Simulation::vertexCount() const {
  return state_->particles.count();
}

Vec3 Simulation::position(uint32_t v) const {
  return state_->particles.positions[v] / state_->options.unit;
}

std::vector<Vec3> Simulation::positions() const {
  std::vector<Vec3> positions(vertexCount());
  for (uint32_t v = 0; v < vertexCount(); ++v) positions[v] = position(v);
  return positions;
}

Vec3 Simulation::velocity(uint32_t v) const {
  const Float4 q = state_->particles.motion[v].q;
  return Vec3{double{q[0]}, double{q[1]}, double{q[2]}} / state_->substep;
}

void Simulation::setPositions(std::span<const Vec3> positions) {
  Particles& particles = state_->particles;
  for (uint32_t v = 0; v < vertexCount(); ++v)
    if (particles.inverseMass[v] > 0) particles.positions[v] = positions[v] * state_->options.unit;
}

void Simulation::setVelocities(std::span<const Vec3> velocities) {
  Particles& particles = state_->particles;
  for (uint32_t v = 0; v < vertexCount(); ++v) {
    if (particles.inverseMass[v] == 0) continue;
    const Vec3 q = velocities[v] * state_->substep;
    particles.motion[v].q =
        Float4{static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z), 0};
    particles.lost[v].q = Float4{};
  }
}

void Simulation::setGravity(const Vec3& gravity) {
  state_->gravity = gravity;
}

void Simulation::setPinTargets(std::span<const Vec3> targets) {
  if (targets.size() != state_->pins.count())
    throw std::invalid_argument("There are " + std::to_string(state_->pins.count()) + " pins, but " +
                                std::to_string(targets.size()) + " targets: give one for each.");
  for (size_t i = 0; i < targets.size(); ++i) state_->pinTargets[i] = targets[i] * state_->options.unit;
}

double Simulation::kineticEnergy() const {
  double sum = 0;
  for (uint32_t v = 0; v < vertexCount(); ++v) sum += 0.5 * state_->masses[v] * squaredLength(velocity(v));
  return sum;
}

double Simulation::elasticEnergy() const {
  const auto& positions = state_->particles.positions;
  if (state_->edges) return state_->edges->energy(positions);
  return state_->membrane->energy(positions) + state_->bending->energy(positions);
}

bool Simulation::isFinite() const {
  const Particles& particles = state_->particles;
  for (uint32_t v = 0; v < vertexCount(); ++v)
    if (!limber::isFinite(particles.positions[v]) || !limber::isFinite(velocity(v))) return false;
  return !state_->bending || state_->bending->isFinite();
}

double Simulation::mass() const {
  double sum = 0;
  for (const double mass : state_->masses) sum += mass;
  return sum;
}

uint32_t Simulation::constraintCount() const {
  return state_->constraintCount();
}

uint32_t Simulation::edgeCount() const {
  return static_cast<uint32_t>(state_->topology.edges.size());
}

}  // namespace limber
