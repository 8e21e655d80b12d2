// Comparisons of motions, and running simulations. These are the one thing that lives between calls:
// JavaScript knows them by numbers and must end each of them.

#include <map>

#include "bind/binding_tools.h"
#include "compare/compare_motion.h"
#include "compare/motion_deviation.h"
#include "simulate/running_scenario.h"
#include "transfer/carry_pins.h"

namespace limber {
namespace {

SimulationModel modelOf(const std::string& name) {
  if (name == "shell") return SimulationModel::Shell;
  if (name == "springs") return SimulationModel::Springs;
  throw std::invalid_argument("Nothing can be simulated as \"" + name + "\": take shell or springs.");
}

Vec3 vec3Of(const val& in) {
  return {in[0].as<double>(), in[1].as<double>(), in[2].as<double>()};
}

SimulationOptions simulationOptionsOf(const val& in) {
  SimulationOptions options;
  options.material = materialOf(in);
  options.model = modelOf(in["material"].as<std::string>());
  options.substeps = in["substeps"].as<int>();
  options.damping = in["damping"].as<double>();
  options.friction = in["friction"].as<double>();
  options.selfCollision = in["selfCollision"].as<bool>();
  return options;
}

CollisionScene addedCollisionsOf(const val& in) {
  CollisionScene added;
  const auto isGiven = [](const val& value) { return !value.isUndefined() && !value.isNull(); };
  if (isGiven(in["ground"])) added.ground = in["ground"].as<double>();
  const val colliders = in["colliders"];
  if (!isGiven(colliders)) return added;
  for (int i = 0; i < colliders["length"].as<int>(); ++i) {
    const val collider = colliders[i];
    added.colliders.push_back(
        {vec3Of(collider["from"]), vec3Of(collider["to"]), collider["radius"].as<double>()});
  }
  return added;
}

Scenario scenarioOf(const TriangleMesh& original, const val& in) {
  return {scenarioKind(in["scenario"].as<std::string>()), bounds(original), in["seconds"].as<double>(),
          in["unit"].as<double>(), addedCollisionsOf(in)};
}

val jsVec3(const Vec3& v) {
  val out = val::array();
  for (int c = 0; c < 3; ++c) out.set(c, v[c]);
  return out;
}

val jsScenarioCollisionScene(const val& original, const val& in) {
  const CollisionScene all = collisionSceneOf(scenarioOf(meshOf(original), in));
  val out = val::object(), colliders = val::array();
  for (const Collider& collider : all.colliders) {
    val one = val::object();
    one.set("from", jsVec3(collider.from));
    one.set("to", jsVec3(collider.to));
    one.set("radius", collider.radius);
    colliders.call<void>("push", one);
  }
  out.set("ground", all.ground ? val(*all.ground) : val::null());
  out.set("colliders", colliders);
  return out;
}

// The pinned vertices of the original: those of `pinned`, or what the scenario pins by itself where that is
// null.
std::vector<uint32_t> pinnedOf(const TriangleMesh& original, const Scenario& scenario, const val& in) {
  if (in["pinned"].isNull()) return defaultPins(original, scenario);
  const auto pinned = vectorOf<uint32_t>(in["pinned"]);
  for (const uint32_t v : pinned)
    if (v >= original.vertexCount())
      throw std::invalid_argument("A pin names a vertex that the mesh does not have.");
  return pinned;
}

// The points of `other` that the vertices of the original are bound to; empty where `in` is null or left out.
std::vector<SurfacePoint> bindingOf(const TriangleMesh& original, const TriangleMesh& other, const val& in) {
  std::vector<SurfacePoint> points;
  if (in.isNull() || in.isUndefined()) return points;
  const auto triangles = vectorOf<uint32_t>(in["triangle"]);
  const auto shares = vectorOf<float>(in["barycentric"]);
  if (triangles.size() != original.vertexCount() || shares.size() != 3 * triangles.size())
    throw std::invalid_argument(
        "The binding is not of the original: write it again together with the optimized mesh.");
  for (size_t v = 0; v < triangles.size(); ++v) {
    if (triangles[v] != kNone && triangles[v] >= other.triangleCount())
      throw std::invalid_argument(
          "The binding is not of the optimized mesh: write it again together with the optimized mesh.");
    points.push_back({triangles[v], {shares[3 * v], shares[3 * v + 1], shares[3 * v + 2]}});
  }
  return points;
}

val jsRun(const MotionRun& run) {
  val out = val::object();
  out.set("constraints", run.constraints);
  out.set("edges", run.edges);
  out.set("secondsPerStep", run.secondsPerStep);
  out.set("positions", typedArray(run.positions));
  return out;
}

val jsCompareMotion(const val& originalIn, const val& otherIn, const val& in) {
  const TriangleMesh original = meshOf(originalIn);
  MotionOptions options;
  options.simulation = simulationOptionsOf(in);
  options.scenario = scenarioOf(original, in);
  options.pinned = pinnedOf(original, options.scenario, in);
  options.records = in["records"].as<bool>();
  if (!in["calibration"].isUndefined()) options.calibration = in["calibration"].as<double>();
  TriangleMesh other;
  if (!otherIn.isNull()) {
    other = meshOf(otherIn);
    options.binding = bindingOf(original, other, in["binding"]);
  }
  const MotionComparison comparison =
      compareMotion(original, otherIn.isNull() ? nullptr : &other, options, theJob);
  val out = val::object();
  out.set("original", jsRun(comparison.original));
  out.set("other", comparison.other ? jsRun(*comparison.other) : val::null());
  out.set("deviationMean", comparison.deviation.mean);
  out.set("deviationMax", comparison.deviation.max);
  out.set("noiseFloor", comparison.noiseFloor);
  return out;
}

// ---- running simulations ----

// A running simulation, and the points that its motion deviation from other bodies of the same original is
// measured at.
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

// `mesh` is the original itself or a body that its pins are carried over to.
val jsStartSimulation(const val& meshIn, const val& originalIn, const val& in) {
  const TriangleMesh mesh = meshOf(meshIn), original = meshOf(originalIn);
  const Scenario scenario = scenarioOf(original, in);
  SimulationOptions options = simulationOptionsOf(in);
  if (!in["order"].isUndefined()) options.order = in["order"].as<uint32_t>();
  const auto binding = bindingOf(original, mesh, in["binding"]);
  const Pins pins = carryPins(original, pinnedOf(original, scenario, in), mesh, binding);
  RunningScenario body(mesh, options, scenario, pins);
  MotionSamples samples(original, mesh, body.simulation());
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

val jsSimulationDeviation(uint32_t original, uint32_t other) {
  const Running &a = runningOf(original), &b = runningOf(other);
  const MotionDeviation deviation = motionDeviation(a.samples.displacements(a.body.simulation()),
                                                    b.samples.displacements(b.body.simulation()), a.diagonal);
  val out = val::object();
  out.set("mean", deviation.mean);
  out.set("max", deviation.max);
  return out;
}

val jsDragSimulation(uint32_t number, const val& point, const val& target) {
  const Vec3 share = vec3Of(point["barycentric"]);
  runningOf(number).body.simulation().drag({point["triangle"].as<uint32_t>(), {share.x, share.y, share.z}},
                                           vec3Of(target));
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

EMSCRIPTEN_BINDINGS(limber_simulation) {
  using namespace limber;
  emscripten::function("compareMotion", &Guarded<&jsCompareMotion>::call);
  emscripten::function("scenarioCollisionScene", &Guarded<&jsScenarioCollisionScene>::call);
  emscripten::function("startSimulation", &Guarded<&jsStartSimulation>::call);
  emscripten::function("stepSimulations", &Guarded<&jsStepSimulations>::call);
  emscripten::function("simulationPositions", &Guarded<&jsSimulationPositions>::call);
  emscripten::function("simulationPins", &Guarded<&jsSimulationPins>::call);
  emscripten::function("simulationSeconds", &Guarded<&jsSimulationSeconds>::call);
  emscripten::function("simulationDiverged", &Guarded<&jsSimulationDiverged>::call);
  emscripten::function("simulationDeviation", &Guarded<&jsSimulationDeviation>::call);
  emscripten::function("dragSimulation", &Guarded<&jsDragSimulation>::call);
  emscripten::function("releaseSimulation", &Guarded<&jsReleaseSimulation>::call);
  emscripten::function("endSimulation", &Guarded<&jsEndSimulation>::call);
}
