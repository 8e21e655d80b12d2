#include "compare/assignment.h"

#include <algorithm>
#include <cmath>

namespace limber {

namespace {

constexpr int kFree = -1;

// A square assignment of least cost, solved row by row. Prices (dual variables) keep all reduced costs at
// least 0.
class Assignment {
 public:
  explicit Assignment(Eigen::MatrixXd cost)
      : cost_(std::move(cost)),
        size_(static_cast<int>(cost_.rows())),
        rowPrice_(Eigen::VectorXd::Zero(size_)),
        columnPrice_(Eigen::VectorXd::Zero(size_)),
        rowOf_(static_cast<size_t>(size_), kFree) {}

  std::vector<int> solve() {
    for (int row = 0; row < size_; ++row) addRow(row);
    std::vector<int> columnOf(static_cast<size_t>(size_));
    for (int column = 0; column < size_; ++column) columnOf[rowOf_[column]] = column;
    return columnOf;
  }

 private:
  // Finds the shortest path by reduced cost from row `start` to a free column (Dijkstra) and flips the pairs
  // along it.
  void addRow(int start) {
    std::vector<double> distance(size_, HUGE_VAL);
    std::vector<int> previous(size_, kFree);
    std::vector<bool> done(size_, false);
    int row = start, column = kFree;
    double reached = 0;
    for (;;) {
      const int from = column;
      for (int c = 0; c < size_; ++c) {
        if (done[c]) continue;
        const double through = reached + cost_(row, c) - rowPrice_[row] - columnPrice_[c];
        if (through < distance[c]) {
          distance[c] = through;
          previous[c] = from;
        }
      }
      column = kFree;
      for (int c = 0; c < size_; ++c)
        if (!done[c] && (column == kFree || distance[c] < distance[column])) column = c;
      reached = distance[column];
      if (rowOf_[column] == kFree) break;
      done[column] = true;
      row = rowOf_[column];
    }
    rowPrice_[start] += reached;
    for (int c = 0; c < size_; ++c)
      if (done[c]) {
        rowPrice_[rowOf_[c]] += reached - distance[c];
        columnPrice_[c] -= reached - distance[c];
      }
    while (column != kFree) {
      const int before = previous[column];
      rowOf_[column] = before == kFree ? start : rowOf_[before];
      column = before;
    }
  }

  Eigen::MatrixXd cost_;
  int size_;
  Eigen::VectorXd rowPrice_, columnPrice_;
  std::vector<int> rowOf_;
};

}  // namespace

std::vector<int> assign(const Eigen::MatrixXd& value) {
  const Eigen::Index size = std::max(value.rows(), value.cols());
  if (size == 0) return {};
  Eigen::MatrixXd cost = Eigen::MatrixXd::Zero(size, size);
  cost.topLeftCorner(value.rows(), value.cols()) = -value;
  std::vector<int> columnOf = Assignment(std::move(cost)).solve();
  columnOf.resize(static_cast<size_t>(value.rows()));
  for (int& column : columnOf)
    if (column >= value.cols()) column = -1;
  return columnOf;
}

}  // namespace limber
