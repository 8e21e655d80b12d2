#include "modes/factorisation.h"

#include <Eigen/Dense>
#include <algorithm>
#include <stdexcept>

#include "base/parallel.h"
#include "modes/dense_ldlt.h"
#include "modes/ordering.h"

namespace limber {

namespace {

// Levels with fewer fronts than this are worked one front at a time, with the threads inside the front.
constexpr size_t kFrontsForThreads = 6;

double frontWork(double pivots, double boundary) {
  const double rows = pivots + boundary;
  return pivots * rows * rows;
}

}  // namespace

Factorisation::Factorisation(const StiffnessModel& model) : model_(model) {
  buildFronts();
}

void Factorisation::buildFronts() {
  const Dissection dissection = dissect(model_);
  const uint32_t unknownCount = model_.unknownCount();
  positionOf_.resize(unknownCount);
  for (const DissectionPart& part : dissection.parts)
    for (uint32_t node : part.nodes)
      for (uint32_t u = model_.firstUnknown[node]; u < model_.firstUnknown[node + 1]; ++u) {
        positionOf_[u] = static_cast<uint32_t>(unknownAt_.size());
        unknownAt_.push_back(u);
      }
  uint32_t deepest = 0;
  for (const DissectionPart& part : dissection.parts) deepest = std::max(deepest, part.depth);
  levels_.resize(dissection.parts.empty() ? 0 : deepest + 1);

  std::vector<uint32_t> stamp(unknownCount, 0);
  uint32_t position = 0;
  for (uint32_t f = 0; f < dissection.parts.size(); ++f) {
    const DissectionPart& part = dissection.parts[f];
    Front front;
    front.firstPivot = position;
    front.children = part.children;
    for (uint32_t node : part.nodes) position += model_.firstUnknown[node + 1] - model_.firstUnknown[node];
    front.pivotCount = position - front.firstPivot;
    const auto add = [&](uint32_t p) {
      if (p < position || stamp[p] == f + 1) return;
      stamp[p] = f + 1;
      front.boundary.push_back(p);
    };
    for (uint32_t p = front.firstPivot; p < position; ++p)
      for (Eigen::SparseMatrix<double>::InnerIterator entry(model_.stiffness, unknownAt_[p]); entry; ++entry)
        add(positionOf_[static_cast<size_t>(entry.row())]);
    for (uint32_t child : front.children)
      for (uint32_t p : fronts_[child].boundary) add(p);
    std::sort(front.boundary.begin(), front.boundary.end());
    front.work = frontWork(front.pivotCount, static_cast<double>(front.boundary.size()));
    levels_[deepest - part.depth].push_back(f);
    fronts_.push_back(std::move(front));
  }
}

// The front's own entries of K - shift M and its children's updates, lower triangle.
void Factorisation::assemble(const Front& front, double shift, Eigen::MatrixXd& dense) const {
  const auto rows = static_cast<Eigen::Index>(front.pivotCount + front.boundary.size());
  dense.setZero(rows, rows);
  const auto local = [&](uint32_t position) -> Eigen::Index {
    if (position < front.firstPivot + front.pivotCount) return position - front.firstPivot;
    const auto at = std::lower_bound(front.boundary.begin(), front.boundary.end(), position);
    return front.pivotCount + (at - front.boundary.begin());
  };
  for (uint32_t p = front.firstPivot; p < front.firstPivot + front.pivotCount; ++p) {
    const uint32_t unknown = unknownAt_[p];
    for (Eigen::SparseMatrix<double>::InnerIterator entry(model_.stiffness, unknown); entry; ++entry) {
      const uint32_t q = positionOf_[static_cast<size_t>(entry.row())];
      if (q >= p) dense(local(q), p - front.firstPivot) += entry.value();
    }
    dense(p - front.firstPivot, p - front.firstPivot) -= shift * model_.mass[unknown];
  }
  std::vector<Eigen::Index> rowOf;
  for (uint32_t child : front.children) {
    const Front& below = fronts_[child];
    rowOf.clear();
    for (uint32_t p : below.boundary) rowOf.push_back(local(p));
    for (size_t j = 0; j < rowOf.size(); ++j)
      for (size_t i = j; i < rowOf.size(); ++i)
        dense(rowOf[i], rowOf[j]) += below.update(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  }
}

void Factorisation::factoriseFront(Front& front, double shift, Job& job) {
  Eigen::MatrixXd dense;
  assemble(front, shift, dense);
  for (uint32_t child : front.children) fronts_[child].update.resize(0, 0);
  const Eigen::Index pivots = front.pivotCount, boundary = dense.rows() - pivots;
  partialLdlt(dense, pivots, diagonal_.segment(front.firstPivot, pivots), job);
  front.factor = dense.leftCols(pivots);
  front.update = dense.bottomRightCorner(boundary, boundary);
}

void Factorisation::factorise(double shift, Job& job) {
  diagonal_.resize(model_.unknownCount());
  double total = 0, done = 0;
  for (const Front& front : fronts_) total += front.work;
  for (const auto& level : levels_) {
    if (level.size() >= kFrontsForThreads) {
      parallelFor(level.size(), 1, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) factoriseFront(fronts_[level[i]], shift, job);
      });
      for (uint32_t f : level) done += fronts_[f].work;
      job.report(done / total);
    } else {
      for (uint32_t f : level) {
        factoriseFront(fronts_[f], shift, job);
        done += fronts_[f].work;
        job.report(done / total);
      }
    }
  }
  if (!diagonal_.allFinite())
    throw std::runtime_error(
        "The stiffness matrix could not be factorised: look for coordinates or thicknesses of wildly "
        "different size.");
}

