// Distances, motions and pairings of two meshes that need not resemble each other.

#include <Eigen/Core>
#include <set>

#include "compare/assignment.h"
#include "compare/compare_motion.h"
#include "compare/surface_distance.h"
#include "draw_simulation.h"
#include "promises.h"
#include "soup.h"

namespace limber::fuzz {
namespace {

void fuzzAssignment(FuzzInput& input) {
  Eigen::MatrixXd value(1 + input.byte() % 8, 1 + input.byte() % 8);
  for (Eigen::Index i = 0; i < value.size(); ++i) {
    const double any = input.anyFloat();
    value(i) = std::isfinite(any) ? any : 0;
  }
  std::set<int> taken;
  int paired = 0;
  for (const int column : assign(value)) {
    require(column >= -1 && column < value.cols(), "a partner exists");
    if (column < 0) continue;
    require(taken.insert(column).second, "no partner is taken twice");
    ++paired;
  }
  require(paired == std::min(value.rows(), value.cols()), "as many are paired as can be");
}

void fuzzDistances(const TriangleMesh& a, const TriangleMesh& b, FuzzInput& input, Job& job) {
  const SurfaceDistanceOptions options{.samples = 1u + input.byte()};
  const SurfaceDistance distance = measureSurfaceDistance(a, b, options, job);
  require(!std::isnan(distance.hausdorff) && !std::isnan(distance.mean), "a distance is a number");
  require(distance.mean <= distance.hausdorff * (1 + 1e-9), "the mean distance is not above the largest");
  const double alone = measureHausdorff(a, b, options, job);
  const double tolerance = 1e-9 * (distance.hausdorff + bounds(a).diagonal() + bounds(b).diagonal());
  require(std::abs(alone - distance.hausdorff) <= tolerance, "both Hausdorff distances are the same");
  require(isWithinHausdorff(a, b, alone * 1.01 + tolerance, options, job),
          "a distance is within a limit that is larger");
  if (alone > 100 * tolerance)
    require(!isWithinHausdorff(a, b, alone * 0.99, options, job), "a distance is not within a smaller limit");
}

void fuzzMotion(const TriangleMesh& a, const TriangleMesh& b, FuzzInput& input, Job& job) {
  MotionOptions options;
  options.simulation = drawSimulationOptions(input);
  options.scenario = drawScenario(input, a, options.simulation.material.unit);
  options.pinned = defaultPins(a, options.scenario);
  options.calibration = input.chance(32) ? static_cast<double>(input.anyFloat()) : input.real(0.1, 4);
  options.sampleCount = 32;
  options.records = true;
  const MotionComparison motion = compareMotion(a, &b, options, job);
  require(motion.other.has_value(), "both bodies are compared");
  requireFinite(motion.original.positions, "a body that has not diverged is finite");
  requireFinite(motion.other->positions, "the other body is finite, too");
  require(std::isfinite(motion.deviation.mean) && std::isfinite(motion.deviation.max),
          "a deviation is finite");
}

}  // namespace

void fuzzCompare(FuzzInput& input) {
  fuzzAssignment(input);
  const TriangleMesh a = drawMesh(input, 60), b = drawMesh(input, 60);
  Job job;
  fuzzDistances(a, b, input, job);
  if (input.chance(64)) fuzzMotion(a, b, input, job);
}

}  // namespace limber::fuzz
