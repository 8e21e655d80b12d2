#include "fit/tune/trial/trial_scenes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fit/tune/trial/swing_spectrum.h"

namespace limber {
namespace {

constexpr double kPeriods = 1.5;
constexpr uint32_t kStepsPerPeriod = 40;
constexpr double kSwaySize = 0.04;  // of the diagonal, at the peak
constexpr double kMaxBorder = 0.5;  // of the diagonal: the border of a body with small holes
constexpr double kGravity = 9.81;   // m/s2

double diagonalOf(const MovingBody& body) {
  return bounds(body.mesh).diagonal() * body.constants.unit;
}

Scenario scenarioOf(const MovingBody& original, const char* name) {
  return {.kind = scenarioKind(name),
          .box = bounds(original.mesh),
          .seconds = 1,
          .unit = original.constants.unit};
}

// The initial velocity for finding the lowest frequency of hanging bodies: across the body, growing with the
// square of the distance from the pins' centre.
std::vector<Vec3> velocitiesFromPins(const MovingBody& original, const TrialScene& scene) {
  Vec3 centre;
  for (const uint32_t v : scene.pins.vertices)
    centre += original.mesh.positions[v] / static_cast<double>(scene.pins.vertices.size());
  Vec3 across;
  across[scene.scenario.across()] = 1;
  std::vector<Vec3> velocities;
  for (const Vec3& p : original.mesh.positions) velocities.push_back(across * squaredLength(p - centre));
  return velocities;
}

std::vector<Vec3> swayVelocities(const MovingBody& original, const TrialScene& scene) {
  std::vector<Vec3> velocities;
  for (const Vec3& p : original.mesh.positions) velocities.push_back(initialVelocity(scene.scenario, p));
  return velocities;
}

// The duration for Morley's shell comes from hinges that have the same energy when bent around a cylinder:
// hinges by area have three times the energy of a plate with their constant.
SolverConstraints timingConstraints(const MovingBody& original, SolverModel model) {
  SolverConstants constants = original.constants;
  if (model.bend == BendElement::Morley) {
    model.bend = BendElement::HingeByArea;
    constants.bend /= 3;
  }
  return {original.mesh, original.topology, model, constants};
}

void setDuration(TrialScene& scene, double omega) {
  scene.step = 2 * std::numbers::pi / omega / kStepsPerPeriod;
  scene.stepCount = static_cast<uint32_t>(kPeriods * kStepsPerPeriod);
}

// Returns false if nothing swings.
bool timeScene(TrialScene& scene, const MovingBody& original, const SolverModel& model, Job& job) {
  const SolverConstraints constraints = timingConstraints(original, model);
  const std::vector<double> masses = massesOf(original, model);
  ImplicitSystem system({constraints, original.mesh, masses, original.factors, scene.pins}, 0, job);
  if (system.unknownCount() == 0) return false;
  const bool sways = scene.gravity == Vec3{};
  const std::vector<Vec3> velocities =
      sways ? swayVelocities(original, scene) : velocitiesFromPins(original, scene);
  const Swing swing = swingOf(swingSpectrum(system, velocities, job));
  const double diagonal = diagonalOf(original);
  if (sways) {
    if (swing.omega == 0) return false;
    double fastest = 0;
    for (const uint32_t v : system.free()) fastest = std::max(fastest, length(velocities[v]));
    scene.speed = kSwaySize * diagonal / (fastest * swing.seconds);
    scene.motionSize = kSwaySize * diagonal;
    setDuration(scene, swing.omega);
    return true;
  }
  // A rod of the length of the diagonal swings about its end with omega^2 = 3/2 g / L. Stiffnesses add, so
  // the squares of the frequencies add up to a lower bound (Southwell 1922).
  const double squared = swing.omega * swing.omega + 1.5 * kGravity / diagonal;
  scene.motionSize = std::min(diagonal, kGravity / squared);
  setDuration(scene, std::sqrt(squared));
  return true;
}

}  // namespace

bool isNearlyClosed(const TriangleMesh& mesh, const Topology& topology) {
  double border = 0;
  for (const Topology::Edge& edge : topology.edges)
    if (edge.useCount == 1) border += length(mesh.positions[edge.a] - mesh.positions[edge.b]);
  return border < kMaxBorder * bounds(mesh).diagonal();
}

std::vector<TrialScene> trialScenes(const MovingBody& original, const SolverModel& model, Job& job) {
  const bool isClosed = isNearlyClosed(original.mesh, original.topology),
             isPinned = original.pins.count() > 0;
  std::vector<TrialScene> scenes;
  if (isClosed) {
    const Scenario sway = scenarioOf(original, "sway");
    scenes.push_back({.name = "sway", .scenario = sway, .pins = {defaultPins(original.mesh, sway), {}}});
  }
  if (!isClosed || isPinned) {
    const Scenario hang = scenarioOf(original, "hang");
    const Pins pins = isPinned ? original.pins : Pins{defaultPins(original.mesh, hang), {}};
    scenes.push_back({.name = "hang",
                      .scenario = hang,
                      .gravity = {0, -kGravity, 0},
                      .usersPins = isPinned,
                      .pins = pins});
  }
  std::erase_if(scenes, [&](TrialScene& scene) { return !timeScene(scene, original, model, job); });
  return scenes;
}

}  // namespace limber