void Factorisation::solve(Eigen::VectorXd& x) const {
  const auto n = static_cast<Eigen::Index>(unknownAt_.size());
  Eigen::VectorXd y(n), below;
  for (Eigen::Index p = 0; p < n; ++p) y[p] = x[unknownAt_[static_cast<size_t>(p)]];
  for (const Front& front : fronts_) {
    const Eigen::Index pivots = front.pivotCount, boundary = static_cast<Eigen::Index>(front.boundary.size());
    auto part = y.segment(front.firstPivot, pivots);
    front.factor.topRows(pivots).triangularView<Eigen::UnitLower>().solveInPlace(part);
    below.noalias() = front.factor.bottomRows(boundary) * part;
    for (Eigen::Index i = 0; i < boundary; ++i) y[front.boundary[static_cast<size_t>(i)]] -= below[i];
  }
  y.array() /= diagonal_.array();
  for (auto front = fronts_.rbegin(); front != fronts_.rend(); ++front) {
    const Eigen::Index pivots = front->pivotCount,
                       boundary = static_cast<Eigen::Index>(front->boundary.size());
    below.resize(boundary);
    for (Eigen::Index i = 0; i < boundary; ++i) below[i] = y[front->boundary[static_cast<size_t>(i)]];
    auto part = y.segment(front->firstPivot, pivots);
    part.noalias() -= front->factor.bottomRows(boundary).transpose() * below;
    front->factor.topRows(pivots).transpose().triangularView<Eigen::UnitUpper>().solveInPlace(part);
  }
  for (Eigen::Index p = 0; p < n; ++p) x[unknownAt_[static_cast<size_t>(p)]] = y[p];
}

uint32_t Factorisation::negativePivots() const {
  return static_cast<uint32_t>((diagonal_.array() < 0).count());
}

uint64_t Factorisation::nonzeros() const {
  uint64_t sum = 0;
  for (const Front& front : fronts_) {
    const uint64_t pivots = front.pivotCount;
    sum += pivots * (pivots + 1) / 2 + pivots * front.boundary.size();
  }
  return sum;
}

}  // namespace limber
