#include "fit/tune/trial/trial_constraints.h"

#include "fit/tune/trial/implicit_motion.h"

namespace limber {
namespace {

// The work limit of a body in a scene, see StepMinimiser::work: about 15 seconds on one thread. A sway of
// 5,500 faces takes a tenth of it, and the fall of a sheet of 3,000 faces a half; a body that crumples under
// its weight would never finish.
constexpr double kMaxWork = 2e10;

}  // namespace

TrialDisplacements moveConstraints(const TrialRun& run, const SolverModel& model, Job& job) {
  const auto& [scene, body, pins, samples, stride, recordEvery, report] = run;
  const SolverConstraints constraints(body.mesh, body.topology, model, body.constants);
  const std::vector<double> masses = massesOf(body, model);
  const bool hasHinges = model.bend != BendElement::CrossSprings;
  ImplicitMotion motion(
      {constraints, body.mesh, masses, body.factors, pins, hasHinges ? body.constants.stretch : 0},
      {stride * scene.step, scene.motionSize, scene.gravity, kMaxWork}, job);
  motion.setVelocities(run.startVelocities());
  std::vector<Vec3> rest, displacements;
  for (const SurfacePoint& sample : samples)
    rest.push_back(positionOf(sample, body.mesh.triangles, constraints.rest()));
  for (uint32_t step = stride; step <= scene.stepCount; step += stride) {
    if (!motion.step(job)) return std::nullopt;
    report(static_cast<double>(step) / scene.stepCount);
    if (step % recordEvery != 0) continue;
    for (size_t i = 0; i < rest.size(); ++i)
      displacements.push_back(positionOf(samples[i], body.mesh.triangles, motion.positions()) - rest[i]);
  }
  return displacements;
}

}  // namespace limber
