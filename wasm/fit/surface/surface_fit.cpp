#include "fit/surface/surface_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "fit/surface/evenness.h"
#include "fit/tuning.h"
#include "linear/element_assembly.h"
#include "mesh/eigen_vec3.h"
#include "query/closest_point.h"

namespace limber {

namespace {

namespace constants = tuning::surface;

constexpr size_t kSamplesPerRange = 512;

// The point of the mesh that is closest to a sample; its triangle is kNone where the face there looks the
// other way.
struct Contact : SurfacePoint {
  double distance = 0;  // along the sample's normal, from the mesh to the sample
};

// `closestTriangles`: where the searches start, kNone for where the sample before was found; afterwards what
// they have found.
std::vector<Contact> findContacts(const TriangleMesh& mesh, const FitSamples& samples,
                                  std::vector<uint32_t>& closestTriangles) {
  const ClosestPointTree tree(mesh);
  std::vector<Contact> contacts(samples.surface.size());
  closestTriangles.resize(contacts.size(), kNone);
  parallelFor(contacts.size(), kSamplesPerRange, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const auto& [point, normal, area] = samples.surface[i];
      const bool isKnown = closestTriangles[i] != kNone;
      const uint32_t near = isKnown || i == begin ? closestTriangles[i] : closestTriangles[i - 1];
      const ClosestPoint closest = tree.closest(point, near);
      closestTriangles[i] = closest.triangle;
      if (dot(normalized(areaNormal(mesh, closest.triangle)), normal) < constants::kLeastCosine) continue;
      contacts[i] = {closest, dot(point - closest.position, normal)};
    }
  });
  return contacts;
}

// The quadratic model while it is summed up.
struct ModelSums {
  const TriangleMesh& mesh;
  std::vector<std::array<Eigen::Matrix3d, 6>>
      triangles;                          // blocks between the corners 00 01 02 11 12 22 of a triangle
  std::vector<Eigen::Matrix3d> vertices;  // blocks of single vertices
  Eigen::VectorXd gradient;

  explicit ModelSums(const TriangleMesh& ofMesh)
      : mesh(ofMesh),
        vertices(mesh.vertexCount(), Eigen::Matrix3d::Zero()),
        gradient(Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(mesh.vertexCount()))) {
    std::array<Eigen::Matrix3d, 6> zero;
    zero.fill(Eigen::Matrix3d::Zero());
    triangles.assign(mesh.triangleCount(), zero);
  }

  auto gradientAt(size_t v) { return gradient.segment<3>(3 * static_cast<Eigen::Index>(v)); }
};

constexpr int kPair[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};

// Adds x^T B x to the quadratic term, where x is the displacement of a point of the surface.
void addBlocks(ModelSums& sums, const SurfacePoint& point, const Eigen::Matrix3d& block) {
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b)
      sums.triangles[point.triangle][static_cast<size_t>(kPair[a][b])] +=
          point.barycentric[a] * point.barycentric[b] * block;
}

void measureDistance(const std::vector<Contact>& contacts, const FitSamples& samples, SurfaceFit& fit) {
  double squares = 0;
  for (size_t i = 0; i < contacts.size(); ++i) {
    if (contacts[i].triangle == kNone) continue;
    squares += samples.surface[i].area * contacts[i].distance * contacts[i].distance;
    fit.area += samples.surface[i].area;
  }
  fit.meanSquare = fit.area > 0 ? squares / fit.area : 0;
}

void addContacts(const FitSamples& samples, SurfaceFit& fit, ModelSums& sums) {
  const std::vector<Contact> contacts = findContacts(sums.mesh, samples, fit.closestTriangles);
  measureDistance(contacts, samples, fit);
  const double far = constants::kFarDistance * constants::kFarDistance * fit.meanSquare;
  for (size_t i = 0; i < contacts.size(); ++i) {
    const Contact& contact = contacts[i];
    if (contact.triangle == kNone) continue;
    const auto& [point, normal, wholeArea] = samples.surface[i];
    const double square = contact.distance * contact.distance;
    const double area = wholeArea * (far > 0 ? std::min(1 + square / far, constants::kMostFarWeight) : 1);
    const Eigen::Vector3d n = eigen(normal);
    addBlocks(sums, contact, area * n * n.transpose());
    for (int a = 0; a < 3; ++a)
      sums.gradientAt(sums.mesh.triangles[contact.triangle][static_cast<size_t>(a)]) +=
          area * contact.barycentric[a] * contact.distance * n;
  }
}

