#include "fields/guidance.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "fields/strain.h"
#include "mesh/topology.h"

namespace limber {

namespace {

// The largest displacement of a shape, relative to the bounding diagonal of its component.
constexpr double kAmplitude = 0.05;

std::vector<double> componentDiagonals(const TriangleMesh& mesh, const Topology& topology) {
  std::vector<Bounds> boxes(topology.componentCount);
  std::vector<bool> seen(topology.componentCount, false);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const uint32_t component = topology.componentOfVertex[v];
    const Vec3& p = mesh.positions[v];
    Bounds& box = boxes[component];
    if (!seen[component]) box = {p, p};
    seen[component] = true;
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], p[axis]);
      box.high[axis] = std::max(box.high[axis], p[axis]);
    }
  }
  std::vector<double> diagonals;
  for (const Bounds& box : boxes) diagonals.push_back(box.diagonal());
  return diagonals;
}

// The shapes of one ordinal in units of the mesh: the largest displacement of each component becomes
// kAmplitude of its diagonal.
std::vector<float> scaledShape(std::span<const float> shape, const Topology& topology,
                               const std::vector<double>& diagonals) {
  std::vector<float> scaled(shape.size());
  for (size_t i = 0; i < shape.size(); ++i)
    scaled[i] = static_cast<float>(shape[i] * kAmplitude * diagonals[topology.componentOfVertex[i / 3]]);
  return scaled;
}

// w_k of Eq. 6 per component: as given, or 1 / omega_k^2; 0 if the component lacks the mode.
std::vector<double> ordinalWeights(std::span<const double> omega, size_t modesPerComponent,
                                   const GuidanceOptions& options, size_t entry) {
  std::vector<double> weights(omega.size() / modesPerComponent, 0.0);
  for (size_t component = 0; component < weights.size(); ++component) {
    const double w = omega[component * modesPerComponent + options.ordinals[entry]];
    if (w > 0) weights[component] = options.weights.empty() ? 1 / (w * w) : options.weights[entry];
  }
  return weights;
}

void check(const GuidanceOptions& options, size_t modesPerComponent) {
  if (options.ordinals.empty())
    throw std::invalid_argument("No mode was chosen to guide the simplification: choose at least one.");
  for (uint32_t ordinal : options.ordinals)
    if (ordinal >= modesPerComponent)
      throw std::invalid_argument("Mode " + std::to_string(ordinal + 1) + " was asked for, but only " +
                                  std::to_string(modesPerComponent) +
                                  " modes were computed: compute more or choose a lower one.");
  if (!options.weights.empty() && options.weights.size() != options.ordinals.size())
    throw std::invalid_argument("There are " + std::to_string(options.weights.size()) + " weights for " +
                                std::to_string(options.ordinals.size()) + " modes: give one for each.");
  if (!(options.p >= 1)) throw std::invalid_argument("The norm p of Eq. 6 must be at least 1.");
}

}  // namespace

StrainGuidance strainGuidance(const TriangleMesh& mesh, std::span<const float> shapes,
                              std::span<const double> omega, const GuidanceOptions& options, Job& job) {
  job.begin(Phase::Strain);
  const size_t ordinalSize = 3 * mesh.positions.size();
  const size_t modesPerComponent = ordinalSize ? shapes.size() / ordinalSize : 0;
  check(options, modesPerComponent);
  const Topology topology = buildTopology(mesh);
  if (omega.size() != modesPerComponent * topology.componentCount)
    throw std::invalid_argument("The modes belong to another mesh: compute them again for this one.");
  const auto diagonals = componentDiagonals(mesh, topology);

  std::vector<WeightedStrain> ordinals;
  for (size_t entry = 0; entry < options.ordinals.size(); ++entry) {
    const auto shape = shapes.subspan(options.ordinals[entry] * ordinalSize, ordinalSize);
    ordinals.push_back({greenLagrangeStrain(mesh, scaledShape(shape, topology, diagonals), 1),
                        ordinalWeights(omega, modesPerComponent, options, entry)});
    job.report(0.8 * static_cast<double>(entry + 1) / static_cast<double>(options.ordinals.size()));
  }
  const auto components = componentOfTriangle(mesh, topology);
  const auto sigma = combineStrain(ordinals, components, options.p);
  StrainGuidance guidance;
  guidance.strain.assign(sigma.begin(), sigma.end());
  guidance.rank = rankWithin(sigma, components, topology.componentCount);
  for (float& rank : guidance.rank)
    if (rank < options.threshold) rank = 0;
  job.report(1);
  return guidance;
}

}  // namespace limber
