#pragma once

#include "linear/stiffness_model.h"
#include "mesh/topology.h"

namespace limber {

// The graph Laplacian with k = 1 per edge and lumped areas as masses, one unknown per vertex: the model whose
// modes look like the paper's (docs/paper.md). `mesh` should be scaled to a bounding diagonal of 1; lambda is
// then without unit.
StiffnessModel laplacianModel(const TriangleMesh& mesh, const Topology& topology);

}  // namespace limber
