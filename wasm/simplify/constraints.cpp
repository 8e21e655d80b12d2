#include "simplify/constraints.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace limber {
namespace {

void checkSize(size_t found, size_t expected, const char* list, const char* item) {
  if (found == 0 || found == expected) return;
  throw std::invalid_argument(std::string("The list of ") + list + " has " + std::to_string(found) +
                              " values, but the mesh has " + std::to_string(expected) + " " + item +
                              ": make it for this mesh.");
}

void checkAttributes(const TriangleMesh& mesh, const SimplifyConstraints& constraints) {
  if (constraints.attributes.empty()) return;
  const uint32_t dimension = constraints.attributeDimension;
  if (dimension < 1 || dimension > SimplifyConstraints::kAttributeLimit)
    throw std::invalid_argument("The attributes that guide the simplification have dimension " +
                                std::to_string(dimension) + ": take 1 to " +
                                std::to_string(SimplifyConstraints::kAttributeLimit) + ".");
  if (uint64_t{3} * constraints.displacementFields > dimension)
    throw std::invalid_argument("Of " + std::to_string(dimension) + " attributes, " +
                                std::to_string(constraints.displacementFields) +
                                " displacements cannot be the last ones: each has three.");
  const uint64_t rows =
      constraints.wedges.empty() ? mesh.vertexCount() : uint64_t{std::ranges::max(constraints.wedges)} + 1;
  if (constraints.attributes.size() < rows * dimension)
    throw std::invalid_argument("There are " + std::to_string(constraints.attributes.size()) +
                                " attribute values, but " + std::to_string(rows * dimension) +
                                " are needed: give one row for each wedge.");
  if (!std::ranges::all_of(constraints.attributes, [](float x) { return std::isfinite(x); }))
    throw std::invalid_argument(
        "An attribute that guides the simplification is not a number: repair it first.");
}

bool isShare(float x) {
  return x >= 0 && x <= 1;
}

}  // namespace

void checkConstraints(const TriangleMesh& mesh, const SimplifyConstraints& constraints) {
  checkSize(constraints.wedges.size(), 3 * size_t{mesh.triangleCount()}, "wedges", "corners");
  checkSize(constraints.groups.size(), mesh.triangleCount(), "groups", "triangles");
  checkSize(constraints.locked.size(), mesh.vertexCount(), "locked vertices", "vertices");
  checkSize(constraints.keep.size(), mesh.vertexCount(), "keep weights", "vertices");
  checkSize(constraints.pinnedSets.size(), mesh.vertexCount(), "pinned sets", "vertices");
  checkSize(constraints.textureWeights.size(), mesh.triangleCount(), "texture weights", "triangles");
  checkSize(constraints.mirror.size(), mesh.vertexCount(), "mirror images", "vertices");
  if (!std::ranges::all_of(constraints.keep, isShare))
    throw std::invalid_argument("The keep weights must lie between 0 and 1.");
  if (!std::ranges::all_of(constraints.textureWeights, isShare))
    throw std::invalid_argument("The texture weights must lie between 0 and 1.");
  if (!(constraints.creaseAngle >= 0 && constraints.creaseAngle <= 180))
    throw std::invalid_argument("The crease angle must lie between 0 and 180 degrees.");
  checkAttributes(mesh, constraints);
}

}  // namespace limber
