#include "fit/surface/surface_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "fit/surface/evenness.h"
#include "fit/tuning.h"
#include "mesh/eigen_vec3.h"
#include "query/closest_point.h"
#include "query/surface_walk.h"

namespace limber {

namespace {

namespace constants = tuning::surface;

constexpr size_t kSamplesPerRange = 512;
constexpr size_t kSearches = 32;  // at most, because each may take memory for every triangle

// The point of the mesh that is closest to a sample; its triangle is kNone if the face there faces the other
// way.
struct Contact : SurfacePoint {
  double distance = 0;  // along the sample's normal, from the mesh to the sample
};

// The input and output of a search for closest points.
struct ContactSearch {
  const TriangleMesh& mesh;
  const FitSamples& samples;
  std::vector<uint32_t>& closestTriangles;  // per sample of the surface: the last result, then the new one
  const Job& job;
};

// Calls `search(point, previously found triangle, kNone for the first of a range)` for every sample, and
// converts the results to contacts. Each range of samples uses one searcher, made by `makeSearch()`.
template <class MakeSearch>
std::vector<Contact> searchContacts(const ContactSearch& wanted, const MakeSearch& makeSearch) {
  const TriangleMesh& mesh = wanted.mesh;
  const FitSamples& samples = wanted.samples;
  std::vector<uint32_t>& closestTriangles = wanted.closestTriangles;
  std::vector<Contact> contacts(samples.surface.size());
  const size_t grain = std::max(kSamplesPerRange, contacts.size() / kSearches + 1);
  parallelFor(contacts.size(), grain, [&](size_t begin, size_t end) {
    wanted.job.check();
    auto search = makeSearch();
    uint32_t before = kNone;
    for (size_t i = begin; i < end; ++i) {
      const auto& [point, normal, area] = samples.surface[i];
      const ClosestPoint closest = search(point, closestTriangles[i] != kNone ? closestTriangles[i] : before);
      before = closestTriangles[i] = closest.triangle;
      if (dot(normalized(areaNormal(mesh, closest.triangle)), normal) < constants::kMinCosine) continue;
      contacts[i] = {closest, dot(point - closest.position, normal)};
    }
  });
  return contacts;
}

// Finds the closest points on the whole mesh, and their triangles.
std::vector<Contact> findContacts(const ContactSearch& wanted) {
  const ClosestPointTree tree(wanted.mesh);
  wanted.closestTriangles.assign(wanted.samples.surface.size(), kNone);
  return searchContacts(
      wanted, [&] { return [&](const Vec3& point, uint32_t near) { return tree.closest(point, near); }; });
}

// Tracks the closest points along the surface, from the triangles where they were before the mesh was moved.
std::vector<Contact> followContacts(const ContactSearch& wanted, const Topology& topology) {
  return searchContacts(wanted, [&] {
    return [walk = SurfaceWalk(wanted.mesh, topology)](const Vec3& point, uint32_t near) mutable {
      return walk.closest(point, {&near, 1}, [](uint32_t, uint32_t) { return true; });
    };
  });
}

// The blocks of one row of the quadratic term: between one corner of a triangle and its corners 0, 1 and 2.
using CornerBlocks = std::array<Eigen::Matrix3d, 3>;

// Adds the row of x^T B x, where x is the displacement of a point of the triangle.
void addBlock(CornerBlocks& row, int corner, const SurfacePoint& point, const Eigen::Matrix3d& block) {
  for (int b = 0; b < 3; ++b)
    row[static_cast<size_t>(b)] += point.barycentric[corner] * point.barycentric[b] * block;
}

// Entries by their triangle, in their order: those of triangle t are of[start[t]] .. of[start[t + 1] - 1].
// Entries whose triangle is kNone are left out.
struct ByTriangle {
  std::vector<uint32_t> start, of;
};
template <typename Entry>
ByTriangle byTriangle(const std::vector<Entry>& entries, uint32_t triangleCount) {
  ByTriangle sorted;
  sorted.start.assign(triangleCount + 1, 0);
  for (const Entry& entry : entries)
    if (entry.triangle != kNone) ++sorted.start[entry.triangle + 1];
  std::partial_sum(sorted.start.begin(), sorted.start.end(), sorted.start.begin());
  sorted.of.resize(sorted.start.back());
  std::vector<uint32_t> next(sorted.start.begin(), sorted.start.end() - 1);
  for (uint32_t i = 0; i < entries.size(); ++i)
    if (entries[i].triangle != kNone) sorted.of[next[entries[i].triangle]++] = i;
  return sorted;
}

// A sample of a border or feature edge on the mesh, and the block of its point.
struct FeatureContact : SurfacePoint {
  Eigen::Matrix3d across;
};

// The quadratic model during summation. The blocks of triangles are computed one after the other while the
// matrix is assembled: all of them would take more memory than the matrix.
struct ModelSums {
  const TriangleMesh& mesh;
  const FitSamples& samples;
  std::vector<Contact> contacts;  // of the samples of the surface
  double far = 0;                 // squared distance from which samples weigh more
  std::vector<FeatureContact> features;
  std::vector<Eigen::Matrix3d> vertices;  // blocks of single vertices
  Eigen::VectorXd gradient;

