#include "linear/factor_structure.h"

#include <algorithm>

#include "base/parallel.h"
#include "linear/ordering/front_tree.h"
#include "linear/ordering/ordering.h"

namespace limber {

namespace {

// Subtrees with less than this share of the work become tasks of one thread: small enough for a balanced load
// on several threads, large enough to leave little work above the tasks.
constexpr double kTaskShare = 1.0 / 24;

// Multiplications for eliminating the pivots of a front.
double frontWork(double pivots, double boundary) {
  return pivots * (pivots * pivots / 3 + pivots * boundary + boundary * boundary);
}

void buildFronts(const SparsePencil& pencil, const Job& job, FactorStructure& s) {
  const NodeGraph graph = nodeGraph(pencil);
  const std::vector<FrontNodes> tree = buildFrontTree(graph, eliminationOrder(graph, job), job);
  s.positionOf.resize(pencil.unknownCount());
  const auto forEachUnknown = [&](uint32_t node, const auto& body) {
    for (uint32_t u = pencil.firstUnknown[node]; u < pencil.firstUnknown[node + 1]; ++u) body(u);
  };
  for (const FrontNodes& nodes : tree)
    for (uint32_t node : nodes.pivots)
      forEachUnknown(node, [&](uint32_t u) {
        s.positionOf[u] = static_cast<uint32_t>(s.unknownAt.size());
        s.unknownAt.push_back(u);
      });
  uint32_t position = 0;
  for (const FrontNodes& nodes : tree) {
    FactorStructure::Front front{};
    front.firstPivot = position;
    for (uint32_t node : nodes.pivots) front.pivotCount += graph.weight[node];
    front.firstRow = static_cast<uint32_t>(s.boundary.size());
    for (uint32_t node : nodes.boundary)
      forEachUnknown(node, [&](uint32_t u) { s.boundary.push_back(s.positionOf[u]); });
    front.boundaryCount = static_cast<uint32_t>(s.boundary.size()) - front.firstRow;
    front.work = front.subtreeWork = frontWork(front.pivotCount, front.boundaryCount);
    front.children = nodes.children;
    for (uint32_t child : front.children) front.subtreeWork += s.fronts[child].subtreeWork;
    position += front.pivotCount;
    s.storedZeros += nodes.zeros;
    s.valueCount += front.valueCount();
    s.fronts.push_back(std::move(front));
  }
}

// Appends scratch rows to the work vector of solves.
void addScratch(FactorStructure& s) {
  s.workRows = s.slotCount;
  for (FactorStructure::Task& task : s.tasks) {
    task.firstScratch = s.workRows;
    uint32_t most = 0;
    for (uint32_t f = task.firstFront; f <= task.root; ++f) most = std::max(most, s.fronts[f].boundaryCount);
    s.workRows += most;
  }
  s.topScratch = s.workRows;
  uint32_t most = 0;
  for (const uint32_t f : s.top) most = std::max(most, s.fronts[f].boundaryCount);
  s.workRows += most;
}

// A task is a maximal subtree with less work than the limit. In a solve its rows outside the subtree get
// slots of their own, so that no two tasks write to the same row.
void buildTasks(FactorStructure& s) {
  const double limit = kTaskShare * s.work();
  const auto count = static_cast<uint32_t>(s.fronts.size());
  std::vector<uint32_t> parent(count, count), size(count, 1);
  for (uint32_t f = 0; f < count; ++f)
    for (uint32_t child : s.fronts[f].children) {
      parent[child] = f;
      size[f] += size[child];
    }
  s.slot = s.boundary;
  s.slotCount = s.unknownCount;
  for (uint32_t f = 0; f < count; ++f) {
    if (s.fronts[f].subtreeWork > limit) {
      s.top.push_back(f);
      continue;
    }
    if (parent[f] != count && s.fronts[parent[f]].subtreeWork <= limit) continue;
    const FactorStructure::Task task{f + 1 - size[f], f, s.slotCount, 0};
    const FactorStructure::Front& root = s.fronts[f];
    const auto rootRows = s.boundary.begin() + root.firstRow;
    const uint32_t end = root.firstPivot + root.pivotCount;
    for (uint32_t row = s.fronts[task.firstFront].firstRow; row < root.firstRow + root.boundaryCount; ++row)
      if (s.boundary[row] >= end)
        s.slot[row] =
            s.slotCount +
            static_cast<uint32_t>(std::lower_bound(rootRows, rootRows + root.boundaryCount, s.boundary[row]) -
                                  rootRows);
    s.slotCount += root.boundaryCount;
    s.tasks.push_back(task);
  }
  std::stable_sort(s.tasks.begin(), s.tasks.end(),
                   [&](const FactorStructure::Task& a, const FactorStructure::Task& b) {
                     return s.fronts[a.root].subtreeWork > s.fronts[b.root].subtreeWork;
                   });
  addScratch(s);
}

}  // namespace

FactorStructure factorStructure(const SparsePencil& pencil, const Job& job) {
  FactorStructure structure;
  structure.unknownCount = pencil.unknownCount();
  buildFronts(pencil, job, structure);
  buildTasks(structure);
  return structure;
}

uint64_t FactorStructure::nonzeros() const {
  uint64_t sum = 0;
  for (const Front& front : fronts) {
    const uint64_t pivots = front.pivotCount;
    sum += pivots * (pivots + 1) / 2 + pivots * front.boundaryCount;
  }
  return sum - storedZeros;
}

// Each thread stores at most the updates of one task, in addition to those of finished tasks that wait for
// their parents.
uint64_t FactorStructure::memory() const {
  const auto updateBytes = [&](uint32_t f) {
    return sizeof(double) * uint64_t{fronts[f].boundaryCount} * fronts[f].boundaryCount;
  };
  uint64_t largestTask = 0, waiting = 0;
  for (const Task& task : tasks) {
    uint64_t inside = 0;
    for (uint32_t f = task.firstFront; f <= task.root; ++f) inside = std::max(inside, 3 * updateBytes(f));
    largestTask = std::max(largestTask, inside);
    waiting += updateBytes(task.root);
  }
  for (uint32_t f : top) largestTask = std::max(largestTask, 2 * updateBytes(f));
  return sizeof(double) * (valueCount + workRows + unknownCount) + waiting +
         static_cast<uint64_t>(threadCount()) * largestTask;
}

double FactorStructure::work() const {
  double sum = 0;
  for (const Front& front : fronts) sum += front.work;
  return sum;
}

std::vector<bool> touchedFronts(const FactorStructure& structure, const std::vector<uint32_t>& unknowns) {
  std::vector<bool> isChanged(structure.unknownCount);  // by position
  for (const uint32_t u : unknowns) isChanged[structure.positionOf[u]] = true;
  std::vector<bool> isTouched(structure.fronts.size());
  for (uint32_t f = 0; f < structure.fronts.size(); ++f) {
    const FactorStructure::Front& front = structure.fronts[f];
    for (uint32_t k = 0; k < front.pivotCount && !isTouched[f]; ++k)
      isTouched[f] = isChanged[front.firstPivot + k];
    for (uint32_t k = 0; k < front.boundaryCount && !isTouched[f]; ++k)
      isTouched[f] = isChanged[structure.boundary[front.firstRow + k]];
    for (const uint32_t child : front.children) isTouched[f] = isTouched[f] || isTouched[child];
  }
  return isTouched;
}

}  // namespace limber
