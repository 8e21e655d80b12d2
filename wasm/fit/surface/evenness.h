#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "fit/surface/feature_segments.h"
#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// The surroundings of each vertex: the triangles around it, or, for a vertex of a border or feature edge, its
// segments.
struct Neighbourhoods {
  std::vector<double> area;              // a third of the area of the triangles around the vertex
  std::vector<Eigen::Matrix3d> normals;  // covariance of the directions across the surface (the feature edge)
  std::vector<Vec3> middle;              // mean of the triangles' centres, by area (of the segments' middles)
  std::vector<uint8_t> isOnFeature;      // whether the vertex is on a border or a feature edge
};

// The weight of a triangle's normal in the covariance of a vertex: its area, or its angle at the vertex. With
// areas, a corner of three planes of which one has small triangles looks like an edge; with angles it does
// not, because angles do not depend on how planes are triangulated.
enum class NormalWeight : uint8_t { Area, Angle };

Neighbourhoods neighbourhoodsOf(const TriangleMesh& mesh, const Topology& topology,
                                const FeatureSegments& features, NormalWeight weight);

// The directions along which a vertex may move without leaving the surface: the sum of s d d^T over the
// eigenvectors d of the covariance of its normals but the last one, where s falls from 1 at an eigenvalue of
// 0 to 0 at tuning::surface::kCreaseRatio of the largest one.
Eigen::Matrix3d tangentialFreedom(const Eigen::Matrix3d& normals);

}  // namespace limber
