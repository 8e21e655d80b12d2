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
    : pencil_(pencil), structure_(std::move(structure)) {
  assignOffsets();
}

Factorisation::Factorisation(const SparsePencil& pencil, std::shared_ptr<const Factorisation> base,
                             const std::vector<uint32_t>& unknowns)
    : pencil_(pencil),
      structure_(base->structure_),
      base_(std::move(base)),
      isTouched_(touchedFronts(*structure_, unknowns)) {
  assignOffsets();
}

void Factorisation::assignOffsets() {
  firstValue_.resize(structure_->fronts.size());
  for (uint32_t f = 0; f < firstValue_.size(); ++f) {
    firstValue_[f] = static_cast<size_t>(valueCount_);
    if (!isOwn(f)) continue;
    valueCount_ += structure_->fronts[f].valueCount();
    work_ += structure_->fronts[f].work;
  }
}

void Factorisation::keepFor(const std::vector<uint32_t>& unknowns) {
  const std::vector<bool> isTouched = touchedFronts(*structure_, unknowns);
  isKept_.resize(isTouched.size());
  for (uint32_t f = 0; f < isTouched.size(); ++f)
    for (const uint32_t child : structure_->fronts[f].children)
      if (isTouched[f] && !isTouched[child]) isKept_[child] = true;
}

uint64_t Factorisation::memory() const {
  uint64_t kept = 0;  // entries of updates
  for (uint32_t f = 0; f < isKept_.size(); ++f)
    if (isKept_[f])
      kept += uint64_t{structure_->fronts[f].boundaryCount} * structure_->fronts[f].boundaryCount;
  const uint64_t shared = structure_->valueCount - valueCount_;
  return structure_->memory() - sizeof(double) * shared + sizeof(double) * kept;
}

const double* Factorisation::valuesOf(uint32_t f) const {
  return isOwn(f) ? values_.data() + firstValue_[f] : base_->valuesOf(f);
}

// Fills the lower part of the columns of a front with its entries of K - shift M, and localRow with the row
// of each position in it.
void Factorisation::assemble(uint32_t f, double shift, uint32_t* localRow) {
  const Front& front = structure_->fronts[f];
  Values columns(values_.data() + firstValue_[f], front.rows(), front.pivotCount);
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

// Adds the update of a child to the columns of a front and to its own update.
void Factorisation::addUpdate(uint32_t child, uint32_t f, const uint32_t* localRow) {
  const Front &front = structure_->fronts[f], &below = structure_->fronts[child];
  Values columns(values_.data() + firstValue_[f], front.rows(), front.pivotCount);
  Eigen::MatrixXd& update = updates_[f];
  const Eigen::MatrixXd& from = isOwn(child) ? updates_[child] : base_->updates_[child];
  std::vector<uint32_t> rowOf(below.boundaryCount);
  for (uint32_t k = 0; k < below.boundaryCount; ++k)
    rowOf[k] = localRow[structure_->boundary[below.firstRow + k]];
  for (uint32_t j = 0; j < below.boundaryCount; ++j) {
    const bool isPivot = rowOf[j] < front.pivotCount;
    const uint32_t offset = isPivot ? 0 : front.pivotCount;
    double* to = isPivot ? columns.col(rowOf[j]).data() : update.col(rowOf[j] - offset).data();
    const double* add = from.col(j).data();
    for (uint32_t i = j; i < below.boundaryCount; ++i) to[rowOf[i] - offset] += add[i];
  }
}

void Factorisation::factoriseFront(uint32_t f, double shift, uint32_t* localRow, Job& job) {
  const Front& front = structure_->fronts[f];
  assemble(f, shift, localRow);
  Eigen::MatrixXd& update = updates_[f];
  update.resize(front.boundaryCount, front.boundaryCount);
  for (uint32_t j = 0; j < front.boundaryCount; ++j) update.col(j).tail(front.boundaryCount - j).setZero();
  for (const uint32_t child : front.children) {
    addUpdate(child, f, localRow);
    if (!isKept(child)) updates_[child].resize(0, 0);
  }
  Values columns(values_.data() + firstValue_[f], front.rows(), front.pivotCount);
  partialLdlt(columns, diagonal_.segment(front.firstPivot, front.pivotCount), update, job);
}

void Factorisation::factorise(double shift, Job& job) {
  const uint32_t unknownCount = structure_->unknownCount;
  values_.resize(static_cast<Eigen::Index>(valueCount_));
  if (base_)
    diagonal_ = base_->diagonal_;
  else
    diagonal_.resize(unknownCount);
  updates_.assign(structure_->fronts.size(), {});
  Progress progress{job, work_};
  const auto factoriseOwn = [&](uint32_t f, uint32_t* localRow) {
    if (!isOwn(f)) return;
    factoriseFront(f, shift, localRow, job);
    progress.add(structure_->fronts[f].work);
  };
  const auto newLocalRows = [&] { return std::unique_ptr<uint32_t[]>(new uint32_t[unknownCount]); };
  parallelFor(structure_->tasks.size(), 1, [&](size_t begin, size_t end) {
    const auto localRow = newLocalRows();
    for (size_t t = begin; t < end; ++t)
      for (uint32_t f = structure_->tasks[t].firstFront; f <= structure_->tasks[t].root; ++f)
        factoriseOwn(f, localRow.get());
  });
  const auto localRow = newLocalRows();
  for (const uint32_t f : structure_->top) factoriseOwn(f, localRow.get());
  if (isKept_.empty()) updates_.clear();
  if (!diagonal_.allFinite())
    throw std::runtime_error(
        "The matrix could not be factorised: look for coordinates or thicknesses of wildly "
        "different size.");
}

// Forward substitution: solves for the pivots of a front and subtracts their contribution from its boundary.
template <class Rows>
void Factorisation::forward(uint32_t f, uint32_t scratch, Rows& y) const {
  const Front& front = structure_->fronts[f];
  const ConstValues columns(valuesOf(f), front.rows(), front.pivotCount);
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
void Factorisation::backward(uint32_t f, uint32_t scratch, Rows& y) const {
  const Front& front = structure_->fronts[f];
  const ConstValues columns(valuesOf(f), front.rows(), front.pivotCount);
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
        forward(f, task.firstScratch, y);
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
      forward(f, scratch, part);
    }
    for (uint32_t p = 0; p < structure_->unknownCount; ++p) part.row(p) /= diagonal_[p];
    for (auto f = structure_->top.rbegin(); f != structure_->top.rend(); ++f) backward(*f, scratch, part);
  });
  forEachSlot([&](uint32_t position, uint32_t slot) { y.row(slot) = y.row(position); });
  parallelFor(structure_->tasks.size(), 1, [&](size_t begin, size_t end) {
    for (size_t t = begin; t < end; ++t) {
      const Task& task = structure_->tasks[t];
      for (uint32_t f = task.root + 1; f-- > task.firstFront;) {
        job.check();
        backward(f, task.firstScratch, y);
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

std::shared_ptr<Factorisation> factorisationOf(const SparsePencil& pencil,
                                               std::shared_ptr<const FactorStructure> structure, Job& job) {
  return structure ? std::make_shared<Factorisation>(pencil, std::move(structure))
                   : std::make_shared<Factorisation>(pencil, job);
}

}  // namespace limber
