#pragma once

#include <Eigen/Dense>

#include "fit/target/mismatch.h"

namespace limber {

// The steps dx of the coordinates of a mesh that minimise
//   dx^T A dx - 2 g^T dx + w |r + J dx|^2
// for any residual weight w > 0: the first two terms are the damped model of the surface distance
// (SurfaceFit, DampedSystem), the last one is the linearised mismatch of modes (Mismatch, with residuals
// clipped to tuning::search::kMaxResidual). J has few rows, so the Woodbury formula gives the minimum for
// all w from one factorisation of A: with s = A^-1 g, X = A^-1 J^T and G = J X,
//   dx = s - X y,  (1 / w + G) y = r + J s.
// At this dx the surface terms are y^T G y - g^T s. G is made tridiagonal once, after which each w costs
// O(residuals).
class BudgetedStep {
 public:
  // `solved`: A^-1 times the columns g and J^T.
  BudgetedStep(const Eigen::VectorXd& gradient, const Mismatch& mismatch, Eigen::MatrixXd solved);

  // The minimising dx.
  Eigen::VectorXd step(double residualWeight) const;

  // The surface terms at the minimising dx: the growth of the squared distance, integrated over the area,
  // that the model predicts. It rises with the weight.
  double growth(double residualWeight) const;

  // The largest weight in [least, most] whose growth is at most `budget`, found by bisection; `least` if
  // there is none. Pass it to step() to get the step within the budget.
  double weightWithinBudget(double budget, double least, double most) const;

 private:
  Eigen::VectorXd multipliers(double residualWeight) const;

  Eigen::MatrixXd solved_;                           // s and X
  double surfaceGain_;                               // g^T s
  Eigen::Tridiagonalization<Eigen::MatrixXd> gram_;  // G = Q T Q^T
  Eigen::VectorXd diagonal_, subdiagonal_;           // of T
  Eigen::VectorXd target_;                           // Q^T (r + J s)
};

}  // namespace limber
