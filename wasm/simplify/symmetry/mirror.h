#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "simplify/collapse_mesh.h"

namespace limber {

// Per triangle 1 if the mesh lacks its image; partners[v] is the image of vertex v.
std::vector<uint8_t> asymmetricTriangles(const TriangleMesh& mesh, std::span<const uint32_t> partners);
// The number of triangles without an image.
uint32_t trianglesWithoutImage(const TriangleMesh& mesh, std::span<const uint32_t> partners);

// The plane of the points p with normal . p = offset.
struct MirrorPlane {
  Vec3 normal;  // unit
  double offset = 0;

  // The signed distance of p from the plane.
  double height(const Vec3& p) const { return dot(normal, p) - offset; }
  Vec3 image(const Vec3& p) const { return p - normal * (2 * height(p)); }
  // The foot of p on the plane.
  Vec3 onto(const Vec3& p) const { return p - normal * height(p); }
};

// The mean plane between vertices and their partners.
MirrorPlane fitMirrorPlane(std::span<const Vec3> positions, std::span<const uint32_t> partners);

// Preserves the mirror symmetry of a mesh, given by pairs of vertices: each collapse is carried out together
// with its image, so that both sides stay images of each other, bit for bit if the plane is x, y or z = 0.
// Vertices on the plane stay on it. Edges that cross the plane do not collapse, and neither do edges so near
// to their image that one collapse would affect both.
class Mirror {
 public:
  // partners[v] is the image of vertex v, v itself on the plane. Keeps references to `partners` and `mesh`,
  // which must not have collapsed yet. Throws std::invalid_argument if that is not a symmetry of the
  // triangles, or of the positions to 1e-4 of the diagonal.
  Mirror(const TriangleMesh& input, const CollapseMesh& mesh, std::span<const uint32_t> partners);

  bool isOnPlane(uint32_t v) const { return partners_[v] == v; }
  // The collapse with its target moved onto the plane, on which both of its ends must lie.
  Collapse onPlane(const Collapse& step) const;
  // Whether the collapse is its own image, because both ends lie on the plane.
  bool isItsOwnImage(const Collapse& step) const { return isOnPlane(step.kept) && isOnPlane(step.removed); }
  // Whether a collapse and its image do not affect each other. Not for a collapse that is its own image.
  bool isApart(const Collapse& step) const;
  // Its `edge` is kNone if the image of the edge does not exist.
  Collapse imageOf(const Collapse& step) const;
  // Whether an existing image does not move an end that constraints fix in place. Constraints may fix
  // vertices on only one side; then only the step on that side has an image that may follow it.
  bool mayFollow(const Collapse& image, const Collapse& step) const {
    const uint32_t fixed = mesh_.fixedEnd(image.edge);
    return fixed == kNone || (fixed == image.kept && mesh_.fixedEnd(step.edge) == step.kept);
  }

 private:
  void checkPositions() const;
  Vec3 imageTarget(uint32_t edge, uint32_t kept, const Collapse& step) const;
  bool areNeighbours(uint32_t a, uint32_t b) const;
  bool forbidsImage(const Collapse& step) const;

  const CollapseMesh& mesh_;
  std::span<const uint32_t> partners_;
  MirrorPlane plane_;  // in the frame of CollapseMesh
};

}  // namespace limber
