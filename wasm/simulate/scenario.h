#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "simulate/simulation.h"

namespace limber {

enum class ScenarioKind : int32_t { Twist = 0, Sway = 1, Hang = 2, Drop = 3, Pull = 4, Wind = 5, Drape = 6 };

// What a body can touch, in units of the mesh.
struct CollisionScene {
  std::optional<double> ground = {};  // height of a floor across y
  std::vector<Collider> colliders = {};
};

// A motion that any body can be put through: a pure function of the body's box and the time, so that two
// bodies of one box are treated alike. The axis is the box's longest side (the first of equal ones).
//   twist  the upper half of the pins turns about the axis by 45 degrees within 0.7 of the time, and stays
//   sway   the body is struck across the axis: velocity 0.5 diagonals per second at the far end, falling with
//          the square of the height above the lower end
//   hang   gravity, 9.81 m/s2 along -y
//   drop   gravity, and a floor 0.3 diagonals below the box
//   pull   the upper half of the pins moves along the axis by a fifth of its length within 0.7 of the time
//   wind   gravity, and wind across the axis that rises to 8 m/s within a quarter of a second and gusts by a
//          third, 0.8 times a second
//   drape  gravity along the shortest side, onto a ball of a fifth of a diagonal under the middle
struct Scenario {
  ScenarioKind kind;
  Bounds box;                 // of the original, in units of the mesh
  double seconds;             // of the whole motion
  double unit = 1;            // metres per unit of the mesh
  CollisionScene added = {};  // to what the scenario has by itself; a floor in place of its own

  int axis() const;
  // The axis that sway and wind run along: the box's shortest side (the last of equal ones).
  int across() const;
};

// What a scenario pins when nobody says so: vertices within 6 % of the axis' length of its lower end, or of
// its upper end, or of both. Nothing for drop and drape.
std::vector<uint32_t> defaultPins(const TriangleMesh& mesh, const Scenario& scenario);

// Where a pin that rests at `rest` is at `time`, in units of the mesh.
Vec3 pinTarget(const Scenario& scenario, const Vec3& rest, double time);

// m/s, of a point that rests at `rest`, at time 0.
Vec3 initialVelocity(const Scenario& scenario, const Vec3& rest);

// Everything the body can touch, which does not move.
CollisionScene collisionSceneOf(const Scenario& scenario);

// Gravity, collisionScene and initial velocities; before the first step.
void startScenario(const Scenario& scenario, std::span<const Vec3> restPositions, Simulation& simulation);

// Pins and wind of the step that begins at `time`; `pinRest` as the pins of the simulation come.
void prepareStep(const Scenario& scenario, double time, std::span<const Vec3> pinRest,
                 Simulation& simulation);

}  // namespace limber
