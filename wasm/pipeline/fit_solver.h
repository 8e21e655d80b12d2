#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/job.h"
#include "modes/factor_structure.h"
#include "modes/stiffness_model.h"
#include "pipeline/surface_fit.h"

namespace limber {

// Solves for steps of a mesh whose triangles stay, so that the places of A's numbers do.
class FitSolver {
 public:
  // `locked`: per vertex of the mesh, not 0 where it stays in place. The job must outlive it.
  FitSolver(const std::vector<uint8_t>& locked, Job& job);

  // (A + hold * inertia)^-1 of each column, A and inertia those of the fit. Throws Cancelled.
  Eigen::MatrixXd solve(const SurfaceFit& fit, double hold, Eigen::MatrixXd columns);

 private:
  Job& job_;
  StiffnessModel model_;
  std::vector<uint32_t> held_;
  std::shared_ptr<const FactorStructure> structure_;
};

}  // namespace limber