void keepUnsampled(ModelSums& sums) {
  for (uint32_t t = 0; t < sums.mesh.triangleCount(); ++t) {
    if (!std::ranges::all_of(sums.triangles[t], [](const auto& block) { return block.isZero(); })) continue;
    const Eigen::Vector3d n = eigen(normalized(areaNormal(sums.mesh, t)));
    const Eigen::Matrix3d share = triangleArea(sums.mesh, t) / 3 * n * n.transpose();
    for (const size_t diagonal : {0, 3, 5}) sums.triangles[t][diagonal] = share;
  }
}

void addFeatures(const FeatureSegments& features, const std::vector<FitSamples::OnFeature>& samples,
                 double weight, ModelSums& sums) {
  if (features.triangle.empty() || samples.empty()) return;
  const ClosestPointTree tree(features.segments);
  for (const auto& [point, tangent, length] : samples) {
    const ClosestPoint closest = tree.closest(point);
    const auto [start, end] = features.corner[closest.triangle];
    SurfacePoint onMesh{features.triangle[closest.triangle]};
    onMesh.barycentric[start] = closest.barycentric[0];
    onMesh.barycentric[end] = 1 - closest.barycentric[0];
    const Eigen::Vector3d along = eigen(tangent);
    const Eigen::Matrix3d across =
        weight * length * (Eigen::Matrix3d::Identity() - along * along.transpose());
    const Eigen::Vector3d force = across * eigen(point - closest.position);
    addBlocks(sums, onMesh, across);
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

Eigen::SparseMatrix<double> assemble(const Topology& topology, const ModelSums& sums) {
  const TriangleMesh& mesh = sums.mesh;
  std::vector<uint32_t> firstUnknown, nodes;
  for (uint32_t v = 0; v <= mesh.vertexCount(); ++v) firstUnknown.push_back(3 * v);
  for (const Triangle& triangle : mesh.triangles) nodes.insert(nodes.end(), triangle.begin(), triangle.end());
  ElementAssembly assembly(firstUnknown, nodes, 3);
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    Eigen::Matrix<double, 9, 9> element;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        element.block<3, 3>(3 * a, 3 * b) = sums.triangles[t][static_cast<size_t>(kPair[a][b])];
    for (int a = 0; a < 3; ++a) {
      const uint32_t v = mesh.triangles[t][static_cast<size_t>(a)];
      element.block<3, 3>(3 * a, 3 * a) +=
          sums.vertices[v] / static_cast<double>(topology.trianglesAround(v).size());
    }
    assembly.add(t, element);
  }
  return assembly.take();
}

}  // namespace

SurfaceFit fitSurface(const TriangleMesh& mesh, const Topology& topology, const FitSamples& samples,
                      const SurfaceFitOptions& options) {
  SurfaceFit fit;
  fit.closestTriangles = options.startTriangles;
  ModelSums sums(mesh);
  addContacts(samples, fit, sums);
  if (options.keepsUnsampled) keepUnsampled(sums);
  const FeatureSegments features = featureSegments(mesh, topology, options.featureEdges);
  const double edge = std::sqrt(fit.area / std::max(1u, mesh.triangleCount()));
  addFeatures(features, samples.features, constants::kBorderWeight * edge, sums);
  const Neighbourhoods around = neighbourhoodsOf(mesh, features, options.normalWeight);
  if (options.evenness > 0) addEvenness(around, options.evenness, sums);
  fit.dampingDiagonal = dampingDiagonalOf(around.area);
  fit.hessian = assemble(topology, sums);
  fit.gradient = std::move(sums.gradient);
  return fit;
}

}  // namespace limber
