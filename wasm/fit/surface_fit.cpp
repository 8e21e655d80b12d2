#include "fit/surface_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "linear/element_assembly.h"
#include "mesh/eigen_vec3.h"
#include "mesh/sampling.h"
#include "mesh/vertex_areas.h"
#include "query/closest_point.h"

namespace limber {

namespace {

using Block = Eigen::Matrix3d;

constexpr size_t kSamplesPerRange = 512;
constexpr double kSameSide = -0.3;  // cosine between the normals of a sample and of the face it may pull at
constexpr double kFar =
    3;  // samples this many root mean squares off pull twice as hard, farther ones more ...
constexpr double kMostStress = 20;        // ... up to this
constexpr double kCreaseRatio = 1 / 6.0;  // of eigenvalues of the normals' covariance

// Where a sample pulls; `triangle` is kNone where there is none on the same side.
struct Contact {
  uint32_t triangle = kNone;
  double weight[3] = {0, 0, 0};
  double distance = 0;  // along the sample's normal, from the mesh to the sample
};

// Starts from the triangles that are `near`, if any, and leaves there what it has found.
std::vector<Contact> touchSurface(const TriangleMesh& mesh, const FitSamples& samples,
                                  std::vector<uint32_t>& near) {
  const ClosestPointTree tree(mesh);
  std::vector<Contact> contacts(samples.surface.size());
  near.resize(contacts.size(), kNone);
  parallelFor(contacts.size(), kSamplesPerRange, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const auto& [point, normal, area] = samples.surface[i];
      const ClosestPoint closest = tree.closest(point, near[i]);
      near[i] = closest.triangle;
      if (dot(normalized(areaNormal(mesh, closest.triangle)), normal) < kSameSide) continue;
      contacts[i] = {closest.triangle,
                     {closest.barycentric[0], closest.barycentric[1], closest.barycentric[2]},
                     dot(point - closest.position, normal)};
    }
  });
  return contacts;
}

// The quadratic model while it is summed up: blocks between the corners of each triangle, and of each vertex.
struct Sums {
  std::vector<std::array<Block, 6>> corners;  // pairs 00 01 02 11 12 22
  std::vector<Block> vertex;
  Eigen::VectorXd pull;
};

constexpr int kPair[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};

void addContacts(const TriangleMesh& mesh, const FitSamples& samples, SurfaceFit& fit, Sums& sums) {
  const std::vector<Contact> contacts = touchSurface(mesh, samples, fit.touched);
  double squares = 0;
  for (size_t i = 0; i < contacts.size(); ++i) {
    if (contacts[i].triangle == kNone) continue;
    squares += samples.surface[i].area * contacts[i].distance * contacts[i].distance;
    fit.area += samples.surface[i].area;
  }
  fit.meanSquare = fit.area > 0 ? squares / fit.area : 0;
  const double far = kFar * kFar * fit.meanSquare;
  for (size_t i = 0; i < contacts.size(); ++i) {
    const Contact& contact = contacts[i];
    if (contact.triangle == kNone) continue;
    const auto& [point, normal, wholeArea] = samples.surface[i];
    const double square = contact.distance * contact.distance;
    const double area = wholeArea * (far > 0 ? std::min(1 + square / far, kMostStress) : 1);
    const Eigen::Vector3d n = eigen(normal);
    const Block plane = area * n * n.transpose();
    for (int a = 0; a < 3; ++a) {
      for (int b = a; b < 3; ++b)
        sums.corners[contact.triangle][static_cast<size_t>(kPair[a][b])] +=
            contact.weight[a] * contact.weight[b] * plane;
      const uint32_t v = mesh.triangles[contact.triangle][static_cast<size_t>(a)];
      sums.pull.segment<3>(3 * static_cast<Eigen::Index>(v)) +=
          area * contact.weight[a] * contact.distance * n;
    }
  }
}

// Edges of borders and lines as triangles without area, so that the same search finds the closest one.
struct BorderEdges {
  TriangleMesh segments;
  std::vector<uint32_t> triangle;          // that has the edge
  std::vector<std::array<int, 2>> corner;  // its ends in that triangle
};

