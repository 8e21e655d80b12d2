#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/job.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// Which elastic modes guide the simplification, and how they are combined (paper, Eq. 6). Amplitudes are
// fixed: the largest displacement of a shape is 5 % of the bounding diagonal of its component.
struct GuidanceOptions {
  std::vector<uint32_t> ordinals;  // of the guiding modes, from 0, within each component
  std::vector<double> weights;     // w_k per entry of `ordinals`; empty: 1 / omega_k^2 of each component
  double p = 2;                    // in [1, infinity]
  double threshold = 0;            // in [0, 1]: ranks below it become 0 (paper, section 5)
};

struct StrainGuidance {
  std::vector<float> strain;  // per triangle: sigma of Eq. 6
  std::vector<float> rank;    // per triangle: rank within its component in [0, 1]; 0 below the threshold
};

// `shapes`: as ModeSet::shapes, for the vertices of `mesh`. `omega`: omega[component * modesPerComponent +
// ordinal], 0 if the component lacks that mode. Throws std::invalid_argument with a sentence if an ordinal
// does not exist or the modes do not fit the mesh, and Cancelled.
StrainGuidance strainGuidance(const TriangleMesh& mesh, std::span<const float> shapes,
                              std::span<const double> omega, const GuidanceOptions& options, Job& job);

}  // namespace limber
