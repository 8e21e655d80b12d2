#include "transfer/shape_transfer.h"

#include "base/parallel.h"
#include "mesh/vertex_areas.h"

namespace limber {

std::vector<ClosestPoint> closestPoints(const TriangleMesh& original, const TriangleMesh& result,
                                        const std::vector<ClosestPoint>& last) {
  const ClosestPointTree tree(result);
  const std::vector<Vec3> normals = vertexNormals(original);
  std::vector<ClosestPoint> points(original.vertexCount());
  parallelFor(points.size(), 256, [&](size_t begin, size_t end) {
    for (size_t v = begin; v < end; ++v)
      points[v] =
          tree.closestFacing(original.positions[v], normals[v], last.empty() ? kNone : last[v].triangle);
  });
  return points;
}

Eigen::MatrixXd transfer(const Eigen::MatrixXd& shapes, const TriangleMesh& result,
                         const std::vector<ClosestPoint>& points) {
  Eigen::MatrixXd carried(3 * static_cast<Eigen::Index>(points.size()), shapes.cols());
  if (shapes.cols() == 0) return carried;  // Its rows have no address.
  for (size_t v = 0; v < points.size(); ++v)
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      auto row = carried.row(3 * static_cast<Eigen::Index>(v) + axis);
      row.setZero();
      for (int c = 0; c < 3; ++c)
        row += points[v].barycentric[c] *
               shapes.row(3 * static_cast<Eigen::Index>(result.triangles[points[v].triangle][c]) + axis);
    }
  return carried;
}

Eigen::VectorXd rootMasses(const TriangleMesh& mesh) {
  Eigen::VectorXd mass = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(mesh.vertexCount()));
  const std::vector<double> areas = vertexAreas(mesh);
  for (size_t v = 0; v < areas.size(); ++v)
    mass.segment<3>(3 * static_cast<Eigen::Index>(v)).setConstant(areas[v]);
  return mass.cwiseSqrt();
}

Eigen::MatrixXd massNormalised(const Eigen::MatrixXd& shapes, const Eigen::VectorXd& rootMass) {
  Eigen::MatrixXd scaled = rootMass.asDiagonal() * shapes;
  for (Eigen::Index k = 0; k < scaled.cols(); ++k) {
    const double size = scaled.col(k).norm();
    if (size > 0) scaled.col(k) /= size;
  }
  return scaled;
}

}  // namespace limber
