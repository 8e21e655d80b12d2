#include "simulate/solid/solid_state.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/parallel.h"
#include "elastic/refine_pinned_faces.h"
#include "elastic/solid/lattice_grid.h"
#include "simulate/solid/velocity_fit.h"
#include "simulate/wind.h"

namespace limber {

namespace {

// The number of nodes from which lattices are cut into blocks, and the size of the blocks.
constexpr BlockSizes kBlocksOfNodes = {2500, 800};

// Renumbers the nodes from end to end, so that blocks are ranges.
void renumber(LatticeBody& body) {
  const auto order = orderFromEndToEnd({flattened(body.cells), 8}, static_cast<uint32_t>(body.nodes.size()));
  std::vector<uint32_t> slots(order.size());
  LatticeBody before = body;
  for (uint32_t slot = 0; slot < order.size(); ++slot) {
    slots[order[slot]] = slot;
    body.nodes[slot] = before.nodes[order[slot]];
    body.masses[slot] = before.masses[order[slot]];
  }
  for (auto& cell : body.cells)
    for (uint32_t& node : cell) node = slots[node];
}

}  // namespace

SolidState::SolidState(const TriangleMesh& mesh, const SimulationOptions& options, const Pins& pins, Job& job)
    : options_(options),
      surface_(mesh),
      drawn_(mesh.triangles),
      vertexCount_(mesh.vertexCount()),
      pins_(pins),
      pinnedVertices_(pins.vertices),
      restDiagonal_(bounds(mesh).diagonal() * options.material.unit),
      substep_(kStepSeconds / options.substeps) {
  makeBody(job);
  makeParticles();
  job.check();
  cells_.emplace(body_, particles_,
                 CellConstraints::Options{options.material.young, options.material.poisson, blocks_, substep_,
                                          options.order});
  job.check();
  contacts_.emplace(body_, blocks_);
  makePins();
  makeSchedule();
}

// Pinned faces are refined down to the size of a cell, so that they are pinned everywhere, and then all
// faces, so that contacts are found everywhere on the surface.
void SolidState::makeBody(Job& job) {
  const Vec3 cell = squaredLength(options_.cellSize) > 0 ? options_.cellSize : solidCellSize(surface_);
  refinePinnedFaces(surface_, pinnedVertices_, longestSide(cell), &pinnedParents_);
  std::vector<uint32_t> pinOf(surface_.vertexCount(), kNone);
  for (uint32_t pin = 0; pin < pinnedVertices_.size(); ++pin) pinOf[pinnedVertices_[pin]] = pin;
  for (auto& [a, b] : pinnedParents_) {
    a = pinOf[a];
    b = pinOf[b];
  }
  std::vector<uint32_t> all(surface_.vertexCount());
  std::iota(all.begin(), all.end(), 0u);
  refinePinnedFaces(surface_, all, longestSide(cell));
  job.check();
  body_ = latticeBody(surface_, cell, options_.material, job);
  const auto nodeCount = static_cast<uint32_t>(body_.nodes.size());
  const uint32_t blockCount = blockCountOf(nodeCount, kBlocksOfNodes);
  if (blockCount > 1) renumber(body_);
  blocks_ = blocksOf({flattened(body_.cells), 8}, nodeCount, blockCount);
  for (uint32_t v = 0; v < vertexCount_; ++v) vertices_.push_back(embeddedVertex(body_, v));
}

void SolidState::makeParticles() {
  particles_.positions = body_.nodes;
  const size_t slots = particles_.idle(blocks_.groupCount());
  particles_.inverseMass.assign(slots, 0.0);
  particles_.motion.assign(slots, Motion{});
  particles_.lost.assign(slots, Motion{});
  particles_.acceleration.assign(slots, Float4{});
  particles_.damping.assign(slots, 0.0f);
  const auto damping = static_cast<float>(std::min(options_.damping * substep_, 1.0));
  for (size_t node = 0; node < body_.masses.size(); ++node) {
    particles_.inverseMass[node] = 1 / body_.masses[node];
    particles_.damping[node] = damping;
  }
  double area = 0;
  surfaceMasses_.assign(vertexCount_, 0.0);
  for (const Triangle& t : drawn_) {
    const auto& p = surface_.positions;
    const double own = 0.5 * length(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]));
    for (const uint32_t v : t) surfaceMasses_[v] += own / 3;
    area += own;
  }
  for (double& share : surfaceMasses_) share *= mass() / area;
}

