#include "transfer/bind_meshes.h"

#include <algorithm>
#include <stdexcept>

#include "base/parallel.h"
#include "mesh/topology.h"
#include "query/surface_walk.h"

namespace limber {
namespace {

constexpr size_t kVerticesPerRange = 16384;
constexpr size_t kVerticesPerCheck = 1024;

// A face faces the same way as a vertex if the cosine between their normals is at least this. It is below 0
// because the rim of a sheet has faces a little beyond 90 degrees.
constexpr double kMinCosine = -0.25;

void check(const TriangleMesh& original, const MeshAt& result) {
  const auto outside = [&](uint32_t v) { return v != kNone && v >= result.mesh.vertexCount(); };
  if (result.vertexOfInput.size() == original.vertexCount() &&
      std::ranges::none_of(result.vertexOfInput, outside))
    return;
  throw std::invalid_argument("The result was made from another mesh: reduce this mesh and bind to that.");
}

std::vector<Vec3> faceNormals(const TriangleMesh& mesh) {
  std::vector<Vec3> normals;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) normals.push_back(normalized(areaNormal(mesh, t)));
  return normals;
}

// The data that the searches for all vertices share.
struct Surfaces {
  const TriangleMesh& original;
  const MeshAt& result;
  Topology originalTopology, resultTopology;
  std::vector<Vec3> originalNormals;  // per vertex of the original
  std::vector<Vec3> resultNormals;    // per triangle of the result

  bool facesAlike(uint32_t vertex, uint32_t triangle) const {
    return dot(originalNormals[vertex], resultNormals[triangle]) >= kMinCosine;
  }
};

// Collects the triangles of the result around the vertices that `vertex` and its neighbours were merged into;
// some repeat.
void collectStart(const Surfaces& surfaces, uint32_t vertex, std::vector<uint32_t>& start) {
  start.clear();
  const auto& [original, result, originalTopology, resultTopology, originalNormals, resultNormals] = surfaces;
  uint32_t last = kNone;
  const auto add = [&](uint32_t survivor) {
    if (survivor == kNone || survivor == last) return;
    last = survivor;
    const auto around = resultTopology.trianglesAround(survivor);
    start.insert(start.end(), around.begin(), around.end());
  };
  add(result.vertexOfInput[vertex]);
  for (const uint32_t t : originalTopology.trianglesAround(vertex))
    for (const uint32_t neighbour : original.triangles[t]) add(result.vertexOfInput[neighbour]);
}

void store(const ClosestPoint& found, double offset, uint32_t vertex, Binding& binding) {
  binding.triangle[vertex] = found.triangle;
  binding.offset[vertex] = static_cast<float>(offset);
  const double sum = found.barycentric[0] + found.barycentric[1] + found.barycentric[2];
  for (int c = 0; c < 3; ++c)
    binding.barycentric[3 * size_t{vertex} + c] = static_cast<float>(found.barycentric[c] / sum);
}

// Vertices of the original.
struct VertexRange {
  size_t begin, end;
};

void bindRange(const Surfaces& surfaces, const VertexRange& range, Binding& binding, Job& job) {
  SurfaceWalk walk(surfaces.result.mesh, surfaces.resultTopology);
  std::vector<uint32_t> start;
  for (size_t v = range.begin; v < range.end; ++v) {
    if (v % kVerticesPerCheck == 0) job.check();
    const auto vertex = static_cast<uint32_t>(v);
    if (surfaces.result.vertexOfInput[v] == kNone) continue;
    collectStart(surfaces, vertex, start);
    const auto alike = [&](uint32_t triangle) { return surfaces.facesAlike(vertex, triangle); };
    const bool anyAlike = std::ranges::any_of(start, alike);
    if (anyAlike) std::erase_if(start, [&](uint32_t triangle) { return !alike(triangle); });
    const Vec3& point = surfaces.original.positions[v];
    const ClosestPoint found =
        walk.closest(point, start, [&](uint32_t, uint32_t triangle) { return !anyAlike || alike(triangle); });
    const double offset = dot(point - found.position, surfaces.resultNormals[found.triangle]);
    store(found, offset, vertex, binding);
  }
}

}  // namespace

Binding bindToResult(const TriangleMesh& original, const MeshAt& result, Job& job) {
  check(original, result);
  job.begin(Phase::Measure);
  const Surfaces surfaces{original,
                          result,
                          buildTopology(original),
                          buildTopology(result.mesh),
                          vertexNormals(original),
                          faceNormals(result.mesh)};
  const size_t count = original.vertexCount();
  Binding binding;
  binding.triangle.assign(count, kNone);
  binding.barycentric.assign(3 * count, 0.0f);
  binding.offset.assign(count, 0.0f);
  job.report(0.5);
  parallelFor(count, kVerticesPerRange,
              [&](size_t begin, size_t end) { bindRange(surfaces, {begin, end}, binding, job); });
  job.report(1);
  return binding;
}

}  // namespace limber
