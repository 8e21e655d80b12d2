#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "simplify/history.h"
#include "simplify/symmetry/mirror.h"

namespace limber {

// The mirror symmetry of a whole result that is its own mirror image.
struct ResultMirror {
  std::vector<uint32_t> partners;        // per vertex of the result: its mirror image
  std::vector<uint32_t> triangleImages;  // per triangle of the result: its mirror image
  MirrorPlane plane;                     // in units of the file
};
// `partners[v]`: the mirror image of vertex v of the original, see SimplifyConstraints::mirror. Throws
// std::invalid_argument if the result is not its own mirror image. O(n log n).
ResultMirror mirrorOfResult(const TriangleMesh& original, const MeshAt& result,
                            std::span<const uint32_t> partners);

// The mirror symmetry of one mesh.
struct MeshMirror {
  std::vector<uint32_t> partners;  // per vertex: its mirror image
  MirrorPlane plane;

  // Moves each vertex to the mean of its position and the mirror image of its partner's.
  void symmetrise(TriangleMesh& mesh) const;
  // The same for displacements, entries 3 v + axis of each column.
  void symmetrise(Eigen::Ref<Eigen::MatrixXd> displacements) const;
};

}  // namespace limber