void SolidState::makePins() {
  std::vector<LatticePoint> points;
  for (const uint32_t v : pinnedVertices_) points.push_back(embeddedVertex(body_, v));
  for (const SurfacePoint& point : pins_.points)
    points.push_back(embeddedPoint(body_, drawn_[point.triangle], point.barycentric));
  fixed_.set(particles_, std::move(points));
  for (size_t i = 0; i < fixed_.count(); ++i) pinStarts_.push_back(fixed_.position(i, particles_));
  pinTargets_ = pinStarts_;
}

void SolidState::setPinTargets(std::span<const Vec3> targets) {
  const double unit = options_.material.unit;
  const size_t own = pins_.vertices.size(), refined = pinnedParents_.size();
  for (size_t i = 0; i < own; ++i) pinTargets_[i] = targets[i] * unit;
  for (size_t i = 0; i < refined; ++i) {
    const auto& [a, b] = pinnedParents_[i];
    pinTargets_[own + i] = (pinTargets_[a] + pinTargets_[b]) * 0.5;
  }
  for (size_t i = 0; i < pins_.points.size(); ++i) pinTargets_[own + refined + i] = targets[own + i] * unit;
}

void SolidState::startPins() {
  for (size_t i = 0; i < fixed_.count(); ++i)
    fixed_.rebase(i, particles_, {pinStarts_[i], pinTargets_[i]}, options_.substeps);
  pinStarts_ = pinTargets_;
  if (!dragged_.count()) return;
  const Vec3 from = dragged_.position(0, particles_);
  dragged_.rebase(0, particles_, PointConstraints::dragged(from, dragTarget_), options_.substeps);
}

void SolidState::drag(const SurfacePoint& point, const Vec3& target) {
  dragged_.set(particles_, {embeddedPoint(body_, drawn_[point.triangle], point.barycentric)});
  dragTarget_ = target * options_.material.unit;
}

// The air acts on the vertices, and each node takes its share of their forces.
void SolidState::startWind() {
  windAcceleration_.clear();
  if (squaredLength(wind) == 0) return;
  std::vector<Vec3> positions, velocities;
  for (uint32_t v = 0; v < vertexCount_; ++v) {
    positions.push_back(vertices_[v].position(particles_));
    velocities.push_back(velocity(v));
  }
  const auto pushed =
      windAcceleration({drawn_, positions, velocities, surfaceMasses_, true}, wind, kStepSeconds);
  windAcceleration_.assign(body_.nodes.size(), Vec3{});
  for (uint32_t v = 0; v < vertexCount_; ++v)
    for (size_t i = 0; i < vertices_[v].nodes.size(); ++i) {
      const uint32_t node = vertices_[v].nodes[i];
      windAcceleration_[node] +=
          pushed[v] * (surfaceMasses_[v] * vertices_[v].weights[i] / body_.masses[node]);
    }
}

void SolidState::startGroup(size_t group) {
  const auto& start = cells_->colouring().groupStart;
  if (group < blocks_.count())
    for (uint32_t node = blocks_.start[group]; node < blocks_.start[group + 1]; ++node) {
      const Vec3 acceleration = windAcceleration_.empty() ? gravity : gravity + windAcceleration_[node];
      particles_.acceleration[node] = toFloat4(acceleration * (substep_ * substep_));
    }
  contacts_->rebase(particles_, collisionScene, contactDistance(restDiagonal_, gravity, options_.substeps),
                    group);
  cells_->rebase(particles_, start[group], start[group + 1]);
}

void SolidState::advanceBlock(size_t block, const Advance& what) {
  advance(particles_, blocks_.start[block], blocks_.start[block + 1], what);
}

void SolidState::finishBlock(size_t block) {
  advanceBlock(block, {true, false});
  finishStep(particles_, blocks_.start[block], blocks_.start[block + 1]);
}

