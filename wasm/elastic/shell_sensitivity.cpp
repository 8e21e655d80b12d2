#include "elastic/shell_sensitivity.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/dual.h"
#include "base/parallel.h"
#include "base/real_pair.h"

namespace limber {

namespace {

// A triangle's shape in its own plane is three numbers: corner 0 at (0, 0), 1 at (a, 0), 2 at (b, c). A
// number and its derivatives by these.
using Number = Dual<3>;
using Tensor = std::array<Number, 3>;  // xx, yy, 2 xy
constexpr size_t kShape = 3;

// What an element's derivatives are taken by: a, b, c, and turns about its own axes x, y, z.
constexpr size_t kParameters = 6;

constexpr size_t kTrianglesPerRange = 128;
constexpr uint32_t kTrianglesPerChunk = 1024;

// Strains of modes/shell.h from displacements along the triangle's own axes and rotations of its edges.
struct Element {
  Eigen::Matrix3d axes;  // columns: x from corner 0 to corner 1, y, normal
  double a, b, c;
  Number area;
  std::array<Number, 3> gradientX, gradientY;  // of the corners' barycentric coordinates
  std::array<Tensor, 3> bend, turn;            // curvature for a corner's w, and for an edge's rotation
};

Eigen::Matrix3d axesOf(const TriangleMesh& mesh, uint32_t t) {
  const Vec3 x = normalized(mesh.corner(t, 1) - mesh.corner(t, 0)), n = normalized(areaNormal(mesh, t));
  const Vec3 y = cross(n, x);
  Eigen::Matrix3d axes;
  axes << x.x, y.x, n.x, x.y, y.y, n.y, x.z, y.z, n.z;
  return axes;
}

Element elementOf(const TriangleMesh& mesh, uint32_t t) {
  Element element;
  element.axes = axesOf(mesh, t);
  const Vec3 p = mesh.corner(t, 1) - mesh.corner(t, 0), q = mesh.corner(t, 2) - mesh.corner(t, 0);
  element.a = length(p);
  element.b = dot(q, p) / element.a;
  element.c = length(cross(p, q)) / element.a;
  const Number a = Number::variable(element.a, 0), b = Number::variable(element.b, 1),
               c = Number::variable(element.c, 2);
  // Edge e runs from corner e + 1 to corner e + 2.
  const std::array<Number, 3> edgeX = {b - a, -b, a}, edgeY = {c, -c, Number(0)};
  const Number twiceArea = a * c;
  element.area = twiceArea * 0.5;
  std::array<Tensor, 3> slopeOf;  // t_e m_e^T
  for (size_t e = 0; e < 3; ++e) {
    const Number ex = edgeX[e], ey = edgeY[e], squared = ex * ex + ey * ey;
    element.gradientX[e] = -ey / twiceArea;
    element.gradientY[e] = ex / twiceArea;
    slopeOf[e] = {ex * ey / squared, -(ex * ey) / squared, (ey * ey - ex * ex) / squared};
    const Number turning = Number(1) / (sqrt(squared) * element.area);  // l_e / A, over l_e^2
    element.turn[e] = {ey * ey * turning, ex * ex * turning, ex * ey * turning * -2.0};
  }
  for (size_t v = 0; v < 3; ++v)  // corner v ends edge v + 1 and starts edge v + 2
    for (size_t k = 0; k < 3; ++k)
      element.bend[v][k] = (slopeOf[(v + 2) % 3][k] - slopeOf[(v + 1) % 3][k]) / element.area;
  return element;
}

// What a mode does to one triangle, along the triangle's own axes.
struct ElementMode {
  std::array<std::array<double, 3>, 3> displacement;  // of the corners
  std::array<double, 3> turn;                         // s_e phi_e of the edge opposite to each corner
};

ElementMode modeOf(const TriangleMesh& mesh, const Topology& topology, uint32_t t, const Element& element,
                   const Eigen::Ref<const Eigen::VectorXd, 0, Eigen::InnerStride<>>& phi) {
  ElementMode mode;
  const Triangle& triangle = mesh.triangles[t];
  for (size_t v = 0; v < 3; ++v) {
    const Eigen::Vector3d own =
        element.axes.transpose() * phi.segment<3>(3 * static_cast<Eigen::Index>(triangle[v]));
    mode.displacement[v] = {own[0], own[1], own[2]};
    const double sign = triangle[(v + 1) % 3] < triangle[(v + 2) % 3] ? 1 : -1;
    mode.turn[v] = sign * phi[3 * mesh.vertexCount() + topology.edgeOpposite(Corner(t, v))];
  }
  return mode;
}

// Membrane strain, then curvature.
using Strain = std::array<double, 6>;

// A strain, its derivatives by a, b and c, and those by turns about x, y and z; the last lane is free.
using StrainSlope = std::array<RealPair, 4>;

struct StrainSlopes {
  Strain stress{};
  std::array<StrainSlope, 6> strain{};
};

// A number and its first derivative, or the other two.
RealPair part(const Number& x, size_t half) {
  return half == 0 ? RealPair{x.value, x.derivative[0]} : RealPair{x.derivative[1], x.derivative[2]};
}

// What the shape makes of displacements and rotations at a corner.
void addShape(const Element& element, const ElementMode& mode, size_t v, std::array<StrainSlope, 6>& out) {
  const auto [ux, uy, w] = mode.displacement[v];
  for (size_t half = 0; half < 2; ++half) {
    const RealPair gx = part(element.gradientX[v], half), gy = part(element.gradientY[v], half);
    out[0][half] += gx * ux;
    out[1][half] += gy * uy;
    out[2][half] += gx * uy + gy * ux;
    for (size_t k = 0; k < 3; ++k)
      out[3 + k][half] += part(element.bend[v][k], half) * w + part(element.turn[v][k], half) * mode.turn[v];
  }
}

// When a triangle turns by a small angle about one of its axes, displacements turn back against it.
void addTurns(const Element& element, const ElementMode& mode, size_t v, std::array<StrainSlope, 6>& out) {
  const auto [ux, uy, w] = mode.displacement[v];
  const std::array<RealPair, 2> x = {RealPair{0, -w}, RealPair{uy, 0}},
                                y = {RealPair{w, 0}, RealPair{-ux, 0}},
                                z = {RealPair{-uy, ux}, RealPair{0, 0}};
  const double gx = element.gradientX[v].value, gy = element.gradientY[v].value;
  for (size_t half = 0; half < 2; ++half) {
    out[0][2 + half] += gx * x[half];
    out[1][2 + half] += gy * y[half];
    out[2][2 + half] += gx * y[half] + gy * x[half];
    for (size_t k = 0; k < 3; ++k) out[3 + k][2 + half] += element.bend[v][k].value * z[half];
  }
}

// Plane stress of unit stiffness.
void setStress(const double* strain, double factor, double poisson, double* stress) {
  const double scale = factor / (1 - poisson * poisson);
  stress[0] = scale * (strain[0] + poisson * strain[1]);
  stress[1] = scale * (strain[1] + poisson * strain[0]);
  stress[2] = scale * (1 - poisson) / 2 * strain[2];
}

StrainSlopes strainsOf(const Element& element, const ElementMode& mode, const ShellMaterial& material) {
  StrainSlopes strains;
  for (size_t v = 0; v < 3; ++v) {
    addShape(element, mode, v, strains.strain);
    addTurns(element, mode, v, strains.strain);
  }
  Strain value;
  for (size_t k = 0; k < 6; ++k) value[k] = strains.strain[k][0][0];
  const double h = material.thickness;
  setStress(value.data(), h, material.poisson, strains.stress.data());
  setStress(value.data() + 3, h * h * h / 12, material.poisson, strains.stress.data() + 3);
  return strains;
}

// The stresses of each times the strains of the other, and the derivatives by the parameters. The material's
// stiffness is constant, so that a stress' derivatives need not be known.
StrainSlope energySlope(const StrainSlopes& i, const StrainSlopes& j) {
  StrainSlope sum{};
  for (size_t k = 0; k < 6; ++k)
    for (size_t at = 0; at < sum.size(); ++at)
      sum[at] += i.stress[k] * j.strain[k][at] + j.stress[k] * i.strain[k][at];
  return sum;
}

// lambda h / 3 times the sum over the corners of u_i . u_j: a lumped mass for each unit of area.
double inertiaOf(const ElementMode& a, const ElementMode& b, double lambda, double thickness) {
  double sum = 0;
  for (size_t v = 0; v < 3; ++v)
    for (size_t axis = 0; axis < 3; ++axis) sum += a.displacement[v][axis] * b.displacement[v][axis];
  return lambda * thickness * sum / 3;
}

// Derivatives by the corners' coordinates from those by shape and turns. Moving corner 1 along y turns the
// triangle by 1 / a about its normal, and so on; moving all three alike changes nothing.
std::array<double, 9> byCorners(const Element& element, const std::array<double, kParameters>& slope) {
  const auto& [a, b, c, turnX, turnY, turnZ] = slope;
  const Eigen::Vector3d first(a, (turnZ + element.c * b - element.b * c) / element.a,
                              -(turnY + element.b / element.c * turnX) / element.a),
      second(b, c, turnX / element.c);
  std::array<double, 9> out;
  Eigen::Map<Eigen::Matrix3d> corner(out.data());
  corner.col(1) = element.axes * first;
  corner.col(2) = element.axes * second;
  corner.col(0) = -corner.col(1) - corner.col(2);
  return out;
}

// Of psi_i^T (K - lambda M) psi_j of one triangle.
std::array<double, 9> slopesOf(const Element& element, const StrainSlopes& i, const StrainSlopes& j,
                               double inertia) {
  const StrainSlope energy = energySlope(i, j);
  const double density = 0.5 * energy[0][0] - inertia;
  std::array<double, kParameters> slope;
  for (size_t k = 0; k < kParameters; ++k) {
    slope[k] = element.area.value * energy[(k + 1) / 2][(k + 1) % 2];
    if (k < kShape) slope[k] += element.area.derivative[k] * density;
  }
  return byCorners(element, slope);
}

}  // namespace

Eigen::MatrixXd shellSensitivity(const TriangleMesh& mesh, const Topology& topology,
                                 const ShellMaterial& material, const Eigen::MatrixXd& psi,
                                 std::span<const ModePair> pairs, const Job& job) {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto modeCount = static_cast<size_t>(psi.cols());
  const RowMajor shapes = psi;
  const auto pairCount = static_cast<Eigen::Index>(pairs.size());
  RowMajor sum = RowMajor::Zero(3 * static_cast<Eigen::Index>(mesh.vertexCount()), pairCount);
  RowMajor slopes(9 * kTrianglesPerChunk, pairCount);  // nine rows a triangle
  const auto differentiate = [&](uint32_t first, size_t begin, size_t end) {
    std::vector<ElementMode> modes(modeCount);
    std::vector<StrainSlopes> strains(modeCount);
    for (size_t at = begin; at < end; ++at) {
      const uint32_t t = first + static_cast<uint32_t>(at);
      const Element element = elementOf(mesh, t);
      for (size_t k = 0; k < modeCount; ++k) {
        modes[k] = modeOf(mesh, topology, t, element, shapes.col(static_cast<Eigen::Index>(k)));
        strains[k] = strainsOf(element, modes[k], material);
      }
      for (size_t p = 0; p < pairs.size(); ++p) {
        const auto i = static_cast<size_t>(pairs[p].i), j = static_cast<size_t>(pairs[p].j);
        const double inertia = inertiaOf(modes[i], modes[j], pairs[p].lambda, material.thickness);
        const auto slope = slopesOf(element, strains[i], strains[j], inertia);
        for (size_t n = 0; n < 9; ++n)
          slopes(static_cast<Eigen::Index>(9 * at + n), static_cast<Eigen::Index>(p)) =
              std::isfinite(slope[n]) ? slope[n] : 0;
      }
    }
  };
  for (uint32_t first = 0; first < mesh.triangleCount(); first += kTrianglesPerChunk) {
    job.check();
    const uint32_t count = std::min(kTrianglesPerChunk, mesh.triangleCount() - first);
    parallelFor(count, kTrianglesPerRange,
                [&](size_t begin, size_t end) { differentiate(first, begin, end); });
    for (uint32_t k = 0; k < 3 * count; ++k)
      sum.middleRows<3>(3 * static_cast<Eigen::Index>(mesh.triangles[first + k / 3][k % 3])) +=
          slopes.middleRows<3>(3 * static_cast<Eigen::Index>(k));
  }
  return sum;
}

}  // namespace limber
