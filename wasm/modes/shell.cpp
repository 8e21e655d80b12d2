#include "modes/shell.h"

#include <algorithm>
#include <array>

#include "modes/mass.h"

namespace limber {

namespace {

using ElementMatrix =
    Eigen::Matrix<double, 12, 12>;  // nine displacements (3 * corner + axis), three edge rotations

// A triangle in its own plane. Edge c is opposite to corner c.
struct Frame {
  Vec3 normal;
  std::array<Vec3, 3> edge;     // from corner c + 1 to corner c + 2
  std::array<Vec3, 3> outward;  // unit, in the plane
  std::array<double, 3> length;
  std::array<Vec3, 3> gradient;  // of the barycentric coordinate c
  double area;
};

Frame frameOf(const TriangleMesh& mesh, uint32_t t) {
  Frame frame;
  const Vec3 twice = areaNormal(mesh, t);
  frame.normal = normalized(twice);
  frame.area = 0.5 * length(twice);
  for (int c = 0; c < 3; ++c) {
    frame.edge[c] = mesh.corner(t, (c + 2) % 3) - mesh.corner(t, (c + 1) % 3);
    frame.length[c] = length(frame.edge[c]);
    frame.outward[c] = normalized(cross(frame.edge[c], frame.normal));
    frame.gradient[c] = frame.outward[c] * (-frame.length[c] / (2 * frame.area));
  }
  return frame;
}

// Plane stress for the in-plane strains (xx, yy, 2 xy), times thickness, E = 1.
Eigen::Matrix3d membraneElasticity(double thickness, double poisson) {
  Eigen::Matrix3d c;
  c << 1, poisson, 0, poisson, 1, 0, 0, 0, (1 - poisson) / 2;
  return c * (thickness / (1 - poisson * poisson));
}

// Constant-strain triangle: B maps nine displacements to (xx, yy, 2 xy) along `x` and `y`.
void addMembrane(const Frame& frame, const Eigen::Matrix3d& elasticity, ElementMatrix& k) {
  const Vec3 x = normalized(frame.edge[2]), y = cross(frame.normal, x);
  Eigen::Matrix<double, 3, 9> b;
  for (int c = 0; c < 3; ++c) {
    const double gx = dot(frame.gradient[c], x), gy = dot(frame.gradient[c], y);
    for (int axis = 0; axis < 3; ++axis) {
      b(0, 3 * c + axis) = gx * x[axis];
      b(1, 3 * c + axis) = gy * y[axis];
      b(2, 3 * c + axis) = gx * y[axis] + gy * x[axis];
    }
  }
  k.topLeftCorner<9, 9>() += frame.area * b.transpose() * elasticity * b;
}

// Morley: row e of `slope` gives s_e phi_e - theta_e(u), the turn that edge e leaves to bending.
void addBending(const Frame& frame, const std::array<double, 3>& sign, double rigidity, double poisson,
                ElementMatrix& k) {
  Eigen::Matrix<double, 3, 12> slope = Eigen::Matrix<double, 3, 12>::Zero();
  Eigen::Matrix3d energy;
  for (int e = 0; e < 3; ++e) {
    for (int c = 0; c < 3; ++c)
      for (int axis = 0; axis < 3; ++axis)
        slope(e, 3 * c + axis) = dot(frame.gradient[c], frame.outward[e]) * frame.normal[axis];
    slope(e, 9 + e) = sign[e];
    for (int f = 0; f < 3; ++f) {
      const double cosine = dot(frame.outward[e], frame.outward[f]);
      energy(e, f) = rigidity * frame.length[e] * frame.length[f] / frame.area *
                     ((1 - poisson) * cosine * cosine + poisson);
    }
  }
  k += slope.transpose() * energy * slope;
}

// The unknowns of a triangle in the order of ElementMatrix.
std::array<uint32_t, 12> unknownsOf(const TriangleMesh& mesh, const Topology& topology, uint32_t t) {
  std::array<uint32_t, 12> unknowns;
  for (uint32_t c = 0; c < 3; ++c) {
    for (uint32_t axis = 0; axis < 3; ++axis) unknowns[3 * c + axis] = 3 * mesh.triangles[t][c] + axis;
    unknowns[9 + c] = 3 * mesh.vertexCount() + topology.edgeOfCorner[3 * t + c];
  }
  return unknowns;
}

// Triangles so thin that their stiffness would drown all others in rounding (height below 1e-7 of the longest
// edge) carry no stiffness of their own; their neighbours hold their vertices.
bool isUsable(const Frame& frame) {
  const double longest = *std::max_element(frame.length.begin(), frame.length.end());
  return frame.area > 0.5e-7 * longest * longest;
}

Eigen::SparseMatrix<double> assemble(const TriangleMesh& mesh, const Topology& topology, double thickness,
                                     double poisson) {
  const double rigidity = thickness * thickness * thickness / (12 * (1 - poisson * poisson));
  const Eigen::Matrix3d elasticity = membraneElasticity(thickness, poisson);
  const auto unknownCount = static_cast<Eigen::Index>(3 * size_t{mesh.vertexCount()} + topology.edges.size());
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(144 * size_t{mesh.triangleCount()});
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const Frame frame = frameOf(mesh, t);
    ElementMatrix k = ElementMatrix::Zero();
    if (isUsable(frame)) {
      const Triangle& triangle = mesh.triangles[t];
      std::array<double, 3> sign;
      for (int e = 0; e < 3; ++e) sign[e] = triangle[(e + 1) % 3] < triangle[(e + 2) % 3] ? 1 : -1;
      addMembrane(frame, elasticity, k);
      addBending(frame, sign, rigidity, poisson, k);
    }
    const auto unknowns = unknownsOf(mesh, topology, t);
    for (int i = 0; i < 12; ++i)
      for (int j = 0; j < 12; ++j) entries.emplace_back(unknowns[i], unknowns[j], k(i, j));
  }
  Eigen::SparseMatrix<double> stiffness(unknownCount, unknownCount);
  stiffness.setFromTriplets(entries.begin(), entries.end());
  return stiffness;
}

// A rotation whose triangles all carry no stiffness would leave an empty row: it is held at 0 instead.
void holdLooseRotations(Eigen::SparseMatrix<double>& stiffness, Eigen::Index firstRotation) {
  for (Eigen::Index i = firstRotation; i < stiffness.rows(); ++i)
    if (stiffness.coeff(i, i) == 0) stiffness.coeffRef(i, i) = 1;
}

}  // namespace

StiffnessModel shellModel(const TriangleMesh& mesh, const Topology& topology, double thickness,
                          double poisson) {
  StiffnessModel model;
  model.stiffness = assemble(mesh, topology, thickness, poisson);
  holdLooseRotations(model.stiffness, 3 * static_cast<Eigen::Index>(mesh.vertexCount()));
  model.mass = Eigen::VectorXd::Zero(model.stiffness.rows());
  const auto areas = lumpedAreas(mesh);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    for (int axis = 0; axis < 3; ++axis)
      model.mass[static_cast<Eigen::Index>(3 * v) + axis] = thickness * areas[v];
  model.nodes = mesh.positions;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) model.firstUnknown.push_back(3 * v);
  for (uint32_t e = 0; e <= topology.edges.size(); ++e)
    model.firstUnknown.push_back(3 * mesh.vertexCount() + e);
  for (const Topology::Edge& edge : topology.edges)
    model.nodes.push_back((mesh.positions[edge.a] + mesh.positions[edge.b]) * 0.5);
  return model;
}

}  // namespace limber
