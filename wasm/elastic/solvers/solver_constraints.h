#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "elastic/solvers/constraint_strain.h"
#include "elastic/solvers/hinge_element.h"
#include "elastic/solvers/membrane_element.h"
#include "elastic/solvers/solver_model.h"
#include "elastic/solvers/spring_element.h"
#include "mesh/topology.h"

namespace limber {

enum class ConstraintKind : uint8_t { Stretch = 0, Bend = 1 };

// One constraint of a solver: the vertices that it couples.
struct SolverConstraint {
  ConstraintKind kind = ConstraintKind::Stretch;
  uint8_t rows = 1;         // components of its strain: 3 for a CST, else 1
  uint8_t vertexCount = 2;  // 2: a spring; 3: a CST; 4: a hinge, the ends of its edge first
  std::array<uint32_t, 4> vertices{};
};

// All constraints of a solver on one mesh, for all models without Morley's element. At rest every strain is
// 0, and K = sum_c J_c^T J_c is the exact stiffness.
//
// Order: stretch constraints first (triangles by index, or edges in the order of Topology::edges), then
// bending constraints by the order of their edges. An edge has a bending constraint if it has exactly two
// triangles with different opposite corners. Triangles without area, or next to none, have the bounded
// stiffness that MembraneElement and HingeElement describe.
class SolverConstraints {
 public:
  // Copies what it needs. Throws std::invalid_argument for Morley's element and for a constant out of range.
  SolverConstraints(const TriangleMesh& rest, const Topology& topology, const SolverModel& model,
                    const SolverConstants& constants);

  uint32_t count() const { return static_cast<uint32_t>(constraints_.size()); }
  uint32_t stretchCount() const { return stretchCount_; }
  const SolverConstraint& operator[](uint32_t c) const { return constraints_[c]; }

  // `positions`: of all vertices, in metres.
  ConstraintStrain strainAt(uint32_t c, std::span<const Vec3> positions) const;
  // The contribution of stress to the second derivative of the energy, in addition to the Gauss-Newton matrix
  // J^T J: block (k, l), for the k-th and the l-th vertex, is entry (k, l) times the identity. With all
  // stress it is exact for a membrane, and for a spring exact across its direction; for a hinge it is
  // omitted. With tension only it is positive semidefinite. N/m.
  Eigen::Matrix4d stressStiffnessAt(uint32_t c, std::span<const Vec3> positions, StressKind kind) const;
  // 1/2 |strain|^2 in joules.
  double energyAt(uint32_t c, std::span<const Vec3> positions) const;
  // Rest positions in metres.
  std::span<const Vec3> rest() const { return rest_; }

 private:
  void addStretch(const TriangleMesh& mesh, const Topology& topology, StretchElement element,
                  const SolverConstants& constants);
  void addBends(const TriangleMesh& mesh, const Topology& topology, BendElement element, double bend);
  template <size_t N>
  std::array<Vec3, N> at(const SolverConstraint& constraint, std::span<const Vec3> positions) const;

  std::vector<SolverConstraint> constraints_;
  std::vector<uint32_t> elementOf_;  // per constraint: its index among the elements of its type
  std::vector<SpringElement> springs_;
  std::vector<HingeElement> hinges_;
  std::vector<MembraneElement> membranes_;
  std::vector<Vec3> rest_;
  uint32_t stretchCount_ = 0;
};

// Masses of all vertices in kg, all above 0; their sum is surfaceDensity times the area. With MassRule::Area,
// a vertex whose triangles have almost no area gets the minimum mass of `lumpedAreas`.
std::vector<double> solverMasses(const TriangleMesh& mesh, MassRule rule, const SolverConstants& constants);

}  // namespace limber
