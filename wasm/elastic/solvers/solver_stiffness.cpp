#include "elastic/solvers/solver_stiffness.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "elastic/shell_element.h"

namespace limber {
namespace {

constexpr size_t kConstraintsPerRange = 512;
constexpr uint32_t kNoNode = ElementAssembly::kNoNode;

// U with U^T U = C, so that a plane strain e = (xx, yy, 2 xy) has the energy density 1/2 |U e|^2.
Eigen::Matrix3d rootOfPlaneStress(double shear, double lambda) {
  Eigen::Matrix3d c;
  c << lambda + 2 * shear, lambda, 0, lambda, lambda + 2 * shear, 0, 0, 0, shear;
  return c.llt().matrixU();
}

// The constants of one kind of strain of a shell.
struct ShellConstants {
  Eigen::Matrix3d root;  // U^T U = stress over strain, or moment over curvature
  double tie;            // stiffness of the gaps of a tie
};

ShellConstants shellConstants(ConstraintKind kind, const SolverConstants& constants) {
  if (kind == ConstraintKind::Stretch) {
    const double shear = constants.stretch, lambda = constants.secondStretch;
    const double young = 4 * shear * (lambda + shear) / (lambda + 2 * shear);  // times the thickness
    return {rootOfPlaneStress(shear, lambda), young / kFlattestTriangle};
  }
  const double d = constants.bend, poisson = constants.poisson;
  return {rootOfPlaneStress(d * (1 - poisson) / 2, d * poisson),
          d * (1 - poisson * poisson) / kFlattestTriangle};
}

TriangleMesh inMetres(const TriangleMesh& mesh, double unit) {
  TriangleMesh scaled = mesh;
  for (Vec3& p : scaled.positions) p *= unit;
  return scaled;
}

// The model with its bending element replaced if it is Morley's, to get the stretch constraints.
SolverModel withoutMorley(SolverModel model) {
  if (model.bend == BendElement::Morley) model.bend = BendElement::Hinge;
  return model;
}

}  // namespace

SolverStiffness::SolverStiffness(const TriangleMesh& rest, const Topology& topology, const SolverModel& model,
                                 const SolverConstants& constants)
    : vertexCount_(rest.vertexCount()) {
  const bool isMorley = model.bend == BendElement::Morley;
  const SolverConstraints constraints(rest, topology, withoutMorley(model), constants);
  for (uint32_t v = 0; v <= vertexCount_; ++v) firstUnknown_.push_back(3 * v);
  if (isMorley)
    for (uint32_t e = 1; e <= topology.edges.size(); ++e) firstUnknown_.push_back(3 * vertexCount_ + e);
  if (isMorley && model.stretch == StretchElement::Membrane)
    addShell(rest, topology, ConstraintKind::Stretch, constants);
  else
    addAll(constraints, ConstraintKind::Stretch);
  stretchCount_ = count();
  if (isMorley)
    addShell(rest, topology, ConstraintKind::Bend, constants);
  else
    addAll(constraints, ConstraintKind::Bend);
  pattern_.emplace(firstUnknown_, nodes_, kNodes);
}

void SolverStiffness::add(const SolverConstraint& constraint, const std::array<uint32_t, kNodes>& nodes,
                          const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  constraints_.push_back(constraint);
  nodes_.insert(nodes_.end(), nodes.begin(), nodes.end());
  firstValue_.push_back(values_.size());
  for (Eigen::Index column = 0; column < matrix.cols(); ++column)
    for (Eigen::Index row = 0; row < matrix.rows(); ++row) values_.push_back(matrix(row, column));
}

void SolverStiffness::addAll(const SolverConstraints& constraints, ConstraintKind kind) {
  for (uint32_t c = 0; c < constraints.count(); ++c) {
    const SolverConstraint& constraint = constraints[c];
    if (constraint.kind != kind) continue;
    std::array<uint32_t, kNodes> nodes;
    nodes.fill(kNoNode);
    std::copy_n(constraint.vertices.begin(), constraint.vertexCount, nodes.begin());
    const ConstraintStrain strain = constraints.strainAt(c, constraints.rest());
    add(constraint, nodes, strain.jacobian.topLeftCorner(constraint.rows, 3 * constraint.vertexCount));
  }
}

void SolverStiffness::addShell(const TriangleMesh& rest, const Topology& topology, ConstraintKind kind,
                               const SolverConstants& constants) {
  const TriangleMesh mesh = inMetres(rest, constants.unit);
  const ShellConstants shell = shellConstants(kind, constants);
  const bool isBend = kind == ConstraintKind::Bend;
  if (isBend) looseRotation_.assign(topology.edges.size(), 0);
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    std::array<uint32_t, kNodes> nodes = {a, b, c, kNoNode, kNoNode, kNoNode};
    const ShellElement element = shellElement(mesh, t);
    for (uint32_t corner = 0; isBend && corner < 3; ++corner) {
      const uint32_t edge = topology.edgeOpposite(Corner(t, corner));
      nodes[3 + corner] = vertexCount_ + edge;
      if (element.isTie) looseRotation_[edge] += kLooseRotation * shell.tie;
    }
    const ShellElement::Strain& strain = isBend ? element.curvature : element.strain;
    const ShellElement::Strain scaled =
        element.isTie ? ShellElement::Strain(std::sqrt(shell.tie) * strain)
                      : ShellElement::Strain(std::sqrt(element.weight) * shell.root * strain);
    add({kind, 3, 3, {a, b, c}}, nodes, scaled.leftCols(isBend ? 12 : 9));
    if (!isBend) continue;
    triangles_.push_back({a, b, c});
    edgesOfTriangle_.push_back({nodes[3], nodes[4], nodes[5]});
  }
}

