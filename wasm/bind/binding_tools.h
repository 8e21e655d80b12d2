#pragma once

// What the bindings share: plain objects of web/engine/core/core.ts in, plain objects out. Typed arrays are
// copied at the edge. A C++ exception is returned as an Error object, which web/engine/core/load_core.ts
// throws: so no destructor on the C++ stack is skipped.

#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <algorithm>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/job.h"
#include "elastic/material.h"
#include "mesh/triangle_mesh.h"

namespace limber {

using emscripten::val;

// Of the running call; there is one at a time.
inline Job theJob;

template <typename T>
std::vector<T> vectorOf(const val& array) {
  return emscripten::convertJSArrayToNumberVector<T>(array);
}

// A copy in JavaScript's own memory. `slice` copies shared memory into a plain buffer.
template <typename T>
val typedArray(const std::vector<T>& values) {
  return val(emscripten::typed_memory_view(values.size(), values.data())).template call<val>("slice");
}

inline std::vector<float> floatPositions(const TriangleMesh& mesh) {
  std::vector<float> flat(3 * mesh.positions.size());
  for (size_t v = 0; v < mesh.positions.size(); ++v)
    for (int c = 0; c < 3; ++c) flat[3 * v + c] = static_cast<float>(mesh.positions[v][c]);
  return flat;
}

inline std::vector<uint32_t> flatTriangles(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return {};
  const uint32_t* const first = mesh.triangles[0].data();
  return {first, first + 3 * mesh.triangles.size()};
}

inline val jsMesh(const TriangleMesh& mesh) {
  val out = val::object();
  out.set("positions", typedArray(floatPositions(mesh)));
  out.set("triangles", typedArray(flatTriangles(mesh)));
  return out;
}

// Copies a typed array to where there is room for it.
template <typename T>
void copyTo(T* target, size_t count, const val& array) {
  val(emscripten::typed_memory_view(count, target)).template call<void>("set", array);
}

inline void refuseTriangle(const TriangleMesh& mesh) {
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    for (const uint32_t v : mesh.triangles[t])
      if (v >= mesh.vertexCount())
        throw std::invalid_argument("Triangle " + std::to_string(t) + " names vertex " + std::to_string(v) +
                                    ", but the mesh has " + std::to_string(mesh.vertexCount()) +
                                    " vertices: weld the file's data first.");
}

inline TriangleMesh meshOf(const val& in) {
  const auto positions = vectorOf<float>(in["positions"]);
  const val triangles = in["triangles"];
  TriangleMesh mesh;
  mesh.positions.resize(positions.size() / 3);
  for (size_t v = 0; v < mesh.positions.size(); ++v)
    mesh.positions[v] = {positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]};
  mesh.triangles.resize(triangles["length"].as<size_t>() / 3);
  copyTo(mesh.triangles.empty() ? nullptr : mesh.triangles[0].data(), 3 * mesh.triangles.size(), triangles);
  uint32_t largest = 0;
  for (const auto& [a, b, c] : mesh.triangles) largest = std::max({largest, a, b, c});
  if (!mesh.triangles.empty() && largest >= mesh.vertexCount()) refuseTriangle(mesh);
  return mesh;
}

// The ElasticMaterial of an options object: young (Pa), poisson, density (kg/m3), thickness (units of the
// mesh) and unit (metres per unit of the mesh).
inline ElasticMaterial materialOf(const val& in) {
  return {in["young"].as<double>(), in["poisson"].as<double>(), in["density"].as<double>(),
          in["thickness"].as<double>(), in["unit"].as<double>()};
}

inline val jsError(const char* name, const std::string& message) {
  val error = val::global("Error").new_(message);
  error.set("name", std::string(name));
  return error;
}

// `f` with every exception turned into an Error object that is returned.
template <auto f>
struct Guarded;
template <typename... Arguments, val (*f)(Arguments...)>
struct Guarded<f> {
  static val call(Arguments... arguments) {
    try {
      return f(arguments...);
    } catch (const Cancelled& error) {
      return jsError("Cancelled", error.what());
    } catch (const std::bad_alloc&) {
      return jsError("Error",
                     "Not enough memory for a mesh of this size: reduce it first, or ask for fewer modes.");
    } catch (const std::exception& error) {
      return jsError("Error", error.what());
    }
  }
};

}  // namespace limber
