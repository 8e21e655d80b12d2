#pragma once

#include <Eigen/Core>
#include <vector>

#include "query/closest_point.h"

namespace limber {

// For each vertex of the original, the closest point of the result, on the sheet of the surface that faces
// the same way. `last`: the return value for the same meshes with other positions of the result's vertices,
// as the start of the search; or empty. O(n log n).
std::vector<ClosestPoint> closestPoints(const TriangleMesh& original, const TriangleMesh& result,
                                        const std::vector<ClosestPoint>& last = {});

// Interpolates shapes of the result (a column each, rows 3 v + axis) at its points that correspond to the
// vertices of the original. Returns a column for each shape, with rows 3 v + axis of the original.
Eigen::MatrixXd transfer(const Eigen::MatrixXd& shapes, const TriangleMesh& result,
                         const std::vector<ClosestPoint>& points);

// Square roots of the lumped areas, rows 3 v + axis: |rootMass * shape|^2 is the modal mass of a shell of
// thickness and density 1.
Eigen::VectorXd rootMasses(const TriangleMesh& mesh);

// Multiplies rows by the root masses and scales columns to length 1, so that the MAC of two shapes is their
// squared inner product.
Eigen::MatrixXd massNormalised(const Eigen::MatrixXd& shapes, const Eigen::VectorXd& rootMass);

}  // namespace limber
