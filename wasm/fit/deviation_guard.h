#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "query/closest_point.h"

namespace limber {

// Tells where the triangles of a mesh would move too far from its original, or points of the original too far
// from them, judged at samples of both: some 20,000 points spread over the triangles, or a few on each, and
// all vertices. A margin of a tenth is for what lies between; triangles that are farther off from the start
// shall not move.
class DeviationGuard {
 public:
  // Keeps a reference to `original`. `limit`: a length in its units.
  DeviationGuard(const TriangleMesh& original, double limit);

  // Where vertices move from. Returns per triangle 1 where it is too far already. O(n log n).
  std::vector<uint8_t> begin(const TriangleMesh& mesh);

  // Per triangle of `moved`, the mesh of `begin` with its vertices elsewhere: 1 where it is too far and was
  // not. Takes time where points move by more than what is left to them.
  std::vector<uint8_t> tooFar(const TriangleMesh& moved) const;

 private:
  struct Sample {
    Vec3 point;
    ClosestPoint nearest;  // on the other surface
  };
  Vec3 ownPoint(const TriangleMesh& mesh, size_t i) const;
  void checkOriginal(const TriangleMesh& moved, std::vector<uint8_t>& isFar) const;
  void checkMoved(const TriangleMesh& moved, std::vector<uint8_t>& isFar) const;

  double allowed_;
  std::vector<std::array<double, 3>> weights_;  // barycentric: where the samples lie on each triangle
  ClosestPointTree tree_;                       // of the original
  std::vector<Vec3> originals_;                 // samples of the original
  std::vector<Sample> original_;                // these, against the mesh
  std::vector<Sample> own_;                     // of the mesh, triangle after triangle, against the original
};

}  // namespace limber
