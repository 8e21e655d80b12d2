#include "elastic/shell_sensitivity.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/dual.h"
#include "base/parallel.h"
#include "base/real_pair.h"
#include "elastic/shell_element.h"

namespace limber {

namespace {

// In its own plane a triangle has corner 0 at (0, 0), corner 1 at (a, 0) and corner 2 at (b, c). A Number has
// its derivatives with respect to the shape parameters a, b and c.
using Number = Dual<3>;
using DualTensor = std::array<Number, 3>;  // xx, yy, 2 xy
constexpr size_t kShapeParameters = 3;

// An element is differentiated with respect to a, b and c, then to small rotations about its own axes x, y
// and z.
constexpr size_t kParameters = 6;

constexpr size_t kTrianglesPerRange = 128;
constexpr uint32_t kTrianglesPerChunk = 1024;

// The strains of elastic/shell.h, from displacements along the triangle's own axes and from edge rotations.
struct Element {
  Eigen::Matrix3d axes;  // columns: x from corner 0 to corner 1, y, normal
  double a, b, c;
  Number area, weight;                         // of mass and of stiffness, see ShellElement
  std::array<Number, 3> gradientX, gradientY;  // per corner: of its barycentric coordinate
  std::array<DualTensor, 3> cornerCurvature;   // per corner: from its normal displacement
  std::array<DualTensor, 3> edgeCurvature;     // per edge: from its rotation
};

Eigen::Matrix3d axesOf(const TriangleMesh& mesh, uint32_t t) {
  const Vec3 x = normalized(mesh.corner(t, 1) - mesh.corner(t, 0)), n = normalized(areaNormal(mesh, t));
  const Vec3 y = cross(n, x);
  Eigen::Matrix3d axes;
  axes << x.x, y.x, n.x, x.y, y.y, n.y, x.z, y.z, n.z;
  return axes;
}

Number longestSquared(const std::array<Number, 3>& edgeX, const std::array<Number, 3>& edgeY) {
  Number longest = Number(0);
  for (size_t e = 0; e < 3; ++e) {
    const Number squared = edgeX[e] * edgeX[e] + edgeY[e] * edgeY[e];
    if (squared.value > longest.value) longest = squared;
  }
  return longest;
}

// ShellElement::weight; 0 for a tie, whose stiffness hardly depends on its shape.
Number stiffnessWeight(const Number& area, const Number& squaredLongest) {
  const Number flatness = area * 2.0 / squaredLongest;
  if (!(flatness.value > kDegenerateTriangle)) return Number(0);
  return flatness.value < kFlattestTriangle ? area * flatness * (1 / kFlattestTriangle) : area;
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
  // Edge e is opposite to corner e and runs from corner e + 1 to corner e + 2.
  const std::array<Number, 3> edgeX = {b - a, -b, a}, edgeY = {c, -c, Number(0)};
  const Number twiceArea = a * c;
  element.area = twiceArea * 0.5;
  element.weight = stiffnessWeight(element.area, longestSquared(edgeX, edgeY));
  std::array<DualTensor, 3> tangentNormal;  // t_e m_e^T
  for (size_t e = 0; e < 3; ++e) {
    const Number ex = edgeX[e], ey = edgeY[e], squared = ex * ex + ey * ey;
    element.gradientX[e] = -ey / twiceArea;
    element.gradientY[e] = ex / twiceArea;
    tangentNormal[e] = {ex * ey / squared, -(ex * ey) / squared, (ey * ey - ex * ex) / squared};
    const Number factor = Number(1) / (sqrt(squared) * element.area);  // l_e / A, over l_e^2
    element.edgeCurvature[e] = {ey * ey * factor, ex * ex * factor, ex * ey * factor * -2.0};
  }
  for (size_t v = 0; v < 3; ++v)  // corner v ends edge v + 1 and starts edge v + 2
    for (size_t k = 0; k < 3; ++k)
      element.cornerCurvature[v][k] =
          (tangentNormal[(v + 2) % 3][k] - tangentNormal[(v + 1) % 3][k]) / element.area;
  return element;
}

// The displacements of one triangle in a mode, along the triangle's own axes.
struct ElementMode {
  std::array<std::array<double, 3>, 3> displacement;  // per corner
  std::array<double, 3> edgeRotation;                 // per edge e: s_e psi_e
};

ElementMode modeOf(const ThinShell& shell, uint32_t t, const Element& element,
                   const Eigen::Ref<const Eigen::VectorXd, 0, Eigen::InnerStride<>>& phi) {
  const auto& [mesh, topology, thickness, poisson] = shell;
  ElementMode mode;
  const Triangle& triangle = mesh.triangles[t];
  for (size_t v = 0; v < 3; ++v) {
    const Eigen::Vector3d own =
        element.axes.transpose() * phi.segment<3>(3 * static_cast<Eigen::Index>(triangle[v]));
    mode.displacement[v] = {own[0], own[1], own[2]};
    const double sign = triangle[(v + 1) % 3] < triangle[(v + 2) % 3] ? 1 : -1;
    mode.edgeRotation[v] = sign * phi[3 * mesh.vertexCount() + topology.edgeOpposite(Corner(t, v))];
  }
  return mode;
}

// The membrane strain, then the curvature.
using Strain = std::array<double, 6>;

// A number with its derivatives with respect to a, b and c and to rotations about x, y and z. The last lane
// is unused.
using Derivatives = std::array<RealPair, 4>;

struct StrainDerivatives {
  Strain stress{};
  std::array<Derivatives, 6> strain{};
};

// The first two lanes of a Number, its value and the derivative with respect to a, or the other two.
RealPair lanes(const Number& x, size_t half) {
  return half == 0 ? RealPair{x.value, x.derivative[0]} : RealPair{x.derivative[1], x.derivative[2]};
}

// Adds the strains from corner v and its opposite edge, with derivatives with respect to the shape
// parameters.
void addShape(const Element& element, const ElementMode& mode, size_t v, std::array<Derivatives, 6>& out) {
  const auto [ux, uy, w] = mode.displacement[v];
  for (size_t half = 0; half < 2; ++half) {
    const RealPair gx = lanes(element.gradientX[v], half), gy = lanes(element.gradientY[v], half);
    out[0][half] += gx * ux;
    out[1][half] += gy * uy;
    out[2][half] += gx * uy + gy * ux;
    for (size_t k = 0; k < 3; ++k)
      out[3 + k][half] += lanes(element.cornerCurvature[v][k], half) * w +
                          lanes(element.edgeCurvature[v][k], half) * mode.edgeRotation[v];
  }
}

// Adds the derivatives of the strains from corner v with respect to rotations of the triangle. In the frame
// of a triangle that rotates by a small angle, displacements rotate backwards.
void addRotations(const Element& element, const ElementMode& mode, size_t v,
                  std::array<Derivatives, 6>& out) {
  const auto [ux, uy, w] = mode.displacement[v];
  const std::array<RealPair, 2> x = {RealPair{0, -w}, RealPair{uy, 0}},
                                y = {RealPair{w, 0}, RealPair{-ux, 0}},
                                z = {RealPair{-uy, ux}, RealPair{0, 0}};
  const double gx = element.gradientX[v].value, gy = element.gradientY[v].value;
  for (size_t half = 0; half < 2; ++half) {
    out[0][2 + half] += gx * x[half];
    out[1][2 + half] += gy * y[half];
    out[2][2 + half] += gx * y[half] + gy * x[half];
    for (size_t k = 0; k < 3; ++k) out[3 + k][2 + half] += element.cornerCurvature[v][k].value * z[half];
  }
}

// Plane stress for E = 1, times `factor`.
void setStress(const double* strain, double factor, double poisson, double* stress) {
  const double scale = factor / (1 - poisson * poisson);
  stress[0] = scale * (strain[0] + poisson * strain[1]);
  stress[1] = scale * (strain[1] + poisson * strain[0]);
  stress[2] = scale * (1 - poisson) / 2 * strain[2];
}

StrainDerivatives strainsOf(const Element& element, const ElementMode& mode, const ThinShell& shell) {
  StrainDerivatives strains;
  for (size_t v = 0; v < 3; ++v) {
    addShape(element, mode, v, strains.strain);
    addRotations(element, mode, v, strains.strain);
  }
  Strain value;
  for (size_t k = 0; k < 6; ++k) value[k] = strains.strain[k][0][0];
  const double h = shell.thickness;
  setStress(value.data(), h, shell.poisson, strains.stress.data());
  setStress(value.data() + 3, h * h * h / 12, shell.poisson, strains.stress.data() + 3);
  return strains;
}

// The stresses of each mode times the strains of the other, with derivatives. The material stiffness is
// constant, so derivatives of stresses are not needed.
Derivatives energyDerivatives(const StrainDerivatives& i, const StrainDerivatives& j) {
  Derivatives sum{};
  for (size_t k = 0; k < 6; ++k)
    for (size_t at = 0; at < sum.size(); ++at)
      sum[at] += i.stress[k] * j.strain[k][at] + j.stress[k] * i.strain[k][at];
  return sum;
}

// lambda h / 3 times the sum of u_i . u_j over the corners: the kinetic energy per unit of area, with lumped
// masses.
double inertiaOf(const ElementMode& a, const ElementMode& b, double lambda, double thickness) {
  double sum = 0;
  for (size_t v = 0; v < 3; ++v)
    for (size_t axis = 0; axis < 3; ++axis) sum += a.displacement[v][axis] * b.displacement[v][axis];
  return lambda * thickness * sum / 3;
}

// Derivatives with respect to the coordinates of the corners from those with respect to shape and rotation.
// Moving corner 1 along y rotates the triangle by 1 / a about its normal, and so on; moving all three corners
// equally changes nothing.
std::array<double, 9> byCorners(const Element& element, const std::array<double, kParameters>& derivative) {
  const auto& [a, b, c, rotationX, rotationY, rotationZ] = derivative;
  const Eigen::Vector3d first(a, (rotationZ + element.c * b - element.b * c) / element.a,
                              -(rotationY + element.b / element.c * rotationX) / element.a),
      second(b, c, rotationX / element.c);
  std::array<double, 9> out;
  Eigen::Map<Eigen::Matrix3d> corner(out.data());
  corner.col(1) = element.axes * first;
  corner.col(2) = element.axes * second;
  corner.col(0) = -corner.col(1) - corner.col(2);
  return out;
}

// The contribution of one triangle to the derivatives of psi_i^T (K - lambda M) psi_j.
std::array<double, 9> contribution(const Element& element, const StrainDerivatives& i,
                                   const StrainDerivatives& j, double inertia) {
  const Derivatives energy = energyDerivatives(i, j);
  std::array<double, kParameters> derivative;
  for (size_t k = 0; k < kParameters; ++k) {
    derivative[k] = element.weight.value * energy[(k + 1) / 2][(k + 1) % 2];
    if (k < kShapeParameters)
      derivative[k] +=
          0.5 * element.weight.derivative[k] * energy[0][0] - element.area.derivative[k] * inertia;
  }
  return byCorners(element, derivative);
}

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Computes the derivatives of all pairs for one triangle after another. One object for each thread.
class Differentiator {
 public:
  Differentiator(const ThinShell& shell, const RowMajor& psi, std::span<const ModePair> pairs)
      : shell_(shell),
        psi_(psi),
        pairs_(pairs),
        modes_(static_cast<size_t>(psi.cols())),
        strains_(modes_.size()) {}

