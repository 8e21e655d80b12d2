#include "simulate/scenario.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limber {

namespace {

constexpr double kPinnedShare = 0.06, kMovingShare = 0.7;
constexpr double kTurn = std::numbers::pi / 4, kPull = 0.2, kStrike = 0.5, kDropHeight = 0.3;
// Of the ball and of the gap above it, in diagonals.
constexpr double kBallRadius = 0.2, kBallGap = 0.01;
constexpr double kWindSpeed = 8, kWindRise = 0.25, kGust = 1.0 / 3, kGustRate = 0.8;

// From 0 to 1 with no velocity at either end.
double eased(double share) {
  const double s = std::clamp(share, 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

double moved(const Scenario& scenario, double time) {
  return eased(time / (kMovingShare * scenario.seconds));
}

Vec3 sizeOf(const Scenario& scenario) {
  return scenario.box.high - scenario.box.low;
}

Vec3 alongAxis(int axis, double size) {
  Vec3 v;
  v[axis] = size;
  return v;
}

// m/s2.
Vec3 gravityOf(const Scenario& scenario) {
  switch (scenario.kind) {
    case ScenarioKind::Hang:
    case ScenarioKind::Drop:
    case ScenarioKind::Wind:
      return {0, -9.81, 0};
    case ScenarioKind::Drape:
      return alongAxis(scenario.across(), -9.81);
    default:
      return {};
  }
}

// Under the middle of the box, as gravity has it.
Collider ballUnder(const Scenario& scenario) {
  const int down = scenario.across();
  const double diagonal = scenario.box.diagonal(), radius = kBallRadius * diagonal;
  Vec3 centre = (scenario.box.low + scenario.box.high) * 0.5;
  centre[down] = scenario.box.low[down] - kBallGap * diagonal - radius;
  return {centre, centre, radius};
}

}  // namespace

int Scenario::axis() const {
  const Vec3 size = sizeOf(*this);
  int longest = 0;
  for (int c = 1; c < 3; ++c)
    if (size[c] > size[longest]) longest = c;
  return longest;
}

int Scenario::across() const {
  const Vec3 size = sizeOf(*this);
  int shortest = 2;
  for (int c = 1; c >= 0; --c)
    if (size[c] < size[shortest]) shortest = c;
  // A cube's axis and the side across it must not be one.
  return shortest == axis() ? (shortest + 1) % 3 : shortest;
}

std::vector<uint32_t> defaultPins(const TriangleMesh& mesh, const Scenario& scenario) {
  const int axis = scenario.axis();
  const double low = scenario.box.low[axis], high = scenario.box.high[axis];
  const double depth = kPinnedShare * (high - low);
  const ScenarioKind kind = scenario.kind;
  const bool both = kind == ScenarioKind::Twist || kind == ScenarioKind::Pull;
  const bool lower = both || kind == ScenarioKind::Sway;
  const bool upper = both || kind == ScenarioKind::Hang || kind == ScenarioKind::Wind;
  std::vector<uint32_t> pins;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const double place = mesh.positions[v][axis];
    if ((lower && place <= low + depth) || (upper && place >= high - depth)) pins.push_back(v);
  }
  return pins;
}

Vec3 pinTarget(const Scenario& scenario, const Vec3& rest, double time) {
  const int axis = scenario.axis();
  const Vec3 centre = (scenario.box.low + scenario.box.high) * 0.5;
  if (rest[axis] <= centre[axis]) return rest;
  if (scenario.kind == ScenarioKind::Pull)
    return rest + alongAxis(axis, kPull * sizeOf(scenario)[axis] * moved(scenario, time));
  if (scenario.kind != ScenarioKind::Twist) return rest;
  const double angle = kTurn * moved(scenario, time);
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const Vec3 arm = rest - centre;
  Vec3 turned = rest;
  turned[u] = centre[u] + std::cos(angle) * arm[u] - std::sin(angle) * arm[v];
  turned[v] = centre[v] + std::sin(angle) * arm[u] + std::cos(angle) * arm[v];
  return turned;
}

Vec3 initialVelocity(const Scenario& scenario, const Vec3& rest) {
  if (scenario.kind != ScenarioKind::Sway) return {};
  const int axis = scenario.axis();
  const double height = (rest[axis] - scenario.box.low[axis]) / sizeOf(scenario)[axis];
  return alongAxis(scenario.across(), kStrike * scenario.box.diagonal() * scenario.unit * height * height);
}

CollisionScene collisionSceneOf(const Scenario& scenario) {
  CollisionScene all = scenario.added;
  if (scenario.kind == ScenarioKind::Drop && !all.ground)
    all.ground = scenario.box.low.y - kDropHeight * scenario.box.diagonal();
  if (scenario.kind == ScenarioKind::Drape) all.colliders.push_back(ballUnder(scenario));
  return all;
}

void startScenario(const Scenario& scenario, std::span<const Vec3> restPositions, Simulation& simulation) {
  std::vector<Vec3> velocities;
  for (const Vec3& rest : restPositions) velocities.push_back(initialVelocity(scenario, rest));
  simulation.setVelocities(velocities);
  simulation.setGravity(gravityOf(scenario));
  const CollisionScene collisionScene = collisionSceneOf(scenario);
  if (collisionScene.ground) simulation.setGround(*collisionScene.ground);
  simulation.setColliders(collisionScene.colliders);
}

void prepareStep(const Scenario& scenario, double time, std::span<const Vec3> pinRest,
                 Simulation& simulation) {
  std::vector<Vec3> targets;
  for (const Vec3& rest : pinRest) targets.push_back(pinTarget(scenario, rest, time + Simulation::kStep));
  simulation.setPinTargets(targets);
  if (scenario.kind != ScenarioKind::Wind) return;
  const double gust = 1 + kGust * std::sin(2 * std::numbers::pi * kGustRate * time);
  simulation.setWind(alongAxis(scenario.across(), kWindSpeed * gust * eased(time / kWindRise)));
}

}  // namespace limber
