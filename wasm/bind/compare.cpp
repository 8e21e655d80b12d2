// Measures of the similarity of two meshes: surface distance and frequencies.

#include <cmath>

#include "bind/function.h"
#include "bind/material.h"
#include "bind/meshes.h"
#include "bind/parallel_calls.h"
#include "compare/fidelity.h"
#include "compare/surface_distance.h"

namespace limber {

template <>
struct Fields<SurfaceDistance> {
  static constexpr auto list =
      std::tuple(field("hausdorff", &SurfaceDistance::hausdorff), field("mean", &SurfaceDistance::mean),
                 field("vertexHausdorff", &SurfaceDistance::vertexHausdorff));
};

// {omega, shapes} of web/engine/core. The shapes of shell modes are float32 values, so that both directions
// are exact.
template <>
struct Convert<ModeBasis> {
  static val toJs(const ModeBasis& modes) {
    std::vector<double> omega(static_cast<size_t>(modes.modeCount()));
    for (size_t k = 0; k < omega.size(); ++k)
      omega[k] = std::sqrt(modes.lambda[static_cast<Eigen::Index>(k)]);
    val out = val::object();
    out.set("omega", typedArray(omega));
    out.set("shapes", typedArray(std::vector<float>(modes.phi.data(), modes.phi.data() + modes.phi.size())));
    return out;
  }
  static ModeBasis fromJs(const val& in) {
    const auto omega = vectorOf<double>(in["omega"]);
    const auto shapes = vectorOf<float>(in["shapes"]);
    const auto count = static_cast<Eigen::Index>(omega.size());
    const auto rows = count > 0 ? static_cast<Eigen::Index>(shapes.size()) / count : 0;
    return {Eigen::Map<const Eigen::VectorXd>(omega.data(), count).cwiseAbs2(),
            Eigen::Map<const Eigen::MatrixXf>(shapes.data(), rows, count).cast<double>()};
  }
};

template <>
struct Fields<FrequencyErrors> {
  static constexpr auto list =
      std::tuple(field("mean", &FrequencyErrors::mean), field("max", &FrequencyErrors::max));
};

template <>
struct Fields<Fidelity> {
  static constexpr auto list =
      std::tuple(field("frequencyErrorMean", &Fidelity::frequencyErrorMean),
                 field("frequencyErrorMax", &Fidelity::frequencyErrorMax),
                 field("frequencyErrorCalibrated", &Fidelity::frequencyErrorCalibrated),
                 field("calibrationFactor", &Fidelity::calibrationFactor),
                 field("frequencyErrorThin", &Fidelity::frequencyErrorThin),
                 field("frequencyErrorThick", &Fidelity::frequencyErrorThick),
                 field("frequencyErrorHigh", &Fidelity::frequencyErrorHigh),
                 field("macMean", &Fidelity::macMean), field("macMin", &Fidelity::macMin));
};

namespace {

FidelityOptions fidelityOptionsOf(const val& in) {
  FidelityOptions options;
  options.modeCount = in["modeCount"].as<int>();
  options.material = fromJs<ElasticMaterial>(in);
  return options;
}

// One call of a function that measures two meshes at a number of samples.
template <auto measure>
class Measurement {
 public:
  static constexpr size_t kArguments = 3;
  static constexpr Phase kPhase = Phase::Measure;

  Measurement(const val& a, const val& b, const val& samples)
      : a_(meshOf(a)), b_(meshOf(b)), samples_(samples.as<uint32_t>()) {}
  auto run(Job& job) const { return measure(*a_, *b_, {.samples = samples_}, job); }
  val write(const auto& result) const { return toJs(result); }

 private:
  std::shared_ptr<const TriangleMesh> a_, b_;
  uint32_t samples_;
};
using MeasureDistance = Measurement<&measureSurfaceDistance>;
using MeasureHausdorff = Measurement<&measureHausdorff>;

class IsWithinHausdorff {
 public:
  static constexpr size_t kArguments = 4;
  static constexpr Phase kPhase = Phase::Measure;

  IsWithinHausdorff(const val& a, const val& b, const val& limit, const val& samples)
      : a_(meshOf(a)), b_(meshOf(b)), limit_(limit.as<double>()), samples_(samples.as<uint32_t>()) {}
  bool run(Job& job) const { return isWithinHausdorff(*a_, *b_, limit_, {.samples = samples_}, job); }
  val write(bool isWithin) const { return val(isWithin); }

 private:
  std::shared_ptr<const TriangleMesh> a_, b_;
  double limit_;
  uint32_t samples_;
};

val jsShellModes(const val& mesh, const val& in) {
  return toJs(shellModes(*meshOf(mesh), fidelityOptionsOf(in), theJob));
}

val jsFrequencyErrors(const val& original, const val& modes, const val& result, const val& in) {
  return toJs(frequencyErrors(*meshOf(original), fromJs<ModeBasis>(modes), *meshOf(result),
                              fidelityOptionsOf(in), theJob));
}

val jsCalibrationFactor(const val& original, const val& result, const val& in) {
  return val(calibrationFactor(*meshOf(original), *meshOf(result), fidelityOptionsOf(in), theJob));
}

val jsCompareFidelity(const val& original, const val& result, const val& in) {
  return toJs(compareFidelity(*meshOf(original), *meshOf(result), fidelityOptionsOf(in), theJob));
}

}  // namespace
}  // namespace limber

EMSCRIPTEN_BINDINGS(limber_compare) {
  using namespace limber;
  offerParallel<MeasureDistance>("measureSurfaceDistance");
  offerParallel<MeasureHausdorff>("measureHausdorff");
  offerParallel<IsWithinHausdorff>("isWithinHausdorff");
  offer<&jsShellModes>("shellModes");
  offer<&jsFrequencyErrors>("frequencyErrors");
  offer<&jsCalibrationFactor>("calibrationFactor");
  offer<&jsCompareFidelity>("compareFidelity");
}
