#include "simulate/simulation_state.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "base/parallel.h"
#include "simulate/wind.h"

namespace limber {

namespace {

// From this many constraints on, a body's stages (a colour's 20 microseconds or more) pay for several
// threads.
constexpr uint32_t kThreadedEdges = 40000, kThreadedTriangles = 20000;
constexpr size_t kBatchGrain = 64, kVertexGrain = 1024;

// Contacts are looked for within this share of the body's diagonal.
constexpr double kContactReach = 0.02;
// The share of its way that a dragged point makes in a step.
constexpr double kDragPace = 0.2;

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

bool hasNoBorder(const Topology& topology) {
  return std::none_of(topology.edges.begin(), topology.edges.end(),
                      [](const Topology::Edge& edge) { return edge.useCount == 1; });
}

}  // namespace

Simulation::State::State(const TriangleMesh& source, const SimulationOptions& given, const Pins& givenPins)
    : options(given),
      mesh(inMetres(source, given.unit)),
      topology(buildTopology(mesh)),
      substep(kStep / given.substeps),
      masses(lumpedMasses(mesh, given.density * given.thickness * given.unit)),
      closed(hasNoBorder(topology)),
      pins(givenPins) {
  makeParticles();
  makeConstraints();
  makePins();
  makeStages();
}

void Simulation::State::makeParticles() {
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

void Simulation::State::makeConstraints() {
  const Sheet sheet = {options.young, options.poisson, options.thickness * options.unit, options.density};
  if (options.avoidsItself) selfContacts.emplace(mesh, options.friction);
  const ConstraintOptions made = {sheet, substep, options.order};
  if (options.material == Material::Springs) {
    edges.emplace(mesh, topology, particles, made);
    return;
  }
  membrane.emplace(mesh, particles, made);
  bending.emplace(mesh, topology, particles, made);
  const double bulkModulus = options.young / (3 * (1 - 2 * options.poisson));
  if (options.keepsVolume) volume.emplace(mesh, topology, bulkModulus, substep);
}

void Simulation::State::makePins() {
  for (const SurfaceAnchor& point : pins.points) heldPoints.add(mesh, particles, point);
  for (const uint32_t v : pins.vertices) pinTargets.push_back(particles.positions[v]);
  for (size_t i = 0; i < pins.points.size(); ++i) {
    pinTargets.push_back(heldPoints.position(i, particles));
    pinStarts.push_back(pinTargets.back());
  }
}

template <class Constraints>
void Simulation::State::addStages(Constraints& constraints) {
  const Colouring& colouring = constraints.colouring();
  rebasing_.push_back({colouring.batches.size(), kBatchGrain,
                       [&](size_t begin, size_t end, int) { constraints.rebase(particles, begin, end); }});
  for (uint32_t c = 0; c < colouring.colourCount(); ++c) {
    const size_t first = colouring.colourStart[c];
    substepping_.push_back({colouring.colourStart[c + 1] - first, kBatchGrain,
                            [&constraints, first](size_t begin, size_t end, int) {
                              constraints.project(first + begin, first + end);
                            }});
  }
}

void Simulation::State::makeStages() {
  substepping_.push_back({particles.count(), kVertexGrain, [this](size_t begin, size_t end, int repeat) {
                            advance(particles, static_cast<uint32_t>(begin), static_cast<uint32_t>(end),
                                    {repeat > 0, true});
                          }});
  if (bending) {
    const auto damping = static_cast<float>(std::min(options.damping * substep, 1.0));
    substepping_.push_back(
        {bending->edgeCount(), kVertexGrain, [this, damping](size_t begin, size_t end, int repeat) {
           bending->advanceTurns(begin, end, {repeat > 0, true}, damping);
         }});
  }
  if (edges) addStages(*edges);
  if (membrane) addStages(*membrane);
  if (bending) addStages(*bending);
  substepping_.push_back({1, 1, [this](size_t, size_t, int repeat) {
                            if (volume) volume->project(particles);
                            heldPoints.project(particles, repeat);
                            dragged.project(particles, repeat);
                            if (selfContacts) selfContacts->project(particles);
                            contacts.project(particles);
                          }});
}

void Simulation::State::setAccelerations() {
  const auto& inverseMass = particles.inverseMass;
  std::vector<Vec3> blown;
  if (squaredLength(wind) > 0)
    blown =
        windAcceleration({mesh.triangles, particles.positions, velocities(), masses, closed}, wind, kStep);
  for (uint32_t v = 0; v < particles.count(); ++v) {
    const Vec3 acceleration = blown.empty() ? gravity : gravity + blown[v];
    particles.acceleration[v] = inverseMass[v] > 0 ? toFloat4(acceleration * (substep * substep)) : Float4{};
  }
}

void Simulation::State::startPins() {
  for (size_t i = 0; i < pins.vertices.size(); ++i) {
    const uint32_t v = pins.vertices[i];
    particles.motion[v].q = toFloat4((pinTargets[i] - particles.positions[v]) / options.substeps);
  }
  for (size_t i = 0; i < pins.points.size(); ++i) {
    const Vec3& target = pinTargets[pins.vertices.size() + i];
    heldPoints.rebase(i, particles, {pinStarts[i], target}, options.substeps);
    pinStarts[i] = target;
  }
  if (dragged.count()) {
    const Vec3 from = dragged.position(0, particles);
    dragged.rebase(0, particles, {from, from + (dragTarget - from) * kDragPace}, options.substeps);
  }
}

void Simulation::State::step(const Job& job) {
  const bool isLarge = constraintCount() >= (edges ? kThreadedEdges : kThreadedTriangles);
  const bool threaded = isLarge && threadCount() > 1 && threadChoice_.threaded();
  const auto start = std::chrono::steady_clock::now();
  setAccelerations();
  startPins();
  contacts.rebase(particles, obstacles, kContactReach * bounds(mesh).diagonal(), options.substeps);
  if (volume) volume->rebase(particles);
  if (selfContacts) selfContacts->rebase(particles, options.substeps);
  runStages(rebasing_, 1, threaded, job);
  runStages(substepping_, options.substeps, threaded, job);
  advance(particles, 0, particles.count(), {true, false});
  if (bending) bending->advanceTurns(0, bending->edgeCount(), {true, false}, 0);
  finishStep(particles, 0, particles.count());
  for (size_t i = 0; i < pins.vertices.size(); ++i) particles.positions[pins.vertices[i]] = pinTargets[i];
  threadChoice_.tell(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

Vec3 Simulation::State::velocity(uint32_t v) const {
  const Float4 q = particles.motion[v].q;
  return Vec3{double{q[0]}, double{q[1]}, double{q[2]}} / substep;
}

std::vector<Vec3> Simulation::State::velocities() const {
  std::vector<Vec3> all(particles.count());
  for (uint32_t v = 0; v < particles.count(); ++v) all[v] = velocity(v);
  return all;
}

uint32_t Simulation::State::constraintCount() const {
  if (edges) return edges->count();
  return membrane->count() + bending->count() + (volume ? volume->count() : 0);
}

double Simulation::State::elasticEnergy() const {
  if (edges) return edges->energy(particles.positions);
  return membrane->energy(particles.positions) + bending->energy(particles.positions) +
         (volume ? volume->energy(particles.positions) : 0);
}

}  // namespace limber
