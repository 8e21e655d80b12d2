// Simplification: the history, the mesh at a number of faces, and why vertices are kept.

#include "simplify/simplify.h"

#include "bind/function.h"
#include "bind/meshes.h"
#include "bind/parallel_calls.h"
#include "simplify/method_name.h"
#include "simplify/why_kept.h"

namespace limber {

template <>
struct Convert<Method> {
  static Method fromJs(const val& in) { return methodNamed(in.as<std::string>()); }
};

template <>
struct Names<Borders> {
  static constexpr std::array list = {"free", "fixed"};
  static constexpr const char* what = "treatment of borders";
};

namespace {

// The storage behind SimplifyConstraints.
struct ConstraintLists {
  std::vector<uint32_t> wedges, groups, pinnedSets, mirror;
  std::vector<float> keep, attributes, textureWeights;
  std::vector<uint8_t> locked;
  uint32_t attributeDimension = 0;
  uint32_t displacementFields = 0;
  double creaseAngle = 0;
  Borders borders = Borders::Free;

  SimplifyConstraints view() const {
    return {.wedges = wedges,
            .groups = groups,
            .locked = locked,
            .keep = keep,
            .pinnedSets = pinnedSets,
            .attributes = attributes,
            .textureWeights = textureWeights,
            .mirror = mirror,
            .attributeDimension = attributeDimension,
            .displacementFields = displacementFields,
            .creaseAngle = creaseAngle,
            .borders = borders};
  }
};

}  // namespace

template <>
struct Fields<ConstraintLists> {
  static constexpr auto list = std::tuple(
      optionalField("wedges", &ConstraintLists::wedges), optionalField("groups", &ConstraintLists::groups),
      optionalField("locked", &ConstraintLists::locked), optionalField("keep", &ConstraintLists::keep),
      optionalField("pinnedSets", &ConstraintLists::pinnedSets),
      optionalField("attributes", &ConstraintLists::attributes),
      optionalField("textureWeights", &ConstraintLists::textureWeights),
      optionalField("attributeDimension", &ConstraintLists::attributeDimension),
      optionalField("displacementFields", &ConstraintLists::displacementFields),
      optionalField("mirror", &ConstraintLists::mirror),
      optionalField("creaseAngle", &ConstraintLists::creaseAngle),
      optionalField("borders", &ConstraintLists::borders));
};

template <>
struct Fields<SimplifyOptions> {
  static constexpr auto list = std::tuple(field("method", &SimplifyOptions::method),
                                          field("strainWeight", &SimplifyOptions::strainWeight),
                                          field("curvatureWeight", &SimplifyOptions::curvatureWeight),
                                          field("qualityWeight", &SimplifyOptions::qualityWeight),
                                          optionalField("sizeWeight", &SimplifyOptions::sizeWeight),
                                          optionalField("stopFaces", &SimplifyOptions::stopFaces),
                                          optionalField("maxDeviation", &SimplifyOptions::maxDeviation),
                                          optionalField("minAngle", &SimplifyOptions::minAngle),
                                          optionalField("recordErrors", &SimplifyOptions::recordErrors),
                                          optionalField("deferBeyond", &SimplifyOptions::deferBeyond));
};

namespace {

// A request for a simplification, which owns its storage.
struct Request {
  std::shared_ptr<const TriangleMesh> mesh;
  std::vector<float> strain, curvature;
  ConstraintLists constraints;
  SimplifyOptions options;

  Request(const val& meshIn, const val& strainIn, const val& curvatureIn, const val& in)
      : mesh(meshOf(meshIn)),
        strain(vectorOf<float>(strainIn)),
        curvature(vectorOf<float>(curvatureIn)),
        options(fromJs<SimplifyOptions>(in)) {
    if (!in["constraints"].isUndefined()) constraints = fromJs<ConstraintLists>(in["constraints"]);
    options.constraints = constraints.view();
  }
  Request(const Request&) = delete;  // the options point into it

  Guidance guidance() const { return {strain, curvature}; }
};

class Simplify {
 public:
  static constexpr size_t kArguments = 4;
  static constexpr Phase kPhase = Phase::Simplify;

  Simplify(const val& mesh, const val& strain, const val& curvature, const val& options)
      : request_(mesh, strain, curvature, options) {}
  History run(Job& job) const { return simplify(*request_.mesh, request_.guidance(), request_.options, job); }
  val write(const History& history) const { return toJs(history); }

 private:
  Request request_;
};

val jsMeshAt(const val& mesh, const val& history, uint32_t faces) {
  return toJs(meshAt(*meshOf(mesh), *historyOf(history), faces));
}

// The terms as arrays, one value per vertex of meshAt(mesh, history, faces).
val jsWhyKept(const val& reduction, uint32_t faces) {
  const Request request(reduction["mesh"], reduction["strain"], reduction["curvature"], reduction["options"]);
  const auto history = historyOf(reduction["history"]);
  const auto all = whyKept({*request.mesh, request.guidance(), request.options, *history}, faces, theJob);
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

}  // namespace
}  // namespace limber

EMSCRIPTEN_BINDINGS(limber_simplify) {
  using namespace limber;
  offerParallel<Simplify>("simplify");
  offer<&jsMeshAt>("meshAt");
  offer<&jsWhyKept>("whyKept");
}
