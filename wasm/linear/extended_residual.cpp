#include "linear/extended_residual.h"

#include <cmath>

namespace limber {

namespace {

constexpr double kSplit = 134217729;  // 2^27 + 1 splits a double into two halves (Veltkamp)

// A sum of doubles with its rounding error (Knuth's two-sum, Dekker's product).
struct ExtendedSum {
  double sum = 0, lost = 0;

  void add(double value) {
    const double total = sum + value, part = total - sum;
    lost += (sum - (total - part)) + (value - part);
    sum = total;
  }
  void addProduct(double a, double b) {
    const double product = a * b;
    const double splitA = a * kSplit, splitB = b * kSplit;
    const double highA = splitA - (splitA - a), highB = splitB - (splitB - b);
    const double lowA = a - highA, lowB = b - highB;
    lost += ((highA * highB - product) + highA * lowB + lowA * highB) + lowA * lowB;
    add(product);
  }
};

}  // namespace

Eigen::VectorXd extendedResidual(const SparsePencil& pencil, double lambda, const Eigen::VectorXd& phi,
                                 const Eigen::VectorXd& low) {
  Eigen::VectorXd residual(phi.size());
  for (Eigen::Index i = 0; i < phi.size(); ++i) {
    ExtendedSum sum;
    double lowSum = -lambda * pencil.m[i] * low[i];
    // K is symmetric to the last bit, so column i serves as row i.
    for (Eigen::SparseMatrix<double>::InnerIterator entry(pencil.k, i); entry; ++entry) {
      sum.addProduct(entry.value(), phi[entry.row()]);
      lowSum += entry.value() * low[entry.row()];
    }
    ExtendedSum inertia;  // lambda M_ii, with its rounding error
    inertia.addProduct(lambda, pencil.m[i]);
    sum.addProduct(-inertia.sum, phi[i]);
    residual[i] = sum.sum + (sum.lost - inertia.lost * phi[i] + lowSum);
  }
  return residual;
}

}  // namespace limber
