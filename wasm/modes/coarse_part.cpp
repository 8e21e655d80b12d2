#include "modes/coarse_part.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "mesh/eigen_vec3.h"
#include "mesh/topology.h"
#include "query/closest_point.h"
#include "simplify/simplify.h"

namespace limber {

namespace {

constexpr double kSizeWeight = 0.0033;  // keeps the triangles even, so that bending is resolved everywhere
constexpr size_t kVerticesPerRange = 1024;
constexpr int kGradientSteps = 4;

// Pins by majority; where a pinned vertex would be left without a pinned one around it, its own is pinned.
std::vector<uint32_t> coarsePins(const Part& original, const MeshAt& at) {
  const uint32_t count = at.mesh.vertexCount();
  std::vector<uint32_t> members(count, 0), pinned(count, 0);
  for (uint32_t v : at.vertexOfInput)
    if (v != kNone) ++members[v];
  for (uint32_t v : original.pinned) ++pinned[at.vertexOfInput[v]];
  std::vector<uint8_t> isHeld(count, 0), isNearHeld(count, 0);
  for (uint32_t v = 0; v < count; ++v)
    isHeld[v] = isNearHeld[v] = pinned[v] > 0 && 2 * pinned[v] >= members[v];
  for (const Triangle& t : at.mesh.triangles)
    if (isHeld[t[0]] || isHeld[t[1]] || isHeld[t[2]])
      for (uint32_t v : t) isNearHeld[v] = 1;
  std::vector<uint32_t> pins;
  for (uint32_t v = 0; v < count; ++v)
    if (isHeld[v] || (pinned[v] > 0 && !isNearHeld[v])) pins.push_back(v);
  return pins;
}

// Displacement gradient at a vertex: least squares over its neighbours in the tangent plane, while the normal
// turns with the plane (Kirchhoff). How far neighbours lie off the plane enters by fixed-point steps, each a
// factor of the curvature times the edges' length more exact. Columns are derivatives along x, y and z.
Eigen::Matrix3d gradientAt(const std::vector<Vec3>& positions, const std::vector<Vec3>& displacement,
                           uint32_t v, std::span<const uint32_t> ring, const Vec3& unitNormal) {
  const Eigen::Vector3d normal = eigen(unitNormal);
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (uint32_t w : ring) {
    const Eigen::Vector3d edge = eigen(positions[w] - positions[v]);
    const Eigen::Vector3d along = edge - normal * normal.dot(edge);
    if (along.squaredNorm() > 0) spread += along * along.transpose() / edge.squaredNorm();
  }
  const double size = spread.trace();
  if (!(size > 0)) return Eigen::Matrix3d::Zero();
  // The plane's own direction is kept out of the inverse.
  const Eigen::Matrix3d inverse =
      (spread + size * normal * normal.transpose() + 1e-9 * size * Eigen::Matrix3d::Identity()).inverse();
  Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
  for (int step = 0; step < kGradientSteps; ++step) {
    Eigen::Matrix3d moved = Eigen::Matrix3d::Zero();
    for (uint32_t w : ring) {
      const Eigen::Vector3d edge = eigen(positions[w] - positions[v]);
      const double above = normal.dot(edge);
      const Eigen::Vector3d change = eigen(displacement[w] - displacement[v]) - gradient * normal * above;
      if (edge.squaredNorm() > 0) moved += change * (edge - normal * above).transpose() / edge.squaredNorm();
    }
    gradient = moved * inverse;
    gradient -= gradient * normal * normal.transpose();
    gradient -= gradient.transpose() * normal * normal.transpose();
  }
  return gradient;
}

}  // namespace

CoarsePart coarsen(const Part& original, uint32_t vertices, Job& job) {
  job.begin(Phase::Simplify);
  SimplifyOptions options;
  options.method = Method::Qem;
  options.sizeWeight = kSizeWeight;
  const double perVertex = static_cast<double>(original.mesh.triangleCount()) / original.mesh.vertexCount();
  options.stopFaces = static_cast<uint32_t>(perVertex * vertices);
  const History history = simplify(original.mesh, {}, options, job);
  MeshAt at = meshAt(original.mesh, history, options.stopFaces);
  CoarsePart coarse;
  coarse.part.model = original.model;
  coarse.part.diagonal = original.diagonal;
  coarse.part.components = original.components;
  coarse.part.pinned = coarsePins(original, at);
  coarse.part.mesh = std::move(at.mesh);
  coarse.vertexOfInput = std::move(at.vertexOfInput);
  return coarse;
}

Prolongation::Prolongation(const TriangleMesh& original, const CoarsePart& coarse)
    : original_(original), coarse_(coarse), places_(original.vertexCount()) {
  const TriangleMesh& mesh = coarse.part.mesh;
  const Topology topology = buildTopology(mesh);
  normal_.resize(mesh.vertexCount());
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    for (uint32_t v : mesh.triangles[t]) normal_[v] += areaNormal(mesh, t);
  for (Vec3& n : normal_) n = normalized(n);
  std::vector<std::vector<uint32_t>> rings(mesh.vertexCount());
  for (const Topology::Edge& edge : topology.edges) {
    rings[edge.a].push_back(edge.b);
    rings[edge.b].push_back(edge.a);
  }
  ringStart_.push_back(0);
  for (const auto& ring : rings) {
    ring_.insert(ring_.end(), ring.begin(), ring.end());
    ringStart_.push_back(static_cast<uint32_t>(ring_.size()));
  }
  parallelFor(places_.size(), kVerticesPerRange, [&](size_t begin, size_t end) {
    for (size_t v = begin; v < end; ++v) {
      const uint32_t centre = coarse.vertexOfInput[v];
      double nearest = HUGE_VAL;
      const auto visit = [&](uint32_t t) {
        const ClosestPoint point = closestOnTriangle(mesh, t, original.positions[v]);
        if (point.distance >= nearest) return;
        nearest = point.distance;
        places_[v] = {t, {point.barycentric[0], point.barycentric[1], point.barycentric[2]}};
      };
      for (uint32_t t : topology.trianglesAround(centre)) visit(t);
      for (uint32_t w : rings[centre])
        for (uint32_t t : topology.trianglesAround(w)) visit(t);
    }
  });
}

std::vector<Vec3> Prolongation::prolong(const std::vector<Vec3>& displacement) const {
  const TriangleMesh& mesh = coarse_.part.mesh;
  std::vector<Eigen::Matrix3d> gradient(mesh.vertexCount());
  parallelFor(gradient.size(), kVerticesPerRange, [&](size_t begin, size_t end) {
    for (size_t v = begin; v < end; ++v)
      gradient[v] =
          gradientAt(mesh.positions, displacement, static_cast<uint32_t>(v),
                     std::span(ring_).subspan(ringStart_[v], ringStart_[v + 1] - ringStart_[v]), normal_[v]);
  });
  std::vector<Vec3> fine(places_.size());
  parallelFor(fine.size(), kVerticesPerRange, [&](size_t begin, size_t end) {
    for (size_t v = begin; v < end; ++v)
      for (int c = 0; c < 3; ++c) {
        const uint32_t corner = mesh.triangles[places_[v].triangle][static_cast<size_t>(c)];
        const Vec3 way = original_.positions[v] - mesh.positions[corner];
        const Eigen::Vector3d turned = gradient[corner] * eigen(way);
        fine[v] += places_[v].weight[c] * (displacement[corner] + Vec3{turned[0], turned[1], turned[2]});
      }
  });
  return fine;
}

}  // namespace limber
