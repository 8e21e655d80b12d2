// Comparisons of motions, and running simulations. JavaScript refers to a running simulation by its number
// and must end it.

#include <map>

#include "bind/function.h"
#include "bind/material.h"
#include "bind/meshes.h"
#include "bind/solver.h"
#include "compare/compare_motion.h"
#include "compare/motion_deviation.h"
#include "simulate/running_scenario.h"
#include "simulate/solid/lattice_body.h"
#include "transfer/carry_pins.h"

namespace limber {

template <>
struct Names<SimulationModel> {
  static constexpr std::array list = {"springs", "shell", "solid"};
  static constexpr const char* what = "model of simulation";
};

template <>
struct Fields<SimulatedSolver> {
  static constexpr auto list =
      std::tuple(field("model", &SimulatedSolver::model), field("constants", &SimulatedSolver::constants),
                 optionalField("stretchFactors", &SimulatedSolver::stretchFactors),
                 optionalField("bendFactors", &SimulatedSolver::bendFactors),
                 optionalField("masses", &SimulatedSolver::masses));
};

template <>
struct Fields<SimulationOptions> {
  static constexpr auto list = std::tuple(
      field("material", &SimulationOptions::model), field("substeps", &SimulationOptions::substeps),
      field("damping", &SimulationOptions::damping), field("friction", &SimulationOptions::friction),
      field("selfCollision", &SimulationOptions::selfCollision),
      optionalField("solver", &SimulationOptions::solver), optionalField("order", &SimulationOptions::order));
};

template <>
struct Fields<Collider> {
  static constexpr auto list = std::tuple(field("from", &Collider::from), field("to", &Collider::to),
                                          field("radius", &Collider::radius));
};

template <>
struct Fields<CollisionScene> {
  static constexpr auto list = std::tuple(optionalField("ground", &CollisionScene::ground),
                                          optionalField("colliders", &CollisionScene::colliders));
};

template <>
struct Fields<MotionRun> {
  static constexpr auto list = std::tuple(
      field("constraints", &MotionRun::constraints), field("edges", &MotionRun::edges),
      field("secondsPerStep", &MotionRun::secondsPerStep), field("positions", &MotionRun::positions));
};

template <>
struct Fields<MotionDeviation> {
  static constexpr auto list =
      std::tuple(field("mean", &MotionDeviation::mean), field("max", &MotionDeviation::max));
};

namespace {

SimulationOptions simulationOptionsOf(const val& in, const TriangleMesh& original) {
  auto options = fromJs<SimulationOptions>(in);
  options.material = fromJs<ElasticMaterial>(in);
  if (options.model == SimulationModel::Solid && !options.solver) options.cellSize = solidCellSize(original);
  return options;
}

Scenario scenarioOf(const TriangleMesh& original, const val& in) {
  const ScenarioKind* kind = scenarioKind(in["scenario"].as<std::string>());
  return {kind,
          bounds(original),
          in["seconds"].as<double>(),
          in["unit"].as<double>(),
          fromJs<CollisionScene>(in),
          startPose(kind, original)};
}

val jsScenarioCollisionScene(const val& original, const val& in) {
  return toJs(collisionSceneOf(scenarioOf(*meshOf(original), in)));
}

// The pinned vertices of the original: those of `pinned`, or the default pins of the scenario if that is
// null.
std::vector<uint32_t> pinnedOf(const TriangleMesh& original, const Scenario& scenario, const val& in) {
  if (in["pinned"].isNull()) return defaultPins(original, scenario);
  const auto pinned = vectorOf<uint32_t>(in["pinned"]);
  for (const uint32_t v : pinned)
    if (v >= original.vertexCount())
      throw std::invalid_argument("A pin names a vertex that the mesh does not have.");
  return pinned;
}

// The points of `result` to which the vertices of the original are bound; empty if `in` is null or undefined.
std::vector<SurfacePoint> bindingOf(const TriangleMesh& original, const TriangleMesh& result, const val& in) {
  std::vector<SurfacePoint> points;
  if (in.isNull() || in.isUndefined()) return points;
  const auto triangles = vectorOf<uint32_t>(in["triangle"]);
  const auto barycentric = vectorOf<float>(in["barycentric"]);
  if (triangles.size() != original.vertexCount() || barycentric.size() != 3 * triangles.size())
    throw std::invalid_argument(
        "The binding is not of the original: write it again together with the optimized mesh.");
  for (size_t v = 0; v < triangles.size(); ++v) {
    if (triangles[v] != kNone && triangles[v] >= result.triangleCount())
      throw std::invalid_argument(
          "The binding is not of the optimized mesh: write it again together with the optimized mesh.");
    points.push_back({triangles[v], {barycentric[3 * v], barycentric[3 * v + 1], barycentric[3 * v + 2]}});
  }
  return points;
}

val jsCompareMotion(const val& originalIn, const val& resultIn, const val& in) {
  const auto original = meshOf(originalIn);
  MotionOptions options;
  options.simulation = simulationOptionsOf(in, *original);
  options.scenario = scenarioOf(*original, in);
  options.pinned = pinnedOf(*original, options.scenario, in);
  options.records = in["records"].as<bool>();
  if (!in["doublesSubsteps"].isUndefined()) options.doublesSubsteps = in["doublesSubsteps"].as<bool>();
  options.otherSolver = fromJs<std::optional<SimulatedSolver>>(in["otherSolver"]);
  if (!in["calibration"].isUndefined()) options.calibration = in["calibration"].as<double>();
  const auto result = resultIn.isNull() ? nullptr : meshOf(resultIn);
  if (result) options.binding = bindingOf(*original, *result, in["binding"]);
  const MotionComparison comparison = compareMotion(*original, result.get(), options, theJob);
  val out = val::object();
  out.set("original", toJs(comparison.original));
  out.set("other", toJs(comparison.other));
  out.set("deviationMean", comparison.deviation.mean);
  out.set("deviationMax", comparison.deviation.max);
  out.set("noiseFloor", comparison.noiseFloor);
  out.set("substeps", comparison.substeps);
  out.set("substepDeviation", comparison.substepDeviation);
  out.set("isConverged", comparison.isConverged);
  return out;
}

// A running simulation, and the points at which its motion deviation from other bodies of the same original
// is measured.
struct Running {
  RunningScenario body;
  MotionSamples samples;
  double diagonal;  // of the original, in units of the mesh
};

std::map<uint32_t, Running> running;
uint32_t lastNumber = 0;

Running& runningOf(uint32_t number) {
  const auto found = running.find(number);
  if (found == running.end()) throw std::invalid_argument("The simulation has ended: start it again.");
  return found->second;
}

// `mesh` is the original itself or a body to which its pins are carried over.
val jsStartSimulation(const val& meshIn, const val& originalIn, const val& in) {
  const auto mesh = meshOf(meshIn), original = meshOf(originalIn);
  const Scenario scenario = scenarioOf(*original, in);
  const auto binding = bindingOf(*original, *mesh, in["binding"]);
  const Pins pins = carryPins(*original, pinnedOf(*original, scenario, in), *mesh, binding);
  RunningScenario body({*mesh, simulationOptionsOf(in, *original), pins}, scenario, theJob);
  MotionSamples samples(*original, *mesh, body.simulation());
  running.emplace(++lastNumber, Running{std::move(body), std::move(samples), scenario.box.diagonal()});
  return val(lastNumber);
}

val jsStepSimulations(const val& numbers) {
  std::vector<RunningScenario*> bodies;
  for (const uint32_t number : vectorOf<uint32_t>(numbers)) bodies.push_back(&runningOf(number).body);
  stepTogether(bodies, theJob);
  for (const RunningScenario* body : bodies) body->requireNotDiverged();
  return val::null();
}

// [3 * i + c]
val flatArray(const std::vector<Vec3>& positions) {
  std::vector<float> flat;
  flat.reserve(3 * positions.size());
  for (const Vec3& p : positions)
    for (int c = 0; c < 3; ++c) flat.push_back(static_cast<float>(p[c]));
  return typedArray(flat);
}

val jsSimulationPositions(uint32_t number) {
  return flatArray(runningOf(number).body.simulation().positions());
}

val jsSimulationPins(uint32_t number) {
  return flatArray(runningOf(number).body.pinPositions());
}

val jsSimulationSeconds(uint32_t number) {
  return val(runningOf(number).body.stepSeconds());
}

val jsSimulationDiverged(uint32_t number) {
  return val(runningOf(number).body.simulation().hasDiverged());
}

val jsSimulationDeviation(uint32_t original, uint32_t result) {
  const Running &a = runningOf(original), &b = runningOf(result);
  return toJs(motionDeviation(a.samples.displacements(a.body.simulation()),
                              b.samples.displacements(b.body.simulation()), a.diagonal));
}

val jsDragSimulation(uint32_t number, const val& point, const val& target) {
  const auto barycentric = fromJs<Vec3>(point["barycentric"]);
  const SurfacePoint at = {point["triangle"].as<uint32_t>(), {barycentric.x, barycentric.y, barycentric.z}};
  runningOf(number).body.simulation().drag(at, fromJs<Vec3>(target));
  return val::null();
}

val jsReleaseSimulation(uint32_t number) {
  runningOf(number).body.simulation().release();
  return val::null();
}

val jsEndSimulation(uint32_t number) {
  running.erase(number);
  return val::null();
}

}  // namespace
}  // namespace limber

EMSCRIPTEN_BINDINGS(limber_simulate) {
  using namespace limber;
  offer<&jsCompareMotion>("compareMotion");
  offer<&jsScenarioCollisionScene>("scenarioCollisionScene");
  offer<&jsStartSimulation>("startSimulation");
  offer<&jsStepSimulations>("stepSimulations");
  offer<&jsSimulationPositions>("simulationPositions");
  offer<&jsSimulationPins>("simulationPins");
  offer<&jsSimulationSeconds>("simulationSeconds");
  offer<&jsSimulationDiverged>("simulationDiverged");
  offer<&jsSimulationDeviation>("simulationDeviation");
  offer<&jsDragSimulation>("dragSimulation");
  offer<&jsReleaseSimulation>("releaseSimulation");
  offer<&jsEndSimulation>("endSimulation");
}
