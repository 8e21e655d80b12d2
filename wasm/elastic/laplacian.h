#pragma once

#include "linear/sparse_pencil.h"
#include "mesh/topology.h"

namespace limber {

// The graph Laplacian with k = 1 per edge as K and lumped areas as M, one unknown per vertex: the model whose
// modes resemble the paper's (docs/paper.md). `mesh` should be scaled to a bounding diagonal of 1, so that
// lambda is dimensionless.
SparsePencil laplacianPencil(const TriangleMesh& mesh, const Topology& topology);

}  // namespace limber
