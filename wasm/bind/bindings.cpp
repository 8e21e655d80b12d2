// The functions of web/engine/core/core.ts; bindings_simulation.cpp has those of a running simulation. No
// other file knows both C++ and JavaScript.

#include <emscripten/bind.h>
#include <emscripten/heap.h>
#include <emscripten/val.h>

#include <algorithm>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/job.h"
#include "base/parallel.h"
#include "bind/binding_tools.h"
#include "compare/fidelity.h"
#include "compare/surface_distance.h"
#include "fields/curvature.h"
#include "fields/guidance.h"
#include "fit/modal_fit.h"
#include "mesh/inspect.h"
#include "mesh/quality.h"
#include "mesh/topology.h"
#include "mesh/weld.h"
#include "modes/find_modes.h"
#include "simplify/cost/method_names.h"
#include "simplify/history.h"
#include "simplify/mirror_images.h"
#include "simplify/simplify.h"
#include "simplify/why_kept.h"
#include "transfer/bind_meshes.h"
#include "transfer/corner_sources.h"

namespace limber {
namespace {

// ---- mesh ----

val jsInspection(const Inspection& inspection) {
  val out = val::object();
  out.set("vertices", inspection.vertices);
  out.set("faces", inspection.faces);
  out.set("components", inspection.components);
  out.set("boundaryLoops", inspection.boundaryLoops);
  out.set("genus", inspection.genus ? val(static_cast<double>(*inspection.genus)) : val::null());
  out.set("eulerCharacteristic", static_cast<double>(inspection.eulerCharacteristic));
  out.set("nonManifoldEdges", inspection.nonManifoldEdges);
  out.set("nonManifoldVertices", inspection.nonManifoldVertices);
  out.set("orientationClashes", inspection.orientationClashes);
  return out;
}

val jsWeld(const val& positions, const val& indices, const val& options) {
  const auto source = vectorOf<float>(positions);
  const auto sourceIndices = vectorOf<uint32_t>(indices);
  WeldOptions weldOptions;
  weldOptions.tolerance = options["tolerance"].as<double>();
  theJob.begin(Phase::Weld);
  const WeldResult result = weld(source, sourceIndices, weldOptions, theJob);
  weldOptions.keepDuplicates = true;
  const WeldResult asItCame =
      result.duplicateFaces ? weld(source, sourceIndices, weldOptions, theJob) : result;
  val out = val::object();
  out.set("mesh", jsMesh(result.mesh));
  out.set("vertexOfSource", typedArray(result.vertexOfSource));
  out.set("sourceOfTriangle", typedArray(result.sourceOfTriangle));
  out.set("weldedVertices", result.weldedVertices);
  out.set("degenerateFaces", result.degenerateFaces);
  out.set("duplicateFaces", result.duplicateFaces);
  out.set("flippedFaces", result.flippedFaces);
  out.set("inspection", jsInspection(inspect(asItCame.mesh)));
  return out;
}

val jsInspect(const val& mesh) {
  return jsInspection(inspect(meshOf(mesh)));
}

// ---- modes ----

// In the order of the enums.
const std::vector<std::string> modelNames = {"laplacian", "shell", "solid", "auto"};
const std::vector<std::string> modeNames = {"bend", "twist", "stretch", "breathe", "local"};

val jsFindModes(const val& jsMeshIn, const val& in) {
  const TriangleMesh mesh = meshOf(jsMeshIn);
  ModesOptions options;
  const auto model = std::find(modelNames.begin(), modelNames.end(), in["model"].as<std::string>());
  options.model = static_cast<Model>(model - modelNames.begin());
  options.direction = in["direction"].as<int>();
  options.pinned = vectorOf<uint32_t>(in["pinned"]);
  options.modeCount = in["modeCount"].as<int>();
  options.thickness = in["thickness"].as<double>();
  options.young = in["young"].as<double>();
  options.poisson = in["poisson"].as<double>();
  options.density = in["density"].as<double>();
  options.unit = in["unit"].as<double>();
  const ModeSet set = findModes(mesh, options, in["exact"].as<bool>(), theJob);

  val modes = val::array(), components = val::array(), out = val::object();
  for (const Mode& mode : set.modes) {
    val entry = val::object();
    entry.set("omega", mode.omega);
    entry.set("residual", mode.residual);
    entry.set("component", mode.component);
    entry.set("ordinal", mode.ordinal);
    entry.set("axis", mode.axis);
    entry.set("name", modeNames[static_cast<size_t>(mode.name)]);
    modes.call<void>("push", entry);
  }
  for (const ComponentModes& component : set.components) {
    val entry = val::object();
    entry.set("faces", component.faces);
    entry.set("model", modelNames[static_cast<size_t>(component.model)]);
    entry.set("host", component.host);
    entry.set("coarseVertices", component.coarseVertices);
    entry.set("zeroModesExpected", component.zeroModesExpected);
    entry.set("zeroModesFound", component.zeroModesFound);
    entry.set("modeCount", component.modeCount);
    components.call<void>("push", entry);
  }
  out.set("modes", modes);
  out.set("components", components);
  out.set("modesPerComponent", set.modesPerComponent);
  out.set("shapes", typedArray(set.shapes));
  out.set("componentOfVertex", typedArray(buildTopology(mesh).componentOfVertex));
  out.set("factorNonzeros", static_cast<double>(set.factorNonzeros));
  return out;
}

// omega[component * modesPerComponent + ordinal], 0 where the component lacks that mode.
std::vector<double> omegaTable(const val& modeSet) {
  const auto modesPerComponent = modeSet["modesPerComponent"].as<uint32_t>();
  const auto componentCount = modeSet["components"]["length"].as<uint32_t>();
  std::vector<double> omega(size_t{modesPerComponent} * componentCount, 0.0);
  const val modes = modeSet["modes"];
  const auto modeCount = modes["length"].as<uint32_t>();
  for (uint32_t i = 0; i < modeCount; ++i) {
    const size_t at =
        size_t{modes[i]["component"].as<uint32_t>()} * modesPerComponent + modes[i]["ordinal"].as<uint32_t>();
    if (at >= omega.size())
      throw std::invalid_argument("A mode names a component or ordinal that its set does not have.");
    omega[at] = modes[i]["omega"].as<double>();
  }
  for (uint32_t component = 0; component < componentCount; ++component) {  // cavities have their host's
    const auto host = modeSet["components"][component]["host"].as<uint32_t>();
    if (host >= componentCount)
      throw std::invalid_argument("A part of the modes names a host that is not there.");
    for (uint32_t ordinal = 0; ordinal < modesPerComponent; ++ordinal)
      omega[size_t{component} * modesPerComponent + ordinal] =
          omega[size_t{host} * modesPerComponent + ordinal];
  }
  return omega;
}

val jsStrainGuidance(const val& mesh, const val& modeSet, const val& in) {
  GuidanceOptions options;
  options.ordinals = vectorOf<uint32_t>(in["ordinals"]);
  options.weights = vectorOf<double>(in["weights"]);
  options.p = in["p"].as<double>();
  options.threshold = in["threshold"].as<double>();
  const auto shapes = vectorOf<float>(modeSet["shapes"]);
  const StrainGuidance guidance = strainGuidance(meshOf(mesh), shapes, omegaTable(modeSet), options, theJob);
  val out = val::object();
  out.set("strain", typedArray(guidance.strain));
  out.set("rank", typedArray(guidance.rank));
  return out;
}

val jsMeanCurvature(const val& jsMeshIn) {
  const TriangleMesh mesh = meshOf(jsMeshIn);
  const Curvature curvature = meanCurvature(mesh, buildTopology(mesh), theJob);
  val out = val::object();
  out.set("vertex", typedArray(curvature.vertex));
  out.set("triangle", typedArray(curvature.triangle));
  return out;
}

// ---- symmetry ----

val jsFindMirrorImages(const val& mesh, const val& charts, int axis) {
  const auto wedges = vectorOf<uint32_t>(charts["wedges"]), groups = vectorOf<uint32_t>(charts["groups"]);
  const MirrorImages images = findMirrorImages(meshOf(mesh), {wedges, groups}, axis, theJob);
  val out = val::object();
  out.set("partners", typedArray(images.partners));
  out.set("corners", typedArray(images.corners));
  out.set("asymmetricVertices", images.asymmetricVertices);
  out.set("asymmetricTriangles", images.asymmetricTriangles);
  return out;
}

// ---- simplification ----

// In the order of the enums.
const std::vector<std::string> stopNames = {"target", "deviation", "angle", "exhausted"};

template <typename T>
std::vector<T> optionalVector(const val& array) {
  return array.isUndefined() ? std::vector<T>() : vectorOf<T>(array);
}
double optionalNumber(const val& number) {
  return number.isUndefined() ? 0 : number.as<double>();
}

// Everything that a simplification is asked for, in storage of its own.
struct Request {
  TriangleMesh mesh;
  std::vector<float> strain, curvature, keep, attributes;
  std::vector<uint32_t> wedges, groups, pinnedSets, mirror;
  std::vector<uint8_t> locked;
  SimplifyOptions options;

