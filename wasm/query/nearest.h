#pragma once

#include <cstdint>
#include <span>

#include "mesh/corner.h"
#include "mesh/triangle_mesh.h"
#include "query/bounding_tree.h"

namespace limber {

// Finds the triangle of a mesh that is nearest to a point. Of several whose distances are equal to a
// millionth of the diagonal, as around a vertex, it is the one whose centre is nearest, and of these the
// lowest.
class NearestTriangle {
 public:
  NearestTriangle() = default;
  // Keeps a reference to `mesh`, which must have a triangle.
  explicit NearestTriangle(const TriangleMesh& mesh);

  // `guess` is any triangle; a close one saves time.
  uint32_t find(const Vec3& p, uint32_t guess) const;
  // Whether a triangle of the mesh lies within a squared distance of p. `guess` as above.
  bool isWithin(const Vec3& p, double squaredDistance, uint32_t guess) const;
  // As `find` for a vertex of the mesh, from its star only: the corners at the vertex. kNone for an empty
  // star.
  uint32_t findAround(uint32_t vertex, std::span<const Corner> star) const;

 private:
  double squaredDistance(const Vec3& p, uint32_t t) const;

  const TriangleMesh* mesh_ = nullptr;
  double step_ = 0;  // distances are compared in whole steps of this length
  BoundingTree tree_;
};

// Finds the vertex of a mesh that is nearest to a point; the lowest of several.
class NearestVertex {
 public:
  NearestVertex() = default;
  // Keeps a reference to `mesh`.
  explicit NearestVertex(const TriangleMesh& mesh);

  // `guess` is any vertex; a close one saves time.
  uint32_t find(const Vec3& p, uint32_t guess) const;

 private:
  const TriangleMesh* mesh_ = nullptr;
  BoundingTree tree_;
};

}  // namespace limber
