#include "linear/extended_residual.h"

#include <cmath>

namespace limber {

namespace {

// A sum of doubles and what its additions have rounded off (Knuth's two-sum, Dekker's product).
struct ExtendedSum {
  double sum = 0, lost = 0;

  void add(double value) {
    const double total = sum + value, part = total - sum;
    lost += (sum - (total - part)) + (value - part);
    sum = total;
  }
  void addProduct(double a, double b) {
    const double product = a * b;
    const double splitA = a * 134217729.0, splitB = b * 134217729.0;  // 2^27 + 1
    const double highA = splitA - (splitA - a), highB = splitB - (splitB - b);
    const double lowA = a - highA, lowB = b - highB;
    lost += ((highA * highB - product) + highA * lowB + lowA * highB) + lowA * lowB;
    add(product);
  }
};

}  // namespace

Eigen::VectorXd extendedResidual(const StiffnessModel& model, double lambda, const Eigen::VectorXd& phi,
                                 const Eigen::VectorXd& low) {
  Eigen::VectorXd residual(phi.size());
  for (Eigen::Index i = 0; i < phi.size(); ++i) {
    ExtendedSum sum;
    double lowSum = -lambda * model.mass[i] * low[i];
    // K is symmetric to the last bit: its column is its row.
    for (Eigen::SparseMatrix<double>::InnerIterator entry(model.stiffness, i); entry; ++entry) {
      sum.addProduct(entry.value(), phi[entry.row()]);
      lowSum += entry.value() * low[entry.row()];
    }
    ExtendedSum inertia;  // lambda M phi, with what lambda M has rounded off
    inertia.addProduct(lambda, model.mass[i]);
    sum.addProduct(-inertia.sum, phi[i]);
    residual[i] = sum.sum + (sum.lost - inertia.lost * phi[i] + lowSum);
  }
  return residual;
}

}  // namespace limber
