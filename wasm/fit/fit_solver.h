#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/job.h"
#include "fit/surface_fit.h"
#include "linear/factor_structure.h"
#include "linear/sparse_pencil.h"

namespace limber {

// Solves for steps of a mesh whose triangles stay, so that the places of A's numbers do.
class FitSolver {
 public:
  // `locked`: per vertex of the mesh, not 0 where it stays in place. The job must outlive it.
  FitSolver(const std::vector<uint8_t>& locked, Job& job);

  // Of the surface fit: A, and what each unknown weighs that is held in place, times `hold`.
  struct System {
    const Eigen::SparseMatrix<double>& stiffness;
    const Eigen::VectorXd& inertia;
    double hold;
  };
  // (A + hold * inertia)^-1 of each column. Throws Cancelled.
  Eigen::MatrixXd solve(const System& system, Eigen::MatrixXd columns);

 private:
  Job& job_;
  SparsePencil model_;
  std::vector<uint32_t> held_;
  std::shared_ptr<const FactorStructure> structure_;
};

}  // namespace limber
