// The fits: to the surface, and to the modes.

#include "bind/charts.h"
#include "bind/function.h"
#include "bind/meshes.h"
#include "bind/parallel_calls.h"
#include "fit/modal_fit.h"
#include "fit/shape_fit.h"

namespace limber {

template <>
struct Fields<ModalFitResult> {
  static constexpr auto list =
      std::tuple(field("result", &ModalFitResult::result), field("errorBefore", &ModalFitResult::errorBefore),
                 field("errorAfter", &ModalFitResult::errorAfter), field("large", &ModalFitResult::large),
                 field("tooLarge", &ModalFitResult::tooLarge), field("flips", &ModalFitResult::flips));
};

template <>
struct Fields<ShapeFitResult> {
  static constexpr auto list =
      std::tuple(field("result", &ShapeFitResult::result), field("flips", &ShapeFitResult::flips));
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

template <>
struct Fields<ShapeFitOptions> {
  static constexpr auto list = std::tuple(field("keepsSeams", &ShapeFitOptions::keepsSeams),
                                          field("maxDeviation", &ShapeFitOptions::maxDeviation),
                                          field("minAngle", &ShapeFitOptions::minAngle),
                                          optionalField("samples", &ShapeFitOptions::samples));
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

class FitShape {
 public:
  static constexpr size_t kArguments = 3;
  static constexpr Phase kPhase = Phase::Fit;

  FitShape(const val& mesh, const val& result, const val& in)
      : mesh_(meshOf(mesh)),
        result_(fromJs<MeshAt>(result)),
        lists_(fromJs<FitLists>(in)),
        options_(fromJs<ShapeFitOptions>(in)) {
    options_.charts = lists_.charts.view();
    options_.locked = lists_.locked;
    options_.pinned = PinnedVertices(vectorOf<uint32_t>(in["pinned"]));
    options_.mirror = lists_.mirror;
  }
  FitShape(const FitShape&) = delete;  // the options point into it

  ShapeFitResult run(Job& job) const { return fitShape(*mesh_, result_, options_, job); }
  val write(const ShapeFitResult& fitted) const { return toJs(fitted); }

 private:
  std::shared_ptr<const TriangleMesh> mesh_;
  MeshAt result_;
  FitLists lists_;
  ShapeFitOptions options_;
};

}  // namespace
}  // namespace limber

EMSCRIPTEN_BINDINGS(limber_fit) {
  using namespace limber;
  offer<&jsFitModes>("fitModes");
  offerParallel<FitShape>("fitShape");
}