  ModelSums(const TriangleMesh& ofMesh, const FitSamples& ofSamples)
      : mesh(ofMesh),
        samples(ofSamples),
        vertices(mesh.vertexCount(), Eigen::Matrix3d::Zero()),
        gradient(Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(mesh.vertexCount()))) {}

  auto gradientAt(size_t v) { return gradient.segment<3>(3 * static_cast<Eigen::Index>(v)); }
  double weightOf(size_t sample) const {
    const double square = contacts[sample].distance * contacts[sample].distance;
    return samples.surface[sample].area *
           (far > 0 ? std::min(1 + square / far, constants::kMaxFarWeight) : 1);
  }
};

void measureDistance(const std::vector<Contact>& contacts, const FitSamples& samples,
                     SampleDistance& distance) {
  double squares = 0;
  for (size_t i = 0; i < contacts.size(); ++i) {
    if (contacts[i].triangle == kNone) continue;
    squares += samples.surface[i].area * contacts[i].distance * contacts[i].distance;
    distance.area += samples.surface[i].area;
  }
  distance.meanSquare = distance.area > 0 ? squares / distance.area : 0;
}

void addContacts(SurfaceFit& fit, const Topology& topology, ModelSums& sums, const Job& job) {
  const ContactSearch wanted{sums.mesh, sums.samples, fit.closestTriangles, job};
  sums.contacts = fit.closestTriangles.empty() ? findContacts(wanted) : followContacts(wanted, topology);
  measureDistance(sums.contacts, sums.samples, fit);
  sums.far = constants::kFarDistance * constants::kFarDistance * fit.meanSquare;
}

void addFeatures(const FeatureSegments& features, double weight, ModelSums& sums) {
  if (features.triangle.empty() || sums.samples.features.empty()) return;
  const ClosestPointTree tree(features.segments);
  for (const auto& [point, tangent, length] : sums.samples.features) {
    const ClosestPoint closest = tree.closest(point);
    const auto [start, end] = features.corner[closest.triangle];
    SurfacePoint onMesh{features.triangle[closest.triangle]};
    onMesh.barycentric[start] = closest.barycentric[0];
    onMesh.barycentric[end] = 1 - closest.barycentric[0];
    const Eigen::Vector3d along = eigen(tangent);
    const Eigen::Matrix3d across =
        weight * length * (Eigen::Matrix3d::Identity() - along * along.transpose());
    const Eigen::Vector3d force = across * eigen(point - closest.position);
    sums.features.push_back({onMesh, across});
    for (int a = 0; a < 3; ++a)
      sums.gradientAt(sums.mesh.triangles[onMesh.triangle][static_cast<size_t>(a)]) +=
          onMesh.barycentric[a] * force;
  }
}

void addEvenness(const Neighbourhoods& around, double evenness, ModelSums& sums) {
  parallelFor(sums.mesh.vertexCount(), kSamplesPerRange, [&](size_t begin, size_t end) {
    for (size_t v = begin; v < end; ++v) {
      const Eigen::Matrix3d block = evenness * around.area[v] * tangentialFreedom(around.normals[v]);
      sums.vertices[v] += block;
      sums.gradientAt(v) += block * eigen(around.middle[v] - sums.mesh.positions[v]);
    }
  });
}

Eigen::VectorXd dampingDiagonalOf(const std::vector<double>& area) {
  const double mean = std::accumulate(area.begin(), area.end(), 0.0) / static_cast<double>(area.size());
  Eigen::VectorXd diagonal(3 * static_cast<Eigen::Index>(area.size()));
  for (size_t v = 0; v < area.size(); ++v)
    diagonal.segment<3>(3 * static_cast<Eigen::Index>(v)).setConstant(std::max(area[v], mean));
  return diagonal;
}

// The contribution of the samples of one triangle to the model at one of its corners.
struct CornerTerms {
  CornerBlocks blocks;
  Eigen::Vector3d force;
};

// Computes the terms of the samples, corner by corner.
class TriangleModel {
 public:
  TriangleModel(const ModelSums& sums, bool keepsUnsampled)
      : sums_(sums),
        keepsUnsampled_(keepsUnsampled),
        contacts_(byTriangle(sums.contacts, sums.mesh.triangleCount())),
        features_(byTriangle(sums.features, sums.mesh.triangleCount())) {}

