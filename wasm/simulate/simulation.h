#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/job.h"
#include "mesh/surface_point.h"
#include "mesh/triangle_mesh.h"

namespace limber {

class Helpers;

enum class Material : int32_t { Springs = 0, Shell = 1 };

// Positions and lengths of the mesh, of pins and of colliders are in the mesh's own units; all else is SI.
struct SimulationOptions {
  Material material = Material::Shell;
  double young = 0;            // Pa, > 0
  double poisson = 0;          // in (-1, 0.5)
  double density = 0;          // kg/m3, > 0
  double thickness = 0;        // units of the mesh, > 0
  double unit = 1;             // metres per unit of the mesh, > 0
  int substeps = 20;           // of a step, 1 to 10,000
  double damping = 0;          // 1/s: velocities fall by this rate
  double friction = 0.5;       // Coulomb's, against the ground and colliders
  bool keepsVolume = true;     // of closed components of a shell, as if filled with the material
  bool selfCollision = false;  // sheets push each other away, see SelfContacts
  uint32_t order = 0;          // of the constraints: 0 as they come, any other number an order of its own
};

// A capsule around the segment from -> to; a ball where both are one.
struct Collider {
  Vec3 from, to;
  double radius;
};

// What holds a body: vertices, and points of the surface.
struct Pins {
  std::vector<uint32_t> vertices = {};
  std::vector<SurfacePoint> points = {};
  size_t count() const { return vertices.size() + points.size(); }
};

// An elastic surface in motion: substep XPBD with one pass per substep (Macklin et al. 2019). Masses are
// lumped, a third of its triangles' for every vertex. The same input gives the same bits, on any number of
// threads.
class Simulation {
 public:
  static constexpr double kStep = 1.0 / 60;  // seconds

  // Starts at rest in the mesh's own shape. Throws std::invalid_argument with a sentence for a useless
  // option, an empty mesh, or a pin that the mesh does not have.
  Simulation(const TriangleMesh& mesh, const SimulationOptions& options, const Pins& pins = {});
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  // One step of 1/60 s, with the help of other threads where `helpers` are given. Throws Cancelled, after
  // which the simulation is of no use.
  void step(const Job& job, Helpers* helpers = nullptr);
  // How many seconds longer the last step would have taken without them, as far as their work tells.
  double helpedSeconds() const;

  uint32_t vertexCount() const;
  // In units of the mesh.
  Vec3 position(uint32_t v) const;
  Vec3 position(const SurfacePoint& anchor) const;
  std::vector<Vec3> positions() const;
  // m/s.
  Vec3 velocity(uint32_t v) const;
  // Places free vertices, in units of the mesh; for tests and restarts.
  void setPositions(std::span<const Vec3> positions);
  // m/s, of free vertices; what pins move keeps its own.
  void setVelocities(std::span<const Vec3> velocities);

  // m/s2.
  void setGravity(const Vec3& gravity);
  // m/s, of the air.
  void setWind(const Vec3& wind);
  // A floor at this height along y, in units of the mesh.
  void setGround(double height);
  // Replaces all colliders; units of the mesh. They stand still within a step. Throws std::invalid_argument
  // where a radius is not above 0.
  void setColliders(std::span<const Collider> colliders);
  // Draws a point of the surface to `target` (units of the mesh), as a hand would, by a fifth of what is left
  // of the way in a step. `drag` again moves the target or takes another point, `release` ends it.
  void drag(const SurfacePoint& anchor, const Vec3& target);
  void release();
  // Where the pins are to be at the end of the next step, in units of the mesh: vertices, then points.
  void setPinTargets(std::span<const Vec3> targets);

  // Joules; gravity's part is not in it.
  double kineticEnergy() const;
  double elasticEnergy() const;
  // False once anything has become infinite or not a number.
  bool isFinite() const;
  // Kilograms of the whole body.
  double mass() const;
  // Constraints that a substep solves (a bent triangle counts as one), and edges of the mesh.
  uint32_t constraintCount() const;
  uint32_t edgeCount() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace limber
