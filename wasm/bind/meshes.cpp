#include "bind/meshes.h"

#include <algorithm>

#include "bind/function.h"

namespace limber {
namespace {

// The objects that JavaScript has asked the core to keep, by handle.
template <class T>
class Kept {
 public:
  val keep(std::shared_ptr<const T> value) {
    values_[++last_] = std::move(value);
    val handle = val::object();
    handle.set("handle", last_);
    return handle;
  }
  std::shared_ptr<const T> find(const val& handle, const char* what) const {
    const auto found = values_.find(handle["handle"].as<uint32_t>());
    if (found == values_.end())
      throw std::invalid_argument(std::string("This ") + what + " has been released: open the file again.");
    return found->second;
  }
  void release(const val& handle) { values_.erase(handle["handle"].as<uint32_t>()); }

 private:
  std::map<uint32_t, std::shared_ptr<const T>> values_;
  uint32_t last_ = 0;
};

Kept<TriangleMesh> keptMeshes;
Kept<History> keptHistories;

bool isHandle(const val& in) {
  return !in["handle"].isUndefined();
}

[[noreturn]] void refuseTriangle(const TriangleMesh& mesh) {
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    for (const uint32_t v : mesh.triangles[t])
      if (v >= mesh.vertexCount())
        throw std::invalid_argument("Triangle " + std::to_string(t) + " names vertex " + std::to_string(v) +
                                    ", but the mesh has " + std::to_string(mesh.vertexCount()) +
                                    " vertices: weld the file's data first.");
  throw std::logic_error("Every triangle is in order.");
}

TriangleMesh plainMesh(const val& in) {
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

std::vector<float> flatPositions(const TriangleMesh& mesh) {
  std::vector<float> flat(3 * mesh.positions.size());
  for (size_t v = 0; v < mesh.positions.size(); ++v)
    for (int c = 0; c < 3; ++c) flat[3 * v + c] = static_cast<float>(mesh.positions[v][c]);
  return flat;
}

val jsKeepMesh(const val& mesh) {
  return keptMeshes.keep(meshOf(mesh));
}

val jsKeepHistory(const val& history) {
  return keptHistories.keep(historyOf(history));
}

val jsReleaseMesh(const val& handle) {
  keptMeshes.release(handle);
  return val::null();
}

val jsReleaseHistory(const val& handle) {
  keptHistories.release(handle);
  return val::null();
}

}  // namespace

std::vector<uint32_t> flatTriangles(const std::vector<Triangle>& triangles) {
  if (triangles.empty()) return {};
  const uint32_t* const first = triangles[0].data();
  return {first, first + 3 * triangles.size()};
}

val jsMesh(const TriangleMesh& mesh) {
  val out = val::object();
  out.set("positions", typedArray(flatPositions(mesh)));
  out.set("triangles", typedArray(flatTriangles(mesh.triangles)));
  return out;
}

std::shared_ptr<const TriangleMesh> meshOf(const val& in) {
  if (isHandle(in)) return keptMeshes.find(in, "mesh");
  return std::make_shared<const TriangleMesh>(plainMesh(in));
}

std::shared_ptr<const History> historyOf(const val& in) {
  if (isHandle(in)) return keptHistories.find(in, "history");
  return std::make_shared<const History>(fromJs<History>(in));
}

}  // namespace limber

EMSCRIPTEN_BINDINGS(limber_meshes) {
  using namespace limber;
  offer<&jsKeepMesh>("keepMesh");
  offer<&jsReleaseMesh>("releaseMesh");
  offer<&jsKeepHistory>("keepHistory");
  offer<&jsReleaseHistory>("releaseHistory");
}
