#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "base/job.h"
#include "fit/surface/evenness.h"
#include "fit/surface/feature_segments.h"
#include "fit/surface/fit_samples.h"
#include "linear/block_matrix.h"
#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"

namespace limber {

struct SurfaceFitOptions {
  double evenness = 0;  // weight of moving a vertex along the surface to the middle of its triangles
  NormalWeight normalWeight = NormalWeight::Area;  // of normals in the covariances of evenness
  // Whether triangles that are closest to no sample, such as those under another sheet, keep their planes;
  // nothing else constrains their vertices.
  bool keepsUnsampled = false;
  const EdgeList* featureEdges = nullptr;  // interior edges that follow the feature edges of the original
  // closestTriangles of a fit of the mesh before it was moved: closest points are tracked from there, along
  // the surface. Empty: they are searched on the whole mesh.
  std::vector<uint32_t> startTriangles = {};
};

// How far samples of the original's surface are from a mesh, along their normals.
struct SampleDistance {
  double meanSquare = 0;                   // mean squared distance, in squared units of the mesh
  double area = 0;                         // that the samples represent
  std::vector<uint32_t> closestTriangles;  // per sample of the surface
};
// Throws Cancelled.
SampleDistance sampleDistance(const TriangleMesh& mesh, const FitSamples& samples, const Job& job);

// The Gauss-Newton model (Nocedal and Wright 2006, section 10.3) of the squared distance between the samples
// and a mesh whose vertices move by dx, integrated over the area of the original:
//   E(dx) = dx^T A dx - 2 g^T dx + constant.
// It sums, over the samples s, weight * area * (n . (s - closest point of the moved mesh))^2, so that points
// may slide along the tangent plane. The weight grows with the distance, so that tips and horns keep their
// position. Samples of borders and feature edges add their squared distance across the edge's direction.
// Evenness adds the squared distance of each vertex from the middle of its triangles (of its segments, on a
// feature edge), along the surface only: see tangentialFreedom.
struct SurfaceFit : SampleDistance {
  BlockMatrix hessian;              // A; its nodes are the vertices
  Eigen::VectorXd dampingDiagonal;  // D: the area around a vertex, at least the mean, per coordinate
  Eigen::VectorXd gradient;         // g: minus half of the derivative of E at dx = 0
};
// Throws Cancelled.
SurfaceFit fitSurface(const TriangleMesh& mesh, const Topology& topology, const FitSamples& samples,
                      const SurfaceFitOptions& options, const Job& job);

}  // namespace limber
