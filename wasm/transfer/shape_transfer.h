#pragma once

#include <Eigen/Core>
#include <vector>

#include "query/closest_point.h"

namespace limber {

// For each vertex of the original, its closest point on the other surface, on the sheet that looks the same
// way. `last`: those of the same two, but for the places of the other's vertices, to start from; or empty.
std::vector<ClosestPoint> closestPoints(const TriangleMesh& original, const TriangleMesh& other,
                                        const std::vector<ClosestPoint>& last = {});

// Shapes of the other body (a column each, rows 3 * v + c), at the original's vertices.
Eigen::MatrixXd transfer(const Eigen::MatrixXd& shapes, const TriangleMesh& other,
                         const std::vector<ClosestPoint>& points);

// Square roots of the lumped areas, three per vertex: |weight * shape|^2 is the modal mass but for a factor.
Eigen::VectorXd rootMasses(const TriangleMesh& mesh);

// Scales rows by the masses and columns to length 1, so that a MAC is a squared inner product.
Eigen::MatrixXd massNormalised(const Eigen::MatrixXd& shapes, const Eigen::VectorXd& rootMass);

}  // namespace limber
