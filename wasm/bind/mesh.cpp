// Meshes: welding, inspection, quality, curvature, mirror symmetry.

#include "bind/charts.h"
#include "bind/function.h"
#include "bind/meshes.h"
#include "fields/curvature.h"
#include "mesh/quality.h"
#include "mesh/repair/inspect.h"
#include "mesh/repair/weld.h"
#include "mesh/topology.h"
#include "simplify/symmetry/mirror_images.h"

namespace limber {

template <>
struct Fields<Inspection> {
  static constexpr auto list = std::tuple(
      field("vertices", &Inspection::vertices), field("faces", &Inspection::faces),
      field("components", &Inspection::components), field("solidComponents", &Inspection::solidComponents),
      field("boundaryLoops", &Inspection::boundaryLoops), field("genus", &Inspection::genus),
      field("eulerCharacteristic", &Inspection::eulerCharacteristic),
      field("nonManifoldEdges", &Inspection::nonManifoldEdges),
      field("nonManifoldVertices", &Inspection::nonManifoldVertices),
      field("orientationClashes", &Inspection::orientationClashes));
};

template <>
struct Fields<WeldResult> {
  static constexpr auto list = std::tuple(
      field("mesh", &WeldResult::mesh), field("vertexOfSource", &WeldResult::vertexOfSource),
      field("sourceOfTriangle", &WeldResult::sourceOfTriangle),
      field("weldedVertices", &WeldResult::weldedVertices),
      field("degenerateFaces", &WeldResult::degenerateFaces),
      field("duplicateFaces", &WeldResult::duplicateFaces), field("flippedFaces", &WeldResult::flippedFaces));
};

template <>
struct Fields<QualityReport> {
  static constexpr auto list = std::tuple(field("minAngle", &QualityReport::minAngle),
                                          field("meanMinAngle", &QualityReport::meanMinAngle));
};

template <>
struct Fields<Curvature> {
  static constexpr auto list =
      std::tuple(field("vertex", &Curvature::vertex), field("triangle", &Curvature::triangle));
};

template <>
struct Fields<MirrorImages> {
  static constexpr auto list =
      std::tuple(field("partners", &MirrorImages::partners), field("corners", &MirrorImages::corners),
                 field("asymmetricVertices", &MirrorImages::asymmetricVertices),
                 field("asymmetricTriangles", &MirrorImages::asymmetricTriangles));
};

namespace {

val jsWeld(const val& positions, const val& indices, const val& options) {
  const auto source = vectorOf<float>(positions);
  const auto sourceIndices = vectorOf<uint32_t>(indices);
  WeldOptions weldOptions;
  weldOptions.tolerance = options["tolerance"].as<double>();
  theJob.begin(Phase::Weld);
  const WeldResult result = weld(source, sourceIndices, weldOptions, theJob);
  val out = toJs(result);
  // The inspection is that of the input mesh, including its duplicate faces.
  weldOptions.keepDuplicates = true;
  const Inspection inspection =
      inspect(result.duplicateFaces ? weld(source, sourceIndices, weldOptions, theJob).mesh : result.mesh);
  out.set("inspection", toJs(inspection));
  return out;
}

val jsInspect(const val& mesh) {
  return toJs(inspect(*meshOf(mesh)));
}

val jsMeasureQuality(const val& mesh) {
  return toJs(measureQuality(*meshOf(mesh)));
}

val jsMeanCurvature(const val& in) {
  const auto mesh = meshOf(in);
  return toJs(meanCurvature(*mesh, buildTopology(*mesh), theJob));
}

val jsFindMirrorImages(const val& mesh, const val& charts, int axis) {
  return toJs(findMirrorImages(*meshOf(mesh), fromJs<ChartLists>(charts).view(), axis, theJob));
}

}  // namespace
}  // namespace limber

EMSCRIPTEN_BINDINGS(limber_mesh) {
  using namespace limber;
  offer<&jsWeld>("weld");
  offer<&jsInspect>("inspect");
  offer<&jsMeasureQuality>("measureQuality");
  offer<&jsMeanCurvature>("meanCurvature");
  offer<&jsFindMirrorImages>("findMirrorImages");
}
