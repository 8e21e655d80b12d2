#pragma once

// Meshes and histories as JavaScript passes them: plain objects, or handles of objects that the core keeps.

#include <emscripten/val.h>

#include <cstdint>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>

#include "bind/convert.h"
#include "mesh/triangle_mesh.h"
#include "simplify/history.h"

namespace limber {

// {positions, triangles}, see TriangleMesh in web/engine/core.
val jsMesh(const TriangleMesh& mesh);

// The mesh of a plain object, or the kept mesh of a handle. Throws std::invalid_argument if a triangle refers
// to a vertex that does not exist, or if the handle has been released.
std::shared_ptr<const TriangleMesh> meshOf(const val& in);

// The same for a history.
std::shared_ptr<const History> historyOf(const val& in);

// [3 * i + c] of triangles.
std::vector<uint32_t> flatTriangles(const std::vector<Triangle>& triangles);

template <>
struct Convert<TriangleMesh> {
  static val toJs(const TriangleMesh& mesh) { return jsMesh(mesh); }
  static TriangleMesh fromJs(const val& in) { return *meshOf(in); }
};

// Triangles as one typed array of vertices.
template <>
struct Convert<std::vector<Triangle>> {
  static val toJs(const std::vector<Triangle>& triangles) { return typedArray(flatTriangles(triangles)); }
  static std::vector<Triangle> fromJs(const val& in) {
    const auto flat = vectorOf<uint32_t>(in);
    std::vector<Triangle> triangles;
    triangles.reserve(flat.size() / 3);
    for (size_t i = 0; i + 2 < flat.size(); i += 3) triangles.push_back({flat[i], flat[i + 1], flat[i + 2]});
    return triangles;
  }
};

template <>
struct Names<StopReason> {
  static constexpr std::array list = {"target", "deviation", "angle", "exhausted"};
  static constexpr const char* what = "reason to stop";
};

template <>
struct Fields<Refused> {
  static constexpr auto list = std::tuple(
      field("topology", &Refused::topology), field("flip", &Refused::flip), field("lock", &Refused::lock),
      field("angle", &Refused::angle), field("deviation", &Refused::deviation));
};

template <>
struct Fields<History> {
  static constexpr auto list =
      std::tuple(field("vertexCount", &History::vertexCount), field("triangleCount", &History::triangleCount),
                 field("kept", &History::kept), field("removed", &History::removed),
                 field("positions", &History::positions), field("trianglesAfter", &History::trianglesAfter),
                 optionalField("errors", &History::errors), optionalField("refused", &History::refused),
                 optionalField("stop", &History::stop));
};

template <>
struct Fields<Flips> {
  static constexpr auto list =
      std::tuple(field("triangles", &Flips::triangles), field("corners", &Flips::corners));
};

template <>
struct Fields<MeshAt> {
  static constexpr auto list =
      std::tuple(field("mesh", &MeshAt::mesh), field("vertexOfInput", &MeshAt::vertexOfInput),
                 field("inputOfVertex", &MeshAt::inputOfVertex),
                 field("inputOfTriangle", &MeshAt::inputOfTriangle), field("flips", &MeshAt::flips));
};

}  // namespace limber
