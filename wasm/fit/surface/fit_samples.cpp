#include "fit/surface/fit_samples.h"

#include <algorithm>
#include <cmath>

#include "mesh/sampling.h"
#include "mesh/vertex_areas.h"

namespace limber {

namespace {

// The centres of the cuts^2 congruent parts of a triangle.
void sampleTriangle(const TriangleMesh& mesh, uint32_t t, uint32_t cuts,
                    std::vector<FitSamples::OnSurface>& out) {
  const double area = triangleArea(mesh, t);
  if (!(area > 0)) return;
  const Vec3 normal = normalized(areaNormal(mesh, t));
  const double share = area / (cuts * cuts);
  forEachPartCentre({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)}, static_cast<int>(cuts),
                    [&](const Vec3& p) { out.push_back({p, normal, share}); });
}

}  // namespace

FitSamples sampleForFit(const TriangleMesh& original, const Topology& topology, uint32_t count,
                        const EdgeList& featureEdges) {
  const uint32_t n = std::max(1u, original.triangleCount());
  const auto cuts = static_cast<uint32_t>(std::max(1.0, std::ceil(std::sqrt(1.0 * count / n))));
  const double area = surfaceArea(original);
  FitSamples samples;
  samples.surface.reserve(size_t{n} * cuts * cuts);
  for (uint32_t t = 0; t < original.triangleCount(); ++t) {
    const double size = area > 0 ? std::sqrt(triangleArea(original, t) / (area / n)) : 0;
    sampleTriangle(original, t, std::max(cuts, static_cast<uint32_t>(cuts * size)), samples.surface);
  }
  const FeatureSegments features = featureSegments(original, topology, &featureEdges);
  for (const Triangle& segment : features.segments.triangles) {
    const Vec3 a = original.positions[segment[0]], edge = original.positions[segment[1]] - a;
    for (uint32_t i = 0; i < 2 * cuts; ++i)
      samples.features.push_back(
          {a + edge * ((i + 0.5) / (2 * cuts)), normalized(edge), length(edge) / (2 * cuts)});
  }
  return samples;
}

}  // namespace limber
