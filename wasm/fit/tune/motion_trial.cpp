#include "fit/tune/motion_trial.h"

#include <cmath>

#include "compare/motion_deviation.h"
#include "fit/tune/trial/trial_constraints.h"
#include "fit/tune/trial/trial_shell.h"
#include "mesh/surface_samples.h"
#include "query/closest_point.h"
#include "transfer/carry_pins.h"

namespace limber {
namespace {

// Faces of an original above which a trial takes more than about a minute.
constexpr uint32_t kMaxFaces = 20000;
// The same for cross springs: nets of them buckle everywhere, so that a step takes five times as many solves.
constexpr uint32_t kMaxFacesOfSprings = 10000;
constexpr uint32_t kRecordEvery = 2, kLongStride = 2;

// The points of motion deviation, see compare/motion_deviation.h, bound to a body.
std::vector<SurfacePoint> samplesOn(const TriangleMesh& original, const TriangleMesh& body) {
  const SurfaceSamples samples = sampleSurface(original, kMotionSamples);
  const ClosestPointTree tree(body);
  std::vector<SurfacePoint> points;
  for (size_t i = 0; i < samples.positions.size(); ++i)
    points.push_back(
        tree.closestFacing(samples.positions[i], normalized(areaNormal(original, samples.triangles[i]))));
  return points;
}

std::string refusalOf(const MovingBody& original, const SolverModel& model) {
  if (model.bend == BendElement::Morley && !(original.constants.bend > 0))
    return "a shell without bending stiffness has no thickness";
  const uint32_t most = model.bend == BendElement::CrossSprings ? kMaxFacesOfSprings : kMaxFaces;
  if (original.mesh.triangleCount() > most)
    return "the original has " + std::to_string(original.mesh.triangleCount()) +
           " faces, and to move one of more than " + std::to_string(most) + " faces takes too long";
  return {};
}

}  // namespace

struct MotionTrial::State {
  const MovingBody original;
  const SolverModel model;
  std::string refusal;
  std::vector<TrialScene> scenes;
  std::vector<std::vector<Vec3>> displacements;  // of the original, per scene
  std::vector<double> noises;                    // per scene, see noiseFloor()

  double diagonal() const { return bounds(original.mesh).diagonal() * original.constants.unit; }

  Pins pinsOf(const TrialScene& scene, const MovingBody& body) const {
    if (&body.mesh == &original.mesh) return scene.pins;
    return scene.usersPins ? body.pins : carryPins(original.mesh, scene.pins.vertices, body.mesh);
  }

  // Per scene.
  std::optional<std::vector<std::vector<Vec3>>> run(const MovingBody& body, uint32_t stride, Job& job) const {
    WholePhase phase(job, Phase::Simulate);
    const std::vector<SurfacePoint> samples = samplesOn(original.mesh, body.mesh);
    std::vector<std::vector<Vec3>> all;
    for (const TrialScene& scene : scenes) {
      const double done = static_cast<double>(all.size());
      const auto report = [&, count = static_cast<double>(scenes.size())](double part) {
        phase.report((done + part) / count);
      };
      const TrialRun run{scene, body, pinsOf(scene, body), samples, stride, kRecordEvery, report};
      auto moved = model.bend == BendElement::Morley ? moveShell(run, job) : moveConstraints(run, model, job);
      if (!moved) return std::nullopt;
      all.push_back(std::move(*moved));
    }
    return all;
  }

  // Drops the scenes in which the time steps of the original do not converge or take too long, also with
  // steps twice as long, because the error of the time steps is then unknown.
  void moveOriginal(Job& job) {
    const std::vector<TrialScene> all = std::move(scenes);
    std::vector<TrialScene> moving;
    const double order = model.bend == BendElement::Morley ? 1 : 2;
    for (const TrialScene& scene : all) {
      scenes = {scene};
      auto moved = run(original, 1, job);
      if (!moved) continue;
      const auto coarsely = run(original, kLongStride, job);
      if (!coarsely) continue;
      noises.push_back(motionDeviation(moved->front(), coarsely->front(), diagonal()).mean /
                       (std::exp2(order) - 1));
      displacements.push_back(std::move(moved->front()));
      moving.push_back(scene);
    }
    scenes = std::move(moving);
  }

  std::vector<double> deviationsFrom(const std::vector<std::vector<Vec3>>& other) const {
    std::vector<double> deviations;
    for (size_t i = 0; i < scenes.size(); ++i)
      deviations.push_back(motionDeviation(displacements[i], other[i], diagonal()).mean);
    return deviations;
  }
};

namespace {

double meanOf(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value / static_cast<double>(values.size());
  return sum;
}

}  // namespace

MotionTrial::MotionTrial(const MovingBody& original, const SolverModel& model, Job& job)
    : state_(new State{original, model, refusalOf(original, model), {}, {}, {}}) {
  if (!state_->refusal.empty()) return;
  {
    const WholePhase phase(job, Phase::Simulate);
    state_->scenes = trialScenes(original, model, job);
  }
  if (state_->scenes.empty()) {
    state_->refusal = "nothing of the original can swing";
    return;
  }
  state_->moveOriginal(job);
  if (state_->scenes.empty())
    state_->refusal = "the time steps of the original do not converge or take too long";
}

MotionTrial::~MotionTrial() = default;
MotionTrial::MotionTrial(MotionTrial&&) noexcept = default;
MotionTrial& MotionTrial::operator=(MotionTrial&&) noexcept = default;

const std::string& MotionTrial::refusal() const {
  return state_->refusal;
}

std::string MotionTrial::scene() const {
  std::string names;
  for (const TrialScene& scene : state_->scenes) names += (names.empty() ? "" : " and ") + scene.name;
  return names;
}

std::optional<std::vector<double>> MotionTrial::deviationsOf(const MovingBody& body, Job& job) {
  if (!refusal().empty()) return std::nullopt;
  const auto moved = state_->run(body, 1, job);
  if (!moved) return std::nullopt;
  return state_->deviationsFrom(*moved);
}

std::optional<double> MotionTrial::deviationOf(const MovingBody& body, Job& job) {
  const auto deviations = deviationsOf(body, job);
  return deviations ? std::optional(meanOf(*deviations)) : std::nullopt;
}

double MotionTrial::noiseFloor() const {
  return meanOf(state_->noises);
}

}  // namespace limber
