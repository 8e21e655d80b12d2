#pragma once

#include <Eigen/Core>

namespace limber {

// The Levenberg-Marquardt damping of a search (Marquardt 1963): mu, by which the damping diagonal D of a step
// is multiplied, and a scale of D per coordinate, so that vertices that cannot move are left out of the steps
// of the others. Constants are in tuning::damping.
class Damping {
 public:
  // `favourSpeed`: mu falls faster after good steps, and rises more each time that the best state has to be
  // restored in a row.
  Damping(Eigen::Index coordinateCount, double initial, bool favourSpeed);

  // mu.
  double value() const { return value_; }
  // Whether mu has reached its upper limit: no shorter step is worth trying.
  bool isExhausted() const;
  // D with its scale.
  Eigen::VectorXd scaled(const Eigen::VectorXd& dampingDiagonal) const;

  // Follows the decrease of the squared residuals that a step made against the one that its model predicted.
  void adapt(double gain, double predicted);
  // Raises the scale of blocked vertices, which the guard did not let make half of their displacement, and
  // lowers that of others to no less than 1. Both have entries 3 v + axis.
  void scaleBlocked(const Eigen::VectorXd& wanted, const Eigen::VectorXd& made);

  // To be called when a step has found a new best state, and when the best state has been restored: elongated
  // triangles bend the residuals so much that a linear step can be a thousand times too long.
  void noteImprovement() { restores_ = 0; }
  void noteRestore();

 private:
  double value_;
  bool favourSpeed_;
  int restores_ = 0;  // in a row
  Eigen::ArrayXd scale_;
};

}  // namespace limber
