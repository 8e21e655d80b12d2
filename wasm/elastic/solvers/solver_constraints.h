#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "elastic/solvers/solver_model.h"
#include "mesh/topology.h"

namespace limber {

enum class ConstraintKind : uint8_t { Stretch = 0, Bend = 1 };

// One constraint of a solver: which vertices it couples.
struct SolverConstraint {
  ConstraintKind kind = ConstraintKind::Stretch;
  uint8_t rows = 1;         // components of its strain: 3 for a CST, else 1
  uint8_t vertexCount = 2;  // 2: a spring; 3: a CST; 4: a hinge, the ends of its edge first
  std::array<uint32_t, 4> vertices{};
};

// The generalised strain of a constraint, scaled so that its energy is 1/2 |strain|^2 in joules, and its
// derivatives by the positions of its vertices in metres (column 3 k + axis for its k-th vertex). Rows and
// columns beyond those of the constraint are 0.
struct ConstraintStrain {
  Eigen::Vector3d strain = Eigen::Vector3d::Zero();
  Eigen::Matrix<double, 3, 12> jacobian = Eigen::Matrix<double, 3, 12>::Zero();
};

// All constraints of a solver on one mesh, for every model without Morley's element. At rest every strain is
// 0, and K = sum_c J_c^T J_c is the exact stiffness.
//
// Order: stretch constraints first (triangles by index, or edges in the order of Topology::edges), then
// bending constraints by the order of their edges. An edge bends if it has exactly two triangles.
class SolverConstraints {
 public:
  // Copies what it needs. Throws std::invalid_argument for Morley's element.
  SolverConstraints(const TriangleMesh& rest, const Topology& topology, const SolverModel& model,
                    const SolverConstants& constants);

  uint32_t count() const { return static_cast<uint32_t>(constraints_.size()); }
  uint32_t stretchCount() const { return stretchCount_; }
  const SolverConstraint& operator[](uint32_t c) const { return constraints_[c]; }

  // `positions`: of all vertices, in metres.
  ConstraintStrain strainAt(uint32_t c, std::span<const Vec3> positions) const;
  // Rest positions in metres.
  std::span<const Vec3> rest() const { return rest_; }

 private:
  std::vector<SolverConstraint> constraints_;
  std::vector<Vec3> rest_;
  uint32_t stretchCount_ = 0;
};

// Masses of all vertices in kg; their sum is surfaceDensity times the area.
std::vector<double> solverMasses(const TriangleMesh& mesh, MassRule rule, const SolverConstants& constants);

}  // namespace limber
