#include "elastic/shell.h"

#include <algorithm>

#include "elastic/shell_element.h"
#include "linear/element_assembly.h"
#include "mesh/vertex_areas.h"

namespace limber {

namespace {

using ElementMatrix = Eigen::Matrix<double, 12, 12>;
using StrainMatrix = ShellElement::Strain;

// The plane-stress matrix of E = 1, times `factor`.
Eigen::Matrix3d planeStress(double factor, double poisson) {
  Eigen::Matrix3d c;
  c << 1, poisson, 0, poisson, 1, 0, 0, 0, (1 - poisson) / 2;
  return c * (factor / (1 - poisson * poisson));
}

ElementMatrix tieStiffness(const ShellElement& tie, double thickness) {
  const double bending = thickness * thickness * thickness / 12;
  const StrainMatrix force = tie.strain * (thickness / kFlattestTriangle),
                     moment = tie.curvature * (bending / kFlattestTriangle);
  ElementMatrix k = force.transpose().lazyProduct(tie.strain) + moment.transpose().lazyProduct(tie.curvature);
  // Edge rotations without any other stiffness would make K singular.
  k.diagonal().tail<3>().array() += kLooseRotation * bending / kFlattestTriangle;
  return k;
}

ElementMatrix elementStiffness(const ShellElement& element, double thickness, double poisson) {
  if (element.isTie) return tieStiffness(element, thickness);
  const StrainMatrix stress = planeStress(element.weight * thickness, poisson) * element.strain;
  const StrainMatrix moment =
      planeStress(element.weight * thickness * thickness * thickness / 12, poisson) * element.curvature;
  // lazyProduct, because Eigen considers these sizes large and would allocate packing buffers.
  return element.strain.transpose().lazyProduct(stress) + element.curvature.transpose().lazyProduct(moment);
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
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    assembly.add(t, elementStiffness(shellElement(mesh, t), thickness, poisson));
  Eigen::SparseMatrix<double> sum;
  assembly.take(sum);
  return sum;
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
  ElementAssembly(pencil.firstUnknown, elementNodes(mesh, topology), 6).take(pencil.k);
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