  Request(const val& jsMeshIn, const val& jsStrain, const val& jsCurvature, const val& in)
      : mesh(meshOf(jsMeshIn)), strain(vectorOf<float>(jsStrain)), curvature(vectorOf<float>(jsCurvature)) {
    options.method = methodNamed(in["method"].as<std::string>());
    options.strainWeight = in["strainWeight"].as<double>();
    options.curvatureWeight = in["curvatureWeight"].as<double>();
    options.qualityWeight = in["qualityWeight"].as<double>();
    options.sizeWeight = optionalNumber(in["sizeWeight"]);
    options.stopFaces = static_cast<uint32_t>(optionalNumber(in["stopFaces"]));
    options.maxDeviation = optionalNumber(in["maxDeviation"]);
    options.minAngle = optionalNumber(in["minAngle"]);
    if (!in["constraints"].isUndefined()) readConstraints(in["constraints"]);
  }
  Request(const Request&) = delete;  // the options point into it

  Guidance guidance() const { return {strain, curvature}; }

 private:
  void readConstraints(const val& in) {
    wedges = optionalVector<uint32_t>(in["wedges"]);
    groups = optionalVector<uint32_t>(in["groups"]);
    locked = optionalVector<uint8_t>(in["locked"]);
    keep = optionalVector<float>(in["keep"]);
    pinnedSets = optionalVector<uint32_t>(in["pinnedSets"]);
    attributes = optionalVector<float>(in["attributes"]);
    mirror = optionalVector<uint32_t>(in["mirror"]);
    const bool fixed = !in["borders"].isUndefined() && in["borders"].as<std::string>() == "fixed";
    options.constraints = {
        .wedges = wedges,
        .groups = groups,
        .locked = locked,
        .keep = keep,
        .pinnedSets = pinnedSets,
        .attributes = attributes,
        .mirror = mirror,
        .attributeDimension = static_cast<uint32_t>(optionalNumber(in["attributeDimension"])),
        .creaseAngle = optionalNumber(in["creaseAngle"]),
        .borders = fixed ? Borders::Fixed : Borders::Free};
  }
};

val jsSimplify(const val& mesh, const val& strain, const val& curvature, const val& in) {
  const Request request(mesh, strain, curvature, in);
  const History history = simplify(request.mesh, request.guidance(), request.options, theJob);
  val out = val::object(), refused = val::object();
  refused.set("topology", history.refused.topology);
  refused.set("flip", history.refused.flip);
  refused.set("lock", history.refused.lock);
  refused.set("angle", history.refused.angle);
  refused.set("deviation", history.refused.deviation);
  out.set("vertexCount", history.vertexCount);
  out.set("triangleCount", history.triangleCount);
  out.set("kept", typedArray(history.kept));
  out.set("removed", typedArray(history.removed));
  out.set("positions", typedArray(history.positions));
  out.set("trianglesAfter", typedArray(history.trianglesAfter));
  out.set("refused", refused);
  out.set("stop", stopNames[static_cast<size_t>(history.stop)]);
  return out;
}

History historyOf(const val& in) {
  History history;
  history.vertexCount = in["vertexCount"].as<uint32_t>();
  history.triangleCount = in["triangleCount"].as<uint32_t>();
  history.kept = vectorOf<uint32_t>(in["kept"]);
  history.removed = vectorOf<uint32_t>(in["removed"]);
  history.positions = vectorOf<float>(in["positions"]);
  history.trianglesAfter = vectorOf<uint32_t>(in["trianglesAfter"]);
  return history;
}

std::vector<uint32_t> cornersOf(const std::vector<Triangle>& triangles) {
  std::vector<uint32_t> corners;
  for (const Triangle& triangle : triangles) corners.insert(corners.end(), triangle.begin(), triangle.end());
  return corners;
}

val jsMeshAtOf(const MeshAt& at) {
  val out = val::object(), flips = val::object();
  flips.set("triangles", typedArray(cornersOf(at.flips.triangles)));
  flips.set("corners", typedArray(at.flips.corners));
  out.set("mesh", jsMesh(at.mesh));
  out.set("vertexOfInput", typedArray(at.vertexOfInput));
  out.set("inputOfVertex", typedArray(at.inputOfVertex));
  out.set("inputOfTriangle", typedArray(at.inputOfTriangle));
  out.set("flips", flips);
  return out;
}

val jsMeshAt(const val& mesh, const val& history, uint32_t faces) {
  return jsMeshAtOf(meshAt(meshOf(mesh), historyOf(history), faces));
}

// The terms as arrays, one value per vertex of meshAt(mesh, history, faces).
val jsWhyKept(const val& mesh, const val& strain, const val& curvature, const val& in, const val& history,
              uint32_t faces) {
  const Request request(mesh, strain, curvature, in);
  const History made = historyOf(history);
  const auto all = whyKept({request.mesh, request.guidance(), request.options, made}, faces, theJob);
  const std::pair<const char*, double CostTerms::*> terms[] = {
      {"error", &CostTerms::error},         {"size", &CostTerms::size},       {"strain", &CostTerms::strain},
      {"curvature", &CostTerms::curvature}, {"quality", &CostTerms::quality}, {"keep", &CostTerms::keep}};
  val out = val::object();
  for (const auto& [name, term] : terms) {
    std::vector<float> values;
    for (const WhyKept& why : all) values.push_back(static_cast<float>(why.terms.*term));
    out.set(name, typedArray(values));
  }
  std::vector<uint32_t> neighbour;
  std::vector<uint8_t> verdict;
  for (const WhyKept& why : all) {
    neighbour.push_back(why.neighbour);
    verdict.push_back(static_cast<uint8_t>(why.verdict));
  }
  out.set("neighbour", typedArray(neighbour));
  out.set("verdict", typedArray(verdict));
  return out;
}

MeshAt meshAtOf(const val& in) {
  MeshAt result;
  result.mesh = meshOf(in["mesh"]);
  result.vertexOfInput = vectorOf<uint32_t>(in["vertexOfInput"]);
  result.inputOfVertex = vectorOf<uint32_t>(in["inputOfVertex"]);
  result.inputOfTriangle = vectorOf<uint32_t>(in["inputOfTriangle"]);
  const auto before = vectorOf<uint32_t>(in["flips"]["triangles"]);
  for (size_t i = 0; i + 2 < before.size(); i += 3)
    result.flips.triangles.push_back({before[i], before[i + 1], before[i + 2]});
  result.flips.corners = vectorOf<uint32_t>(in["flips"]["corners"]);
  return result;
}

// ---- fit ----

val jsFitModes(const val& mesh, const val& result, const val& in) {
  const auto wedges = vectorOf<uint32_t>(in["charts"]["wedges"]),
             groups = vectorOf<uint32_t>(in["charts"]["groups"]);
  const auto locked = vectorOf<uint8_t>(in["locked"]);
  ModalFitOptions options;
  options.thickness = in["thickness"].as<double>();
  options.poisson = in["poisson"].as<double>();
  options.charts = {wedges, groups};
  options.holdsSeams = in["holdsSeams"].as<bool>();
  options.locked = locked;
  const auto pinned = vectorOf<uint8_t>(in["pinned"]);
  options.pinned = pinned;
  const auto mirror = optionalVector<uint32_t>(in["mirror"]);
  options.mirror = mirror;
  options.maxDeviation = in["maxDeviation"].as<double>();
  options.minAngle = in["minAngle"].as<double>();
  const ModalFitResult fitted = fitModes(meshOf(mesh), meshAtOf(result), options, theJob);
  val out = val::object();
  out.set("result", jsMeshAtOf(fitted.result));
  out.set("errorBefore", typedArray(fitted.errorBefore));
  out.set("errorAfter", typedArray(fitted.errorAfter));
  out.set("large", fitted.large);
  out.set("tooLarge", fitted.tooLarge);
  return out;
}

// ---- transfer ----

val jsSourceOfCorners(const val& mesh, const val& charts, const val& result) {
  const auto wedges = vectorOf<uint32_t>(charts["wedges"]), groups = vectorOf<uint32_t>(charts["groups"]);
  const CornerSources sources = sourceOfCorners(meshOf(mesh), {wedges, groups}, meshAtOf(result), theJob);
  val out = val::object();
  out.set("triangle", typedArray(sources.triangle));
  out.set("barycentric", typedArray(sources.barycentric));
  return out;
}

val jsBindToResult(const val& mesh, const val& result) {
  const Binding binding = bindToResult(meshOf(mesh), meshAtOf(result), theJob);
  val out = val::object();
  out.set("triangle", typedArray(binding.triangle));
  out.set("barycentric", typedArray(binding.barycentric));
  out.set("offset", typedArray(binding.offset));
  return out;
}

// ---- measures ----

val jsMeasureQuality(const val& mesh) {
  const QualityReport quality = measureQuality(meshOf(mesh));
  val out = val::object();
  out.set("minAngle", quality.minAngle);
  out.set("meanMinAngle", quality.meanMinAngle);
  return out;
}

val jsMeasureSurfaceDistance(const val& a, const val& b) {
  const SurfaceDistance distance = measureSurfaceDistance(meshOf(a), meshOf(b), {}, theJob);
  val out = val::object();
  out.set("hausdorff", distance.hausdorff);
  out.set("mean", distance.mean);
  out.set("vertexHausdorff", distance.vertexHausdorff);
  return out;
}

FidelityOptions fidelityOptionsOf(const val& in) {
  FidelityOptions options;
  options.modeCount = in["modeCount"].as<int>();
  options.thickness = in["thickness"].as<double>();
  options.young = in["young"].as<double>();
  options.poisson = in["poisson"].as<double>();
  options.density = in["density"].as<double>();
  options.unit = in["unit"].as<double>();
  return options;
}

val jsShellModes(const val& mesh, const val& in) {
  const ShellModes modes = shellModes(meshOf(mesh), fidelityOptionsOf(in), theJob);
  val out = val::object();
  out.set("omega", typedArray(modes.omega));
  out.set("shapes", typedArray(modes.shapes));
  return out;
}

val jsFrequencyErrors(const val& original, const val& modes, const val& other, const val& in) {
  const ShellModes shellModes{vectorOf<double>(modes["omega"]), vectorOf<float>(modes["shapes"])};
  const FrequencyErrors errors =
      frequencyErrors(meshOf(original), shellModes, meshOf(other), fidelityOptionsOf(in), theJob);
  val out = val::object();
  out.set("mean", errors.mean);
  out.set("max", errors.max);
  return out;
}

val jsCalibrationFactor(const val& original, const val& other, const val& in) {
  return val(calibrationFactor(meshOf(original), meshOf(other), fidelityOptionsOf(in), theJob));
}

val jsCompareFidelity(const val& original, const val& other, const val& in) {
  const Fidelity fidelity = compareFidelity(meshOf(original), meshOf(other), fidelityOptionsOf(in), theJob);
  val out = val::object();
  out.set("frequencyErrorMean", fidelity.frequencyErrorMean);
  out.set("frequencyErrorMax", fidelity.frequencyErrorMax);
  out.set("frequencyErrorCalibrated", fidelity.frequencyErrorCalibrated);
  out.set("calibrationFactor", fidelity.calibrationFactor);
  out.set("frequencyErrorThin", fidelity.frequencyErrorThin);
  out.set("frequencyErrorThick", fidelity.frequencyErrorThick);
  out.set("frequencyErrorHigh", fidelity.frequencyErrorHigh);
  out.set("macMean", fidelity.macMean);
  out.set("macMin", fidelity.macMin);
  return out;
}

// ---- the running call ----

uintptr_t jobAddress() {
  return reinterpret_cast<uintptr_t>(&theJob.words[0]);
}

// Before each call: no wish to cancel, no progress. `observer` is null or called with (phase, fraction) on
// this thread.
void resetJob(const val& observer) {
  theJob.reset();
  theJob.observer = nullptr;
  if (!observer.isNull())
    theJob.observer = [observer](Phase phase, double fraction) {
      observer(static_cast<int>(phase), fraction);
    };
}

double peakHeapBytes() {
  return static_cast<double>(emscripten_get_heap_size());
}

}  // namespace
}  // namespace limber

