#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace limber {

// A mesh cut into parts, each with vertices and triangles of its own in the order of the whole.
struct MeshParts {
  struct Part {
    TriangleMesh mesh;
    std::vector<uint32_t> vertices;   // per vertex of the part: its id in the whole mesh
    std::vector<uint32_t> triangles;  // per triangle of the part: its index in the whole mesh
  };
  std::vector<Part> parts;
  std::vector<uint32_t> localVertex;  // per vertex of the whole mesh: its id within its part
};

// Cuts a mesh into parts by a partition of its vertices: vertex v belongs to part partOfVertex[v] <
// partCount, and the three corners of a triangle belong to the same part. O(n).
MeshParts splitMesh(const TriangleMesh& mesh, std::span<const uint32_t> partOfVertex, uint32_t partCount);

// Coordinates in which the bounding box of a mesh begins at 0 and its diagonal is 1, so that tolerances and
// weights do not depend on the units of the file.
struct UnitFrame {
  Vec3 origin;          // the lower corner of the box
  double diagonal = 1;  // its length, in the units of the file; 1 for a mesh that is a single point

  Vec3 toFrame(const Vec3& p) const { return (p - origin) / diagonal; }
  Vec3 fromFrame(const Vec3& p) const { return origin + diagonal * p; }
};
UnitFrame unitFrame(const TriangleMesh& mesh);

void moveToFrame(TriangleMesh& mesh, const UnitFrame& frame);

}  // namespace limber