BorderEdges borderEdges(const TriangleMesh& mesh, const Topology& topology, const EdgeList* lines) {
  BorderEdges border;
  border.segments.positions = mesh.positions;
  const auto isFeature = [&](const Topology::Edge& edge) {
    return edge.useCount == 1 || (lines && std::ranges::binary_search(*lines, std::array{edge.a, edge.b}));
  };
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    for (int c = 0; c < 3; ++c) {
      const Topology::Edge& edge = topology.edges[topology.edgeOpposite(Corner(t, c))];
      if (topology.trianglesAt(edge)[0] != t || !isFeature(edge)) continue;
      const int start = (c + 1) % 3, end = (c + 2) % 3;
      const auto& triangle = mesh.triangles[t];
      const uint32_t a = triangle[static_cast<size_t>(start)], b = triangle[static_cast<size_t>(end)];
      border.segments.triangles.push_back({a, b, b});
      border.triangle.push_back(t);
      border.corner.push_back({start, end});
    }
  return border;
}

void addBorders(const TriangleMesh& mesh, const BorderEdges& border, const FitSamples& samples, double weight,
                Sums& sums) {
  if (border.triangle.empty() || samples.border.empty()) return;
  const ClosestPointTree tree(border.segments);
  for (const auto& [point, tangent, length] : samples.border) {
    const ClosestPoint closest = tree.closest(point);
    const uint32_t t = border.triangle[closest.triangle];
    const auto [start, end] = border.corner[closest.triangle];
    double share[3] = {0, 0, 0};
    share[start] = closest.barycentric[0];
    share[end] = 1 - closest.barycentric[0];
    const Eigen::Vector3d along = eigen(tangent);
    const Block across = weight * length * (Block::Identity() - along * along.transpose());
    const Eigen::Vector3d force = across * eigen(point - closest.position);
    for (int a = 0; a < 3; ++a) {
      for (int b = a; b < 3; ++b)
        sums.corners[t][static_cast<size_t>(kPair[a][b])] += share[a] * share[b] * across;
      sums.pull.segment<3>(3 * static_cast<Eigen::Index>(mesh.triangles[t][static_cast<size_t>(a)])) +=
          share[a] * force;
    }
  }
}

// What is around each vertex: a third of the area, the covariance of the normals (of the border's directions
// across, for a border vertex), and the middle.
struct Neighbourhood {
  std::vector<double> area;
  std::vector<Block> normals;
  std::vector<Vec3> middle;
  std::vector<uint8_t> isOnBorder;
};

Neighbourhood neighbourhoods(const TriangleMesh& mesh, const BorderEdges& border) {
  const uint32_t n = mesh.vertexCount();
  Neighbourhood around{vertexAreas(mesh), std::vector<Block>(n, Block::Zero()), std::vector<Vec3>(n),
                       std::vector<uint8_t>(n, 0)};
  std::vector<double> weight(n, 0);
  for (const Triangle& segment : border.segments.triangles)
    for (int end = 0; end < 2; ++end) {
      const uint32_t v = segment[static_cast<size_t>(end)];
      const Vec3 edge = mesh.positions[segment[1]] - mesh.positions[segment[0]];
      const Eigen::Vector3d along = eigen(normalized(edge));
      around.isOnBorder[v] = 1;
      around.normals[v] += length(edge) * (Block::Identity() - along * along.transpose());
      around.middle[v] +=
          0.5 * mesh.positions[segment[static_cast<size_t>(1 - end)]] + 0.5 * mesh.positions[v];
      weight[v] += 1;
    }
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const double area = triangleArea(mesh, t);
    const Eigen::Vector3d normal = eigen(normalized(areaNormal(mesh, t)));
    const Vec3 centre = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3;
    for (uint32_t v : mesh.triangles[t]) {
      if (around.isOnBorder[v]) continue;
      around.normals[v] += area * normal * normal.transpose();
      around.middle[v] += area * centre;
      weight[v] += area;
    }
  }
  for (uint32_t v = 0; v < n; ++v)
    around.middle[v] = weight[v] > 0 ? around.middle[v] / weight[v] : mesh.positions[v];
  return around;
}

// Directions that a vertex may move along without leaving the surface, scaled by how free it is there.
Block freedom(const Block& normals) {
  const Eigen::SelfAdjointEigenSolver<Block> solver(normals);
  const double limit = kCreaseRatio * solver.eigenvalues()[2];
  Block free = Block::Zero();
  for (int k = 0; k < 2 && limit > 0; ++k) {
    const double share = std::max(0.0, 1 - std::max(0.0, solver.eigenvalues()[k]) / limit);
    free += share * solver.eigenvectors().col(k) * solver.eigenvectors().col(k).transpose();
  }
  return free;
}

