#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace limber {

// Sums element matrices into a sparse symmetric matrix whose unknowns are grouped into nodes: node i has the
// unknowns firstUnknown[i] .. firstUnknown[i + 1) - 1. The pattern is fixed at construction: a full block for
// each pair of nodes that share an element, zeros included.
class ElementAssembly {
 public:
  // Fills the unused last slots of an element with fewer nodes.
  static constexpr uint32_t kNoNode = UINT32_MAX;

  // elementNodes[nodesPerElement * element + k]; no node may occur twice in one element.
  ElementAssembly(const std::vector<uint32_t>& firstUnknown, const std::vector<uint32_t>& elementNodes,
                  uint32_t nodesPerElement);

  // `matrix` is symmetric over the unknowns of the element's nodes, node after node. Only its lower triangle
  // is read, so the sum is symmetric to the last bit.
  void add(uint32_t element, const Eigen::Ref<const Eigen::MatrixXd>& matrix);

  // Receives some columns of an element's matrix.
  struct Columns {
    uint32_t element, first, count;
  };
  // The sum of all elements and of everything that `add` has added so far, computed on several threads and
  // bit-identical for any number of them. `fill` writes columns of an element's matrix, one after the other,
  // all rows of each; it is called for each node of an element, from any thread.
  Eigen::SparseMatrix<double> sum(const std::function<void(const Columns&, double* values)>& fill) const;

  // The sum of everything that `add` has added so far, initially explicit zeros in all entries of the
  // pattern.
  const Eigen::SparseMatrix<double>& sum() const { return sum_; }

  // Moves the sum into an empty matrix; the assembly is empty afterwards. Returning it would copy it: sparse
  // matrices of Eigen 3.4 cannot be moved.
  void take(Eigen::SparseMatrix<double>& sum) { sum.swap(sum_); }

 private:
  void findNeighbours();
  void reserveEntries();
  uint32_t unknownsOf(uint32_t node) const { return firstUnknown_[node + 1] - firstUnknown_[node]; }
  uint32_t offsetOf(uint32_t i, uint32_t j) const;
  std::span<const uint32_t> nodesOf(uint32_t element) const;

  std::vector<uint32_t> firstUnknown_, elementNodes_;
  uint32_t nodesPerElement_;
  // Node i has the slots uses_[useStart_[i] .. useStart_[i + 1]) in elementNodes_, ascending.
  std::vector<uint32_t> useStart_, uses_;
  // Node i has the neighbours neighbours_[start_[i] .. start_[i + 1]), ascending and including i itself;
  // rowOffset_ (parallel to neighbours_) is the offset of the neighbour's first unknown in the columns of i.
  std::vector<uint32_t> start_, neighbours_, rowOffset_;
  Eigen::SparseMatrix<double> sum_;
  Eigen::MatrixXd whole_;  // scratch: both triangles of an element matrix
};

}  // namespace limber
