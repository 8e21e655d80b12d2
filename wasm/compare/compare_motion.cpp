#include "compare/compare_motion.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "simulate/running_scenario.h"
#include "transfer/carry_pins.h"

namespace limber {

namespace {

// The order of constraints that the noise floor is measured with.
constexpr uint32_t kOtherOrder = 1;

double secondsNow() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// The runs of one comparison, one after the other, with their common progress.
class ComparedRuns {
 public:
  // `original` and `options` must outlive this object. `count` is how many runs there will be.
  ComparedRuns(const TriangleMesh& original, const MotionOptions& options, int count, Job& job)
      : original_(original),
        options_(options),
        sampleCount_(count > 1 ? options.sampleCount : 0),
        steps_(std::max(1, static_cast<int>(std::lround(options.scenario.seconds / Simulation::kStep)))),
        total_(steps_ * count),
        job_(job) {
    job_.begin(Phase::Simulate);
  }

  struct Body {
    const TriangleMesh& mesh;
    Pins pins;
    uint32_t order;
    bool records;
    double calibration = 1;
  };
  struct Result {
    MotionRun run;
    std::vector<Vec3> displacements;  // [step sampleCount + sample], units of the mesh
  };

  Result run(const Body& body) {
    SimulationOptions options = options_.simulation;
    options.order = body.order;
    options.material.young *= body.calibration;
    RunningScenario running(body.mesh, options, options_.scenario, body.pins);
    const Simulation& simulation = running.simulation();
    const MotionSamples samples(original_, body.mesh, simulation, sampleCount_);
    Result result;
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
      job_.report(static_cast<double>(++done_) / total_);
    }
    return result;
  }

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
  int steps_, total_, done_ = 0;
  Job& job_;
};

}  // namespace

MotionComparison compareMotion(const TriangleMesh& original, const TriangleMesh* other,
                               const MotionOptions& options, Job& job) {
  const uint32_t order = options.simulation.order;
  const bool records = options.records;
  const Pins pins = {options.pinned, {}};
  ComparedRuns runs(original, options, other ? 3 : 1, job);
  ComparedRuns::Result first = runs.run({original, pins, order, records});
  MotionComparison comparison;
  comparison.original = std::move(first.run);
  if (!other) return comparison;
  const Pins carried = carryPins(original, options.pinned, *other, options.binding);
  ComparedRuns::Result second = runs.run({*other, carried, order, records, options.calibration});
  const ComparedRuns::Result reordered = runs.run({original, pins, order + kOtherOrder, false});
  comparison.other = std::move(second.run);
  const double diagonal = bounds(original).diagonal();
  comparison.deviation = motionDeviation(first.displacements, second.displacements, diagonal);
  comparison.noiseFloor = motionDeviation(first.displacements, reordered.displacements, diagonal).mean;
  return comparison;
}

}  // namespace limber