void addEvenness(const TriangleMesh& mesh, const Neighbourhood& around, double evenness, Sums& sums) {
  parallelFor(mesh.vertexCount(), kSamplesPerRange, [&](size_t begin, size_t end) {
    for (size_t v = begin; v < end; ++v) {
      const Block pull = evenness * around.area[v] * freedom(around.normals[v]);
      sums.vertex[v] += pull;
      sums.pull.segment<3>(3 * static_cast<Eigen::Index>(v)) +=
          pull * eigen(around.middle[v] - mesh.positions[v]);
    }
  });
}

// The area around each vertex, at least the mean.
Eigen::VectorXd inertiaOf(const std::vector<double>& area) {
  const double mean = std::accumulate(area.begin(), area.end(), 0.0) / static_cast<double>(area.size());
  Eigen::VectorXd inertia(3 * static_cast<Eigen::Index>(area.size()));
  for (size_t v = 0; v < area.size(); ++v)
    inertia.segment<3>(3 * static_cast<Eigen::Index>(v)).setConstant(std::max(area[v], mean));
  return inertia;
}

Eigen::SparseMatrix<double> assemble(const TriangleMesh& mesh, const Topology& topology, const Sums& sums) {
  std::vector<uint32_t> firstUnknown, nodes;
  for (uint32_t v = 0; v <= mesh.vertexCount(); ++v) firstUnknown.push_back(3 * v);
  for (const Triangle& triangle : mesh.triangles) nodes.insert(nodes.end(), triangle.begin(), triangle.end());
  ElementAssembly assembly(firstUnknown, nodes, 3);
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    Eigen::Matrix<double, 9, 9> element;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        element.block<3, 3>(3 * a, 3 * b) = sums.corners[t][static_cast<size_t>(kPair[a][b])];
    for (int a = 0; a < 3; ++a) {
      const uint32_t v = mesh.triangles[t][static_cast<size_t>(a)];
      element.block<3, 3>(3 * a, 3 * a) +=
          sums.vertex[v] / static_cast<double>(topology.trianglesAround(v).size());
    }
    assembly.add(t, element);
  }
  return assembly.take();
}

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

FitSamples sampleForFit(const TriangleMesh& original, uint32_t count, const EdgeList& lines) {
  const double perTriangle = static_cast<double>(count) / std::max(1u, original.triangleCount());
  const auto cuts = static_cast<uint32_t>(std::max(1.0, std::ceil(std::sqrt(perTriangle))));
  FitSamples samples;
  for (uint32_t t = 0; t < original.triangleCount(); ++t) sampleTriangle(original, t, cuts, samples.surface);
  for (const Triangle& segment : borderEdges(original, buildTopology(original), &lines).segments.triangles) {
    const Vec3 a = original.positions[segment[0]], edge = original.positions[segment[1]] - a;
    for (uint32_t i = 0; i < 2 * cuts; ++i)
      samples.border.push_back(
          {a + edge * ((i + 0.5) / (2 * cuts)), normalized(edge), length(edge) / (2 * cuts)});
  }
  return samples;
}

SurfaceFit fitSurface(const TriangleMesh& mesh, const Topology& topology, const FitSamples& samples,
                      const SurfaceFitOptions& options) {
  SurfaceFit fit;
  fit.touched = options.near;
  std::array<Block, 6> zero;
  zero.fill(Block::Zero());
  Sums sums{std::vector(mesh.triangleCount(), zero), std::vector<Block>(mesh.vertexCount(), Block::Zero()),
            Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(mesh.vertexCount()))};
  addContacts(mesh, samples, fit, sums);
  const BorderEdges border = borderEdges(mesh, topology, options.lines);
  const double edge = std::sqrt(fit.area / std::max(1u, mesh.triangleCount()));
  addBorders(mesh, border, samples, options.borderWeight * edge, sums);
  const Neighbourhood around = neighbourhoods(mesh, border);
  if (options.evenness > 0) addEvenness(mesh, around, options.evenness, sums);
  fit.inertia = inertiaOf(around.area);
  fit.stiffness = assemble(mesh, topology, sums);
  fit.pull = std::move(sums.pull);
  return fit;
}

}  // namespace limber
