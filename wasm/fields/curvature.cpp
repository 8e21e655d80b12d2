#include "fields/curvature.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace limber {

namespace {

constexpr size_t kGrain = 2048;  // vertices of a range for one thread
constexpr double kNeedle =
    1e-12;  // twice the area over the longest edge squared, below which cotangents are inaccurate

// Sums over the triangles around a vertex (Meyer et al. 2003).
struct Ring {
  Vec3 areaGradient;  // sum of (cot a + cot b) (x_i - x_j) / 2 over the edges, Eq. 8
  Vec3 normal;        // angle-weighted
  double area = 0;    // mixed area, Figure 4
};

// The part of a triangle's area that belongs to its corner p: its Voronoi region, or a half or a quarter of
// the triangle if an angle is obtuse.
double mixedArea(const Vec3& p, const Vec3& q, const Vec3& r, double area) {
  const double atP = dot(q - p, r - p), atQ = dot(p - q, r - q), atR = dot(p - r, q - r);
  if (atP < 0) return area / 2;
  if (atQ < 0 || atR < 0) return area / 4;
  // (|pq|^2 cot r + |pr|^2 cot q) / 8, cot = dot / (2 area)
  return (squaredLength(q - p) * atR + squaredLength(r - p) * atQ) / (16 * area);
}

// Adds the triangle (p, q, r), seen from its corner p.
void addTriangle(Ring& ring, const Vec3& p, const Vec3& q, const Vec3& r) {
  const Vec3 twiceNormal = cross(q - p, r - p);
  const double twiceArea = length(twiceNormal);
  const double longest = std::max({squaredLength(q - p), squaredLength(r - p), squaredLength(r - q)});
  if (!(twiceArea > kNeedle * longest)) return;
  const double cotQ = dot(p - q, r - q) / twiceArea, cotR = dot(p - r, q - r) / twiceArea;
  ring.areaGradient += 0.5 * (cotR * (p - q) + cotQ * (p - r));
  ring.normal += std::atan2(twiceArea, dot(q - p, r - p)) / twiceArea * twiceNormal;
  ring.area += mixedArea(p, q, r, twiceArea / 2);
}

Ring ringAround(const TriangleMesh& mesh, const Topology& topology, uint32_t v) {
  Ring ring;
  for (uint32_t t : topology.trianglesAround(v)) {
    const Triangle& triangle = mesh.triangles[t];
    const int c = triangle[0] == v ? 0 : triangle[1] == v ? 1 : 2;
    addTriangle(ring, mesh.positions[v], mesh.positions[triangle[(c + 1) % 3]],
                mesh.positions[triangle[(c + 2) % 3]]);
  }
  return ring;
}

std::vector<bool> borderVertices(const TriangleMesh& mesh, const Topology& topology) {
  std::vector<bool> border(mesh.vertexCount(), false);
  for (const Topology::Edge& edge : topology.edges)
    if (edge.useCount == 1) border[edge.a] = border[edge.b] = true;
  return border;
}

// A border vertex has triangles on one side only, so the gradient of the area there contains a component
// across the border that is not curvature. The vertex gets the area-weighted mean of its interior neighbours.
// Without any, it keeps the caller's value, which is the part of the gradient along the normal.
void fillBorder(const Topology& topology, const std::vector<bool>& border, const std::vector<double>& area,
                std::vector<float>& curvature) {
  std::vector<double> sum(curvature.size(), 0), weight(curvature.size(), 0);
  const auto add = [&](uint32_t to, uint32_t from) {
    if (!border[to] || border[from]) return;
    sum[to] += area[from] * curvature[from];
    weight[to] += area[from];
  };
  for (const Topology::Edge& edge : topology.edges) {
    add(edge.a, edge.b);
    add(edge.b, edge.a);
  }
  for (size_t v = 0; v < curvature.size(); ++v)
    if (weight[v] > 0) curvature[v] = static_cast<float>(sum[v] / weight[v]);
}

}  // namespace

Curvature meanCurvature(const TriangleMesh& mesh, const Topology& topology, Job& job) {
  job.begin(Phase::Curvature);
  const auto border = borderVertices(mesh, topology);
  Curvature out;
  out.vertex.resize(mesh.vertexCount());
  std::vector<double> area(mesh.vertexCount());
  parallelFor(mesh.vertexCount(), kGrain, [&](size_t begin, size_t end) {
    job.check();
    for (size_t v = begin; v < end; ++v) {
      const Ring ring = ringAround(mesh, topology, static_cast<uint32_t>(v));
      area[v] = ring.area;
      const double gradient =
          border[v] ? std::abs(dot(ring.areaGradient, normalized(ring.normal))) : length(ring.areaGradient);
      out.vertex[v] = ring.area > 0 ? static_cast<float>(gradient / (2 * ring.area)) : 0.0f;
    }
  });
  job.report(0.8);
  fillBorder(topology, border, area, out.vertex);
  out.triangle.resize(mesh.triangleCount());
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    out.triangle[t] = (out.vertex[a] + out.vertex[b] + out.vertex[c]) / 3;
  }
  job.report(1);
  return out;
}

}  // namespace limber
