#include "linear/ordering/front_tree.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace limber {

namespace {

constexpr uint32_t kNone = UINT32_MAX;
constexpr uint32_t kCheckInterval = 4096;  // positions between two checks for cancellation

// A merged front of at most `pivots` unknowns may store less than this share of zeros. The larger the front,
// the smaller the share, because the overhead of one more front is constant while the cost of its zeros
// grows. The scheme is that of CHOLMOD's relaxed supernodes (Chen et al. 2008).
struct MergeRule {
  uint64_t pivots;
  double zeroShare;
};
constexpr MergeRule kMergeRules[] = {{8, HUGE_VAL}, {16, 0.3}, {64, 0.08}, {UINT64_MAX, 0.03}};

// A supernode while the tree is built. Weights count unknowns.
struct Supernode {
  std::vector<uint32_t> pivots, boundary;  // positions in the elimination order
  std::vector<uint32_t> children;
  uint64_t pivotWeight = 0, boundaryWeight = 0;
  uint64_t zeros = 0;  // zeros added by merging
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

  // The later positions that position p is coupled to when it is eliminated, unsorted.
  std::vector<uint32_t> structure(uint32_t p, const std::vector<uint32_t>& children) {
    rows_.clear();
    stamp_[p] = p;
    const auto add = [&](uint32_t q) {
      if (q <= p || stamp_[q] == p) return;
      stamp_[q] = p;
      rows_.push_back(q);
    };
    for (uint32_t j : graph_.around(order_[p])) add(positionOf_[j]);
    for (uint32_t child : children)
      for (uint32_t q : supernodes_[child].boundary) add(q);
    return {rows_.begin(), rows_.end()};
  }

  // Fundamental supernodes: a position joins a child whose structure it continues.
  void findSupernodes() {
    std::vector<std::vector<uint32_t>> waiting(order_.size());  // supernodes whose parent is this position
    for (uint32_t p = 0; p < order_.size(); ++p) {
      if (p % kCheckInterval == 0) job_.check();
      const uint32_t s = assign(p, waiting[p]);
      waiting[p] = {};
      const auto& boundary = supernodes_[s].boundary;
      if (!boundary.empty()) waiting[*std::min_element(boundary.begin(), boundary.end())].push_back(s);
    }
    for (Supernode& s : supernodes_)
      for (uint32_t p : s.boundary) s.boundaryWeight += weight(p);
  }

  // Adds position p to one of its children or to a new supernode, and returns the supernode.
  uint32_t assign(uint32_t p, std::vector<uint32_t>& children) {
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

  static bool isWorthwhile(uint64_t pivots, uint64_t entries, uint64_t zeros) {
    const double share = static_cast<double>(zeros) / static_cast<double>(entries);
    return std::any_of(std::begin(kMergeRules), std::end(kMergeRules), [&](const MergeRule& rule) {
      return pivots <= rule.pivots && share < rule.zeroShare;
    });
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
  std::vector<uint32_t> rows_;  // of the structure being computed
  std::vector<Supernode> supernodes_;
};

}  // namespace

std::vector<FrontNodes> buildFrontTree(const NodeGraph& graph, const std::vector<uint32_t>& order,
                                       const Job& job) {
  return TreeBuilder(graph, order, job).run();
}

}  // namespace limber
