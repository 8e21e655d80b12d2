#include "simulate/scenario.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "mesh/topology.h"

namespace limber {

// Null functions mean: pins do not move, no initial velocity, no gravity, still air, nothing to touch.
struct ScenarioKind {
  std::string_view name;
  bool pinsLowerEnd = false, pinsUpperEnd = false;
  bool laysFlat = false;
  bool touchesItself = false;                                                   // closed bodies do
  Vec3 (*pinTarget)(const Scenario&, const Vec3& rest, double time) = nullptr;  // of pins in the upper half
  Vec3 (*initialVelocity)(const Scenario&, const Vec3& rest) = nullptr;         // m/s
  Vec3 (*gravity)(const Scenario&) = nullptr;                                   // m/s2
  Vec3 (*wind)(const Scenario&, double time) = nullptr;                         // m/s
  void (*addToScene)(const Scenario&, CollisionScene&) = nullptr;
};

namespace {

constexpr double kPinnedShare = 0.06;  // of the length of the axis, at an end
constexpr double kMovingShare = 0.7;   // of the time, in which pins move
constexpr double kTwistAngle = std::numbers::pi / 4;
constexpr double kStretchShare = 0.2;  // of the length of the axis
constexpr double kBlowSpeed = 0.5;     // diagonals per second
constexpr double kDropHeight = 0.3;    // diagonals
constexpr double kGravity = -9.81;     // m/s2
// Radius of the ball and gap above it, in diagonals.
constexpr double kBallRadius = 0.2, kBallGap = 0.01;
// m/s, seconds, share of the speed, gusts per second.
constexpr double kWindSpeed = 8, kWindRise = 0.25, kGust = 1.0 / 3, kGustRate = 0.8;

// Rises from 0 to 1 with zero velocity at both ends.
double eased(double share) {
  const double s = std::clamp(share, 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

// The completed share of the pins' motion, in [0, 1].
double motionDone(const Scenario& scenario, double time) {
  return eased(time / (kMovingShare * scenario.seconds));
}

Vec3 sizeOf(const Scenario& scenario) {
  return scenario.box.high - scenario.box.low;
}

Vec3 centreOf(const Scenario& scenario) {
  return (scenario.box.low + scenario.box.high) * 0.5;
}

Vec3 alongAxis(int axis, double size) {
  Vec3 v;
  v[axis] = size;
  return v;
}

Vec3 twistedTarget(const Scenario& scenario, const Vec3& rest, double time) {
  const double angle = kTwistAngle * motionDone(scenario, time);
  const int axis = scenario.axis(), u = (axis + 1) % 3, v = (axis + 2) % 3;
  const Vec3 centre = centreOf(scenario), arm = rest - centre;
  Vec3 target = rest;
  target[u] = centre[u] + std::cos(angle) * arm[u] - std::sin(angle) * arm[v];
  target[v] = centre[v] + std::sin(angle) * arm[u] + std::cos(angle) * arm[v];
  return target;
}

Vec3 stretchedTarget(const Scenario& scenario, const Vec3& rest, double time) {
  const int axis = scenario.axis();
  return rest + alongAxis(axis, kStretchShare * sizeOf(scenario)[axis] * motionDone(scenario, time));
}

Vec3 blowVelocity(const Scenario& scenario, const Vec3& rest) {
  const int axis = scenario.axis();
  const double height = (rest[axis] - scenario.box.low[axis]) / sizeOf(scenario)[axis];
  return alongAxis(scenario.across(), kBlowSpeed * scenario.box.diagonal() * scenario.unit * height * height);
}

Vec3 gravityAlongY(const Scenario&) {
  return {0, kGravity, 0};
}

Vec3 gusts(const Scenario& scenario, double time) {
  const double gust = 1 + kGust * std::sin(2 * std::numbers::pi * kGustRate * time);
  return alongAxis(scenario.across(), kWindSpeed * gust * eased(time / kWindRise));
}

void addFloor(const Scenario& scenario, CollisionScene& scene) {
  if (!scene.ground) scene.ground = scenario.box.low.y - kDropHeight * scenario.box.diagonal();
}

// Under the centre of the posed box, on a floor, so that a body that slides off does not fall for ever.
void addBall(const Scenario& scenario, CollisionScene& scene) {
  const Bounds box = scenario.pose ? scenario.pose->box : scenario.box;
  const double diagonal = scenario.box.diagonal(), radius = kBallRadius * diagonal;
  Vec3 centre = (box.low + box.high) * 0.5;
  centre.y = box.low.y - kBallGap * diagonal - radius;
  scene.colliders.push_back({centre, centre, radius});
  if (!scene.ground) scene.ground = centre.y - radius;
}

constexpr std::array<ScenarioKind, 7> kScenarios = {{
    {.name = "twist", .pinsLowerEnd = true, .pinsUpperEnd = true, .pinTarget = twistedTarget},
    {.name = "sway", .pinsLowerEnd = true, .initialVelocity = blowVelocity},
    {.name = "hang", .pinsUpperEnd = true, .gravity = gravityAlongY},
    {.name = "drop", .touchesItself = true, .gravity = gravityAlongY, .addToScene = addFloor},
    {.name = "pull", .pinsLowerEnd = true, .pinsUpperEnd = true, .pinTarget = stretchedTarget},
    {.name = "wind", .pinsUpperEnd = true, .gravity = gravityAlongY, .wind = gusts},
    {.name = "drape", .laysFlat = true, .gravity = gravityAlongY, .addToScene = addBall},
}};

}  // namespace

const ScenarioKind* scenarioKind(std::string_view name) {
  const auto found = std::ranges::find(kScenarios, name, &ScenarioKind::name);
  if (found != kScenarios.end()) return &*found;
  std::string names;
  for (const ScenarioKind& kind : kScenarios) (names += names.empty() ? "" : ", ") += kind.name;
  throw std::invalid_argument("There is no scenario \"" + std::string(name) + "\": take one of " + names +
                              ".");
}

std::vector<std::string> scenarioNames() {
  std::vector<std::string> names;
  for (const ScenarioKind& kind : kScenarios) names.emplace_back(kind.name);
  return names;
}

int Scenario::axis() const {
  return box.longestAxis();
}

int Scenario::across() const {
  const Vec3 size = sizeOf(*this);
  int shortest = 2;
  for (int c = 1; c >= 0; --c)
    if (size[c] < size[shortest]) shortest = c;
  // In a cube, too, the axis and the direction across it must differ.
  return shortest == axis() ? (shortest + 1) % 3 : shortest;
}

std::vector<uint32_t> defaultPins(const TriangleMesh& mesh, const Scenario& scenario) {
  const int axis = scenario.axis();
  const double low = scenario.box.low[axis], high = scenario.box.high[axis];
  const double depth = kPinnedShare * (high - low);
  const ScenarioKind& kind = *scenario.kind;
  std::vector<uint32_t> pins;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const double height = mesh.positions[v][axis];
    const bool isPinned =
        (kind.pinsLowerEnd && height <= low + depth) || (kind.pinsUpperEnd && height >= high - depth);
    if (isPinned) pins.push_back(v);
  }
  return pins;
}

std::optional<Pose> startPose(const ScenarioKind* kind, const TriangleMesh& original) {
  return kind->laysFlat && original.vertexCount() > 0 ? std::optional(layFlat(original)) : std::nullopt;
}

bool touchesItself(const Scenario& scenario, const TriangleMesh& mesh) {
  if (!scenario.kind->touchesItself) return false;
  const Topology topology = buildIncidence(mesh);
  return std::ranges::none_of(topology.edges, [](const auto& edge) { return edge.useCount == 1; });
}

Vec3 posed(const Scenario& scenario, const Vec3& point) {
  return scenario.pose ? scenario.pose->of(point) : point;
}

TriangleMesh posed(const Scenario& scenario, const TriangleMesh& mesh) {
  TriangleMesh out = mesh;
  for (Vec3& p : out.positions) p = posed(scenario, p);
  return out;
}

Vec3 pinTarget(const Scenario& scenario, const Vec3& rest, double time) {
  const int axis = scenario.axis();
  const bool moves = scenario.kind->pinTarget && rest[axis] > centreOf(scenario)[axis];
  return moves ? scenario.kind->pinTarget(scenario, rest, time) : rest;
}

Vec3 initialVelocity(const Scenario& scenario, const Vec3& rest) {
  return scenario.kind->initialVelocity ? scenario.kind->initialVelocity(scenario, rest) : Vec3{};
}

CollisionScene collisionSceneOf(const Scenario& scenario) {
  CollisionScene scene = scenario.added;
  if (scenario.kind->addToScene) scenario.kind->addToScene(scenario, scene);
  return scene;
}

void startScenario(const Scenario& scenario, std::span<const Vec3> restPositions, Simulation& simulation) {
  std::vector<Vec3> velocities;
  for (const Vec3& rest : restPositions) velocities.push_back(initialVelocity(scenario, rest));
  simulation.setVelocities(velocities);
  simulation.setGravity(scenario.kind->gravity ? scenario.kind->gravity(scenario) : Vec3{});
  const CollisionScene scene = collisionSceneOf(scenario);
  if (scene.ground) simulation.setGround(*scene.ground);
  simulation.setColliders(scene.colliders);
}

void prepareStep(const Scenario& scenario, double time, std::span<const Vec3> pinRest,
                 Simulation& simulation) {
  std::vector<Vec3> targets;
  for (const Vec3& rest : pinRest) targets.push_back(pinTarget(scenario, rest, time + Simulation::kStep));
  simulation.setPinTargets(targets);
  if (scenario.kind->wind) simulation.setWind(scenario.kind->wind(scenario, time));
}

}  // namespace limber
