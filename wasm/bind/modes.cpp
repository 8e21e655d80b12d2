// Modes of vibration and the guidance that follows from them.

#include "bind/function.h"
#include "bind/material.h"
#include "bind/meshes.h"
#include "bind/parallel_calls.h"
#include "fields/guidance.h"
#include "mesh/topology.h"
#include "modes/find_modes.h"

namespace limber {

template <>
struct Names<ElasticModel> {
  static constexpr std::array list = {"laplacian", "shell", "solid", "auto"};
  static constexpr const char* what = "elastic model";
};

template <>
struct Names<ModeName> {
  static constexpr std::array list = {"bend", "twist", "stretch", "breathe", "local"};
  static constexpr const char* what = "name of a mode";
};

template <>
struct Fields<Mode> {
  static constexpr auto list = std::tuple(
      field("omega", &Mode::omega), field("residual", &Mode::residual), field("component", &Mode::component),
      field("ordinal", &Mode::ordinal), field("axis", &Mode::axis), field("name", &Mode::name));
};

template <>
struct Fields<ComponentModes> {
  static constexpr auto list = std::tuple(
      field("faces", &ComponentModes::faces), field("model", &ComponentModes::model),
      field("host", &ComponentModes::host), field("coarseVertices", &ComponentModes::coarseVertices),
      field("zeroModesExpected", &ComponentModes::zeroModesExpected),
      field("zeroModesFound", &ComponentModes::zeroModesFound),
      field("modeCount", &ComponentModes::modeCount), optionalField("failure", &ComponentModes::failure));
};

template <>
struct Fields<ModeSet> {
  static constexpr auto list =
      std::tuple(field("modes", &ModeSet::modes), field("components", &ModeSet::components),
                 field("modesPerComponent", &ModeSet::modesPerComponent), field("shapes", &ModeSet::shapes),
                 field("factorNonzeros", &ModeSet::factorNonzeros));
};

template <>
struct Fields<ModesOptions> {
  static constexpr auto list =
      std::tuple(field("model", &ModesOptions::model), field("direction", &ModesOptions::direction),
                 field("pinned", &ModesOptions::pinned), field("modeCount", &ModesOptions::modeCount),
                 optionalField("guidedParts", &ModesOptions::guidedParts));
};

template <>
struct Fields<GuidanceOptions> {
  static constexpr auto list =
      std::tuple(field("ordinals", &GuidanceOptions::ordinals), field("weights", &GuidanceOptions::weights),
                 field("p", &GuidanceOptions::p), field("threshold", &GuidanceOptions::threshold));
};

template <>
struct Fields<StrainGuidance> {
  static constexpr auto list =
      std::tuple(field("strain", &StrainGuidance::strain), field("rank", &StrainGuidance::rank));
};

namespace {

class FindModes {
 public:
  static constexpr size_t kArguments = 2;
  static constexpr Phase kPhase = Phase::Solve;

  FindModes(const val& mesh, const val& in)
      : mesh_(meshOf(mesh)), options_(fromJs<ModesOptions>(in)), exact_(in["exact"].as<bool>()) {
    options_.material = fromJs<ElasticMaterial>(in);
  }
  ModeSet run(Job& job) const { return findModes(*mesh_, options_, exact_, job); }
  val write(const ModeSet& modes) const {
    val out = toJs(modes);
    out.set("componentOfVertex", typedArray(buildTopology(*mesh_).componentOfVertex));
    return out;
  }

 private:
  std::shared_ptr<const TriangleMesh> mesh_;
  ModesOptions options_;
  bool exact_;
};

// omega[component * modesPerComponent + ordinal], 0 if the component lacks that mode. A cavity has the
// frequencies of its host. Throws std::invalid_argument if indices are out of range.
std::vector<double> omegaTable(const std::vector<Mode>& modes, const std::vector<ComponentModes>& components,
                               uint32_t modesPerComponent) {
  std::vector<double> omega(size_t{modesPerComponent} * components.size(), 0.0);
  for (const Mode& mode : modes) {
    const size_t at = size_t{mode.component} * modesPerComponent + mode.ordinal;
    if (at >= omega.size())
      throw std::invalid_argument("A mode names a component or an ordinal that its set does not have.");
    omega[at] = mode.omega;
  }
  for (size_t component = 0; component < components.size(); ++component) {
    const size_t host = components[component].host;
    if (host >= components.size())
      throw std::invalid_argument("A part of the modes names a host that is not there.");
    std::copy_n(omega.begin() + static_cast<ptrdiff_t>(host * modesPerComponent), modesPerComponent,
                omega.begin() + static_cast<ptrdiff_t>(component * modesPerComponent));
  }
  return omega;
}

class FindGuidance {
 public:
  static constexpr size_t kArguments = 3;
  static constexpr Phase kPhase = Phase::Strain;

  FindGuidance(const val& mesh, const val& modes, const val& options)
      : mesh_(meshOf(mesh)),
        shapes_(vectorOf<float>(modes["shapes"])),
        omega_(omegaTable(fromJs<std::vector<Mode>>(modes["modes"]),
                          fromJs<std::vector<ComponentModes>>(modes["components"]),
                          modes["modesPerComponent"].as<uint32_t>())),
        options_(fromJs<GuidanceOptions>(options)) {}
  StrainGuidance run(Job& job) const { return strainGuidance(*mesh_, shapes_, omega_, options_, job); }
  val write(const StrainGuidance& guidance) const { return toJs(guidance); }

 private:
  std::shared_ptr<const TriangleMesh> mesh_;
  std::vector<float> shapes_;
  std::vector<double> omega_;
  GuidanceOptions options_;
};

}  // namespace
}  // namespace limber

EMSCRIPTEN_BINDINGS(limber_modes) {
  using namespace limber;
  offerParallel<FindModes>("findModes");
  offerParallel<FindGuidance>("strainGuidance");
}
