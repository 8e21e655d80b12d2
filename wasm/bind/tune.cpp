// Tuning: the parameters with which a solver moves a coarse mesh as it moves the original.

#include "bind/function.h"
#include "bind/meshes.h"
#include "bind/solver.h"
#include "fit/tune/tune_solver.h"

namespace limber {

template <>
struct Names<TuneKind> {
  static constexpr std::array list = {"global", "vertex", "constraint"};
  static constexpr const char* what = "kind of tuning";
};

template <>
struct Names<KeptParameters> {
  static constexpr std::array list = {"tuned", "untouched"};
  static constexpr const char* what = "choice of parameters";
};

template <>
struct Names<FrequencyStatus> {
  static constexpr std::array list = {"found", "noResistance", "noConvergence"};
  static constexpr const char* what = "status of frequencies";
};

template <>
struct Fields<TuneOptions> {
  static constexpr auto list =
      std::tuple(field("model", &TuneOptions::model), field("original", &TuneOptions::original),
                 field("result", &TuneOptions::result), field("pinnedOriginal", &TuneOptions::pinnedOriginal),
                 field("pinnedResult", &TuneOptions::pinnedResult), field("tune", &TuneOptions::tune),
                 field("tunedMass", &TuneOptions::tunedMass), field("runsTrial", &TuneOptions::runsTrial));
};

template <>
struct Fields<TunedFrequencies> {
  static constexpr auto list = std::tuple(field("errorUntouched", &TunedFrequencies::errorUntouched),
                                          field("errorTuned", &TunedFrequencies::errorTuned),
                                          field("errorUnseen", &TunedFrequencies::errorUnseen),
                                          field("errorOtherPins", &TunedFrequencies::errorOtherPins));
};

template <>
struct Fields<TunedMotion> {
  static constexpr auto list =
      std::tuple(field("scene", &TunedMotion::scene), field("untouched", &TunedMotion::untouched),
                 field("tuned", &TunedMotion::tuned), field("noiseFloor", &TunedMotion::noiseFloor),
                 field("kept", &TunedMotion::kept));
};

template <>
struct Fields<Tuned> {
  static constexpr auto list =
      std::tuple(field("stretchFactor", &Tuned::stretchFactor), field("bendFactor", &Tuned::bendFactor),
                 field("stretchField", &Tuned::stretchField), field("bendField", &Tuned::bendField),
                 field("stretchFactors", &Tuned::stretchFactors), field("bendFactors", &Tuned::bendFactors),
                 field("masses", &Tuned::masses), field("stretchVertices", &Tuned::stretchVertices),
                 field("bendVertices", &Tuned::bendVertices), field("frequencies", &Tuned::frequencies),
                 field("frequencyStatus", &Tuned::frequencyStatus), field("kept", &Tuned::kept),
                 field("motion", &Tuned::motion), field("motionRefusal", &Tuned::motionRefusal));
};

namespace {

val jsTuneSolver(const val& original, const val& result, const val& options) {
  return toJs(tuneSolver(*meshOf(original), *meshOf(result), fromJs<TuneOptions>(options), theJob));
}

}  // namespace
}  // namespace limber

EMSCRIPTEN_BINDINGS(limber_tune) {
  using namespace limber;
  offer<&jsTuneSolver>("tuneSolver");
}
