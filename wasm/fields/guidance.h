#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/job.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// Which elastic modes count, and how (paper Eq. 6). Amplitudes are fixed: the largest displacement of a shape
// is 5 % of the component's bounding diagonal.
struct GuidanceOptions {
  std::vector<uint32_t> ordinals;  // modes by number, from 0; each component's own
  std::vector<double> weights;     // w_k per entry of `ordinals`; empty: 1 / omega_k^2, each component's own
  double p = 2;                    // in [1, infinity]
  double threshold = 0;            // in [0, 1]: ranks below it count as 0 (paper, section 5)
};

struct StrainGuidance {
  std::vector<float> strain;  // per triangle: sigma of Eq. 6, unranked
  std::vector<float> rank;    // per triangle: rank within its component in [0, 1]; 0 below the threshold
};

// `shapes` as in ModeSet (modesPerComponent ordinals over the mesh's vertices); omega[component *
// modesPerComponent + ordinal], 0 where the component lacks that mode. Throws std::invalid_argument with a
// sentence on a ordinal that does not exist.
StrainGuidance strainGuidance(const TriangleMesh& mesh, std::span<const float> shapes,
                              std::span<const double> omega, const GuidanceOptions& options, Job& job);

}  // namespace limber
