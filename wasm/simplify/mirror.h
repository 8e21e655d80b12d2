#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "simplify/collapse_mesh.h"

namespace limber {

// Per triangle 1 where none is its image; `partners` has a vertex of the mesh for each vertex.
std::vector<uint8_t> asymmetricTriangles(const TriangleMesh& mesh, std::span<const uint32_t> partners);
// How many there are.
uint32_t trianglesWithoutImage(const TriangleMesh& mesh, std::span<const uint32_t> partners);

// The points p with normal . p = offset.
struct MirrorPlane {
  Vec3 normal;  // unit
  double offset = 0;

  double height(const Vec3& p) const { return dot(normal, p) - offset; }
  Vec3 image(const Vec3& p) const { return p - normal * (2 * height(p)); }
  Vec3 onto(const Vec3& p) const { return p - normal * height(p); }
};

// The mean plane between vertices and their partners.
MirrorPlane fitMirrorPlane(std::span<const Vec3> positions, std::span<const uint32_t> partners);

// The plane that a mesh is symmetric to, found from pairs of vertices, and what it makes of collapses: each
// is carried out together with its image, so that both sides stay images of each other, bit by bit where the
// plane is x, y or z = 0. Vertices on the plane stay on it. Edges that cross the plane stay, and so does what
// is so near to its own image that one collapse would touch both.
class Mirror {
 public:
  // `partners[v]` is the image of vertex v, itself on the plane. Throws std::invalid_argument where that is
  // no symmetry of the mesh: of its triangles, and of its positions to 1e-4 of the diagonal. Keeps a
  // reference to `partners` and `mesh`, which must not have collapsed yet.
  Mirror(const TriangleMesh& input, const CollapseMesh& mesh, std::span<const uint32_t> partners);

  bool isOnPlane(uint32_t v) const { return partners_[v] == v; }
  // The collapse with its target on the plane, where both of its ends are.
  Collapse onPlane(const Collapse& step) const;
  // Whether it takes no second collapse: both ends lie on the plane.
  bool isItsOwnImage(const Collapse& step) const { return isOnPlane(step.kept) && isOnPlane(step.removed); }
  // Whether a collapse and its image do not get into each other's way. Not to be asked of its own image.
  bool isApart(const Collapse& step) const;
  Collapse imageOf(const Collapse& step) const;

 private:
  void checkPositions() const;
  bool areNeighbours(uint32_t a, uint32_t b) const;

  const CollapseMesh& mesh_;
  std::span<const uint32_t> partners_;
  MirrorPlane plane_;  // where CollapseMesh has its points
};

}  // namespace limber
