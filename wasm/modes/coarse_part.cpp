#include "modes/coarse_part.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <span>

#include "base/parallel.h"
#include "elastic/displacement.h"
#include "elastic/pins.h"
#include "mesh/eigen_vec3.h"
#include "mesh/topology.h"
#include "query/closest_point.h"
#include "simplify/simplify.h"

namespace limber {

namespace {

constexpr double kSizeWeight = 0.0033;  // makes triangles uniform, so that bending is resolved everywhere
constexpr size_t kVerticesPerRange = 1024;
constexpr int kGradientSteps = 4;
constexpr double kRegularisation = 1e-9;  // of the edge tensor, relative to its trace

// The pinned coarse vertices: by majority, and also if a pinned vertex would otherwise have no pin next to
// it.
std::vector<uint32_t> coarsePins(const Part& original, const MeshAt& at) {
  const uint32_t count = at.mesh.vertexCount();
  std::vector<uint32_t> members(count, 0), pinned(count, 0);
  for (uint32_t v : at.vertexOfInput)
    if (v != kNone) ++members[v];
  for (uint32_t v : original.pinned) ++pinned[at.vertexOfInput[v]];
  std::vector<uint8_t> isPinned(count, 0), isNearPinned(count, 0);
  for (uint32_t v = 0; v < count; ++v)
    isPinned[v] = isNearPinned[v] = pinned[v] > 0 && 2 * pinned[v] >= members[v];
  for (const Triangle& t : at.mesh.triangles)
    if (isPinned[t[0]] || isPinned[t[1]] || isPinned[t[2]])
      for (uint32_t v : t) isNearPinned[v] = 1;
  std::vector<uint32_t> pins;
  for (uint32_t v = 0; v < count; ++v)
    if (isPinned[v] || (pinned[v] > 0 && !isNearPinned[v])) pins.push_back(v);
  return pins;
}

// The unpinned neighbour of v that is nearest to a point; kNone if all are pinned.
uint32_t nearestBeside(const TriangleMesh& mesh, uint32_t v, const Vec3& point,
                       const std::vector<uint32_t>& pins) {
  uint32_t nearest = kNone;
  for (const Triangle& t : mesh.triangles) {
    if (std::ranges::find(t, v) == t.end()) continue;
    for (const uint32_t w : t)
      if (std::ranges::find(pins, w) == pins.end() &&
          (nearest == kNone ||
           squaredLength(mesh.positions[w] - point) < squaredLength(mesh.positions[nearest] - point)))
        nearest = w;
  }
  return nearest;
}

// Makes the pins of the copy leave as many rigid motions as those of the original. If a few pins that were
// close to each other have collapsed into one or two vertices, neighbours of these are pinned too. If pins on
// a line have left it, they are moved back to a vertex of the original that was merged into them.
void matchRigidMotions(const Part& original, CoarsePart& coarse) {
  TriangleMesh& mesh = coarse.part.mesh;
  std::vector<uint32_t>& pins = coarse.part.pinned;
  const uint32_t wanted = rigidMotionsLeft(original.mesh, original.pinned);
  if (rigidMotionsLeft(mesh, pins) < wanted)
    for (const uint32_t v : original.pinned)
      mesh.positions[coarse.vertexOfInput[v]] = original.mesh.positions[v];
  for (const uint32_t v : original.pinned) {
    if (rigidMotionsLeft(mesh, pins) <= wanted) break;
    const uint32_t beside = nearestBeside(mesh, coarse.vertexOfInput[v], original.mesh.positions[v], pins);
    if (beside != kNone) pins.push_back(beside);
  }
  std::ranges::sort(pins);
}

// A vertex of a mesh and its surroundings.
struct Neighbourhood {
  uint32_t vertex;
  std::span<const uint32_t> ring;  // its neighbours
  const Vec3& normal;              // of unit length
};

// The displacement gradient at a vertex, with derivatives along x, y and z as columns: least squares over its
// neighbours in the tangent plane, while the normal rotates with the plane (Kirchhoff). The heights of
// neighbours above the plane enter by fixed-point steps, each of which reduces the error by a factor of the
// curvature times the edge length.
Eigen::Matrix3d gradientAt(const std::vector<Vec3>& positions,
                           const Eigen::Ref<const Eigen::VectorXd>& displacement, const Neighbourhood& at) {
  const uint32_t v = at.vertex;
  const Vec3 own = displacementAt(displacement, v);
  const Eigen::Vector3d normal = eigen(at.normal);
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (uint32_t w : at.ring) {
    const Eigen::Vector3d edge = eigen(positions[w] - positions[v]);
    const Eigen::Vector3d along = edge - normal * normal.dot(edge);
    if (along.squaredNorm() > 0) spread += along * along.transpose() / edge.squaredNorm();
  }
  const double size = spread.trace();
  if (!(size > 0)) return Eigen::Matrix3d::Zero();
  // The normal direction is added before the inversion, so that the tensor is not singular.
  const Eigen::Matrix3d inverse =
      (spread + size * normal * normal.transpose() + kRegularisation * size * Eigen::Matrix3d::Identity())
          .inverse();
  Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
  for (int step = 0; step < kGradientSteps; ++step) {
    Eigen::Matrix3d moved = Eigen::Matrix3d::Zero();
    for (uint32_t w : at.ring) {
      const Eigen::Vector3d edge = eigen(positions[w] - positions[v]);
      const double above = normal.dot(edge);
      const Eigen::Vector3d change = eigen(displacementAt(displacement, w) - own) - gradient * normal * above;
      if (edge.squaredNorm() > 0) moved += change * (edge - normal * above).transpose() / edge.squaredNorm();
    }
    gradient = moved * inverse;
    gradient -= gradient * normal * normal.transpose();
    gradient -= gradient.transpose() * normal * normal.transpose();
  }
  return gradient;
}

// Finds closest points on the triangles around a vertex and its neighbours. If one of these is the hub of
// many triangles, they are searched with a tree: otherwise each of the vertices around it would test all of
// them.
class RingSearch {
 public:
  // Keeps references to its arguments. `rings`: the neighbours of each vertex, ascending.
  RingSearch(const TriangleMesh& mesh, const Topology& topology,
             const std::vector<std::vector<uint32_t>>& rings)
      : mesh_(mesh), topology_(topology), rings_(rings) {
    for (const auto& ring : rings) {
      size_t triangles = 0;
      for (uint32_t w : ring) triangles += topology.cornersAt(w).size();
      isWide_.push_back(triangles > kFewTriangles);
    }
    if (std::ranges::count(isWide_, 1) > 0) tree_ = treeOver(mesh);
  }

