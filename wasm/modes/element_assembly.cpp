#include "modes/element_assembly.h"

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
  std::vector<uint32_t> useStart(nodeCount + 1, 0), uses(elementNodes_.size());
  for (uint32_t node : elementNodes_) ++useStart[node + 1];
  for (size_t i = 0; i < nodeCount; ++i) useStart[i + 1] += useStart[i];
  std::vector<uint32_t> next(useStart.begin(), useStart.end() - 1);
  for (size_t k = 0; k < elementNodes_.size(); ++k)
    uses[next[elementNodes_[k]]++] = static_cast<uint32_t>(k / nodesPerElement_);

  std::vector<uint32_t> seenBy(nodeCount, UINT32_MAX);
  start_.push_back(0);
  for (uint32_t i = 0; i < nodeCount; ++i) {
    for (uint32_t use = useStart[i]; use < useStart[i + 1]; ++use)
      for (uint32_t k = 0; k < nodesPerElement_; ++k) {
        const uint32_t j = elementNodes_[uses[use] * nodesPerElement_ + k];
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
  std::vector<int> rows;
  sum_.resize(unknownCount, unknownCount);
  int* column = sum_.outerIndexPtr();
  column[0] = 0;
  for (uint32_t i = 0; i + 1 < firstUnknown_.size(); ++i) {
    uint32_t height = 0;
    for (uint32_t k = start_[i]; k < start_[i + 1]; ++k) {
      rowOffset_.push_back(height);
      height += firstUnknown_[neighbours_[k] + 1] - firstUnknown_[neighbours_[k]];
    }
    for (uint32_t u = firstUnknown_[i]; u < firstUnknown_[i + 1]; ++u) {
      for (uint32_t k = start_[i]; k < start_[i + 1]; ++k)
        for (uint32_t row = firstUnknown_[neighbours_[k]]; row < firstUnknown_[neighbours_[k] + 1]; ++row)
          rows.push_back(static_cast<int>(row));
      column[u + 1] = column[u] + static_cast<int>(height);
    }
  }
  sum_.resizeNonZeros(static_cast<Eigen::Index>(rows.size()));
  std::copy(rows.begin(), rows.end(), sum_.innerIndexPtr());
  std::fill_n(sum_.valuePtr(), rows.size(), 0.0);
}

void ElementAssembly::add(uint32_t element, const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  const uint32_t* nodes = elementNodes_.data() + size_t{element} * nodesPerElement_;
  Eigen::Index column = 0;
  for (uint32_t j = 0; j < nodesPerElement_; ++j) {
    const uint32_t columns = firstUnknown_[nodes[j] + 1] - firstUnknown_[nodes[j]];
    const auto first = neighbours_.begin() + start_[nodes[j]],
               last = neighbours_.begin() + start_[nodes[j] + 1];
    Eigen::Index row = 0;
    for (uint32_t i = 0; i < nodesPerElement_; ++i) {
      const uint32_t rows = firstUnknown_[nodes[i] + 1] - firstUnknown_[nodes[i]];
      const auto place = std::lower_bound(first, last, nodes[i]) - neighbours_.begin();
      for (uint32_t c = 0; c < columns; ++c) {
        double* to = sum_.valuePtr() + sum_.outerIndexPtr()[firstUnknown_[nodes[j]] + c] + rowOffset_[place];
        for (uint32_t r = 0; r < rows; ++r)
          to[r] += matrix(std::max(row + r, column + c), std::min(row + r, column + c));
      }
      row += rows;
    }
    column += columns;
  }
}

}  // namespace limber