  CornerTerms termsAt(Corner corner) const {
    const uint32_t t = corner.triangle();
    CornerTerms terms;
    CornerBlocks& row = terms.blocks;
    row.fill(Eigen::Matrix3d::Zero());
    terms.force.setZero();
    for (uint32_t k = contacts_.start[t]; k < contacts_.start[t + 1]; ++k) {
      const uint32_t i = contacts_.of[k];
      const Contact& contact = sums_.contacts[i];
      const double weight = sums_.weightOf(i);
      const Eigen::Vector3d n = eigen(sums_.samples.surface[i].normal);
      addBlock(row, corner.index(), contact, weight * n * n.transpose());
      terms.force += weight * contact.barycentric[corner.index()] * contact.distance * n;
    }
    if (keepsUnsampled_ && contacts_.start[t] == contacts_.start[t + 1]) keepPlane(corner, row);
    for (uint32_t k = features_.start[t]; k < features_.start[t + 1]; ++k) {
      const FeatureContact& feature = sums_.features[features_.of[k]];
      addBlock(row, corner.index(), feature, feature.across);
    }
    return terms;
  }

 private:
  // A triangle that is closest to no sample keeps its plane.
  void keepPlane(Corner corner, CornerBlocks& row) const {
    const Eigen::Vector3d n = eigen(normalized(areaNormal(sums_.mesh, corner.triangle())));
    row[static_cast<size_t>(corner.index())] +=
        triangleArea(sums_.mesh, corner.triangle()) / 3 * n * n.transpose();
  }

  const ModelSums& sums_;
  bool keepsUnsampled_;
  ByTriangle contacts_, features_;
};

// Per vertex the vertices around it and itself, ascending, with uninitialised blocks.
BlockMatrix uninitialisedMatrix(const TriangleMesh& mesh, const Topology& topology) {
  BlockMatrix matrix;
  matrix.start.assign(mesh.vertexCount() + 1, 1);
  matrix.start[0] = 0;
  for (const auto& [a, b, firstUse, useCount] : topology.edges) {
    ++matrix.start[a + 1];
    ++matrix.start[b + 1];
  }
  std::partial_sum(matrix.start.begin(), matrix.start.end(), matrix.start.begin());
  matrix.column.resize(matrix.start.back());
  std::vector<uint32_t> next(matrix.start.begin(), matrix.start.end() - 1);
  // Edges ascend by their lower, then by their upper vertex: so do the lower neighbours of every vertex,
  // which come first, and its upper ones, which come last.
  for (const Topology::Edge& edge : topology.edges) matrix.column[next[edge.b]++] = edge.a;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) matrix.column[next[v]++] = v;
  for (const Topology::Edge& edge : topology.edges) matrix.column[next[edge.a]++] = edge.b;
  matrix.blocks.resize(matrix.column.size());
  return matrix;
}

// Also adds the contribution of the samples of the surface to the gradient at each vertex.
BlockMatrix assemble(const Topology& topology, ModelSums& sums, const TriangleModel& model) {
  const TriangleMesh& mesh = sums.mesh;
  BlockMatrix hessian = uninitialisedMatrix(mesh, topology);
  parallelFor(mesh.vertexCount(), kSamplesPerRange, [&](size_t begin, size_t end) {
    for (auto v = static_cast<uint32_t>(begin); v < end; ++v) {
      std::fill(hessian.blocks.begin() + hessian.start[v], hessian.blocks.begin() + hessian.start[v + 1],
                Eigen::Matrix3d::Zero());
      for (const Corner corner : topology.cornersAt(v)) {
        auto [row, force] = model.termsAt(corner);
        row[static_cast<size_t>(corner.index())] +=
            sums.vertices[v] / static_cast<double>(topology.cornersAt(v).size());
        for (size_t c = 0; c < 3; ++c) hessian.at(v, mesh.triangles[corner.triangle()][c]) += row[c];
        sums.gradientAt(v) += force;
      }
    }
  });
  return hessian;
}

}  // namespace

SampleDistance sampleDistance(const TriangleMesh& mesh, const FitSamples& samples, const Job& job) {
  SampleDistance distance;
  measureDistance(findContacts({mesh, samples, distance.closestTriangles, job}), samples, distance);
  return distance;
}

SurfaceFit fitSurface(const TriangleMesh& mesh, const Topology& topology, const FitSamples& samples,
                      const SurfaceFitOptions& options, const Job& job) {
  SurfaceFit fit;
  fit.closestTriangles = options.startTriangles;
  ModelSums sums(mesh, samples);
  addContacts(fit, topology, sums, job);
  const FeatureSegments features = featureSegments(mesh, topology, options.featureEdges);
  const double edge = std::sqrt(fit.area / std::max(1u, mesh.triangleCount()));
  addFeatures(features, constants::kBorderWeight * edge, sums);
  const Neighbourhoods around = neighbourhoodsOf(mesh, topology, features, options.normalWeight);
  if (options.evenness > 0) addEvenness(around, options.evenness, sums);
  fit.dampingDiagonal = dampingDiagonalOf(around.area);
  fit.hessian = assemble(topology, sums, TriangleModel(sums, options.keepsUnsampled));
  fit.gradient = std::move(sums.gradient);
  return fit;
}

}  // namespace limber
