#include "elastic/shell_element.h"

#include <algorithm>
#include <array>

namespace limber {

namespace {

using Tensor = Eigen::Vector3d;  // xx, yy, 2 xy

// A triangle in its own plane: the x axis along its longest edge, the y axis perpendicular. Edge c is
// opposite to corner c and runs from corner c + 1 to corner c + 2.
struct Frame {
  int longest;  // the longest edge
  Vec3 x, y, normal;
  std::array<double, 3> edgeX, edgeY, length;
  double area, flatness;
};

Frame frameOf(const TriangleMesh& mesh, uint32_t t) {
  Frame frame;
  std::array<Vec3, 3> edge;
  for (int c = 0; c < 3; ++c) {
    edge[c] = mesh.corner(t, (c + 2) % 3) - mesh.corner(t, (c + 1) % 3);
    frame.length[c] = length(edge[c]);
  }
  const auto longest = std::max_element(frame.length.begin(), frame.length.end()) - frame.length.begin();
  frame.longest = static_cast<int>(longest);
  const Vec3 twice = cross(edge[(longest + 1) % 3], edge[(longest + 2) % 3]);
  frame.area = 0.5 * length(twice);
  frame.flatness =
      frame.length[longest] > 0 ? 2 * frame.area / (frame.length[longest] * frame.length[longest]) : 0;
  frame.normal = normalized(twice);
  frame.x = normalized(edge[longest]);
  frame.y = cross(frame.normal, frame.x);
  for (int c = 0; c < 3; ++c) {
    frame.edgeX[c] = dot(edge[c], frame.x);
    frame.edgeY[c] = dot(edge[c], frame.y);
  }
  return frame;
}

// Constant-strain triangle: the in-plane strain from the displacements. The gradient of the barycentric
// coordinate of corner c is edge c, rotated by 90 degrees, over twice the area.
ShellElement::Strain membraneStrain(const Frame& frame) {
  ShellElement::Strain b = ShellElement::Strain::Zero();
  for (int c = 0; c < 3; ++c) {
    const double gx = -frame.edgeY[c] / (2 * frame.area), gy = frame.edgeX[c] / (2 * frame.area);
    for (int axis = 0; axis < 3; ++axis)
      b.col(3 * c + axis) =
          Tensor(gx * frame.x[axis], gy * frame.y[axis], gx * frame.y[axis] + gy * frame.x[axis]);
  }
  return b;
}

// Morley's element: the constant curvature from normal displacements w and edge rotations. A linear w with
// gradient g has
//   sum_e l_e (g . m_e) m_e m_e^T = -sum_e (w_end - w_start) t_e m_e^T
// with t_e along edge e and m_e outwards, because the vectors l_e m_e sum to 0. So the displacements are only
// divided by the area, and the gradient itself, which in a thin triangle would suffer from cancellation,
// never appears.
ShellElement::Strain bendingCurvature(const Frame& frame, const std::array<double, 3>& sign) {
  std::array<Tensor, 3> tangentNormal;  // t_e m_e^T, with t_e = (cosine, sine) and m_e = (sine, -cosine)
  ShellElement::Strain b;
  for (int e = 0; e < 3; ++e) {
    const double cosine = frame.edgeX[e] / frame.length[e], sine = frame.edgeY[e] / frame.length[e];
    tangentNormal[e] = Tensor(cosine * sine, -cosine * sine, sine * sine - cosine * cosine);
    b.col(9 + e) =
        Tensor(sine * sine, cosine * cosine, -2 * sine * cosine) * (sign[e] * frame.length[e] / frame.area);
  }
  for (int c = 0; c < 3; ++c) {  // corner c ends edge c + 1 and starts edge c + 2
    const Tensor bend = (tangentNormal[(c + 2) % 3] - tangentNormal[(c + 1) % 3]) / frame.area;
    for (int axis = 0; axis < 3; ++axis) b.col(3 * c + axis) = bend * frame.normal[axis];
  }
  return b;
}

// The gaps of a tie: of the middle corner from the longest edge, then between the rotations of the longest
// edge and each other.
void setGaps(const Frame& frame, const std::array<double, 3>& sign, ShellElement& element) {
  const int e = frame.longest, middle = e, start = (e + 1) % 3, end = (e + 2) % 3;
  const double share = std::clamp(-frame.edgeX[end] / frame.length[e], 0.0, 1.0);
  for (int axis = 0; axis < 3; ++axis) {
    element.strain(axis, 3 * middle + axis) = 1;
    element.strain(axis, 3 * start + axis) = share - 1;
    element.strain(axis, 3 * end + axis) = -share;
  }
  for (int k = 0; k < 2; ++k) {
    const int other = (e + 1 + k) % 3;  // traversed against the longest edge
    element.curvature(k, 9 + e) = sign[e];
    element.curvature(k, 9 + other) = sign[other];
  }
}

}  // namespace

ShellElement shellElement(const TriangleMesh& mesh, uint32_t t) {
  const Triangle& triangle = mesh.triangles[t];
  std::array<double, 3> sign;
  for (int e = 0; e < 3; ++e) sign[e] = triangle[(e + 1) % 3] < triangle[(e + 2) % 3] ? 1 : -1;
  const Frame frame = frameOf(mesh, t);
  ShellElement element;
  element.isTie = !(frame.flatness > kDegenerateTriangle);
  if (element.isTie) {
    setGaps(frame, sign, element);
    return element;
  }
  element.strain = membraneStrain(frame);
  element.curvature = bendingCurvature(frame, sign);
  element.weight = frame.area * std::min(1.0, frame.flatness / kFlattestTriangle);
  return element;
}

}  // namespace limber
