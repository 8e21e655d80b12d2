#include "simulate/simulation_state.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "simulate/constraints/bending_rest.h"
#include "simulate/constraints/solver_rest.h"
#include "simulate/lumped_masses.h"
#include "simulate/wind.h"

namespace limber {

namespace {

// Bodies with at least this many vertices are cut into blocks: their phases are long enough to pay for
// threads.
constexpr BlockSizes kBlocksOfSprings = {8000, 512}, kBlocksOfShell = {2500, 512};

bool hasEdgeSprings(const SimulationOptions& options) {
  if (options.solver) return options.solver->model.stretch == StretchElement::EdgeSprings;
  return options.model == SimulationModel::Springs;
}

uint32_t blockCountOf(const TriangleMesh& mesh, const SimulationOptions& options) {
  return blockCountOf(mesh.vertexCount(), hasEdgeSprings(options) ? kBlocksOfSprings : kBlocksOfShell);
}

std::vector<uint32_t> slotsOf(const TriangleMesh& mesh, uint32_t blockCount) {
  std::vector<uint32_t> slots(mesh.vertexCount());
  std::iota(slots.begin(), slots.end(), 0u);
  if (blockCount == 1) return slots;
  const auto order = orderFromEndToEnd({flattened(mesh.triangles), 3}, mesh.vertexCount());
  for (uint32_t slot = 0; slot < slots.size(); ++slot) slots[order[slot]] = slot;
  return slots;
}

TriangleMesh inSlots(const TriangleMesh& source, const std::vector<uint32_t>& slotOf, double unit) {
  TriangleMesh mesh = source;
  for (size_t v = 0; v < slotOf.size(); ++v) mesh.positions[slotOf[v]] = source.positions[v] * unit;
  for (Triangle& t : mesh.triangles)
    for (uint32_t& v : t) v = slotOf[v];
  return mesh;
}

std::optional<SimulatedSolver> solverInSlots(const SimulationOptions& options, const TriangleMesh& source,
                                             const std::vector<uint32_t>& slotOf) {
  if (!options.solver) return std::nullopt;
  return renumbered(*options.solver, source, slotOf);
}

// Visits the constraints of `state`, stretching before bending.
template <class State, class Visit>
void forEachKind(State& state, Visit visit) {
  if (state.edges) visit(*state.edges);
  if (state.membrane) visit(*state.membrane);
  if (state.crossSprings) visit(*state.crossSprings);
  if (state.bending) visit(*state.bending);
  if (state.hinges) visit(*state.hinges);
}

// Edges whose first vertex lies in block b: [start[b], start[b + 1]).
std::vector<size_t> edgeStarts(const Topology& topology, const Blocks& blocks) {
  std::vector<size_t> start;
  for (const uint32_t first : blocks.start) {
    const auto edge = std::partition_point(topology.edges.begin(), topology.edges.end(),
                                           [first](const Topology::Edge& e) { return e.a < first; });
    start.push_back(static_cast<size_t>(edge - topology.edges.begin()));
  }
  return start;
}

bool hasNoBorder(const Topology& topology) {
  return std::none_of(topology.edges.begin(), topology.edges.end(),
                      [](const Topology::Edge& edge) { return edge.useCount == 1; });
}

}  // namespace

SimulationState::SimulationState(const TriangleMesh& source, const SimulationOptions& given,
                                 const Pins& givenPins)
    : options(given),
      blockCount(blockCountOf(source, given)),
      slotOf(slotsOf(source, blockCount)),
      mesh(inSlots(source, slotOf, given.material.unit)),
      restDiagonal(bounds(mesh).diagonal()),
      topology(buildTopology(mesh)),
      blocks(blocksOf(mesh, flapsOf(mesh, topology), blockCount)),
      solver(solverInSlots(given, source, slotOf)),
      sheet(solver ? sheetOf(solver->constants) : sheetOf(given.material)),
      substep(kStepSeconds / given.substeps),
      masses(lumpedMasses(mesh, sheet, solver ? &*solver : nullptr)),
      closed(hasNoBorder(topology)),
      contacts(blocks),
      triangleContacts(mesh, blocks),
      pins(givenPins),
      edgeStart_(edgeStarts(topology, blocks)) {
  for (uint32_t& v : pins.vertices) v = slotOf[v];
  makeParticles();
  makeConstraints();
  makePins();
  makeSchedule();
}

void SimulationState::makeParticles() {
  particles.positions = mesh.positions;
  const size_t slots = particles.idle(blocks.groupCount());
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

void SimulationState::makeConstraints() {
  if (options.selfCollision) selfContacts.emplace(mesh, options.friction);
  const ConstraintOptions made = {sheet, blocks, substep, options.order};
  if (!hasEdgeSprings(options))
    membrane.emplace(mesh, solver ? StiffnessFactors(solver->stretchFactors) : StiffnessFactors{}, particles,
                     made);
  else
    edges.emplace(solver ? edgeSprings(*solver, mesh, topology) : paperSprings(mesh, topology, sheet),
                  particles, made);
  if (solver || options.model == SimulationModel::Shell) makeBending(made);
  const double bulkModulus = options.material.young / (3 * (1 - 2 * options.material.poisson));
  if (options.keepsVolume && bending) volume.emplace(mesh, topology, blocks, bulkModulus);
}

void SimulationState::makeBending(const ConstraintOptions& made) {
  const BendElement element = solver ? solver->model.bend : BendElement::Morley;
  if (element == BendElement::CrossSprings)
    crossSprings.emplace(limber::crossSprings(*solver, mesh, topology), particles, made);
  else if (element == BendElement::Morley)
    bending.emplace(mesh, topology, particles, made);
  else
    hinges.emplace(hingesOf(*solver, mesh, topology), mesh, particles, made);
}

void SimulationState::makePins() {
  for (const SurfacePoint& point : pins.points) pinnedPoints.add(mesh, particles, point);
  for (const uint32_t v : pins.vertices) pinTargets.push_back(particles.positions[v]);
  for (size_t i = 0; i < pins.points.size(); ++i) {
    pinTargets.push_back(pinnedPoints.position(i, particles));
    pinStarts.push_back(pinTargets.back());
  }
}

void SimulationState::projectGroup(size_t group) {
  forEachKind(*this, [&](const auto& constraints) {
    const auto& start = constraints.colouring().groupStart;
    constraints.project(start[group], start[group + 1]);
  });
}

void SimulationState::advanceBlock(size_t block, const Advance& what) {
  const uint32_t begin = blocks.start[block], end = blocks.start[block + 1];
  advance(particles, begin, end, what);
  if (!bending) return;
  const auto damping = static_cast<float>(std::min(options.damping * substep, 1.0));
  bending->advanceRotations(edgeStart_[block], edgeStart_[block + 1], what, damping);
}

void SimulationState::startBlock(size_t block) {
  for (uint32_t v = blocks.start[block]; v < blocks.start[block + 1]; ++v) {
    const Vec3 acceleration = windAcceleration_.empty() ? gravity : gravity + windAcceleration_[v];
    const bool isFree = particles.inverseMass[v] > 0;
    particles.acceleration[v] = isFree ? toFloat4(acceleration * (substep * substep)) : Float4{};
  }
  contacts.rebase(particles, collisionScene, contactDistanceNow(), block);
  if (volume) volume->rebase(particles, block);
}

void SimulationState::startGroup(size_t group) {
  if (group < blockCount) startBlock(group);
  triangleContacts.rebase(particles, collisionScene, contactDistanceNow(), group);
  forEachKind(*this, [&](auto& constraints) {
    const auto& start = constraints.colouring().groupStart;
    constraints.rebase(particles, start[group], start[group + 1]);
  });
}

void SimulationState::finishBlock(size_t block) {
  advanceBlock(block, {true, false});
  finishStep(particles, blocks.start[block], blocks.start[block + 1]);
}

void SimulationState::projectContacts(size_t group) {
  const auto friction = static_cast<float>(options.friction);
  if (group < blockCount) contacts.project(particles, friction, group);
  triangleContacts.project(particles, friction, group);
}

// In every substep the constraints of all blocks are solved, then those of all borders, then volumes. Pins
// and contacts come last, so that they are satisfied exactly at the end of the substep.
void SimulationState::makeSchedule() {
  const size_t borderCount = blocks.borderCount;
  schedule_.repeats = options.substeps;
  schedule_.before.push_back(phaseOf(blocks.groupCount(), [this](size_t group, int) { startGroup(group); }));
  auto& repeated = schedule_.repeated;
  repeated.push_back(phaseOf(blockCount, [this](size_t block, int repeat) {
    advanceBlock(block, {repeat > 0, true});
    projectGroup(block);
  }));
  repeated.push_back(phaseOf(borderCount, [this](size_t i, int) { projectGroup(blockCount + i); }));
  if (volume && volume->count()) {
    repeated.push_back(phaseOf(blockCount, [this](size_t block, int) { volume->measure(particles, block); }));
    repeated.push_back(
        phaseOf(borderCount, [this](size_t i, int) { volume->measure(particles, blockCount + i); }));
    repeated.push_back(phaseOf(blockCount, [this](size_t block, int) { volume->weigh(particles, block); }));
    repeated.push_back(
        phaseOf(blockCount, [this](size_t block, int) { volume->apply(particles, block, substep); }));
  }
  pointPhase_ = repeated.size();
  repeated.push_back(phaseOf(1, [this](size_t, int repeat) {
    dragged.project(particles, repeat);
    pinnedPoints.project(particles, repeat);  // after the dragged point, which must not move them
    if (selfContacts) selfContacts->project(particles);
  }));
  contactPhase_ = repeated.size();
  repeated.push_back(phaseOf(blockCount, [this](size_t block, int) { projectContacts(block); }));
  repeated.push_back(phaseOf(borderCount, [this](size_t i, int) { projectContacts(blockCount + i); }));
  schedule_.after.push_back(phaseOf(blockCount, [this](size_t block, int) { finishBlock(block); }));
}

void SimulationState::startWind() {
  windAcceleration_.clear();
  if (squaredLength(wind) > 0)
    windAcceleration_ = windAcceleration({mesh.triangles, particles.positions, velocities(), masses, closed},
                                         wind, kStepSeconds);
}

void SimulationState::startPins() {
  for (size_t i = 0; i < pins.vertices.size(); ++i) {
    const uint32_t v = pins.vertices[i];
    particles.motion[v].q = toFloat4((pinTargets[i] - particles.positions[v]) / options.substeps);
  }
  for (size_t i = 0; i < pins.points.size(); ++i) {
    const Vec3& target = pinTargets[pins.vertices.size() + i];
    pinnedPoints.rebase(i, particles, {pinStarts[i], target}, options.substeps);
    pinStarts[i] = target;
  }
  if (dragged.count()) {
    const Vec3 from = dragged.position(0, particles);
    dragged.rebase(0, particles, PointConstraints::dragged(from, dragTarget), options.substeps);
  }
}

void SimulationState::step(const Job& job, Helpers* helpers) {
  const bool threaded = blockCount > 1 && threadCount() > 1 && threadChoice_.threaded();
  const auto start = std::chrono::steady_clock::now();
  helpedSeconds = 0;
  startWind();
  startPins();
  if (selfContacts) selfContacts->rebase(particles, options.substeps);
  schedule_.repeated[pointPhase_].count = pinnedPoints.count() || dragged.count() || selfContacts ? 1 : 0;
  schedule_.repeated[contactPhase_].count = collisionScene.empty() ? 0 : blockCount;
  schedule_.repeated[contactPhase_ + 1].count = collisionScene.colliders.empty() ? 0 : blocks.borderCount;
  if (threaded && helpers)
    helpedSeconds = helpers->run(schedule_, job);
  else
    runSchedule(schedule_, threaded, job);
  for (size_t i = 0; i < pins.vertices.size(); ++i) particles.positions[pins.vertices[i]] = pinTargets[i];
  threadChoice_.record(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

Vec3 SimulationState::velocity(uint32_t v) const {
  return toVec3(particles.motion[v].q) / substep;
}

std::vector<Vec3> SimulationState::velocities() const {
  std::vector<Vec3> all(particles.count());
  for (uint32_t v = 0; v < particles.count(); ++v) all[v] = velocity(v);
  return all;
}

uint32_t SimulationState::constraintCount() const {
  uint32_t count = volume ? volume->count() : 0;
  forEachKind(*this, [&](const auto& constraints) { count += constraints.count(); });
  return count;
}

double SimulationState::elasticEnergy() const {
  double energy = volume ? volume->energy(particles.positions) : 0;
  forEachKind(*this, [&](const auto& constraints) { energy += constraints.energy(particles.positions); });
  return energy;
}

}  // namespace limber
