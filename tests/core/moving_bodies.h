#pragma once

// Simulated bodies that the tests share, and their measures.

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "elastic/modes.h"
#include "mesh/triangle_mesh.h"
#include "simulate/simulation.h"

namespace limber::moving_bodies {

inline const Vec3 kGravity = {0, -9.81, 0};

inline SimulationOptions rubber(double thickness, int substeps,
                                SimulationModel model = SimulationModel::Shell) {
  SimulationOptions options;
  options.model = model;
  options.material = {.young = 1e6, .poisson = 0.3, .density = 1000, .thickness = thickness};
  options.substeps = substeps;
  options.friction = 0.5;
  return options;
}

inline void run(Simulation& body, int steps) {
  const Job job;
  for (int i = 0; i < steps; ++i) body.step(job);
}

// Velocities that deform a body strongly everywhere.
inline std::vector<Vec3> struck(const TriangleMesh& mesh, double speed) {
  std::vector<Vec3> velocities;
  for (const Vec3& p : mesh.positions)
    velocities.push_back(Vec3{std::sin(3 * p.y + p.z), std::cos(2 * p.x), std::sin(4 * p.x - p.y)} * speed);
  return velocities;
}

// The volume that a closed mesh encloses with its vertices at these positions.
inline double volumeOf(const std::vector<Vec3>& positions, const TriangleMesh& mesh) {
  double volume = 0;
  for (const Triangle& t : mesh.triangles)
    volume += dot(positions[t[0]], cross(positions[t[1]], positions[t[2]])) / 6;
  return volume;
}

// Steps a body until measure() has changed its sign three times, at most `mostSteps` steps. Returns the time
// between the first and the third change, interpolated between steps, in steps; 0 if there are fewer.
template <class Measure>
double periodOf(Simulation& body, int mostSteps, Measure measure) {
  std::vector<double> crossings;
  double before = 0;
  for (int i = 1; i <= mostSteps && crossings.size() < 3; ++i) {
    run(body, 1);
    const double now = measure();
    if (before * now < 0) crossings.push_back(i - now / (now - before));
    before = now;
  }
  return crossings.size() < 3 ? 0 : crossings[2] - crossings[0];
}

// The relative error of the frequency of a body that is struck in the shape of a mode, shape[3 v + c], for
// the material that the mode was computed with. A start with velocities instead of displacements lets
// unknowns other than vertices take their part of the shape by themselves. The step of the simulation is
// fixed at 1/60 s, so Young's modulus, which is proportional to the square of a frequency, is changed so that
// a period is a second.
inline double frequencyError(const TriangleMesh& mesh, const Mode& mode, const float* shape,
                             SimulationOptions options) {
  const double period = 2 * std::numbers::pi / mode.omega;
  options.material.young *= period * period;
  Simulation body(mesh, options);
  const auto along = [&](uint32_t v) { return Vec3{shape[3 * v], shape[3 * v + 1], shape[3 * v + 2]}; };
  std::vector<Vec3> velocities;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    velocities.push_back(along(v) * (2e-3 * std::numbers::pi * bounds(mesh).diagonal()));
  body.setVelocities(velocities);
  const auto share = [&] {
    double sum = 0;
    for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
      sum += dot(along(v), body.position(v) - mesh.positions[v]);
    return sum;
  };
  return 60 / periodOf(body, 110, share) - 1;
}

}  // namespace limber::moving_bodies
