#include "modes/ordering.h"

#include <algorithm>
#include <numeric>

namespace limber {

namespace {

constexpr uint32_t kLeafUnknowns = 40;

// Neighbours of each node: neighbours[start[i] .. start[i + 1]).
struct NodeGraph {
  std::vector<uint32_t> start, neighbours;
};

NodeGraph nodeGraph(const StiffnessModel& model) {
  std::vector<uint32_t> nodeOf(model.unknownCount());
  for (uint32_t i = 0; i < model.nodeCount(); ++i)
    for (uint32_t u = model.firstUnknown[i]; u < model.firstUnknown[i + 1]; ++u) nodeOf[u] = i;
  NodeGraph graph;
  graph.start.push_back(0);
  for (uint32_t i = 0; i < model.nodeCount(); ++i) {
    // All unknowns of a node are coupled alike: its first stands for it.
    uint32_t last = i;
    for (Eigen::SparseMatrix<double>::InnerIterator entry(model.stiffness, model.firstUnknown[i]); entry;
         ++entry) {
      const uint32_t other = nodeOf[static_cast<size_t>(entry.row())];
      if (other != i && other != last) graph.neighbours.push_back(other);
      last = other;
    }
    graph.start.push_back(static_cast<uint32_t>(graph.neighbours.size()));
  }
  return graph;
}

class Dissector {
 public:
  explicit Dissector(const StiffnessModel& model)
      : model_(model), graph_(nodeGraph(model)), side_(model.nodeCount(), 0) {}

  Dissection run() {
    std::vector<uint32_t> all(model_.nodeCount());
    std::iota(all.begin(), all.end(), 0u);
    if (!all.empty()) split(std::move(all), 0);
    return std::move(dissection_);
  }

 private:
  uint32_t weight(const std::vector<uint32_t>& nodes) const {
    uint32_t sum = 0;
    for (uint32_t i : nodes) sum += model_.firstUnknown[i + 1] - model_.firstUnknown[i];
    return sum;
  }

  uint32_t addPart(std::vector<uint32_t> nodes, std::vector<uint32_t> children, uint32_t depth) {
    std::sort(nodes.begin(), nodes.end());
    dissection_.parts.push_back({std::move(nodes), std::move(children), depth});
    return static_cast<uint32_t>(dissection_.parts.size() - 1);
  }

  int longestAxis(const std::vector<uint32_t>& nodes) const {
    Vec3 low = model_.nodes[nodes[0]], high = low;
    for (uint32_t i : nodes)
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], model_.nodes[i][axis]);
        high[axis] = std::max(high[axis], model_.nodes[i][axis]);
      }
    const Vec3 size = high - low;
    return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  }

  // The nodes of one half that touch the other.
  std::vector<uint32_t> rim(const std::vector<uint32_t>& half, uint32_t otherMark) const {
    std::vector<uint32_t> touching;
    for (uint32_t i : half)
      for (uint32_t k = graph_.start[i]; k < graph_.start[i + 1]; ++k)
        if (side_[graph_.neighbours[k]] == otherMark) {
          touching.push_back(i);
          break;
        }
    return touching;
  }

  void remove(std::vector<uint32_t>& from, const std::vector<uint32_t>& what) {
    for (uint32_t i : what) side_[i] = 0;
    std::erase_if(from, [&](uint32_t i) { return side_[i] == 0; });
  }

  // Recursion is as deep as the tree: each level halves the nodes.
  uint32_t split(std::vector<uint32_t> nodes, uint32_t depth) {
    if (weight(nodes) <= kLeafUnknowns) return addPart(std::move(nodes), {}, depth);
    const int axis = longestAxis(nodes);
    const auto middle = nodes.begin() + static_cast<std::ptrdiff_t>(nodes.size() / 2);
    std::nth_element(nodes.begin(), middle, nodes.end(), [&](uint32_t a, uint32_t b) {
      const double pa = model_.nodes[a][axis], pb = model_.nodes[b][axis];
      return pa != pb ? pa < pb : a < b;
    });
    std::vector<uint32_t> left(nodes.begin(), middle), right(middle, nodes.end());
    const uint32_t leftMark = ++marks_, rightMark = ++marks_;
    for (uint32_t i : left) side_[i] = leftMark;
    for (uint32_t i : right) side_[i] = rightMark;
    std::vector<uint32_t> leftRim = rim(left, rightMark), rightRim = rim(right, leftMark);
    const bool takeLeft = weight(leftRim) <= weight(rightRim);
    std::vector<uint32_t> separator = std::move(takeLeft ? leftRim : rightRim);
    remove(takeLeft ? left : right, separator);
    nodes.clear();
    nodes.shrink_to_fit();
    std::vector<uint32_t> children;
    if (!left.empty()) children.push_back(split(std::move(left), depth + 1));
    if (!right.empty()) children.push_back(split(std::move(right), depth + 1));
    return addPart(std::move(separator), std::move(children), depth);
  }

  const StiffnessModel& model_;
  NodeGraph graph_;
  std::vector<uint32_t>
      side_;  // mark of the half that a node is in at the moment; marks are never used twice
  uint32_t marks_ = 0;
  Dissection dissection_;
};

}  // namespace

Dissection dissect(const StiffnessModel& model) {
  return Dissector(model).run();
}

}  // namespace limber
