#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "simplify/history.h"
#include "simplify/mirror.h"

namespace limber {

// What a result is the mirror image of: itself.
struct ResultMirror {
  std::vector<uint32_t> partners;        // per vertex of the result: its image
  std::vector<uint32_t> triangleImages;  // per triangle
  MirrorPlane plane;                     // in units of the file
};
// `partners`: per vertex of the original, see SimplifyConstraints::mirror. Throws std::invalid_argument where
// the result is not its own image.
ResultMirror mirrorOfResult(const TriangleMesh& original, const MeshAt& result,
                            std::span<const uint32_t> partners);

// Of a mesh that is its own image.
struct MeshMirror {
  std::vector<uint32_t> partners;  // per vertex
  MirrorPlane plane;

  // The vertices at the mean of what they are and what their image would have them be.
  void symmetrise(TriangleMesh& mesh) const;
  // The same with displacements, 3 numbers a vertex, of each column.
  void symmetrise(Eigen::Ref<Eigen::MatrixXd> displacements) const;
};

}  // namespace limber
