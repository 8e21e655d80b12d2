#include "elastic/solvers/hinge_element.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "elastic/shell_element.h"

namespace limber {
namespace {

struct FoldedHinge {
  Vec3 edge, first, second;  // the edge, and normals whose lengths are twice the areas

  explicit FoldedHinge(const std::array<Vec3, 4>& x)
      : edge(x[1] - x[0]), first(cross(edge, x[2] - x[0])), second(cross(x[3] - x[0], edge)) {}

  double angle() const { return std::atan2(dot(cross(first, second), normalized(edge)), dot(first, second)); }
};

// Height over longest edge of a triangle, from an edge, the opposite corner and twice the area.
double flatness(const Vec3& edge, const Vec3& toCorner, double doubleArea) {
  const double longest =
      std::max({squaredLength(edge), squaredLength(toCorner), squaredLength(toCorner - edge)});
  return longest > 0 ? doubleArea / longest : 0;
}

double stiffnessOf(BendElement element, double bend, double edge, double doubleAreas) {
  if (element == BendElement::HingeByArea) return 6 * bend * edge * edge / doubleAreas;
  return element == BendElement::HingeByLength ? bend * edge : bend;
}

// -(l / |n|^2) n.
Vec3 cornerGradient(const Vec3& normal, double edge) {
  const double squared = squaredLength(normal);
  const double shrunk = squared > 0 ? edge / squared : 0;
  return std::isfinite(shrunk) ? -shrunk * normal : Vec3{};
}

void setDerivative(ConstraintStrain& strain, int vertex, const Vec3& gradient) {
  for (int axis = 0; axis < 3; ++axis) strain.jacobian(0, 3 * vertex + axis) = gradient[axis];
}

}  // namespace

HingeElement::HingeElement(BendElement element, double bend, const std::array<Vec3, 4>& rest) : root_(0) {
  const FoldedHinge fold(rest);
  const double first = length(fold.first), second = length(fold.second);
  const double flattest =
      std::min(flatness(fold.edge, rest[2] - rest[0], first), flatness(fold.edge, rest[3] - rest[0], second));
  if (flattest < kDegenerateTriangle) return;
  root_ = std::sqrt(stiffnessOf(element, bend, length(fold.edge), first + second)) *
          std::min(1.0, flattest / kFlattestTriangle);
  angle_ = fold.angle();
}

ConstraintStrain HingeElement::strainAt(const std::array<Vec3, 4>& x) const {
  ConstraintStrain result;
  const FoldedHinge fold(x);
  const double squaredEdge = squaredLength(fold.edge), edge = std::sqrt(squaredEdge);
  if (root_ == 0 || edge == 0) return result;
  result.strain[0] = root_ * std::remainder(fold.angle() - angle_, 2 * std::numbers::pi);
  const Vec3 third = root_ * cornerGradient(fold.first, edge),
             fourth = root_ * cornerGradient(fold.second, edge);
  const double thirdFoot = dot(x[2] - x[0], fold.edge) / squaredEdge,
               fourthFoot = dot(x[3] - x[0], fold.edge) / squaredEdge;
  const Vec3 end = -(thirdFoot * third + fourthFoot * fourth);
  setDerivative(result, 0, -(third + fourth + end));
  setDerivative(result, 1, end);
  setDerivative(result, 2, third);
  setDerivative(result, 3, fourth);
  return result;
}

}  // namespace limber
