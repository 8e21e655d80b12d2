#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "linear/sparse_pencil.h"

namespace limber {

// The symbolic factorisation: elimination order, fronts and tasks. It only depends on the pattern of K, so
// all pencils with the same nodes and couplings can share it.
struct FactorStructure {
  // A supernode: pivots that are eliminated together as one dense block. Its rows are the pivots followed by
  // the boundary: the later positions coupled to them. Its columns of L are a rows() x pivotCount matrix.
  struct Front {
    uint32_t firstPivot, pivotCount;   // positions firstPivot .. firstPivot + pivotCount - 1
    uint32_t firstRow, boundaryCount;  // its part of `boundary` and `slot`
    double work;                       // multiplications of this front
    double subtreeWork;                // including all fronts below it
    std::vector<uint32_t> children;
    uint32_t rows() const { return pivotCount + boundaryCount; }
    uint64_t valueCount() const { return uint64_t{rows()} * pivotCount; }
  };
  // A subtree that one thread processes alone: fronts firstFront .. root.
  struct Task {
    uint32_t firstFront, root;
    uint32_t firstSlot;  // the first slot of its contributions to the boundary of its root
    uint32_t firstScratch;
  };

  uint32_t unknownCount = 0;
  std::vector<uint32_t> unknownAt, positionOf;  // elimination position -> unknown, and back
  std::vector<Front> fronts;                    // children before parents, subtrees consecutive
  std::vector<uint32_t> boundary;               // positions
  std::vector<uint32_t> slot;                   // per entry of `boundary`: its row of a solve's work vector
  std::vector<Task> tasks;
  std::vector<uint32_t> top;  // fronts above all tasks, in order
  // Rows of a solve's work vector: the unknowns, then the tasks' slots up to `slotCount`, then scratch rows
  // for the boundary of one front of each task, and of one above all tasks.
  uint32_t slotCount = 0, topScratch = 0, workRows = 0;
  uint64_t valueCount = 0;   // doubles that L takes, which may exceed the range of size_t in wasm
  uint64_t storedZeros = 0;  // of these, zeros added by merging fronts

  // Entries of L on and below the diagonal, without the stored zeros.
  uint64_t nonzeros() const;
  // Peak bytes of a factorisation without the pencil: L, and the updates that wait for their parents.
  uint64_t memory() const;
  // Multiplications of one factorisation, approximately.
  double work() const;
};

// Orders the nodes of the pencil by nested dissection (linear/ordering/ordering.h) and groups them into
// fronts. Throws Cancelled.
FactorStructure factorStructure(const SparsePencil& pencil, const Job& job);

// Per front, whether a change in rows and columns of these unknowns changes its columns of L: whether it or a
// front below it has one of them among its rows.
std::vector<bool> touchedFronts(const FactorStructure& structure, const std::vector<uint32_t>& unknowns);

}  // namespace limber
