#include "fit/fit_solver.h"

#include "elastic/pins.h"
#include "linear/factorisation.h"

namespace limber {

FitSolver::FitSolver(const std::vector<uint8_t>& locked, Job& job) : job_(job) {
  for (uint32_t v = 0; v <= locked.size(); ++v) model_.firstUnknown.push_back(3 * v);
  for (uint32_t v = 0; v < locked.size(); ++v)
    if (locked[v]) held_.insert(held_.end(), {3 * v, 3 * v + 1, 3 * v + 2});
}

Eigen::MatrixXd FitSolver::solve(const System& system, Eigen::MatrixXd columns) {
  model_.k = system.stiffness;
  model_.m = system.inertia;
  if (!held_.empty()) clampUnknowns(model_, held_);
  if (!structure_) structure_ = std::make_shared<const FactorStructure>(factorStructure(model_, job_));
  for (uint32_t row : held_) columns.row(row).setZero();
  Factorisation factorisation(model_, structure_);
  factorisation.factorise(-system.hold, job_);
  factorisation.solve(columns, job_);
  return columns;
}

}  // namespace limber
