#include "linear/element_assembly.h"

#include <algorithm>

#include "base/parallel.h"

namespace limber {
namespace {

constexpr size_t kNodesPerRange = 512;

}  // namespace

ElementAssembly::ElementAssembly(const std::vector<uint32_t>& firstUnknown,
                                 const std::vector<uint32_t>& elementNodes, uint32_t nodesPerElement)
    : firstUnknown_(firstUnknown), elementNodes_(elementNodes), nodesPerElement_(nodesPerElement) {
  findNeighbours();
  reserveEntries();
}

void ElementAssembly::findNeighbours() {
  const size_t nodeCount = firstUnknown_.size() - 1;
  useStart_.assign(nodeCount + 1, 0);
  for (uint32_t node : elementNodes_)
    if (node != kNoNode) ++useStart_[node + 1];
  for (size_t i = 0; i < nodeCount; ++i) useStart_[i + 1] += useStart_[i];
  uses_.resize(useStart_.back());
  std::vector<uint32_t> next(useStart_.begin(), useStart_.end() - 1);
  for (size_t slot = 0; slot < elementNodes_.size(); ++slot)
    if (elementNodes_[slot] != kNoNode) uses_[next[elementNodes_[slot]]++] = static_cast<uint32_t>(slot);

  std::vector<uint32_t> seenBy(nodeCount, UINT32_MAX);
  start_.push_back(0);
  for (uint32_t i = 0; i < nodeCount; ++i) {
    for (uint32_t use = useStart_[i]; use < useStart_[i + 1]; ++use)
      for (const uint32_t j : nodesOf(uses_[use] / nodesPerElement_)) {
        if (seenBy[j] == i) continue;
        seenBy[j] = i;
        neighbours_.push_back(j);
      }
    std::sort(neighbours_.begin() + start_.back(), neighbours_.end());
    start_.push_back(static_cast<uint32_t>(neighbours_.size()));
  }
}

void ElementAssembly::reserveEntries() {
  const auto unknownCount = static_cast<Eigen::Index>(firstUnknown_.back());
  sum_.resize(unknownCount, unknownCount);
  int* column = sum_.outerIndexPtr();
  column[0] = 0;
  rowOffset_.reserve(neighbours_.size());
  for (uint32_t i = 0; i + 1 < firstUnknown_.size(); ++i) {
    uint32_t height = 0;
    for (uint32_t k = start_[i]; k < start_[i + 1]; ++k) {
      rowOffset_.push_back(height);
      height += unknownsOf(neighbours_[k]);
    }
    for (uint32_t u = firstUnknown_[i]; u < firstUnknown_[i + 1]; ++u)
      column[u + 1] = column[u] + static_cast<int>(height);
  }
  sum_.resizeNonZeros(column[unknownCount]);
  std::fill_n(sum_.valuePtr(), column[unknownCount], 0.0);
  int* row = sum_.innerIndexPtr();
  for (uint32_t i = 0; i + 1 < firstUnknown_.size(); ++i)
    for (uint32_t u = 0; u < unknownsOf(i); ++u)
      for (uint32_t k = start_[i]; k < start_[i + 1]; ++k)
        for (uint32_t r = 0; r < unknownsOf(neighbours_[k]); ++r)
          *row++ = static_cast<int>(firstUnknown_[neighbours_[k]] + r);
}

// The nodes of an element, without its unused slots.
std::span<const uint32_t> ElementAssembly::nodesOf(uint32_t element) const {
  const std::span<const uint32_t> slots(elementNodes_.data() + size_t{element} * nodesPerElement_,
                                        nodesPerElement_);
  return slots.first(static_cast<size_t>(std::ranges::find(slots, kNoNode) - slots.begin()));
}

// The offset of the block of node i within the columns of node j.
uint32_t ElementAssembly::offsetOf(uint32_t i, uint32_t j) const {
  const auto first = neighbours_.begin() + start_[j], last = neighbours_.begin() + start_[j + 1];
  return rowOffset_[static_cast<size_t>(std::lower_bound(first, last, i) - neighbours_.begin())];
}

void ElementAssembly::add(uint32_t element, const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  const uint32_t* nodes = elementNodes_.data() + size_t{element} * nodesPerElement_;
  whole_ = matrix.selfadjointView<Eigen::Lower>();
  const double* firstColumn = whole_.data();
  for (uint32_t j = 0; j < nodesPerElement_ && nodes[j] != kNoNode; ++j) {
    const double* from = firstColumn;
    for (uint32_t i = 0; i < nodesPerElement_ && nodes[i] != kNoNode; ++i) {
      const uint32_t offset = offsetOf(nodes[i], nodes[j]), rows = unknownsOf(nodes[i]);
      for (uint32_t c = 0; c < unknownsOf(nodes[j]); ++c) {
        double* to = sum_.valuePtr() + sum_.outerIndexPtr()[firstUnknown_[nodes[j]] + c] + offset;
        for (uint32_t r = 0; r < rows; ++r) to[r] += from[c * whole_.rows() + r];
      }
      from += rows;
    }
    firstColumn += unknownsOf(nodes[j]) * whole_.rows();
  }
}

// Each node gathers its columns from its elements in order, so that no two threads write to the same column.
Eigen::SparseMatrix<double> ElementAssembly::sum(
    const std::function<void(const Columns&, double* values)>& fill) const {
  Eigen::SparseMatrix<double> sum = sum_;
  parallelFor(firstUnknown_.size() - 1, kNodesPerRange, [&](size_t begin, size_t end) {
    std::vector<double> values;
    for (auto j = static_cast<uint32_t>(begin); j < end; ++j)
      for (uint32_t use = useStart_[j]; use < useStart_[j + 1]; ++use) {
        Columns columns{uses_[use] / nodesPerElement_, 0, unknownsOf(j)};
        const std::span<const uint32_t> nodes = nodesOf(columns.element);
        uint32_t height = 0;
        for (const uint32_t i : nodes) {
          if (i == j) columns.first = height;
          height += unknownsOf(i);
        }
        values.resize(size_t{height} * columns.count);
        fill(columns, values.data());
        const double* from = values.data();
        for (const uint32_t i : nodes) {
          const uint32_t offset = offsetOf(i, j), rows = unknownsOf(i);
          for (uint32_t c = 0; c < columns.count; ++c) {
            double* to = sum.valuePtr() + sum.outerIndexPtr()[firstUnknown_[j] + c] + offset;
            for (uint32_t r = 0; r < rows; ++r) to[r] += from[size_t{c} * height + r];
          }
          from += rows;
        }
      }
  });
  return sum;
}

}  // namespace limber
