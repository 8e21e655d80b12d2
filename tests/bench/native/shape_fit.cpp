// Simplifies one mesh to half of its faces and fits the result to its surface, natively, for profiles: prints
// the seconds of each, a hash of the positions
// of the result, and its distance from the mesh before and after.
//
//   shape_fit MESH [threads]
//
// MESH, little endian: uint32 vertices, uint32 triangles, float32 positions[3 v + c], uint32 triangles[3 t +
// corner].

#include "fit/shape_fit.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "base/parallel.h"
#include "compare/surface_distance.h"
#include "mesh/quality.h"
#include "simplify/simplify.h"

namespace {

using namespace limber;

template <class T>
std::vector<T> readArray(std::ifstream& file, size_t count) {
  std::vector<T> values(count);
  file.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(count * sizeof(T)));
  if (!file) throw std::runtime_error("The mesh file is missing or too short.");
  return values;
}

TriangleMesh readMesh(const char* path) {
  std::ifstream file(path, std::ios::binary);
  const auto counts = readArray<uint32_t>(file, 2);
  const auto positions = readArray<float>(file, size_t{3} * counts[0]);
  const auto triangles = readArray<uint32_t>(file, size_t{3} * counts[1]);
  TriangleMesh mesh;
  for (size_t v = 0; v < counts[0]; ++v)
    mesh.positions.push_back({positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]});
  for (size_t t = 0; t < counts[1]; ++t)
    mesh.triangles.push_back({triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2]});
  return mesh;
}

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// FNV-1a over all coordinates and corners.
uint64_t hashOf(const TriangleMesh& mesh) {
  uint64_t hash = 0xcbf29ce484222325;
  const auto add = [&](const auto& value) {
    unsigned char bytes[sizeof(value)];
    std::memcpy(bytes, &value, sizeof(value));
    for (const unsigned char byte : bytes) hash = (hash ^ byte) * 0x100000001b3;
  };
  for (const Vec3& p : mesh.positions)
    for (const double value : {p.x, p.y, p.z}) add(value);
  for (const Triangle& triangle : mesh.triangles)
    for (const uint32_t v : triangle) add(v);
  return hash;
}

}  // namespace

int main(int count, char** words) {
  if (count < 2) {
    std::fprintf(stderr, "usage: shape_fit MESH [threads]\n");
    return 1;
  }
  setThreadCount(count > 2 ? std::atoi(words[2]) : 2);
  const TriangleMesh mesh = readMesh(words[1]);
  Job job;
  SimplifyOptions options;
  options.method = Method::Limber;
  options.sizeWeight = 0.01;
  options.qualityWeight = 0.1;
  options.stopFaces = mesh.triangleCount() / 2;
  options.recordErrors = true;
  double start = seconds();
  const History history = simplify(mesh, {}, options, job);
  std::printf("simplify %.2f s\n", seconds() - start);
  const MeshAt level = meshAt(mesh, history, options.stopFaces);
  start = seconds();
  const ShapeFitResult fitted = fitShape(mesh, level, {.maxDeviation = 0.01 * bounds(mesh).diagonal()}, job);
  std::printf("fit %.2f s, %u flips, hash %016llx\n", seconds() - start, fitted.flips,
              static_cast<unsigned long long>(hashOf(fitted.result.mesh)));
  for (const TriangleMesh* result : {&level.mesh, &fitted.result.mesh}) {
    const SurfaceDistance distance = measureSurfaceDistance(mesh, *result, {}, job);
    const double size = bounds(mesh).diagonal() / 100;
    std::printf("mean %.6f %%, hausdorff %.5f %%, mean smallest angle %.3f\n", distance.mean / size,
                distance.hausdorff / size, measureQuality(*result).meanMinAngle);
  }
  return 0;
}