  SurfacePoint closest(uint32_t centre, const Vec3& position) const {
    SurfacePoint best{0, {1, 0, 0}};
    double nearest = HUGE_VAL;
    const auto visit = [&](uint32_t t) {
      const ClosestPoint point = closestOnTriangle(mesh_, t, position);
      if (point.distance >= nearest) return;
      nearest = point.distance;
      best = point;
    };
    for (uint32_t t : topology_.trianglesAround(centre)) visit(t);
    if (isWide_[centre]) {
      tree_.forEachWithin(position, nearest * nearest, [&](uint32_t t) {
        if (std::ranges::any_of(mesh_.triangles[t],
                                [&](uint32_t w) { return std::ranges::binary_search(rings_[centre], w); }))
          visit(t);
        return nearest * nearest;
      });
      return best;
    }
    for (uint32_t w : rings_[centre])
      for (uint32_t t : topology_.trianglesAround(w)) visit(t);
    return best;
  }

 private:
  static constexpr size_t kFewTriangles = 512;  // tested one by one; a regular mesh has 36

  const TriangleMesh& mesh_;
  const Topology& topology_;
  const std::vector<std::vector<uint32_t>>& rings_;
  std::vector<uint8_t> isWide_;
  BoundingTree tree_;
};

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
  matchRigidMotions(original, coarse);
  return coarse;
}

Prolongation::Prolongation(const Part& original, const CoarsePart& coarse)
    : original_(original), coarse_(coarse), points_(original.mesh.vertexCount(), SurfacePoint{0, {1, 0, 0}}) {
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
  const RingSearch search(mesh, topology, rings);
  parallelFor(points_.size(), kVerticesPerRange, [&](size_t begin, size_t end) {
    for (size_t v = begin; v < end; ++v)
      points_[v] = search.closest(coarse.vertexOfInput[v], original.mesh.positions[v]);
  });
}

void Prolongation::prolongShape(const Eigen::Ref<const Eigen::VectorXd>& coarse,
                                Eigen::Ref<Eigen::VectorXd> fine) const {
  const TriangleMesh& mesh = coarse_.part.mesh;
  std::vector<Eigen::Matrix3d> gradient(mesh.vertexCount());
  parallelFor(gradient.size(), kVerticesPerRange, [&](size_t begin, size_t end) {
    for (size_t v = begin; v < end; ++v) {
      const auto ring = std::span(ring_).subspan(ringStart_[v], ringStart_[v + 1] - ringStart_[v]);
      gradient[v] = gradientAt(mesh.positions, coarse, {static_cast<uint32_t>(v), ring, normal_[v]});
    }
  });
  parallelFor(points_.size(), kVerticesPerRange, [&](size_t begin, size_t end) {
    for (size_t v = begin; v < end; ++v) {
      Vec3 sum;
      for (int c = 0; c < 3; ++c) {
        const uint32_t corner = mesh.triangles[points_[v].triangle][static_cast<size_t>(c)];
        const Vec3 offset = original_.mesh.positions[v] - mesh.positions[corner];
        const Eigen::Vector3d rotated = gradient[corner] * eigen(offset);
        sum += points_[v].barycentric[c] *
               (displacementAt(coarse, corner) + Vec3{rotated[0], rotated[1], rotated[2]});
      }
      fine.segment<3>(3 * static_cast<Eigen::Index>(v)) = eigen(sum);
    }
  });
}

Eigen::MatrixXd Prolongation::prolong(const Eigen::MatrixXd& phi, const Job& job) const {
  Eigen::MatrixXd fine(3 * static_cast<Eigen::Index>(points_.size()), phi.cols());
  for (Eigen::Index k = 0; k < phi.cols(); ++k) {
    job.check();
    prolongShape(phi.col(k), fine.col(k));
    for (uint32_t v : original_.pinned) fine.col(k).segment<3>(3 * static_cast<Eigen::Index>(v)).setZero();
  }
  return fine;
}

}  // namespace limber
