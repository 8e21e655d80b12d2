#include "linear/factorisation.h"

#include <Eigen/Dense>
#include <algorithm>
#include <atomic>
#include <memory>
#include <stdexcept>
#include <thread>

#include "base/parallel.h"
#include "linear/dense/dense_ldlt.h"
#include "linear/dense/dense_product.h"
#include "linear/dense/dense_triangle.h"

namespace limber {

namespace {

using Values = Eigen::Map<Eigen::MatrixXd>;
using ConstValues = Eigen::Map<const Eigen::MatrixXd>;
using RowsOfOne = Eigen::VectorXd;
using AllRowsOfMany = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using RowsOfMany = Eigen::Map<AllRowsOfMany, 0, Eigen::OuterStride<>>;  // some of their columns

constexpr Eigen::Index kMinColumns = 8;  // right-hand sides for which another thread helps at the top

// Calls `solve` with the columns of y, divided among several threads. The result of a column does not depend
// on the other columns.
template <class Solve>
void forEachPart(RowsOfOne& y, const Solve& solve) {
  solve(y);
}

template <class Solve>
void forEachPart(RowsOfMany& y, const Solve& solve) {
  const auto columns = static_cast<size_t>(y.cols()),
             parts = std::clamp<size_t>(columns / kMinColumns, 1, static_cast<size_t>(threadCount()));
  parallelFor(columns, (columns + parts - 1) / parts, [&](size_t begin, size_t end) {
    RowsOfMany part(y.data() + begin, y.rows(), static_cast<Eigen::Index>(end - begin), y.outerStride());
    solve(part);
  });
}

}  // namespace

// The completed share of a factorisation. Only the calling thread may report it.
struct Factorisation::Progress {
  Job& job;
  double total;
  std::thread::id caller = std::this_thread::get_id();
  std::atomic<uint64_t> done = 0;

