#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "linear/stiffness_model.h"

namespace limber {

// Where the numbers of a factor go: order, fronts and tasks. The same for all models with the same nodes
// coupled in the same way, whatever their numbers.
struct FactorStructure {
  // Rows: the pivots, then the boundary. Its columns of L are at firstValue, rows x pivots.
  struct Front {
    uint32_t firstPivot, pivotCount;
    uint32_t firstRow, boundaryCount;  // its boundary: boundary[firstRow ..], slot[firstRow ..]
    size_t firstValue;
    double work;         // of its own
    double subtreeWork;  // with all below it
    std::vector<uint32_t> children;
    uint32_t rows() const { return pivotCount + boundaryCount; }
  };
  // Subtrees that threads work through on their own: fronts firstFront .. root.
  struct Task {
    uint32_t firstFront, root;
    uint32_t firstSlot;  // of what it adds to the boundary of its root
  };

  uint32_t unknownCount = 0;
  std::vector<uint32_t> unknownAt, positionOf;  // elimination position <-> unknown
  std::vector<Front> fronts;                    // children before parents, subtrees consecutive
  std::vector<uint32_t> boundary;               // positions
  std::vector<uint32_t> slot;                   // where a solve keeps that row while in this task
  std::vector<Task> tasks;
  std::vector<uint32_t> top;  // fronts above the tasks
  uint32_t slotCount = 0;
  size_t valueCount = 0;
  uint64_t storedZeros = 0;

  // Entries of L below and on the diagonal; the zeros that are stored to make fronts larger do not count.
  uint64_t nonzeros() const;
  // Bytes that a factorisation takes beside the model, at its peak: L and the updates that wait for their
  // parents.
  uint64_t memory() const;
  // Multiplications of one factorisation, about.
  double work() const;
};

// Nested dissection of the model's nodes. Throws Cancelled.
FactorStructure factorStructure(const StiffnessModel& model, const Job& job);

}  // namespace limber
