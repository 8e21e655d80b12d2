#include "elastic/shell.h"

#include <algorithm>
#include <array>

#include "linear/element_assembly.h"
#include "mesh/vertex_areas.h"

namespace limber {

namespace {

// Nine displacements (3 * corner + axis), then the rotations of the edges opposite to corners 0, 1, 2.
using ElementMatrix = Eigen::Matrix<double, 12, 12>;
// Strain or curvature as (xx, yy, 2 xy) along two axes in the triangle's plane.
using Tensor = Eigen::Vector3d;
using StrainMatrix = Eigen::Matrix<double, 3, 12>;

// A triangle flatter than this (height over longest edge) gets the stiffness of one that is just as flat:
// real stiffness grows with 1 / flatness and would drown the rest of the body in rounding. It still keeps its
// vertices together.
constexpr double kFlattest = 1e-4;
// A triangle flatter than this has no plane and becomes a tie between its vertices.
constexpr double kDegenerate = 1e-12;
// The stiffness of an edge rotation that only ties hold, relative to the bending stiffness of the tie: enough
// to keep K regular, too little to matter.
constexpr double kLooseRotation = 1e-10;

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

// The plane-stress matrix of E = 1, times `factor`.
Eigen::Matrix3d planeStress(double factor, double poisson) {
  Eigen::Matrix3d c;
  c << 1, poisson, 0, poisson, 1, 0, 0, 0, (1 - poisson) / 2;
  return c * (factor / (1 - poisson * poisson));
}

// Constant-strain triangle: the in-plane strain from the displacements. The gradient of the barycentric
// coordinate of corner c is edge c, rotated by 90 degrees, over twice the area.
StrainMatrix membraneStrain(const Frame& frame) {
  StrainMatrix b = StrainMatrix::Zero();
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
// with t_e along edge e and m_e outwards, because the vectors l_e m_e sum to 0. So the displacements enter
// divided by the area alone, and the gradient itself, which would cancel to rounding in a thin triangle,
// never appears.
StrainMatrix bendingCurvature(const Frame& frame, const std::array<double, 3>& sign) {
  std::array<Tensor, 3> tangentNormal;  // t_e m_e^T, with t_e = (cosine, sine) and m_e = (sine, -cosine)
  StrainMatrix b;
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

// The stiffness of a triangle whose corners lie on a line, the limit of the stiffness below as a triangle
// flattens. It ties the middle corner to the longest edge and makes the edge rotations on both sides equal.
// Without it a crack would open wherever such a triangle closes a surface.
ElementMatrix tie(const Frame& frame, const std::array<double, 3>& sign, double thickness) {
  const int e = frame.longest, middle = e, start = (e + 1) % 3, end = (e + 2) % 3;
  const double share = std::clamp(-frame.edgeX[end] / frame.length[e], 0.0, 1.0);
  Eigen::Matrix<double, 5, 12> gap = Eigen::Matrix<double, 5, 12>::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    gap(axis, 3 * middle + axis) = 1;
    gap(axis, 3 * start + axis) = share - 1;
    gap(axis, 3 * end + axis) = -share;
  }
  for (int k = 0; k < 2; ++k) {
    const int other = (e + 1 + k) % 3;  // runs against the longest edge
    gap(3 + k, 9 + e) = sign[e];
    gap(3 + k, 9 + other) = sign[other];
  }
  const double bending = thickness * thickness * thickness / 12;
  Eigen::Matrix<double, 5, 1> stiffness;
  stiffness << thickness, thickness, thickness, bending, bending;
  ElementMatrix k = gap.transpose() * (stiffness / kFlattest).asDiagonal() * gap;
  // Edge rotations without any other stiffness must not leave K singular.
  k.diagonal().tail<3>().array() += kLooseRotation * bending / kFlattest;
  return k;
}

ElementMatrix elementStiffness(const Frame& frame, const std::array<double, 3>& sign, double thickness,
                               double poisson) {
  if (!(frame.flatness > kDegenerate)) return tie(frame, sign, thickness);
  const StrainMatrix strain = membraneStrain(frame), curvature = bendingCurvature(frame, sign);
  const double weight = frame.area * std::min(1.0, frame.flatness / kFlattest);
  const StrainMatrix stress = planeStress(weight * thickness, poisson) * strain;
  const StrainMatrix moment =
      planeStress(weight * thickness * thickness * thickness / 12, poisson) * curvature;
  // lazyProduct, because Eigen considers these sizes large and would allocate packing buffers.
  return strain.transpose().lazyProduct(stress) + curvature.transpose().lazyProduct(moment);
}

// The nodes of each triangle: its corners, then its edges.
std::vector<uint32_t> elementNodes(const TriangleMesh& mesh, const Topology& topology) {
  std::vector<uint32_t> nodes;
  nodes.reserve(6 * size_t{mesh.triangleCount()});
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    nodes.insert(nodes.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
    for (uint32_t c = 0; c < 3; ++c)
      nodes.push_back(mesh.vertexCount() + topology.edgeOpposite(Corner(t, c)));
  }
  return nodes;
}

Eigen::SparseMatrix<double> assemble(const ThinShell& shell, const std::vector<uint32_t>& firstUnknown) {
  const auto& [mesh, topology, thickness, poisson] = shell;
  ElementAssembly assembly(firstUnknown, elementNodes(mesh, topology), 6);
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const Triangle& triangle = mesh.triangles[t];
    std::array<double, 3> sign;
    for (int e = 0; e < 3; ++e) sign[e] = triangle[(e + 1) % 3] < triangle[(e + 2) % 3] ? 1 : -1;
    assembly.add(t, elementStiffness(frameOf(mesh, t), sign, thickness, poisson));
  }
  return assembly.take();
}

std::vector<uint32_t> firstUnknowns(const TriangleMesh& mesh, const Topology& topology) {
  std::vector<uint32_t> first;
  const uint32_t vertexCount = mesh.vertexCount();
  for (uint32_t v = 0; v < vertexCount; ++v) first.push_back(3 * v);
  for (uint32_t e = 0; e <= topology.edges.size(); ++e) first.push_back(3 * vertexCount + e);
  return first;
}

}  // namespace

Eigen::MatrixXd rigidMotions(const TriangleMesh& mesh) {
  const Bounds box = bounds(mesh);
  const Vec3 middle = 0.5 * (box.low + box.high);
  Eigen::MatrixXd motions(3 * static_cast<Eigen::Index>(mesh.vertexCount()), 6);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const Vec3 p = mesh.positions[v] - middle;
    motions.middleRows<3>(3 * static_cast<Eigen::Index>(v)) << 1, 0, 0, 0, p.z, -p.y, 0, 1, 0, -p.z, 0, p.x,
        0, 0, 1, p.y, -p.x, 0;
  }
  return motions;
}

