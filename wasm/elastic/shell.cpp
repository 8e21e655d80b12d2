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

// A triangle flatter than this (height over its longest edge) is given the stiffness of one that is just as
// flat: real stiffness grows with 1 / flatness and would drown the rest of the body in rounding. It still
// holds its vertices together.
constexpr double kFlattest = 1e-4;
// Below it a triangle has no plane: it is a tie between its vertices.
constexpr double kDegenerate = 1e-12;

// A triangle in its own plane: x along its longest edge, the y axis at a right angle. Edge c runs from corner
// c + 1 to corner c + 2.
struct Frame {
  int longest;  // edge
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

// Plane stress for tensors as above, times `factor`.
Eigen::Matrix3d planeStress(double factor, double poisson) {
  Eigen::Matrix3d c;
  c << 1, poisson, 0, poisson, 1, 0, 0, 0, (1 - poisson) / 2;
  return c * (factor / (1 - poisson * poisson));
}

// Constant-strain triangle: in-plane strain from the displacements. The gradient of corner c's barycentric
// coordinate is its edge turned by 90 degrees over twice the area.
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

// Morley: constant curvature from displacements across the plane and rotations of the edges. As
// sum_e l_e (g . m_e) m_e m_e^T = -sum_e (w_end - w_start) t_e m_e^T for a linear w with gradient g (t_e
// along the edge, m_e outwards; the edges' l_e m_e sum to 0), the displacements enter with 1 / area alone;
// the gradient itself, which would cancel to rounding in a thin triangle, never appears.
StrainMatrix bendingCurvature(const Frame& frame, const std::array<double, 3>& sign) {
  std::array<Tensor, 3> slopeOf;  // t_e m_e^T, with t_e = (cosine, sine) and m_e = (sine, -cosine)
  StrainMatrix b;
  for (int e = 0; e < 3; ++e) {
    const double cosine = frame.edgeX[e] / frame.length[e], sine = frame.edgeY[e] / frame.length[e];
    slopeOf[e] = Tensor(cosine * sine, -cosine * sine, sine * sine - cosine * cosine);
    b.col(9 + e) =
        Tensor(sine * sine, cosine * cosine, -2 * sine * cosine) * (sign[e] * frame.length[e] / frame.area);
  }
  for (int c = 0; c < 3; ++c) {  // corner c ends edge c + 1 and starts edge c + 2
    const Tensor bend = (slopeOf[(c + 2) % 3] - slopeOf[(c + 1) % 3]) / frame.area;
    for (int axis = 0; axis < 3; ++axis) b.col(3 * c + axis) = bend * frame.normal[axis];
  }
  return b;
}

// A triangle whose corners lie on a line: what the stiffness above tends to as the triangle flattens. It
// keeps the middle corner on the longest edge, and the slopes on both sides equal. Without it a crack would
// open where such a triangle closes a surface.
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
    const int other = (e + 1 + k) % 3;  // run against the longest edge
    gap(3 + k, 9 + e) = sign[e];
    gap(3 + k, 9 + other) = sign[other];
  }
  const double bending = thickness * thickness * thickness / 12;
  Eigen::Matrix<double, 5, 1> stiffness;
  stiffness << thickness, thickness, thickness, bending, bending;
  ElementMatrix k = gap.transpose() * (stiffness / kFlattest).asDiagonal() * gap;
  // Rotations that nothing else holds must not leave K singular; against the tie this is nothing.
  k.diagonal().tail<3>().array() += 1e-10 * bending / kFlattest;
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
  // Plain products: Eigen takes these for large and would allocate what it packs them into.
  return strain.transpose().lazyProduct(stress) + curvature.transpose().lazyProduct(moment);
}

// Corners and edges of each triangle as nodes.
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

Eigen::SparseMatrix<double> assemble(const TriangleMesh& mesh, const Topology& topology,
                                     const std::vector<uint32_t>& firstUnknown, double thickness,
                                     double poisson) {
  ElementAssembly assembly(firstUnknown, elementNodes(mesh, topology), 6);
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const Triangle& triangle = mesh.triangles[t];
    std::array<double, 3> sign;
    for (int e = 0; e < 3; ++e) sign[e] = triangle[(e + 1) % 3] < triangle[(e + 2) % 3] ? 1 : -1;
    assembly.add(t, elementStiffness(frameOf(mesh, t), sign, thickness, poisson));
  }
  return assembly.take();
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

StiffnessModel shellModel(const TriangleMesh& mesh, const Topology& topology, double thickness,
                          double poisson) {
  StiffnessModel model;
  const uint32_t vertexCount = mesh.vertexCount();
  for (uint32_t v = 0; v < vertexCount; ++v) model.firstUnknown.push_back(3 * v);
  for (uint32_t e = 0; e <= topology.edges.size(); ++e) model.firstUnknown.push_back(3 * vertexCount + e);
  model.stiffness = assemble(mesh, topology, model.firstUnknown, thickness, poisson);
  model.mass = Eigen::VectorXd::Zero(model.stiffness.rows());
  const auto areas = lumpedAreas(mesh);
  for (uint32_t v = 0; v < vertexCount; ++v)
    model.mass.segment<3>(static_cast<Eigen::Index>(3 * v)).setConstant(thickness * areas[v]);
  return model;
}

std::vector<uint32_t> heldUnknowns(const TriangleMesh& mesh, const Topology& topology,
                                   std::span<const uint32_t> pinned) {
  std::vector<uint8_t> isPinned(mesh.vertexCount(), 0);
  std::vector<uint32_t> held;
  for (uint32_t v : pinned) {
    isPinned[v] = 1;
    held.insert(held.end(), {3 * v, 3 * v + 1, 3 * v + 2});
  }
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    if (!isPinned[a] || !isPinned[b] || !isPinned[c]) continue;
    for (uint32_t corner = 0; corner < 3; ++corner)
      held.push_back(3 * mesh.vertexCount() + topology.edgeOpposite(Corner(t, corner)));
  }
  return held;
}

}  // namespace limber
