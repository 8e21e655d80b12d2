#include "simplify/wishes.h"

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

void checkAttributes(const TriangleMesh& mesh, const Wishes& wishes) {
  if (wishes.attributes.empty()) return;
  const uint32_t dimension = wishes.attributeDimension;
  if (dimension < 1 || dimension > Wishes::kAttributeLimit)
    throw std::invalid_argument("The attributes that guide the simplification have dimension " +
                                std::to_string(dimension) + ": take 1 to " +
                                std::to_string(Wishes::kAttributeLimit) + ".");
  const size_t places =
      wishes.wedges.empty() ? mesh.vertexCount() : size_t{std::ranges::max(wishes.wedges)} + 1;
  if (wishes.attributes.size() < places * dimension)
    throw std::invalid_argument("There are " + std::to_string(wishes.attributes.size()) +
                                " attribute values, but " + std::to_string(places * dimension) +
                                " are needed: give one row for each wedge.");
  if (!std::ranges::all_of(wishes.attributes, [](float x) { return std::isfinite(x); }))
    throw std::invalid_argument(
        "An attribute that guides the simplification is not a number: repair it first.");
}

}  // namespace

void checkWishes(const TriangleMesh& mesh, const Wishes& wishes) {
  checkSize(wishes.wedges.size(), 3 * size_t{mesh.triangleCount()}, "wedges", "corners");
  checkSize(wishes.groups.size(), mesh.triangleCount(), "groups", "triangles");
  checkSize(wishes.locked.size(), mesh.vertexCount(), "locked vertices", "vertices");
  checkSize(wishes.keep.size(), mesh.vertexCount(), "keep weights", "vertices");
  checkSize(wishes.pinnedSets.size(), mesh.vertexCount(), "pinned sets", "vertices");
  checkSize(wishes.mirror.size(), mesh.vertexCount(), "mirror images", "vertices");
  if (!std::ranges::all_of(wishes.keep, [](float x) { return x >= 0 && x <= 1; }))
    throw std::invalid_argument("The keep weights must lie between 0 and 1.");
  if (!(wishes.creaseAngle >= 0 && wishes.creaseAngle <= 180))
    throw std::invalid_argument("The crease angle must lie between 0 and 180 degrees.");
  checkAttributes(mesh, wishes);
}

}  // namespace limber
