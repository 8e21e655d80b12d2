#include "modes/shell_sensitivity.h"

#include <array>
#include <cmath>

#include "base/dual.h"
#include "base/parallel.h"

namespace limber {

namespace {

using Number = Dual<9>;  // derivatives by the three corners' coordinates
using Point = std::array<Number, 3>;

constexpr size_t kTrianglesPerRange = 256;

Point operator-(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Number dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Point operator/(const Point& a, const Number& s) {
  return {a[0] / s, a[1] / s, a[2] / s};
}

// What a mode does to one triangle.
struct ElementMode {
  std::array<std::array<double, 3>, 3> displacement;  // of the corners
  std::array<double, 3> turn;                         // s_e phi_e of the edge opposite to each corner
};

// (xx, yy, 2 xy) in plane stress of unit stiffness, contracted with itself.
Number planeStressEnergy(const Number& xx, const Number& yy, const Number& xy2, double poisson) {
  const Number shear = xy2 * xy2 * ((1 - poisson) / 2);
  return (xx * xx + yy * yy + xx * yy * (2 * poisson) + shear) / Number(1 - poisson * poisson);
}

// phi^T (K - lambda M) phi of one triangle, from the same strains and curvatures as modes/shell.cpp: x along
// edge 2, from corner 0 to corner 1.
Number elementTerm(const std::array<Point, 3>& corner, const ElementMode& mode, const ShellMaterial& material,
                   double lambda) {
  std::array<Point, 3> edge;  // edge c runs from corner c + 1 to corner c + 2
  for (size_t c = 0; c < 3; ++c) edge[c] = corner[(c + 2) % 3] - corner[(c + 1) % 3];
  const Point twice = cross(edge[0], edge[1]);
  const Number twiceArea = sqrt(dot(twice, twice)), area = twiceArea * 0.5;
  const Point normal = twice / twiceArea, x = edge[2] / sqrt(dot(edge[2], edge[2])), y = cross(normal, x);
  const auto along = [](const Point& axis, const std::array<double, 3>& u) {
    return axis[0] * u[0] + axis[1] * u[1] + axis[2] * u[2];
  };
  Number strainX, strainY, strainXY, bendX, bendY, bendXY;
  std::array<std::array<Number, 3>, 3> slopeOf;  // t_e m_e^T as (xx, yy, 2 xy)
  for (size_t c = 0; c < 3; ++c) {
    const Number ex = dot(edge[c], x), ey = dot(edge[c], y), squared = dot(edge[c], edge[c]);
    const Number gx = -ey / twiceArea, gy = ex / twiceArea;
    const Number ux = along(x, mode.displacement[c]), uy = along(y, mode.displacement[c]);
    strainX += gx * ux;
    strainY += gy * uy;
    strainXY += gx * uy + gy * ux;
    slopeOf[c] = {ex * ey / squared, -(ex * ey) / squared, (ey * ey - ex * ex) / squared};
    const Number turned = sqrt(squared) / area * mode.turn[c];  // m_e m_e^T l_e / A s_e phi_e
    bendX += ey * ey / squared * turned;
    bendY += ex * ex / squared * turned;
    bendXY += -(ex * ey) / squared * turned * 2.0;
  }
  for (size_t c = 0; c < 3; ++c) {  // corner c ends edge c + 1 and starts edge c + 2
    const Number w = along(normal, mode.displacement[c]) / area;
    const auto &ends = slopeOf[(c + 1) % 3], &starts = slopeOf[(c + 2) % 3];
    bendX += (starts[0] - ends[0]) * w;
    bendY += (starts[1] - ends[1]) * w;
    bendXY += (starts[2] - ends[2]) * w;
  }
  double squares = 0;
  for (const auto& u : mode.displacement) squares += u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
  const double h = material.thickness;
  return area * (planeStressEnergy(strainX, strainY, strainXY, material.poisson) * h +
                 planeStressEnergy(bendX, bendY, bendXY, material.poisson) * (h * h * h / 12) -
                 Number(lambda * h * squares / 3));
}

ElementMode modeOf(const TriangleMesh& mesh, const Topology& topology, uint32_t t,
                   const Eigen::Ref<const Eigen::VectorXd>& phi) {
  ElementMode mode;
  const Triangle& triangle = mesh.triangles[t];
  for (size_t c = 0; c < 3; ++c) {
    for (size_t axis = 0; axis < 3; ++axis) mode.displacement[c][axis] = phi[3 * triangle[c] + axis];
    const double sign = triangle[(c + 1) % 3] < triangle[(c + 2) % 3] ? 1 : -1;
    mode.turn[c] = sign * phi[3 * mesh.vertexCount() + topology.edgeOfCorner[3 * size_t{t} + c]];
  }
  return mode;
}

}  // namespace

Eigen::VectorXd eigenvalueSensitivity(const TriangleMesh& mesh, const Topology& topology,
                                      const ShellMaterial& material, double lambda,
                                      const Eigen::Ref<const Eigen::VectorXd>& phi) {
  std::vector<std::array<double, 9>> slopes(mesh.triangleCount());
  parallelFor(slopes.size(), kTrianglesPerRange, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const auto t = static_cast<uint32_t>(i);
      std::array<Point, 3> corner;
      for (int c = 0; c < 3; ++c)
        for (int axis = 0; axis < 3; ++axis)
          corner[static_cast<size_t>(c)][static_cast<size_t>(axis)] =
              Number::variable(mesh.corner(t, c)[axis], 3 * c + axis);
      slopes[i] = elementTerm(corner, modeOf(mesh, topology, t, phi), material, lambda).slope;
    }
  });
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(mesh.vertexCount()));
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    for (size_t c = 0; c < 3; ++c)
      for (size_t axis = 0; axis < 3; ++axis) {
        const double slope = slopes[t][3 * c + axis];
        if (std::isfinite(slope)) sum[3 * mesh.triangles[t][c] + static_cast<Eigen::Index>(axis)] += slope;
      }
  return sum;
}

}  // namespace limber
