#include "compare/compare_motion.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "mesh/surface_samples.h"
#include "query/closest_point.h"
#include "simulate/running_scenario.h"
#include "transfer/carry_pins.h"

namespace limber {

namespace {

// The order of constraints that the noise floor is measured with.
constexpr uint32_t kOtherOrder = 1;

double secondsNow() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Points of the original on `mesh`: the original itself or another.
std::vector<SurfacePoint> bind(const SurfaceSamples& points, const TriangleMesh& original,
                                const TriangleMesh& mesh) {
  const ClosestPointTree tree(mesh);
  std::vector<SurfacePoint> anchors;
  for (size_t i = 0; i < points.positions.size(); ++i) {
    const Vec3 normal = normalized(areaNormal(original, points.triangles[i]));
    const ClosestPoint on = tree.closestFacing(points.positions[i], normal);
    anchors.push_back({on.triangle, {on.barycentric[0], on.barycentric[1], on.barycentric[2]}});
  }
  return anchors;
}

// All runs of one comparison, with their common progress.
class Runs {
 public:
  Runs(const MotionOptions& options, int count, Job& job)
      : options_(options),
        steps_(std::max(1, static_cast<int>(std::lround(options.scenario.seconds / Simulation::kStep)))),
        total_(steps_ * count),
        job_(job) {
    job_.begin(Phase::Simulate);
  }

  struct Body {
    const TriangleMesh& mesh;
    Pins pins;
    std::vector<SurfacePoint> points;
    uint32_t order;
    bool records;
    double calibration = 1;
  };
  struct Result {
    MotionRun run;
    std::vector<Vec3> displacements;  // [step * points + point]
  };

  Result run(const Body& body) {
    SimulationOptions options = options_.simulation;
    options.order = body.order;
    options.young *= body.calibration;
    RunningScenario running(body.mesh, options, options_.scenario, body.pins);
    const Simulation& simulation = running.simulation();
    std::vector<Vec3> rest;
    for (const SurfacePoint& point : body.points) rest.push_back(simulation.position(point));
    Result result;
    result.run.constraints = simulation.constraintCount();
    result.run.edges = simulation.edgeCount();
    result.run.secondsPerStep = std::numeric_limits<double>::infinity();
    for (int step = 0; step < steps_; ++step) {
      const double start = secondsNow();
      running.step(job_);
      result.run.secondsPerStep = std::min(result.run.secondsPerStep, secondsNow() - start);
      for (size_t i = 0; i < rest.size(); ++i)
        result.displacements.push_back(simulation.position(body.points[i]) - rest[i]);
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

  const MotionOptions& options_;
  int steps_, total_, done_ = 0;
  Job& job_;
};

struct Deviation {
  double mean = 0, max = 0;
};

Deviation between(const std::vector<Vec3>& a, const std::vector<Vec3>& b, double percent) {
  Deviation deviation;
  for (size_t i = 0; i < a.size(); ++i) {
    const double distance = percent * length(a[i] - b[i]);
    deviation.mean += distance / static_cast<double>(a.size());
    deviation.max = std::max(deviation.max, distance);
  }
  return deviation;
}

}  // namespace

MotionComparison compareMotion(const TriangleMesh& original, const TriangleMesh* other,
                               const MotionOptions& options, Job& job) {
  const SurfaceSamples samples = other ? sampleSurface(original, options.sampleCount) : SurfaceSamples{};
  const uint32_t order = options.simulation.order;
  const bool records = options.records;
  const Pins pins = {options.pinned, {}};
  const auto points = bind(samples, original, original);
  Runs runs(options, other ? 3 : 1, job);
  Runs::Result first = runs.run({original, pins, points, order, records});
  MotionComparison comparison;
  comparison.original = std::move(first.run);
  if (!other) return comparison;
  Runs::Result second = runs.run({*other, carryPins(original, options.pinned, *other, options.binding),
                                  bind(samples, original, *other), order, records, options.calibration});
  const Runs::Result reordered = runs.run({original, pins, points, order + kOtherOrder, false});
  comparison.other = std::move(second.run);
  const double percent = 100 / bounds(original).diagonal();
  const Deviation deviation = between(first.displacements, second.displacements, percent);
  comparison.deviationMean = deviation.mean;
  comparison.deviationMax = deviation.max;
  comparison.noiseFloor = between(first.displacements, reordered.displacements, percent).mean;
  return comparison;
}

}  // namespace limber
