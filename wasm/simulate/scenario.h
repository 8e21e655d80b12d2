#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "simulate/collision_scene.h"
#include "simulate/pose.h"
#include "simulate/simulation.h"

namespace limber {

// One row of the table of scenarios in scenario.cpp: its name, pins, loads and collision scene. A new
// scenario needs a row there, and a row in web/engine/core/scenarios.ts.
//   twist  The pins of the upper half rotate about the axis by 45 degrees within 0.7 of the time, then stay.
//   sway   The initial velocity is across the axis, 0.5 diagonals per second at the upper end, and grows with
//          the square of the height above the lower end.
//   hang   Gravity, 9.81 m/s2 along -y.
//   drop   Gravity, and a floor 0.3 diagonals below the box. Closed bodies collide with themselves, so that
//          legs do not enter bellies.
//   pull   The pins of the upper half move along the axis by a fifth of its length within 0.7 of the time.
//   wind   Gravity, and wind across the axis that rises to 8 m/s within a quarter of a second and gusts by a
//          third, 0.8 times per second.
//   drape  Laid flat (see layFlat) above a ball of a fifth of a diagonal on a floor; gravity.
struct ScenarioKind;

// Never null. Throws std::invalid_argument with the known names if there is no scenario of this name.
const ScenarioKind* scenarioKind(std::string_view name);
// In the order of the table.
std::vector<std::string> scenarioNames();

// A motion that can be applied to any body. It is a pure function of the box of the original and of time, so
// that the original and its result are treated identically. The axis is the longest side of the box (the
// first of equal ones), and its lower end is the one with the lower coordinate.
struct Scenario {
  const ScenarioKind* kind = nullptr;
  Bounds box = {};                // of the original, in units of the mesh
  double seconds = 0;             // of the whole motion, > 0
  double unit = 1;                // metres per unit of the mesh
  CollisionScene added = {};      // added to the scenario's own scene; its ground replaces the scenario's
  std::optional<Pose> pose = {};  // see startPose; none: the body is not rotated

  int axis() const;
  // The direction of sway and wind: the shortest side of the box (the last of equal ones).
  int across() const;
};

// The vertices of the original that a scenario pins by default, ascending: those within 6 % of the length of
// the axis of its lower end, of its upper end, or of both. None for drop and drape.
std::vector<uint32_t> defaultPins(const TriangleMesh& mesh, const Scenario& scenario);

// The pose of the original at the start of a scenario of this kind; none if it is not rotated.
std::optional<Pose> startPose(const ScenarioKind* kind, const TriangleMesh& original);
// Whether the body collides with itself regardless of SimulationOptions.
bool touchesItself(const Scenario& scenario, const TriangleMesh& mesh);
// A point or a mesh in the pose of the scenario.
Vec3 posed(const Scenario& scenario, const Vec3& point);
TriangleMesh posed(const Scenario& scenario, const TriangleMesh& mesh);

// The position of a pin with the rest position `rest` at `time` (seconds), in units of the mesh.
Vec3 pinTarget(const Scenario& scenario, const Vec3& rest, double time);

// The velocity at time 0 of a point with the rest position `rest`, in m/s.
Vec3 initialVelocity(const Scenario& scenario, const Vec3& rest);

// Everything that the body can touch: the scenario's own scene and the added one. Units of the mesh.
CollisionScene collisionSceneOf(const Scenario& scenario);

// Sets gravity, the collision scene and the initial velocities. Must be called before the first step.
void startScenario(const Scenario& scenario, std::span<const Vec3> restPositions, Simulation& simulation);

// Sets pin targets and wind for the step that begins at `time` (seconds). `pinRest`: the rest positions of
// the pins in the order of Simulation::setPinTargets.
void prepareStep(const Scenario& scenario, double time, std::span<const Vec3> pinRest,
                 Simulation& simulation);

}  // namespace limber
