#pragma once

#include <Eigen/Core>

namespace limber {

// The Levenberg-Marquardt damping of a search (Marquardt 1963): mu, by which the damping diagonal D of a step
// is multiplied, and a scale of D per coordinate, so that vertices that cannot move are left out of the steps
// of the others. Constants are in tuning::damping.
class Damping {
 public:
  // `favourSpeed`: mu falls faster after good steps, and rises more with each consecutive restore of the best
  // state.
  Damping(Eigen::Index coordinateCount, double initial, bool favourSpeed);

  // mu.
  double value() const { return value_; }
  // Whether mu has reached its upper limit, so that no shorter step is worth trying.
  bool isExhausted() const;
  // D with its scale.
  Eigen::VectorXd scaled(const Eigen::VectorXd& dampingDiagonal) const;

  // Adapts mu to the gain ratio of a step: the actual decrease of the squared residuals over the predicted
  // one.
  void adapt(double gain, double predicted);
  // Raises the scale of blocked vertices, which the guard has kept below half of their displacement, and
  // lowers that of others, to no less than 1. Both have entries 3 v + axis.
  void scaleBlocked(const Eigen::VectorXd& wanted, const Eigen::VectorXd& made);

  // Must be called when a step has found a new best state, and when the best state has been restored. With
  // elongated triangles the residuals are so nonlinear that a linear step can be a thousand times too long.
  void noteImprovement() { restores_ = 0; }
  void noteRestore();

 private:
  double value_;
  bool favourSpeed_;
  int restores_ = 0;  // in a row
  Eigen::ArrayXd scale_;
};

}  // namespace limber
