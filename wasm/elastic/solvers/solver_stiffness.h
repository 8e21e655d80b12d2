#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "elastic/solvers/solver_constraints.h"
#include "linear/element_assembly.h"
#include "linear/sparse_pencil.h"

namespace limber {

// The stiffness at rest of any solver model, as a sum over its constraints:
//   K = sum_c s_c B_c^T B_c   with a factor s_c >= 0 for each constraint.
// At the undeformed rest shape this is the exact second derivative of the energy, so that for a mode phi_i
// with phi_i^T M phi_i = 1 the derivative of its eigenvalue with respect to a factor is d lambda_i / d s_c =
// |B_c phi_i|^2.
//
// Constraints are those of SolverConstraints in their order. With Morley's bending element there is a stretch
// constraint for each triangle (or a spring for each edge), then a bending constraint of three vertices for
// each triangle.
//
// Unknowns: displacements u(3 v + c) in metres, then for Morley's element one massless rotation per edge,
// psi(3 vertexCount + e). Forces in N, masses in kg, eigenvalues in (rad/s)^2.
class SolverStiffness {
 public:
  // Copies what it needs. Throws std::invalid_argument as SolverConstraints.
  SolverStiffness(const TriangleMesh& rest, const Topology& topology, const SolverModel& model,
                  const SolverConstants& constants);

  uint32_t count() const { return static_cast<uint32_t>(constraints_.size()); }
  uint32_t stretchCount() const { return stretchCount_; }
  const SolverConstraint& operator[](uint32_t c) const { return constraints_[c]; }
  // Whether B_c is nonzero. It is 0 if its constant is 0 or a triangle has no area.
  bool resists(uint32_t c) const { return !matrixOf(c).isZero(0); }
  uint32_t vertexCount() const { return vertexCount_; }
  Eigen::Index unknownCount() const { return static_cast<Eigen::Index>(firstUnknown_.back()); }

  // A pencil of zeros with the pattern of `pencil`.
  SparsePencil pattern() const;
  // `factors`: one for each constraint. `masses`: kg per vertex, > 0. The pattern never changes.
  SparsePencil pencil(std::span<const double> factors, std::span<const double> masses) const;
  // |B_c phi_i|^2: constraints x modes. `phi`: unknowns x modes. O(constraints x modes).
  Eigen::MatrixXd energies(const Eigen::MatrixXd& phi) const;

  // The unknowns that pinned vertices fix, as in `clampedUnknowns` of elastic/shell.h.
  std::vector<uint32_t> clampedUnknowns(std::span<const uint32_t> pinned) const;

 private:
  static constexpr uint32_t kNodes = 6;

  // Appends a constraint whose matrix has the given columns of B.
  void add(const SolverConstraint& constraint, const std::array<uint32_t, kNodes>& nodes,
           const Eigen::Ref<const Eigen::MatrixXd>& matrix);
  void addAll(const SolverConstraints& constraints, ConstraintKind kind);
  void addShell(const TriangleMesh& rest, const Topology& topology, ConstraintKind kind,
                const SolverConstants& constants);
  uint32_t columnsOf(uint32_t c) const;
  Eigen::Map<const Eigen::MatrixXd> matrixOf(uint32_t c) const;

  std::vector<SolverConstraint> constraints_;
  std::vector<uint32_t> nodes_;     // nodes_[kNodes c + k], filled up with ElementAssembly::kNoNode
  std::vector<size_t> firstValue_;  // per constraint: where its B begins in values_
  std::vector<double> values_;      // B, rows x columns, column by column
  std::vector<uint32_t> firstUnknown_;
  std::vector<double> looseRotation_;  // per edge rotated only by ties: stiffness that keeps K regular, N m
  std::vector<std::array<uint32_t, 3>> edgesOfTriangle_;  // Morley: for pins
  std::vector<Triangle> triangles_;                       // Morley: for pins
  std::optional<ElementAssembly> pattern_;                // with values of 0
  uint32_t vertexCount_ = 0, stretchCount_ = 0;
};

}  // namespace limber
