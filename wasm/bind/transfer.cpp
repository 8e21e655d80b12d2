// Transfer from the original to the result: attributes, vertices and single points.

#include <algorithm>
#include <iterator>
#include <utility>

#include "bind/charts.h"
#include "bind/function.h"
#include "bind/meshes.h"
#include "mesh/pinned_vertices.h"
#include "query/closest_among.h"
#include "transfer/bind_meshes.h"
#include "transfer/carry_pins.h"
#include "transfer/corner_sources.h"

namespace limber {

template <>
struct Fields<CornerSources> {
  static constexpr auto list = std::tuple(field("triangle", &CornerSources::triangle),
                                          field("barycentric", &CornerSources::barycentric));
};

template <>
struct Fields<Binding> {
  static constexpr auto list =
      std::tuple(field("triangle", &Binding::triangle), field("barycentric", &Binding::barycentric),
                 field("offset", &Binding::offset));
};

namespace {

val jsSourceOfCorners(const val& mesh, const val& charts, const val& result) {
  const auto lists = fromJs<ChartLists>(charts);
  return toJs(sourceOfCorners(*meshOf(mesh), lists.view(), fromJs<MeshAt>(result), theJob));
}

val jsBindToResult(const val& mesh, const val& result) {
  return toJs(bindToResult(*meshOf(mesh), fromJs<MeshAt>(result), theJob));
}

// A pin inside a triangle becomes the corner with the largest barycentric coordinate.
val jsCarryPins(const val& original, const val& pinned, const val& result) {
  const auto mesh = meshOf(result);
  Pins pins = carryPins(*meshOf(original), vectorOf<uint32_t>(pinned), *mesh);
  for (const SurfacePoint& point : pins.points) {
    const auto corner = std::ranges::max_element(point.barycentric) - std::begin(point.barycentric);
    pins.vertices.push_back(mesh->triangles[point.triangle][static_cast<size_t>(corner)]);
  }
  return toJs(PinnedVertices(std::move(pins.vertices)).ids());
}

val jsClosestPoint(const val& mesh, const val& triangles, const val& point) {
  const auto list = vectorOf<uint32_t>(triangles);
  const ClosestPoint found = closestAmong(*meshOf(mesh), list, fromJs<Vec3>(point));
  val out = val::object();
  out.set("triangle", found.triangle);
  out.set("barycentric", toJs(Vec3{found.barycentric[0], found.barycentric[1], found.barycentric[2]}));
  return out;
}

}  // namespace
}  // namespace limber

EMSCRIPTEN_BINDINGS(limber_transfer) {
  using namespace limber;
  offer<&jsSourceOfCorners>("sourceOfCorners");
  offer<&jsBindToResult>("bindToResult");
  offer<&jsCarryPins>("carryPins");
  offer<&jsClosestPoint>("closestPoint");
}
