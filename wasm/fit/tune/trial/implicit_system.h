#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "base/job.h"
#include "elastic/solvers/solver_constraints.h"
#include "fit/tune/trial/area_barrier.h"
#include "linear/factor_structure.h"
#include "linear/sparse_pencil.h"
#include "simulate/simulation_options.h"

namespace limber {

// A body that moves under the constraints of a solver.
struct ConstrainedBody {
  const SolverConstraints& constraints;
  const TriangleMesh& mesh;         // pinned points refer to its triangles
  std::span<const double> masses;   // kg per vertex, each > 0
  std::span<const double> factors;  // on the stiffness of each constraint, >= 0; empty: 1
  Pins pins = {};
  double barrierStiffness = 0;  // of the AreaBarrier, N/m, >= 0
};

// The elastic energy of a body with its derivatives, as a sparse pencil over the unknowns of its free
// vertices: those that are not pinned, three unknowns each, in vertex order. Pinned points are tied to their
// targets by springs that are `kPointStiffness` times as stiff as the body and its inertia at their triangle,
// and yield by that much less than the body. Positions are in metres.
class ImplicitSystem {
 public:
  static constexpr double kPointStiffness = 1e4;

  // Finds the pattern and the elimination order. `inertia`: 1/s2, the factor of the masses in the matrices to
  // be solved; it only determines the stiffness of pinned points. Keeps a reference to the constraints and
  // copies the rest. Throws Cancelled.
  ImplicitSystem(const ConstrainedBody& body, double inertia, const Job& job);

  uint32_t unknownCount() const { return 3 * static_cast<uint32_t>(free_.size()); }
  // Ids of the free vertices, ascending: unknown 3 i + axis is a coordinate of vertex free()[i].
  const std::vector<uint32_t>& free() const { return free_; }
  const SolverConstraints& constraints() const { return constraints_; }
  std::span<const double> masses() const { return masses_; }

  // Sets the targets of pinned points, in metres.
  void setPointTargets(std::span<const Vec3> targets);

  // The energy in joules, including the springs of pinned points and the area barrier. The same to the last
  // bit for any number of threads.
  double energyAt(std::span<const Vec3> positions) const;
  // The derivative of the energy with respect to the unknowns, N. Also sets K of the pencil to an
  // approximation of the second derivative: J^T J plus the contribution of stress, which is positive
  // semidefinite for tension only.
  Eigen::VectorXd linearise(std::span<const Vec3> positions, StressKind kind);

  // K of the last linearisation, and M: the masses of the free vertices.
  const SparsePencil& pencil() const { return pencil_; }
  std::shared_ptr<const FactorStructure> structure() const { return structure_; }

 private:
  struct PointSpring {
    std::array<uint32_t, 3> vertices;
    std::array<double, 3> weights;
    double stiffness;
    Vec3 target;
  };
  // A constraint at the current positions.
  struct Linearisation {
    ConstraintStrain strain;
    Eigen::Matrix4d stress = Eigen::Matrix4d::Zero();
  };
  // The index of the first value of block (k-th, l-th vertex) of a constraint in K: entry 4 k + l; kNone if a
  // vertex is pinned.
  using BlockStarts = std::array<uint32_t, 16>;

  void numberVertices(const Pins& pins);
  void addPointSprings(const ConstrainedBody& body, double inertia);
  void buildPattern();
  void reserveEntries(const std::vector<std::vector<uint32_t>>& neighbours);
  std::vector<double> restStiffness() const;
  double factorOf(uint32_t c) const { return factors_.empty() ? 1 : factors_[c]; }
  uint32_t blockStart(uint32_t i, uint32_t j) const;
  BlockStarts blockStarts(std::span<const uint32_t> vertices) const;
  void addTo(uint32_t start, uint32_t column, const Eigen::Matrix3d& block);
  void addForces(std::span<const uint32_t> vertices, const ConstraintStrain& at, double factor,
                 Eigen::VectorXd& gradient) const;
  void addBlocks(std::span<const uint32_t> vertices, const BlockStarts& starts, const Linearisation& at,
                 double factor);
  void addBarrier(std::span<const Vec3> positions, Eigen::VectorXd& gradient);
  void addPointSpringsTo(std::span<const Vec3> positions, Eigen::VectorXd& gradient) const;
  void addPointBlocks();
  Vec3 gapOf(const PointSpring& spring, std::span<const Vec3> positions) const;

  const SolverConstraints& constraints_;
  std::vector<double> masses_, factors_;
  std::vector<uint32_t> free_, indexOf_;  // free vertices, and per vertex its index among them or kNone
  AreaBarrier barrier_;
  std::vector<PointSpring> points_;
  // The free vertex of index i has the couplings neighbours_[neighbourStart_[i] .. neighbourStart_[i + 1]),
  // ascending.
  std::vector<uint32_t> neighbourStart_, neighbours_;
  std::vector<BlockStarts> starts_;   // per constraint
  std::vector<Linearisation> parts_;  // per constraint, of the last linearisation
  SparsePencil pencil_;
  std::shared_ptr<const FactorStructure> structure_;
};

}  // namespace limber