void SolidState::projectGroup(size_t group) const {
  const auto& start = cells_->colouring().groupStart;
  cells_->project(start[group], start[group + 1]);
}

// As in SimulationState: the cells of all blocks, then those of all borders, then pins, then contacts.
void SolidState::makeSchedule() {
  const size_t blockCount = blocks_.count(), borderCount = blocks_.borderCount;
  const auto friction = static_cast<float>(options_.friction);
  schedule_.repeats = options_.substeps;
  schedule_.before.push_back(phaseOf(blocks_.groupCount(), [this](size_t group, int) { startGroup(group); }));
  auto& repeated = schedule_.repeated;
  repeated.push_back(phaseOf(blockCount, [this](size_t block, int repeat) {
    advanceBlock(block, {repeat > 0, true});
    projectGroup(block);
  }));
  repeated.push_back(
      phaseOf(borderCount, [this, blockCount](size_t i, int) { projectGroup(blockCount + i); }));
  pointPhase_ = repeated.size();
  repeated.push_back(phaseOf(1, [this](size_t, int repeat) {
    dragged_.project(particles_, repeat);
    fixed_.project(particles_, repeat);  // after the dragged point, which must not move them
  }));
  contactPhase_ = repeated.size();
  repeated.push_back(phaseOf(
      blockCount, [this, friction](size_t block, int) { contacts_->project(particles_, friction, block); }));
  repeated.push_back(phaseOf(borderCount, [this, friction, blockCount](size_t i, int) {
    contacts_->project(particles_, friction, blockCount + i);
  }));
  schedule_.after.push_back(phaseOf(blockCount, [this](size_t block, int) { finishBlock(block); }));
}

void SolidState::step(const Job& job, Helpers* helpers) {
  const bool threaded = blocks_.count() > 1 && threadCount() > 1 && threadChoice_.threaded();
  const auto start = std::chrono::steady_clock::now();
  helpedSeconds_ = 0;
  startWind();
  startPins();
  schedule_.repeated[pointPhase_].count = fixed_.count() || dragged_.count() ? 1 : 0;
  schedule_.repeated[contactPhase_].count = collisionScene.empty() ? 0 : blocks_.count();
  schedule_.repeated[contactPhase_ + 1].count = collisionScene.empty() ? 0 : blocks_.borderCount;
  if (threaded && helpers)
    helpedSeconds_ = helpers->run(schedule_, job);
  else
    runSchedule(schedule_, threaded, job);
  threadChoice_.record(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

Vec3 SolidState::position(uint32_t v) const {
  return vertices_[v].position(particles_) / options_.material.unit;
}

Vec3 SolidState::position(const SurfacePoint& point) const {
  Vec3 sum;
  for (int c = 0; c < 3; ++c) sum += position(drawn_[point.triangle][c]) * point.barycentric[c];
  return sum;
}

Vec3 SolidState::velocity(uint32_t v) const {
  return vertices_[v].motion(particles_) / substep_;
}

void SolidState::setVelocities(std::span<const Vec3> velocities) {
  std::vector<Vec3> wanted(velocities.begin(), velocities.end());
  for (const uint32_t v : pins_.vertices) wanted[v] = {};
  const std::vector<Vec3> fitted = fitVelocities(body_, wanted);
  for (size_t node = 0; node < fitted.size(); ++node) {
    particles_.motion[node].q = toFloat4(fitted[node] * substep_);
    particles_.lost[node].q = Float4{};
  }
}

double SolidState::kineticEnergy() const {
  double sum = 0;
  for (size_t node = 0; node < body_.masses.size(); ++node)
    sum += 0.5 * body_.masses[node] * squaredLength(toVec3(particles_.motion[node].q) / substep_);
  return sum;
}

bool SolidState::isFinite() const {
  for (size_t node = 0; node < body_.masses.size(); ++node)
    if (!limber::isFinite(particles_.positions[node]) || !limber::isFinite(toVec3(particles_.motion[node].q)))
      return false;
  return true;
}

double SolidState::mass() const {
  return std::accumulate(body_.masses.begin(), body_.masses.end(), 0.0);
}

}  // namespace limber
