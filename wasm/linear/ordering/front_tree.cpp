#include "linear/ordering/front_tree.h"

#include <algorithm>

namespace limber {

namespace {

constexpr uint32_t kNone = UINT32_MAX;

// A supernode while the tree is built; weights in unknowns.
struct Supernode {
  std::vector<uint32_t> pivots, boundary;  // positions in the order
  std::vector<uint32_t> children;
  uint64_t pivotWeight = 0, boundaryWeight = 0;
  uint64_t zeros = 0;  // entries that merging has filled in
  bool isMerged = false;
};

class TreeBuilder {
 public:
  TreeBuilder(const NodeGraph& graph, const std::vector<uint32_t>& order, const Job& job)
      : job_(job), graph_(graph), order_(order), positionOf_(order.size()), stamp_(order.size(), kNone) {
    for (uint32_t p = 0; p < order.size(); ++p) positionOf_[order[p]] = p;
  }

  std::vector<FrontNodes> run() {
    findSupernodes();
    for (uint32_t s = 0; s < supernodes_.size(); ++s) mergeChildren(s);
    return inPostorder();
  }

 private:
  uint64_t weight(uint32_t position) const { return graph_.weight[order_[position]]; }

  // The later positions that position p is coupled to when its turn comes, unsorted.
  std::vector<uint32_t> structure(uint32_t p, const std::vector<uint32_t>& children) {
    std::vector<uint32_t> rows;
    stamp_[p] = p;
    const auto add = [&](uint32_t q) {
      if (q <= p || stamp_[q] == p) return;
      stamp_[q] = p;
      rows.push_back(q);
    };
    for (uint32_t j : graph_.around(order_[p])) add(positionOf_[j]);
    for (uint32_t child : children)
      for (uint32_t q : supernodes_[child].boundary) add(q);
    return rows;
  }

  // Supernodes of the order as it is: a position joins a child whose structure it continues.
  void findSupernodes() {
    std::vector<std::vector<uint32_t>> waiting(order_.size());  // supernodes whose parent is this position
    for (uint32_t p = 0; p < order_.size(); ++p) {
      if (p % 4096 == 0) job_.check();
      const uint32_t s = place(p, waiting[p]);
      waiting[p] = {};
      const auto& boundary = supernodes_[s].boundary;
      if (!boundary.empty()) waiting[*std::min_element(boundary.begin(), boundary.end())].push_back(s);
    }
    for (Supernode& s : supernodes_)
      for (uint32_t p : s.boundary) s.boundaryWeight += weight(p);
  }

  // Puts position p into one of its children or into a new supernode, and returns which.
  uint32_t place(uint32_t p, std::vector<uint32_t>& children) {
    std::vector<uint32_t> rows = structure(p, children);
    const auto same = std::find_if(children.begin(), children.end(), [&](uint32_t child) {
      return supernodes_[child].boundary.size() == rows.size() + 1;
    });
    const uint32_t s = same != children.end() ? *same : static_cast<uint32_t>(supernodes_.size());
    if (same != children.end())
      children.erase(same);
    else
      supernodes_.emplace_back();
    Supernode& supernode = supernodes_[s];
    supernode.pivots.push_back(p);
    supernode.pivotWeight += weight(p);
    supernode.children.insert(supernode.children.end(), children.begin(), children.end());
    supernode.boundary = std::move(rows);
    return s;
  }

  // Merging pays where few zeros are stored in proportion, or the front is small anyway.
  static bool isWorthwhile(uint64_t pivots, uint64_t entries, uint64_t zeros) {
    const double share = static_cast<double>(zeros) / static_cast<double>(entries);
    return pivots <= 8 || (pivots <= 16 && share < 0.3) || (pivots <= 64 && share < 0.08) || share < 0.03;
  }

  void mergeChildren(uint32_t s) {
    Supernode& parent = supernodes_[s];
    const std::vector<uint32_t> children = std::move(parent.children);
    parent.children.clear();
    for (uint32_t c : children) {
      Supernode& child = supernodes_[c];
      const uint64_t added =
          child.pivotWeight * (parent.pivotWeight + parent.boundaryWeight - child.boundaryWeight);
      const uint64_t zeros = parent.zeros + child.zeros + added;
      const uint64_t pivots = parent.pivotWeight + child.pivotWeight;
      const uint64_t entries = pivots * (pivots + 1) / 2 + pivots * parent.boundaryWeight;
      if (!isWorthwhile(pivots, entries, zeros)) {
        parent.children.push_back(c);
        continue;
      }
      parent.pivots.insert(parent.pivots.begin(), child.pivots.begin(), child.pivots.end());
      parent.children.insert(parent.children.end(), child.children.begin(), child.children.end());
      parent.pivotWeight = pivots;
      parent.zeros = zeros;
      child = {};
      child.isMerged = true;
    }
  }

  std::vector<FrontNodes> inPostorder() {
    std::vector<uint8_t> hasParent(supernodes_.size(), 0);
    for (const Supernode& s : supernodes_)
      for (uint32_t c : s.children) hasParent[c] = 1;
    std::vector<uint32_t> sequence, stack;
    for (uint32_t root = 0; root < supernodes_.size(); ++root) {
      if (hasParent[root] || supernodes_[root].isMerged) continue;
      const size_t first = sequence.size();
      stack.assign(1, root);
      while (!stack.empty()) {
        const uint32_t s = stack.back();
        stack.pop_back();
        sequence.push_back(s);
        stack.insert(stack.end(), supernodes_[s].children.begin(), supernodes_[s].children.end());
      }
      std::reverse(sequence.begin() + static_cast<std::ptrdiff_t>(first), sequence.end());
    }
    return toFronts(sequence);
  }

  std::vector<FrontNodes> toFronts(const std::vector<uint32_t>& sequence) {
    std::vector<uint32_t> frontOf(supernodes_.size(), kNone), newPosition(order_.size());
    uint32_t next = 0;
    for (uint32_t f = 0; f < sequence.size(); ++f) {
      frontOf[sequence[f]] = f;
      for (uint32_t p : supernodes_[sequence[f]].pivots) newPosition[p] = next++;
    }
    std::vector<FrontNodes> fronts(sequence.size());
    for (uint32_t f = 0; f < sequence.size(); ++f) {
      Supernode& s = supernodes_[sequence[f]];
      for (uint32_t p : s.pivots) fronts[f].pivots.push_back(order_[p]);
      fronts[f].zeros = s.zeros;
      std::sort(s.boundary.begin(), s.boundary.end(),
                [&](uint32_t a, uint32_t b) { return newPosition[a] < newPosition[b]; });
      for (uint32_t p : s.boundary) fronts[f].boundary.push_back(order_[p]);
      for (uint32_t c : s.children) fronts[f].children.push_back(frontOf[c]);
      std::sort(fronts[f].children.begin(), fronts[f].children.end());
      s = {};
    }
    return fronts;
  }

  const Job& job_;
  const NodeGraph& graph_;
  const std::vector<uint32_t>& order_;
  std::vector<uint32_t> positionOf_, stamp_;
  std::vector<Supernode> supernodes_;
};

}  // namespace

std::vector<FrontNodes> buildFrontTree(const NodeGraph& graph, const std::vector<uint32_t>& order,
                                       const Job& job) {
  return TreeBuilder(graph, order, job).run();
}

}  // namespace limber
