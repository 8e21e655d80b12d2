#include "fit/tune/motion_look_run.h"

#include "compare/motion_deviation.h"
#include "fit/tune/implicit_motion.h"
#include "fit/tune/motion_look_shell.h"
#include "mesh/surface_samples.h"
#include "query/closest_point.h"

namespace limber {
namespace {

Vec3 pointOf(std::span<const Vec3> positions, const TriangleMesh& mesh, const SurfacePoint& point) {
  Vec3 sum;
  for (int c = 0; c < 3; ++c) sum += positions[mesh.triangles[point.triangle][c]] * point.barycentric[c];
  return sum;
}

}  // namespace

std::vector<SurfacePoint> lookSamples(const TriangleMesh& original, const TriangleMesh& body) {
  const SurfaceSamples samples = sampleSurface(original, kMotionSamples);
  const ClosestPointTree tree(body);
  std::vector<SurfacePoint> points;
  for (size_t i = 0; i < samples.positions.size(); ++i)
    points.push_back(
        tree.closestFacing(samples.positions[i], normalized(areaNormal(original, samples.triangles[i]))));
  return points;
}

std::optional<std::vector<Vec3>> runScene(const LookScene& scene, const MovingBody& body,
                                          const SolverModel& model, const LookRun& run,
                                          const std::function<void(double)>& report, Job& job) {
  if (model.bend == BendElement::Morley) return runShellScene(scene, body, run, report, job);
  const SolverConstraints constraints(body.mesh, body.topology, model, body.constants);
  const std::vector<double> masses = massesOf(body, model);
  ImplicitMotion motion({constraints, body.mesh, masses, body.factors, run.pins},
                        {run.stride * scene.step, scene.motionSize, scene.gravity}, job);
  std::vector<Vec3> velocities;
  for (const Vec3& p : body.mesh.positions)
    velocities.push_back(scene.speed * initialVelocity(scene.scenario, p));
  motion.setVelocities(velocities);

  std::vector<Vec3> rest, displacements;
  for (const SurfacePoint& sample : run.samples)
    rest.push_back(pointOf(constraints.rest(), body.mesh, sample));
  for (uint32_t step = run.stride; step <= scene.stepCount; step += run.stride) {
    if (!motion.step(job)) return std::nullopt;
    report(static_cast<double>(step) / scene.stepCount);
    if (step % run.recordEvery != 0) continue;
    for (size_t i = 0; i < rest.size(); ++i)
      displacements.push_back(pointOf(motion.positions(), body.mesh, run.samples[i]) - rest[i]);
  }
  return displacements;
}

}  // namespace limber
