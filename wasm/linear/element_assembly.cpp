#include "linear/element_assembly.h"

#include <algorithm>

namespace limber {

ElementAssembly::ElementAssembly(const std::vector<uint32_t>& firstUnknown,
                                 const std::vector<uint32_t>& elementNodes, uint32_t nodesPerElement)
    : firstUnknown_(firstUnknown), elementNodes_(elementNodes), nodesPerElement_(nodesPerElement) {
  findNeighbours();
  reserveEntries();
}

void ElementAssembly::findNeighbours() {
  const size_t nodeCount = firstUnknown_.size() - 1;
  std::vector<uint32_t> useStart(nodeCount + 1, 0), uses;
  for (uint32_t node : elementNodes_)
    if (node != kNoNode) ++useStart[node + 1];
  for (size_t i = 0; i < nodeCount; ++i) useStart[i + 1] += useStart[i];
  uses.resize(useStart.back());
  std::vector<uint32_t> next(useStart.begin(), useStart.end() - 1);
  for (size_t k = 0; k < elementNodes_.size(); ++k)
    if (elementNodes_[k] != kNoNode)
      uses[next[elementNodes_[k]]++] = static_cast<uint32_t>(k / nodesPerElement_);

  std::vector<uint32_t> seenBy(nodeCount, UINT32_MAX);
  start_.push_back(0);
  for (uint32_t i = 0; i < nodeCount; ++i) {
    for (uint32_t use = useStart[i]; use < useStart[i + 1]; ++use)
      for (uint32_t k = 0; k < nodesPerElement_; ++k) {
        const uint32_t j = elementNodes_[uses[use] * nodesPerElement_ + k];
        if (j == kNoNode) break;
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

// The offset of the block of node i within the columns of node j.
uint32_t ElementAssembly::offsetOf(uint32_t i, uint32_t j) const {
  const auto first = neighbours_.begin() + start_[j], last = neighbours_.begin() + start_[j + 1];
  return rowOffset_[static_cast<size_t>(std::find(first, last, i) - neighbours_.begin())];
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

}  // namespace limber