  // Writes row 3 k + c of `rows`: the derivatives with respect to coordinate c of corner k, a column for each
  // pair. Triangles without area contribute nothing.
  void differentiate(uint32_t t, Eigen::Ref<RowMajor> rows) {
    const Element element = elementOf(shell_.mesh, t);
    for (size_t k = 0; k < modes_.size(); ++k) {
      modes_[k] = modeOf(shell_, t, element, psi_.col(static_cast<Eigen::Index>(k)));
      strains_[k] = strainsOf(element, modes_[k], shell_);
    }
    for (size_t p = 0; p < pairs_.size(); ++p) {
      const auto i = static_cast<size_t>(pairs_[p].i), j = static_cast<size_t>(pairs_[p].j);
      const double inertia = inertiaOf(modes_[i], modes_[j], pairs_[p].lambda, shell_.thickness);
      const auto derivative = contribution(element, strains_[i], strains_[j], inertia);
      for (size_t n = 0; n < 9; ++n)
        rows(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(p)) =
            std::isfinite(derivative[n]) ? derivative[n] : 0;
    }
  }

 private:
  const ThinShell& shell_;
  const RowMajor& psi_;
  std::span<const ModePair> pairs_;
  std::vector<ElementMode> modes_;
  std::vector<StrainDerivatives> strains_;
};

}  // namespace

Eigen::MatrixXd shellSensitivity(const ThinShell& shell, const Eigen::MatrixXd& psi,
                                 std::span<const ModePair> pairs, const Job& job) {
  const TriangleMesh& mesh = shell.mesh;
  const RowMajor shapes = psi;
  const auto pairCount = static_cast<Eigen::Index>(pairs.size());
  RowMajor sum = RowMajor::Zero(3 * static_cast<Eigen::Index>(mesh.vertexCount()), pairCount);
  RowMajor derivatives(9 * kTrianglesPerChunk, pairCount);  // nine rows per triangle
  // Chunks bound the memory of `derivatives`; sums are formed in the order of the triangles.
  for (uint32_t first = 0; first < mesh.triangleCount(); first += kTrianglesPerChunk) {
    job.check();
    const uint32_t count = std::min(kTrianglesPerChunk, mesh.triangleCount() - first);
    parallelFor(count, kTrianglesPerRange, [&](size_t begin, size_t end) {
      Differentiator differentiator(shell, shapes, pairs);
      for (size_t at = begin; at < end; ++at)
        differentiator.differentiate(first + static_cast<uint32_t>(at),
                                     derivatives.middleRows<9>(9 * static_cast<Eigen::Index>(at)));
    });
    for (uint32_t k = 0; k < 3 * count; ++k)
      sum.middleRows<3>(3 * static_cast<Eigen::Index>(mesh.triangles[first + k / 3][k % 3])) +=
          derivatives.middleRows<3>(3 * static_cast<Eigen::Index>(k));
  }
  return sum;
}

}  // namespace limber