EMSCRIPTEN_BINDINGS(limber) {
  using namespace limber;
  emscripten::function("weld", &Guarded<&jsWeld>::call);
  emscripten::function("inspect", &Guarded<&jsInspect>::call);
  emscripten::function("findModes", &Guarded<&jsFindModes>::call);
  emscripten::function("strainGuidance", &Guarded<&jsStrainGuidance>::call);
  emscripten::function("meanCurvature", &Guarded<&jsMeanCurvature>::call);
  emscripten::function("findMirrorImages", &Guarded<&jsFindMirrorImages>::call);
  emscripten::function("simplify", &Guarded<&jsSimplify>::call);
  emscripten::function("meshAt", &Guarded<&jsMeshAt>::call);
  emscripten::function("fitModes", &Guarded<&jsFitModes>::call);
  emscripten::function("whyKept", &Guarded<&jsWhyKept>::call);
  emscripten::function("sourceOfCorners", &Guarded<&jsSourceOfCorners>::call);
  emscripten::function("bindToResult", &Guarded<&jsBindToResult>::call);
  emscripten::function("measureQuality", &Guarded<&jsMeasureQuality>::call);
  emscripten::function("measureSurfaceDistance", &Guarded<&jsMeasureSurfaceDistance>::call);
  emscripten::function("calibrationFactor", &Guarded<&jsCalibrationFactor>::call);
  emscripten::function("compareFidelity", &Guarded<&jsCompareFidelity>::call);
  emscripten::function("shellModes", &Guarded<&jsShellModes>::call);
  emscripten::function("frequencyErrors", &Guarded<&jsFrequencyErrors>::call);
  emscripten::function("setThreadCount", &setThreadCount);
  emscripten::function("threadCount", &threadCount);
  emscripten::function("jobAddress", &jobAddress);
  emscripten::function("resetJob", &resetJob);
  emscripten::function("peakHeapBytes", &peakHeapBytes);
}