SparsePencil shellPencil(const ThinShell& shell) {
  SparsePencil pencil;
  pencil.firstUnknown = firstUnknowns(shell.mesh, shell.topology);
  pencil.k = assemble(shell, pencil.firstUnknown);
  pencil.m = Eigen::VectorXd::Zero(pencil.k.rows());
  const auto areas = lumpedAreas(shell.mesh);
  for (uint32_t v = 0; v < shell.mesh.vertexCount(); ++v)
    pencil.m.segment<3>(static_cast<Eigen::Index>(3 * v)).setConstant(shell.thickness * areas[v]);
  return pencil;
}

SparsePencil shellPattern(const TriangleMesh& mesh, const Topology& topology) {
  SparsePencil pencil;
  pencil.firstUnknown = firstUnknowns(mesh, topology);
  pencil.k = ElementAssembly(pencil.firstUnknown, elementNodes(mesh, topology), 6).take();
  pencil.m = Eigen::VectorXd::Zero(pencil.k.rows());
  return pencil;
}

std::vector<uint32_t> clampedUnknowns(const TriangleMesh& mesh, const Topology& topology,
                                      std::span<const uint32_t> pinned) {
  std::vector<uint8_t> isPinned(mesh.vertexCount(), 0);
  std::vector<uint32_t> clamped;
  for (uint32_t v : pinned) {
    isPinned[v] = 1;
    clamped.insert(clamped.end(), {3 * v, 3 * v + 1, 3 * v + 2});
  }
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    if (!isPinned[a] || !isPinned[b] || !isPinned[c]) continue;
    for (uint32_t corner = 0; corner < 3; ++corner)
      clamped.push_back(3 * mesh.vertexCount() + topology.edgeOpposite(Corner(t, corner)));
  }
  return clamped;
}

}  // namespace limber
