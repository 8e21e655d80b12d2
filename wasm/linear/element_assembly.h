#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <vector>

namespace limber {

// Sums element matrices into a sparse symmetric matrix whose unknowns come in nodes: node i has the unknowns
// firstUnknown[i] .. firstUnknown[i + 1). Whole blocks are stored for each pair of nodes that share an
// element, zeros included.
class ElementAssembly {
 public:
  // elementNodes[nodesPerElement * element + k]; a node must not come twice in one element.
  ElementAssembly(const std::vector<uint32_t>& firstUnknown, const std::vector<uint32_t>& elementNodes,
                  uint32_t nodesPerElement);

  // `matrix`: symmetric, over the unknowns of the element's nodes one after another. Only its lower triangle
  // is read, so that the sum is symmetric to the last bit.
  void add(uint32_t element, const Eigen::Ref<const Eigen::MatrixXd>& matrix);

  // The sum; the assembly is empty afterwards.
  Eigen::SparseMatrix<double> take() { return std::move(sum_); }

 private:
  // Neighbours of node i, itself included: neighbours_[start_[i] .. start_[i + 1]), ascending; rowOffset_ has
  // the place of each one's first unknown within the columns of i.
  void findNeighbours();
  void reserveEntries();
  uint32_t unknownsOf(uint32_t node) const { return firstUnknown_[node + 1] - firstUnknown_[node]; }
  uint32_t offsetOf(uint32_t i, uint32_t j) const;

  std::vector<uint32_t> firstUnknown_, elementNodes_;
  uint32_t nodesPerElement_;
  std::vector<uint32_t> start_, neighbours_, rowOffset_;
  Eigen::SparseMatrix<double> sum_;
  Eigen::MatrixXd whole_;  // scratch
};

}  // namespace limber