uint32_t SolverStiffness::columnsOf(uint32_t c) const {
  const size_t end = c + 1 < firstValue_.size() ? firstValue_[c + 1] : values_.size();
  return static_cast<uint32_t>((end - firstValue_[c]) / constraints_[c].rows);
}

Eigen::Map<const Eigen::MatrixXd> SolverStiffness::matrixOf(uint32_t c) const {
  return {values_.data() + firstValue_[c], constraints_[c].rows, static_cast<Eigen::Index>(columnsOf(c))};
}

SparsePencil SolverStiffness::pattern() const {
  SparsePencil pencil;
  pencil.firstUnknown = firstUnknown_;
  pencil.k = pattern_->sum();
  pencil.m = Eigen::VectorXd::Zero(unknownCount());
  return pencil;
}

SparsePencil SolverStiffness::pencil(std::span<const double> factors, std::span<const double> masses) const {
  SparsePencil pencil;
  pencil.firstUnknown = firstUnknown_;
  pencil.k = pattern_->sum([&](const ElementAssembly::Columns& columns, double* values) {
    const auto matrix = matrixOf(columns.element);
    for (uint32_t c = 0; c < columns.count; ++c) {
      const auto column = matrix.col(columns.first + c);
      for (Eigen::Index row = 0; row < matrix.cols(); ++row)
        *values++ = factors[columns.element] * matrix.col(row).dot(column);
    }
  });
  for (uint32_t e = 0; e < looseRotation_.size(); ++e)
    if (looseRotation_[e] > 0)
      pencil.k.coeffRef(3 * vertexCount_ + e, 3 * vertexCount_ + e) += looseRotation_[e];
  pencil.m = Eigen::VectorXd::Zero(unknownCount());
  for (uint32_t v = 0; v < vertexCount_; ++v)
    pencil.m.segment<3>(3 * static_cast<Eigen::Index>(v)).setConstant(masses[v]);
  return pencil;
}

Eigen::MatrixXd SolverStiffness::energies(const Eigen::MatrixXd& phi) const {
  Eigen::MatrixXd energies(count(), phi.cols());
  parallelFor(count(), kConstraintsPerRange, [&](size_t begin, size_t end) {
    Eigen::MatrixXd local(12, phi.cols());
    for (size_t at = begin; at < end; ++at) {
      const auto c = static_cast<uint32_t>(at);
      const auto matrix = matrixOf(c);
      Eigen::Index row = 0;
      for (uint32_t k = 0; k < kNodes && nodes_[kNodes * at + k] != kNoNode; ++k) {
        const uint32_t node = nodes_[kNodes * at + k];
        const uint32_t first = firstUnknown_[node], size = firstUnknown_[node + 1] - first;
        local.middleRows(row, size) = phi.middleRows(first, size);
        row += size;
      }
      energies.row(static_cast<Eigen::Index>(at)) =
          matrix.lazyProduct(local.topRows(row)).colwise().squaredNorm();
    }
  });
  return energies;
}

std::vector<uint32_t> SolverStiffness::clampedUnknowns(std::span<const uint32_t> pinned) const {
  std::vector<uint8_t> isPinned(vertexCount_, 0);
  std::vector<uint32_t> clamped;
  for (const uint32_t v : pinned) {
    isPinned[v] = 1;
    clamped.insert(clamped.end(), {3 * v, 3 * v + 1, 3 * v + 2});
  }
  for (size_t t = 0; t < triangles_.size(); ++t)
    if (std::ranges::all_of(triangles_[t], [&](uint32_t v) { return isPinned[v] != 0; }))
      for (const uint32_t edge : edgesOfTriangle_[t]) clamped.push_back(firstUnknown_[edge]);
  return clamped;
}

}  // namespace limber