  void add(double work) {
    const uint64_t sum = done += static_cast<uint64_t>(work);
    if (std::this_thread::get_id() == caller)
      job.report(static_cast<double>(sum) / total);
    else
      job.check();
  }
};

Factorisation::Factorisation(const SparsePencil& pencil, Job& job)
    : Factorisation(pencil, std::make_shared<const FactorStructure>(factorStructure(pencil, job))) {}

Factorisation::Factorisation(const SparsePencil& pencil, std::shared_ptr<const FactorStructure> structure)
    : pencil_(pencil), structure_(std::move(structure)) {}

// Fills the lower part of the columns of a front with its entries of K - shift M, and localRow with the row
// of each position in it.
void Factorisation::assemble(const Front& front, double shift, uint32_t* localRow) {
  Values columns(values_.data() + front.firstValue, front.rows(), front.pivotCount);
  for (uint32_t k = 0; k < front.pivotCount; ++k) columns.col(k).tail(front.rows() - k).setZero();
  for (uint32_t k = 0; k < front.pivotCount; ++k) localRow[front.firstPivot + k] = k;
  for (uint32_t k = 0; k < front.boundaryCount; ++k)
    localRow[structure_->boundary[front.firstRow + k]] = front.pivotCount + k;
  for (uint32_t k = 0; k < front.pivotCount; ++k) {
    const uint32_t position = front.firstPivot + k, unknown = structure_->unknownAt[position];
    for (Eigen::SparseMatrix<double>::InnerIterator entry(pencil_.k, unknown); entry; ++entry) {
      const uint32_t other = structure_->positionOf[static_cast<size_t>(entry.row())];
      if (other >= position) columns(localRow[other], k) += entry.value();
    }
    columns(k, k) -= shift * pencil_.m[unknown];
  }
}

void Factorisation::factoriseFront(uint32_t f, double shift, uint32_t* localRow, Job& job) {
  const Front& front = structure_->fronts[f];
  assemble(front, shift, localRow);
  Values columns(values_.data() + front.firstValue, front.rows(), front.pivotCount);
  Eigen::MatrixXd& update = updates_[f];
  update.resize(front.boundaryCount, front.boundaryCount);
  for (uint32_t j = 0; j < front.boundaryCount; ++j) update.col(j).tail(front.boundaryCount - j).setZero();
  std::vector<uint32_t> rowOf;
  for (uint32_t child : front.children) {
    const Front& below = structure_->fronts[child];
    Eigen::MatrixXd& from = updates_[child];
    rowOf.resize(below.boundaryCount);
    for (uint32_t k = 0; k < below.boundaryCount; ++k)
      rowOf[k] = localRow[structure_->boundary[below.firstRow + k]];
    for (uint32_t j = 0; j < below.boundaryCount; ++j) {
      const bool isPivot = rowOf[j] < front.pivotCount;
      const uint32_t offset = isPivot ? 0 : front.pivotCount;
      double* to = isPivot ? columns.col(rowOf[j]).data() : update.col(rowOf[j] - offset).data();
      const double* add = from.col(j).data();
      for (uint32_t i = j; i < below.boundaryCount; ++i) to[rowOf[i] - offset] += add[i];
    }
    from.resize(0, 0);
  }
  partialLdlt(columns, diagonal_.segment(front.firstPivot, front.pivotCount), update, job);
}

void Factorisation::factorise(double shift, Job& job) {
  const uint32_t unknownCount = structure_->unknownCount;
  values_.resize(static_cast<Eigen::Index>(structure_->valueCount));
  diagonal_.resize(unknownCount);
  updates_.assign(structure_->fronts.size(), {});
  Progress progress{job, structure_->work()};
  const auto newLocalRows = [&] { return std::unique_ptr<uint32_t[]>(new uint32_t[unknownCount]); };
  parallelFor(structure_->tasks.size(), 1, [&](size_t begin, size_t end) {
    const auto localRow = newLocalRows();
    for (size_t t = begin; t < end; ++t)
      for (uint32_t f = structure_->tasks[t].firstFront; f <= structure_->tasks[t].root; ++f) {
        factoriseFront(f, shift, localRow.get(), job);
        progress.add(structure_->fronts[f].work);
      }
  });
  const auto localRow = newLocalRows();
  for (uint32_t f : structure_->top) {
    factoriseFront(f, shift, localRow.get(), job);
    progress.add(structure_->fronts[f].work);
  }
  updates_.clear();
  if (!diagonal_.allFinite())
    throw std::runtime_error(
        "The matrix could not be factorised: look for coordinates or thicknesses of wildly "
        "different size.");
}

// Forward substitution: solves for the pivots of a front and subtracts their contribution from its boundary.
template <class Rows>
void Factorisation::forward(const Front& front, uint32_t scratch, Rows& y) const {
  const ConstValues columns(values_.data() + front.firstValue, front.rows(), front.pivotCount);
  auto part = y.middleRows(front.firstPivot, front.pivotCount);
  solveLower(columns.topRows(front.pivotCount), part);
  if (front.boundaryCount == 0) return;
  auto below = y.middleRows(scratch, front.boundaryCount);
  below.setZero();
  subtractProduct(columns.bottomRows(front.boundaryCount), part, below);
  const uint32_t* slot = structure_->slot.data() + front.firstRow;
  for (uint32_t k = 0; k < front.boundaryCount; ++k) y.row(slot[k]) += below.row(k);
}

// Backward substitution: subtracts the contribution of the boundary and solves for the pivots.
template <class Rows>
void Factorisation::backward(const Front& front, uint32_t scratch, Rows& y) const {
  const ConstValues columns(values_.data() + front.firstValue, front.rows(), front.pivotCount);
  auto part = y.middleRows(front.firstPivot, front.pivotCount);
  if (front.boundaryCount > 0) {
    auto below = y.middleRows(scratch, front.boundaryCount);
    const uint32_t* slot = structure_->slot.data() + front.firstRow;
    for (uint32_t k = 0; k < front.boundaryCount; ++k) below.row(k) = y.row(slot[k]);
    subtractProduct(columns.bottomRows(front.boundaryCount).transpose(), below, part);
  }
  solveLowerTransposed(columns.topRows(front.pivotCount), part);
}

// y is the work vector: see FactorStructure::workRows.
template <class Rows>
void Factorisation::solveRows(Rows& y, const Job& job) const {
  y.middleRows(structure_->unknownCount, structure_->slotCount - structure_->unknownCount).setZero();
  parallelFor(structure_->tasks.size(), 1, [&](size_t begin, size_t end) {
    for (size_t t = begin; t < end; ++t) {
      const Task& task = structure_->tasks[t];
      for (uint32_t f = task.firstFront; f <= task.root; ++f) {
        job.check();
        forward(structure_->fronts[f], task.firstScratch, y);
      }
    }
  });
  const auto forEachSlot = [&](const auto& body) {
    for (const Task& task : structure_->tasks) {
      const Front& root = structure_->fronts[task.root];
      for (uint32_t k = 0; k < root.boundaryCount; ++k)
        body(structure_->boundary[root.firstRow + k], task.firstSlot + k);
    }
  };
  forEachSlot([&](uint32_t position, uint32_t slot) { y.row(position) += y.row(slot); });
  forEachPart(y, [&](Rows& part) {
    const uint32_t scratch = structure_->topScratch;
    for (uint32_t f : structure_->top) {
      job.check();
      forward(structure_->fronts[f], scratch, part);
    }
    for (uint32_t p = 0; p < structure_->unknownCount; ++p) part.row(p) /= diagonal_[p];
    for (auto f = structure_->top.rbegin(); f != structure_->top.rend(); ++f)
      backward(structure_->fronts[*f], scratch, part);
  });
  forEachSlot([&](uint32_t position, uint32_t slot) { y.row(slot) = y.row(position); });
  parallelFor(structure_->tasks.size(), 1, [&](size_t begin, size_t end) {
    for (size_t t = begin; t < end; ++t) {
      const Task& task = structure_->tasks[t];
      for (uint32_t f = task.root + 1; f-- > task.firstFront;) {
        job.check();
        backward(structure_->fronts[f], task.firstScratch, y);
      }
    }
  });
}

void Factorisation::solve(Eigen::VectorXd& x, const Job& job) const {
  RowsOfOne y(structure_->workRows);
  for (uint32_t p = 0; p < structure_->unknownCount; ++p) y[p] = x[structure_->unknownAt[p]];
  solveRows(y, job);
  for (uint32_t p = 0; p < structure_->unknownCount; ++p) x[structure_->unknownAt[p]] = y[p];
}

void Factorisation::solve(Eigen::MatrixXd& x, const Job& job) const {
  AllRowsOfMany all(structure_->workRows, x.cols());
  RowsOfMany y(all.data(), all.rows(), all.cols(), all.outerStride());
  for (uint32_t p = 0; p < structure_->unknownCount; ++p) y.row(p) = x.row(structure_->unknownAt[p]);
  solveRows(y, job);
  for (uint32_t p = 0; p < structure_->unknownCount; ++p) x.row(structure_->unknownAt[p]) = y.row(p);
}

uint32_t Factorisation::negativePivots() const {
  return static_cast<uint32_t>((diagonal_.array() < 0).count());
}

}  // namespace limber
