#include "fit/tune/tune_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "mesh/quality.h"
#include "transfer/shape_transfer.h"

namespace limber {
namespace {

constexpr double kSameSize = 0.05;     // relative difference of diagonals that still counts as the same size
constexpr double kMeanDistance = 0.5;  // of the mean edge of the coarse mesh

[[noreturn]] void refuse(const std::string& sentence) {
  throw std::invalid_argument(sentence);
}

std::string rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

// The mean distance of the vertices of one mesh from the surface of the other.
double meanDistance(const TriangleMesh& from, const TriangleMesh& to) {
  double sum = 0;
  for (const ClosestPoint& point : closestPoints(from, to)) sum += point.distance;
  return sum / from.vertexCount();
}

void requirePins(const std::vector<uint32_t>& pinned, const TriangleMesh& mesh, const char* name) {
  for (const uint32_t v : pinned)
    if (v >= mesh.vertexCount())
      refuse("Vertex " + std::to_string(v) + " is pinned, but the " + name + " has only " +
             std::to_string(mesh.vertexCount()) + " vertices; give the pins of this mesh.");
}

}  // namespace

void requireTunable(const TriangleMesh& original, const TriangleMesh& result, const TuneOptions& options) {
  if (original.triangles.empty()) refuse("The original has no usable triangle; give the mesh to tune to.");
  if (result.triangles.empty()) refuse("The coarse mesh has no usable triangle; give the mesh to tune.");
  if (result.triangleCount() > original.triangleCount())
    refuse("The mesh to tune has " + std::to_string(result.triangleCount()) + " faces and the original " +
           std::to_string(original.triangleCount()) + "; give the finer mesh as the original.");
  requirePins(options.pinnedOriginal, original, "original");
  requirePins(options.pinnedResult, result, "coarse mesh");
  const double originalSize = bounds(original).diagonal(), size = bounds(result).diagonal();
  if (std::abs(size / originalSize - 1) > kSameSize)
    refuse("The coarse mesh is " + rounded(size / originalSize) +
           " times as large as the original; scale it to the original's size.");
  const double tolerance = kMeanDistance * meanSide(result);
  const double distance = std::max(meanDistance(original, result), meanDistance(result, original));
  if (distance > tolerance)
    refuse("The two surfaces are " + rounded(100 * distance / originalSize) +
           " % of the diagonal apart on average, more than half an edge of the coarse mesh; give both meshes "
           "in the same place and pose.");
}

}  // namespace limber
