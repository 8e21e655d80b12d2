#include "fit/search/fit_solver.h"

#include "elastic/pins.h"
#include "linear/factorisation.h"

namespace limber {

FitSolver::FitSolver(const std::vector<uint8_t>& locked, Job& job) : job_(job) {
  for (uint32_t v = 0; v <= locked.size(); ++v) pencil_.firstUnknown.push_back(3 * v);
  for (uint32_t v = 0; v < locked.size(); ++v)
    if (locked[v]) lockedUnknowns_.insert(lockedUnknowns_.end(), {3 * v, 3 * v + 1, 3 * v + 2});
}

Eigen::MatrixXd FitSolver::solve(const DampedSystem& system, Eigen::MatrixXd columns) {
  system.hessian.writeTo(pencil_.k);
  pencil_.m = system.dampingDiagonal;
  if (!lockedUnknowns_.empty()) clampUnknowns(pencil_, lockedUnknowns_);
  if (!structure_) structure_ = std::make_shared<const FactorStructure>(factorStructure(pencil_, job_));
  for (const uint32_t row : lockedUnknowns_) columns.row(row).setZero();
  Factorisation factorisation(pencil_, structure_);
  factorisation.factorise(-system.damping, job_);
  factorisation.solve(columns, job_);
  return columns;
}

}  // namespace limber
