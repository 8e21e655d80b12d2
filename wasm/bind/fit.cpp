// The modal fit.

#include "bind/charts.h"
#include "bind/function.h"
#include "bind/meshes.h"
#include "fit/modal_fit.h"

namespace limber {

template <>
struct Fields<ModalFitResult> {
  static constexpr auto list =
      std::tuple(field("result", &ModalFitResult::result), field("errorBefore", &ModalFitResult::errorBefore),
                 field("errorAfter", &ModalFitResult::errorAfter), field("large", &ModalFitResult::large),
                 field("tooLarge", &ModalFitResult::tooLarge));
};

namespace {

// The storage behind the lists of ModalFitOptions.
struct FitLists {
  ChartLists charts;
  std::vector<uint8_t> locked;
  std::vector<uint32_t> mirror;
};

}  // namespace

template <>
struct Fields<FitLists> {
  static constexpr auto list =
      std::tuple(field("charts", &FitLists::charts), field("locked", &FitLists::locked),
                 optionalField("mirror", &FitLists::mirror));
};

template <>
struct Fields<ModalFitOptions> {
  static constexpr auto list = std::tuple(
      field("thickness", &ModalFitOptions::thickness), field("poisson", &ModalFitOptions::poisson),
      field("keepsSeams", &ModalFitOptions::keepsSeams),
      field("maxDeviation", &ModalFitOptions::maxDeviation), field("minAngle", &ModalFitOptions::minAngle));
};

namespace {

val jsFitModes(const val& mesh, const val& result, const val& in) {
  const auto lists = fromJs<FitLists>(in);
  auto options = fromJs<ModalFitOptions>(in);
  options.charts = lists.charts.view();
  options.locked = lists.locked;
  options.pinned = PinnedVertices(vectorOf<uint32_t>(in["pinned"]));
  options.mirror = lists.mirror;
  return toJs(fitModes(*meshOf(mesh), fromJs<MeshAt>(result), options, theJob));
}

}  // namespace
}  // namespace limber

EMSCRIPTEN_BINDINGS(limber_fit) {
  using namespace limber;
  offer<&jsFitModes>("fitModes");
}
