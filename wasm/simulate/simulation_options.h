#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/vec3.h"
#include "elastic/material.h"
#include "mesh/surface_point.h"
#include "simulate/simulated_solver.h"

namespace limber {

// The duration of one step, whatever the number of substeps.
inline constexpr double kStepSeconds = 1.0 / 60;
inline constexpr int kMaxSubsteps = 10000;  // of a step

// Shell: membrane and bending of a thin plate, the same material on every mesh. Springs: on the edges, as in
// the paper (see paperSprings), a different material on every mesh. Solid: a lattice through the inside of
// closed components, in which the surface is embedded; open components are shells.
enum class SimulationModel : int32_t { Springs = 0, Shell = 1, Solid = 2 };

// Positions and lengths of the mesh, of pins and of colliders are in units of the mesh; everything else is in
// SI units. Defaults and ranges that users see are only defined in web/engine/settings/table.ts.
struct SimulationOptions {
  ElasticMaterial material;
  SimulationModel model = SimulationModel::Shell;
  // A solver model (elastic/solvers) instead of `model`. Its constants replace the material, which must have
  // the same unit. Only Morley's shell keeps volumes.
  std::optional<SimulatedSolver> solver = {};
  int substeps = 0;         // per step, 1 to 10,000; callers must set it
  double damping = 0;       // 1/s, >= 0: the rate at which velocities decay
  double friction = 0;      // Coulomb's coefficient, >= 0, against the ground, colliders and the body itself
  bool keepsVolume = true;  // closed components of a shell behave as if filled with the material
  bool selfCollision = false;  // parts of the body repel each other, see SelfContacts
  // Solid: the size of the lattice's cells, in units of the mesh. Original and result need the same size, see
  // solidCellSize; 0 derives it from the mesh itself.
  Vec3 cellSize = {};
  uint32_t order = 0;  // 0 solves constraints in the order of the mesh, n > 0 in the n-th shuffled order
};

// Where a body is pinned: at vertices and at points of its surface.
struct Pins {
  std::vector<uint32_t> vertices = {};
  std::vector<SurfacePoint> points = {};
  size_t count() const { return vertices.size() + points.size(); }
};

}  // namespace limber
