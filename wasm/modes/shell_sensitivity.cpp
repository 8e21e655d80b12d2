#include "modes/shell_sensitivity.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/dual.h"
#include "base/parallel.h"

namespace limber {

namespace {

using Number = Dual<9>;  // derivatives by the three corners' coordinates
using Point = std::array<Number, 3>;

constexpr size_t kTrianglesPerRange = 128;
constexpr uint32_t kTrianglesPerChunk = 4096;

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

// What an element's geometry makes of a mode.
struct Strains {
  std::array<Number, 3> membrane, bending;  // xx, yy, 2 xy
};

// Triangle's own axes and what depends on them alone; x along edge 2, from corner 0 to corner 1, as in
// modes/shell.cpp.
struct Geometry {
  Number area, twiceArea;
  Point normal, x, y;
  std::array<Number, 3> edgeX, edgeY, squared;
  std::array<std::array<Number, 3>, 3> slopeOf;  // t_e m_e^T as (xx, yy, 2 xy)
  std::array<Number, 3> turning;                 // l_e / A
};

Geometry geometryOf(const std::array<Point, 3>& corner) {
  Geometry g;
  std::array<Point, 3> edge;  // edge c runs from corner c + 1 to corner c + 2
  for (size_t c = 0; c < 3; ++c) edge[c] = corner[(c + 2) % 3] - corner[(c + 1) % 3];
  const Point twice = cross(edge[0], edge[1]);
  g.twiceArea = sqrt(dot(twice, twice));
  g.area = g.twiceArea * 0.5;
  g.normal = twice / g.twiceArea;
  g.x = edge[2] / sqrt(dot(edge[2], edge[2]));
  g.y = cross(g.normal, g.x);
  for (size_t c = 0; c < 3; ++c) {
    const Number ex = g.edgeX[c] = dot(edge[c], g.x), ey = g.edgeY[c] = dot(edge[c], g.y);
    const Number squared = g.squared[c] = dot(edge[c], edge[c]);
    g.slopeOf[c] = {ex * ey / squared, -(ex * ey) / squared, (ey * ey - ex * ex) / squared};
    g.turning[c] = sqrt(squared) / g.area;
  }
  return g;
}

Number along(const Point& axis, const std::array<double, 3>& u) {
  return axis[0] * u[0] + axis[1] * u[1] + axis[2] * u[2];
}

Strains strainsOf(const Geometry& g, const ElementMode& mode) {
  Strains strains;
  auto& [sx, sy, sxy] = strains.membrane;
  auto& [bx, by, bxy] = strains.bending;
  for (size_t c = 0; c < 3; ++c) {
    const Number gx = -g.edgeY[c] / g.twiceArea, gy = g.edgeX[c] / g.twiceArea;
    const Number ux = along(g.x, mode.displacement[c]), uy = along(g.y, mode.displacement[c]);
    sx += gx * ux;
    sy += gy * uy;
    sxy += gx * uy + gy * ux;
    const Number turned = g.turning[c] * mode.turn[c] / g.squared[c];  // l_e / A s_e phi_e, times m_e m_e^T
    bx += g.edgeY[c] * g.edgeY[c] * turned;
    by += g.edgeX[c] * g.edgeX[c] * turned;
    bxy += -(g.edgeX[c] * g.edgeY[c]) * turned * 2.0;
  }
  for (size_t c = 0; c < 3; ++c) {  // corner c ends edge c + 1 and starts edge c + 2
    const Number w = along(g.normal, mode.displacement[c]) / g.area;
    const auto &ends = g.slopeOf[(c + 1) % 3], &starts = g.slopeOf[(c + 2) % 3];
    for (size_t k = 0; k < 3; ++k) strains.bending[k] += (starts[k] - ends[k]) * w;
  }
  return strains;
}

// (xx, yy, 2 xy) in plane stress of unit stiffness, one contracted with the other.
Number planeStressProduct(const std::array<Number, 3>& a, const std::array<Number, 3>& b, double poisson) {
  const Number normal = a[0] * b[0] + a[1] * b[1] + (a[0] * b[1] + a[1] * b[0]) * poisson;
  return (normal + a[2] * b[2] * ((1 - poisson) / 2)) * (1 / (1 - poisson * poisson));
}

// psi_i^T (K - lambda M) psi_j of one triangle.
std::array<double, 9> slopesOf(const Geometry& g, const Strains& a, const Strains& b,
                               const ShellMaterial& material, double inertia) {
  const double h = material.thickness;
  const Number energy = planeStressProduct(a.membrane, b.membrane, material.poisson) * h +
                        planeStressProduct(a.bending, b.bending, material.poisson) * (h * h * h / 12);
  return (g.area * (energy - Number(inertia))).slope;
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

// lambda h / 3 times the sum over the corners of u_i . u_j: a lumped mass for each unit of area.
double inertiaOf(const ElementMode& a, const ElementMode& b, double lambda, double thickness) {
  double product = 0;
  for (size_t c = 0; c < 3; ++c)
    for (size_t axis = 0; axis < 3; ++axis) product += a.displacement[c][axis] * b.displacement[c][axis];
  return lambda * thickness * product / 3;
}

}  // namespace

Eigen::MatrixXd shellSensitivity(const TriangleMesh& mesh, const Topology& topology,
                                 const ShellMaterial& material, const Eigen::MatrixXd& psi,
                                 std::span<const ModePair> pairs, const Job& job) {
  const auto modeCount = static_cast<size_t>(psi.cols());
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(mesh.vertexCount()),
                                              static_cast<Eigen::Index>(pairs.size()));
  std::vector<std::array<double, 9>> slopes(kTrianglesPerChunk * pairs.size());
  const auto differentiate = [&](uint32_t t, std::array<double, 9>* out) {
    std::array<Point, 3> corner;
    for (int c = 0; c < 3; ++c)
      for (int axis = 0; axis < 3; ++axis)
        corner[static_cast<size_t>(c)][static_cast<size_t>(axis)] =
            Number::variable(mesh.corner(t, c)[axis], 3 * c + axis);
    const Geometry geometry = geometryOf(corner);
    std::vector<ElementMode> modes;
    std::vector<Strains> strains;
    for (size_t k = 0; k < modeCount; ++k) {
      modes.push_back(modeOf(mesh, topology, t, psi.col(static_cast<Eigen::Index>(k))));
      strains.push_back(strainsOf(geometry, modes.back()));
    }
    for (const auto& [i, j, lambda] : pairs) {
      const auto a = static_cast<size_t>(i), b = static_cast<size_t>(j);
      *out++ = slopesOf(geometry, strains[a], strains[b], material,
                        inertiaOf(modes[a], modes[b], lambda, material.thickness));
    }
  };
  for (uint32_t first = 0; first < mesh.triangleCount(); first += kTrianglesPerChunk) {
    job.check();
    const uint32_t count = std::min(kTrianglesPerChunk, mesh.triangleCount() - first);
    parallelFor(count, kTrianglesPerRange, [&](size_t begin, size_t end) {
      for (size_t k = begin; k < end; ++k)
        differentiate(first + static_cast<uint32_t>(k), &slopes[k * pairs.size()]);
    });
    for (size_t p = 0; p < pairs.size(); ++p)
      for (uint32_t k = 0; k < count; ++k) {
        const auto& slope = slopes[k * pairs.size() + p];
        for (uint32_t n = 0; n < 9; ++n)
          if (std::isfinite(slope[n]))
            sum(3 * mesh.triangles[first + k][n / 3] + n % 3, static_cast<Eigen::Index>(p)) += slope[n];
      }
  }
  return sum;
}

}  // namespace limber
