#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <cstdint>
#include <vector>

#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// Edges by their vertices, the smaller one first; sorted.
using EdgeList = std::vector<std::array<uint32_t, 2>>;

// What a mesh with fewer triangles is fitted to: points of the original, each with its tangent plane and the
// area it stands for, and points of its borders and lines (seams), each with its direction and length.
struct FitSamples {
  struct OnSurface {
    Vec3 point, normal;
    double area;
  };
  struct OnBorder {
    Vec3 point, tangent;
    double length;
  };
  std::vector<OnSurface> surface;
  std::vector<OnBorder> border;
};

// At least `count` points of the surface where it has area, evenly within each triangle.
FitSamples sampleForFit(const TriangleMesh& original, uint32_t count, const EdgeList& lines);

struct SurfaceFitOptions {
  double evenness = 0.003;  // weight of moving a vertex along the surface to the middle of its surroundings
  double borderWeight = 3;  // of distances from borders and lines against distances from the surface
  const EdgeList* lines = nullptr;  // inner edges that stay where the lines of the original are
  std::vector<uint32_t> near = {};  // `touched` of the last fit, to start from; or empty
};

// The quadratic model dx^T A dx - 2 g^T dx + constant of the squared distance between the samples and a mesh
// whose vertices move by dx, integrated over the area: each sample pulls at its closest point along its
// normal (the harder the farther it is off, so that tips and horns keep their place), each sample of a border
// or line at the closest such edge across its tangent. The evenness pulls vertices along the surface (along
// the border, of border vertices) towards the middle of their triangles, less the more the normals around a
// vertex spread, not at all on creases: as far as an eigenvalue of their covariance reaches a sixth of the
// largest.
struct SurfaceFit {
  Eigen::SparseMatrix<double> stiffness;  // A, 3 x vertexCount, both triangles
  Eigen::VectorXd inertia;                // diagonal, per unknown: what it weighs to stay in place
  Eigen::VectorXd pull;                   // g
  double meanSquare = 0;                  // mean squared distance of the samples, in units of the mesh
  double area = 0;                        // that the samples stand for
  std::vector<uint32_t> touched;          // per sample: the triangle that is closest
};
SurfaceFit fitSurface(const TriangleMesh& mesh, const Topology& topology, const FitSamples& samples,
                      const SurfaceFitOptions& options);

}  // namespace limber
