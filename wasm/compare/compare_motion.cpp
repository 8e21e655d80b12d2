#include "compare/compare_motion.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "simulate/running_scenario.h"
#include "transfer/carry_pins.h"

namespace limber {

namespace {

// The order of constraints with which the noise floor is measured.
constexpr uint32_t kOtherOrder = 1;

double secondsNow() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// The runs of one comparison, one after the other, with their common progress.
class ComparedRuns {
 public:
  // `original` and `options` must outlive this object.
  ComparedRuns(const TriangleMesh& original, const MotionOptions& options, uint32_t sampleCount, Job& job)
      : original_(original),
        options_(options),
        sampleCount_(sampleCount),
        steps_(std::max(1, static_cast<int>(std::lround(options.scenario.seconds / Simulation::kStep)))),
        job_(job) {
    job_.begin(Phase::Simulate);
  }

  struct Body {
    const TriangleMesh& mesh;
    const Pins& pins;
    SimulationOptions options;
    bool records;
  };
  struct Result {
    MotionRun run;
    std::vector<Vec3> displacements;  // [step sampleCount + sample], units of the mesh
  };

  // Adds to the number of substeps that the progress refers to.
  void expect(double substeps) { expected_ += substeps; }

  Result run(const Body& body) {
    RunningScenario running({body.mesh, body.options, body.pins}, options_.scenario, job_);
    const Simulation& simulation = running.simulation();
    const MotionSamples samples(original_, body.mesh, simulation, sampleCount_);
    Result result;
    result.displacements.reserve(size_t{sampleCount_} * static_cast<size_t>(steps_));
    result.run.constraints = simulation.constraintCount();
    result.run.edges = simulation.edgeCount();
    result.run.secondsPerStep = std::numeric_limits<double>::infinity();
    for (int step = 0; step < steps_; ++step) {
      const double start = secondsNow();
      running.step(job_);
      result.run.secondsPerStep = std::min(result.run.secondsPerStep, secondsNow() - start);
      running.requireNotDiverged();
      const auto displacements = samples.displacements(simulation);
      result.displacements.insert(result.displacements.end(), displacements.begin(), displacements.end());
      if (body.records) record(simulation, result.run.positions);
      done_ += static_cast<double>(body.options.substeps) / steps_;
      shown_ = std::max(shown_, done_ / expected_);
      job_.report(std::min(shown_, 1.0));
    }
    return result;
  }

  int steps() const { return steps_; }

 private:
  static void record(const Simulation& simulation, std::vector<float>& positions) {
    for (uint32_t v = 0; v < simulation.vertexCount(); ++v) {
      const Vec3 p = simulation.position(v);
      for (int c = 0; c < 3; ++c) positions.push_back(static_cast<float>(p[c]));
    }
  }

  const TriangleMesh& original_;
  const MotionOptions& options_;
  uint32_t sampleCount_;
  int steps_;
  double expected_ = 0, done_ = 0, shown_ = 0;  // substeps, substeps, the fraction that was reported
  Job& job_;
};

// The comparison of the original with the other body at increasing substeps.
class ComparedMotions {
 public:
  ComparedMotions(const TriangleMesh& original, const TriangleMesh& other, const MotionOptions& options,
                  Job& job)
      : original_(original),
        other_(other),
        options_(options),
        diagonal_(bounds(original).diagonal()),
        pins_{options.pinned, {}},
        carried_(carryPins(original, options.pinned, other, options.binding)),
        runs_(original, options, options.sampleCount, job) {}

  MotionComparison run() {
    int substeps = options_.simulation.substeps;
    runs_.expect(5.0 * substeps);
    ComparedRuns::Result first = runs_.run(originalWith(substeps, 0, options_.records));
    for (;; substeps *= 2) {
      ComparedRuns::Result second = runs_.run(otherWith(substeps));
      const bool mayGoOn = options_.doublesSubsteps && solved(first.run, 4 * substeps) <= kMaxSolved &&
                           2 * substeps < kMaxSubsteps;
      ComparedRuns::Result doubled =
          runs_.run(originalWith(std::min(2 * substeps, kMaxSubsteps), 0, options_.records && mayGoOn));
      MotionComparison found = compared(first, second, doubled, substeps);
      second.displacements = std::vector<Vec3>();  // in long runs a gigabyte each
      if (found.isConverged || !mayGoOn) {
        doubled.displacements = std::vector<Vec3>();
        const ComparedRuns::Result reordered = runs_.run(originalWith(substeps, kOtherOrder, false));
        found.noiseFloor = motionDeviation(first.displacements, reordered.displacements, diagonal_).mean;
        found.original = std::move(first.run);
        found.other = std::move(second.run);
        return found;
      }
      runs_.expect(7.0 * substeps);
      first = std::move(doubled);
    }
  }

 private:
  // The constraints that a run of the original solves.
  double solved(const MotionRun& run, int substeps) const {
    return static_cast<double>(run.constraints) * substeps * runs_.steps();
  }

  ComparedRuns::Body originalWith(int substeps, uint32_t order, bool records) const {
    SimulationOptions options = options_.simulation;
    options.substeps = substeps;
    options.order += order;
    return {original_, pins_, options, records};
  }

  ComparedRuns::Body otherWith(int substeps) const {
    SimulationOptions options = options_.simulation;
    options.substeps = substeps;
    options.material.young *= options_.calibration;
    if (options.solver)
      options.solver = options_.otherSolver.value_or(
          SimulatedSolver{options.solver->model, options.solver->constants, {}, {}, {}});
    return {other_, carried_, options, options_.records};
  }

  MotionComparison compared(const ComparedRuns::Result& first, const ComparedRuns::Result& second,
                            const ComparedRuns::Result& doubled, int substeps) const {
    MotionComparison found;
    found.substeps = substeps;
    found.deviation = motionDeviation(first.displacements, second.displacements, diagonal_);
    found.substepDeviation = motionDeviation(first.displacements, doubled.displacements, diagonal_).mean;
    found.isConverged = found.substepDeviation <= kConverged * found.deviation.mean;
    return found;
  }

  const TriangleMesh& original_;
  const TriangleMesh& other_;
  const MotionOptions& options_;
  double diagonal_;
  Pins pins_, carried_;
  ComparedRuns runs_;
};

}  // namespace

MotionComparison compareMotion(const TriangleMesh& original, const TriangleMesh* other,
                               const MotionOptions& options, Job& job) {
  if (other && other->triangles.empty())
    throw std::invalid_argument("A mesh without triangles does not move: give one that has some.");
  if (other) return ComparedMotions(original, *other, options, job).run();
  const Pins pins = {options.pinned, {}};
  ComparedRuns runs(original, options, 0, job);
  runs.expect(options.simulation.substeps);
  MotionComparison alone;
  alone.original = runs.run({original, pins, options.simulation, options.records}).run;
  alone.substeps = options.simulation.substeps;
  return alone;
}

}  // namespace limber
