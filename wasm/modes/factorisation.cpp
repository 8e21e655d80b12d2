#include "modes/factorisation.h"

#include <Eigen/Dense>
#include <algorithm>
#include <atomic>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <thread>

#include "base/parallel.h"
#include "modes/dense_ldlt.h"
#include "modes/front_tree.h"
#include "modes/ordering.h"

namespace limber {

namespace {

constexpr double kTaskShare = 1.0 / 24;  // of the work: subtrees below it are left to one thread

using Values = Eigen::Map<Eigen::MatrixXd>;
using ConstValues = Eigen::Map<const Eigen::MatrixXd>;
using RowsOfOne = Eigen::VectorXd;
using RowsOfMany = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

double frontWork(double pivots, double boundary) {
  return pivots * (pivots * pivots / 3 + pivots * boundary + boundary * boundary);
}

}  // namespace

// How much of a factorisation is done; only the thread that called it may report.
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

Factorisation::Factorisation(const StiffnessModel& model, Job& job) : model_(model) {
  buildFronts(job);
  buildTasks();
}

void Factorisation::buildFronts(const Job& job) {
  const NodeGraph graph = nodeGraph(model_);
  const std::vector<FrontNodes> tree = buildFrontTree(graph, eliminationOrder(graph, job), job);
  positionOf_.resize(model_.unknownCount());
  const auto forEachUnknown = [&](uint32_t node, const auto& body) {
    for (uint32_t u = model_.firstUnknown[node]; u < model_.firstUnknown[node + 1]; ++u) body(u);
  };
  for (const FrontNodes& nodes : tree)
    for (uint32_t node : nodes.pivots)
      forEachUnknown(node, [&](uint32_t u) {
        positionOf_[u] = static_cast<uint32_t>(unknownAt_.size());
        unknownAt_.push_back(u);
      });
  uint32_t position = 0;
  for (const FrontNodes& nodes : tree) {
    Front front{};
    front.firstPivot = position;
    for (uint32_t node : nodes.pivots) front.pivotCount += graph.weight[node];
    front.firstRow = static_cast<uint32_t>(boundary_.size());
    for (uint32_t node : nodes.boundary)
      forEachUnknown(node, [&](uint32_t u) { boundary_.push_back(positionOf_[u]); });
    front.boundaryCount = static_cast<uint32_t>(boundary_.size()) - front.firstRow;
    front.firstValue = valueCount_;
    front.work = front.subtreeWork = frontWork(front.pivotCount, front.boundaryCount);
    front.children = nodes.children;
    for (uint32_t child : front.children) front.subtreeWork += fronts_[child].subtreeWork;
    position += front.pivotCount;
    storedZeros_ += nodes.zeros;
    valueCount_ += size_t{front.rows()} * front.pivotCount;
    fronts_.push_back(std::move(front));
  }
}

// A task is a subtree of little work whose parent is above the limit. In a solve its rows outside of the
// subtree get slots of their own, so that tasks do not write to the same place.
void Factorisation::buildTasks() {
  const double limit = kTaskShare * work();
  const auto count = static_cast<uint32_t>(fronts_.size());
  std::vector<uint32_t> parent(count, count), size(count, 1);
  for (uint32_t f = 0; f < count; ++f)
    for (uint32_t child : fronts_[f].children) {
      parent[child] = f;
      size[f] += size[child];
    }
  slot_ = boundary_;
  slotCount_ = model_.unknownCount();
  for (uint32_t f = 0; f < count; ++f) {
    if (fronts_[f].subtreeWork > limit) {
      top_.push_back(f);
      continue;
    }
    if (parent[f] != count && fronts_[parent[f]].subtreeWork <= limit) continue;
    const Task task{f + 1 - size[f], f, slotCount_};
    const Front& root = fronts_[f];
    const auto rootRows = boundary_.begin() + root.firstRow;
    const uint32_t end = root.firstPivot + root.pivotCount;
    for (uint32_t row = fronts_[task.firstFront].firstRow; row < root.firstRow + root.boundaryCount; ++row)
      if (boundary_[row] >= end)
        slot_[row] =
            slotCount_ +
            static_cast<uint32_t>(std::lower_bound(rootRows, rootRows + root.boundaryCount, boundary_[row]) -
                                  rootRows);
    slotCount_ += root.boundaryCount;
    tasks_.push_back(task);
  }
  std::stable_sort(tasks_.begin(), tasks_.end(), [&](const Task& a, const Task& b) {
    return fronts_[a.root].subtreeWork > fronts_[b.root].subtreeWork;
  });
}

// The front's own entries of K - shift M, and its children's updates.
void Factorisation::assemble(const Front& front, double shift, uint32_t* localRow) {
  Values columns(values_.data() + front.firstValue, front.rows(), front.pivotCount);
  columns.setZero();
  for (uint32_t k = 0; k < front.pivotCount; ++k) localRow[front.firstPivot + k] = k;
  for (uint32_t k = 0; k < front.boundaryCount; ++k)
    localRow[boundary_[front.firstRow + k]] = front.pivotCount + k;
  for (uint32_t k = 0; k < front.pivotCount; ++k) {
    const uint32_t position = front.firstPivot + k, unknown = unknownAt_[position];
    for (Eigen::SparseMatrix<double>::InnerIterator entry(model_.stiffness, unknown); entry; ++entry) {
      const uint32_t other = positionOf_[static_cast<size_t>(entry.row())];
      if (other >= position) columns(localRow[other], k) += entry.value();
    }
    columns(k, k) -= shift * model_.mass[unknown];
  }
}

void Factorisation::factoriseFront(uint32_t f, double shift, uint32_t* localRow, Job& job) {
  const Front& front = fronts_[f];
  assemble(front, shift, localRow);
  Values columns(values_.data() + front.firstValue, front.rows(), front.pivotCount);
  Eigen::MatrixXd& update = updates_[f];
  update.setZero(front.boundaryCount, front.boundaryCount);
  std::vector<uint32_t> rowOf;
  for (uint32_t child : front.children) {
    const Front& below = fronts_[child];
    Eigen::MatrixXd& from = updates_[child];
    rowOf.resize(below.boundaryCount);
    for (uint32_t k = 0; k < below.boundaryCount; ++k) rowOf[k] = localRow[boundary_[below.firstRow + k]];
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
  const uint32_t unknownCount = model_.unknownCount();
  values_.resize(static_cast<Eigen::Index>(valueCount_));
  diagonal_.resize(unknownCount);
  updates_.assign(fronts_.size(), {});
  Progress progress{job, work()};
  const auto newLocalRows = [&] { return std::unique_ptr<uint32_t[]>(new uint32_t[unknownCount]); };
  parallelFor(tasks_.size(), 1, [&](size_t begin, size_t end) {
    const auto localRow = newLocalRows();
    for (size_t t = begin; t < end; ++t)
      for (uint32_t f = tasks_[t].firstFront; f <= tasks_[t].root; ++f) {
        factoriseFront(f, shift, localRow.get(), job);
        progress.add(fronts_[f].work);
      }
  });
  const auto localRow = newLocalRows();
  for (uint32_t f : top_) {
    factoriseFront(f, shift, localRow.get(), job);
    progress.add(fronts_[f].work);
  }
  updates_.clear();
  if (!diagonal_.allFinite())
    throw std::runtime_error(
        "The stiffness matrix could not be factorised: look for coordinates or thicknesses of wildly "
        "different size.");
}

// Subtracts what the front's pivots contribute to the rows of its boundary.
template <class Rows>
void Factorisation::forward(const Front& front, Rows& y) const {
  const ConstValues columns(values_.data() + front.firstValue, front.rows(), front.pivotCount);
  auto part = y.middleRows(front.firstPivot, front.pivotCount);
  columns.topRows(front.pivotCount).template triangularView<Eigen::UnitLower>().solveInPlace(part);
  if (front.boundaryCount == 0) return;
  const Rows below = columns.bottomRows(front.boundaryCount) * part;
  const uint32_t* slot = slot_.data() + front.firstRow;
  for (uint32_t k = 0; k < front.boundaryCount; ++k) y.row(slot[k]) -= below.row(k);
}

template <class Rows>
void Factorisation::backward(const Front& front, Rows& y) const {
  const ConstValues columns(values_.data() + front.firstValue, front.rows(), front.pivotCount);
  auto part = y.middleRows(front.firstPivot, front.pivotCount);
  if (front.boundaryCount > 0) {
    Rows below(front.boundaryCount, y.cols());
    const uint32_t* slot = slot_.data() + front.firstRow;
    for (uint32_t k = 0; k < front.boundaryCount; ++k) below.row(k) = y.row(slot[k]);
    part.noalias() -= columns.bottomRows(front.boundaryCount).transpose() * below;
  }
  columns.topRows(front.pivotCount)
      .transpose()
      .template triangularView<Eigen::UnitUpper>()
      .solveInPlace(part);
}

// y: by position, then the tasks' slots.
template <class Rows>
void Factorisation::solveRows(Rows& y, const Job& job) const {
  y.bottomRows(slotCount_ - model_.unknownCount()).setZero();
  parallelFor(tasks_.size(), 1, [&](size_t begin, size_t end) {
    for (size_t t = begin; t < end; ++t)
      for (uint32_t f = tasks_[t].firstFront; f <= tasks_[t].root; ++f) {
        job.check();
        forward(fronts_[f], y);
      }
  });
  const auto forEachSlot = [&](const auto& body) {
    for (const Task& task : tasks_) {
      const Front& root = fronts_[task.root];
      for (uint32_t k = 0; k < root.boundaryCount; ++k)
        body(boundary_[root.firstRow + k], task.firstSlot + k);
    }
  };
  forEachSlot([&](uint32_t position, uint32_t slot) { y.row(position) += y.row(slot); });
  for (uint32_t f : top_) forward(fronts_[f], y);
  for (uint32_t p = 0; p < model_.unknownCount(); ++p) y.row(p) /= diagonal_[p];
  for (auto f = top_.rbegin(); f != top_.rend(); ++f) backward(fronts_[*f], y);
  forEachSlot([&](uint32_t position, uint32_t slot) { y.row(slot) = y.row(position); });
  parallelFor(tasks_.size(), 1, [&](size_t begin, size_t end) {
    for (size_t t = begin; t < end; ++t)
      for (uint32_t f = tasks_[t].root + 1; f-- > tasks_[t].firstFront;) {
        job.check();
        backward(fronts_[f], y);
      }
  });
}

void Factorisation::solve(Eigen::VectorXd& x, const Job& job) const {
  RowsOfOne y(slotCount_);
  for (uint32_t p = 0; p < model_.unknownCount(); ++p) y[p] = x[unknownAt_[p]];
  solveRows(y, job);
  for (uint32_t p = 0; p < model_.unknownCount(); ++p) x[unknownAt_[p]] = y[p];
}

void Factorisation::solve(Eigen::MatrixXd& x, const Job& job) const {
  RowsOfMany y(slotCount_, x.cols());
  for (uint32_t p = 0; p < model_.unknownCount(); ++p) y.row(p) = x.row(unknownAt_[p]);
  solveRows(y, job);
  for (uint32_t p = 0; p < model_.unknownCount(); ++p) x.row(unknownAt_[p]) = y.row(p);
}

uint32_t Factorisation::negativePivots() const {
  return static_cast<uint32_t>((diagonal_.array() < 0).count());
}

uint64_t Factorisation::nonzeros() const {
  uint64_t sum = 0;
  for (const Front& front : fronts_) {
    const uint64_t pivots = front.pivotCount;
    sum += pivots * (pivots + 1) / 2 + pivots * front.boundaryCount;
  }
  return sum - storedZeros_;
}

// The updates of a whole task may wait at once, on each thread; more do not.
uint64_t Factorisation::memory() const {
  const auto updateBytes = [&](uint32_t f) {
    return sizeof(double) * uint64_t{fronts_[f].boundaryCount} * fronts_[f].boundaryCount;
  };
  uint64_t largestTask = 0, waiting = 0;
  for (const Task& task : tasks_) {
    uint64_t inside = 0;
    for (uint32_t f = task.firstFront; f <= task.root; ++f) inside = std::max(inside, 3 * updateBytes(f));
    largestTask = std::max(largestTask, inside);
    waiting += updateBytes(task.root);
  }
  for (uint32_t f : top_) largestTask = std::max(largestTask, 2 * updateBytes(f));
  return sizeof(double) * (valueCount_ + slotCount_ + model_.unknownCount()) + waiting +
         static_cast<uint64_t>(threadCount()) * largestTask;
}

double Factorisation::work() const {
  double sum = 0;
  for (const Front& front : fronts_) sum += front.work;
  return sum;
}

}  // namespace limber
