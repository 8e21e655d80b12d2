#include "fit/surface/fit_samples.h"

#include <algorithm>
#include <cmath>

namespace limber {

namespace {

// The centres of the cuts^2 congruent triangles that a triangle is cut into.
void sampleTriangle(const TriangleMesh& mesh, uint32_t t, uint32_t cuts,
                    std::vector<FitSamples::OnSurface>& out) {
  const double area = triangleArea(mesh, t);
  if (!(area > 0)) return;
  const Vec3 normal = normalized(areaNormal(mesh, t)), a = mesh.corner(t, 0);
  const Vec3 u = (mesh.corner(t, 1) - a) / cuts, v = (mesh.corner(t, 2) - a) / cuts;
  const double share = area / (cuts * cuts);
  for (uint32_t i = 0; i < cuts; ++i)
    for (uint32_t j = 0; i + j < cuts; ++j) {
      out.push_back({a + u * (i + 1 / 3.0) + v * (j + 1 / 3.0), normal, share});
      if (i + j + 1 < cuts) out.push_back({a + u * (i + 2 / 3.0) + v * (j + 2 / 3.0), normal, share});
    }
}

}  // namespace

FitSamples sampleForFit(const TriangleMesh& original, uint32_t count, const EdgeList& featureEdges) {
  const double perTriangle = static_cast<double>(count) / std::max(1u, original.triangleCount());
  const auto cuts = static_cast<uint32_t>(std::max(1.0, std::ceil(std::sqrt(perTriangle))));
  FitSamples samples;
  for (uint32_t t = 0; t < original.triangleCount(); ++t) sampleTriangle(original, t, cuts, samples.surface);
  const FeatureSegments features = featureSegments(original, buildTopology(original), &featureEdges);
  for (const Triangle& segment : features.segments.triangles) {
    const Vec3 a = original.positions[segment[0]], edge = original.positions[segment[1]] - a;
    for (uint32_t i = 0; i < 2 * cuts; ++i)
      samples.features.push_back(
          {a + edge * ((i + 0.5) / (2 * cuts)), normalized(edge), length(edge) / (2 * cuts)});
  }
  return samples;
}

}  // namespace limber
