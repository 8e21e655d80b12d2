#include "linear/ordering/maximum_flow.h"

#include <algorithm>

namespace limber {

namespace {

constexpr uint32_t kNone = UINT32_MAX;

}  // namespace

MaximumFlow::MaximumFlow(uint32_t nodeCount)
    : first_(nodeCount, kNone), level_(nodeCount), current_(nodeCount) {}

void MaximumFlow::connect(uint32_t from, uint32_t to, int64_t capacity) {
  arcs_.push_back({to, first_[from], capacity});
  first_[from] = static_cast<uint32_t>(arcs_.size() - 1);
  arcs_.push_back({from, first_[to], 0});
  first_[to] = static_cast<uint32_t>(arcs_.size() - 1);
}

void MaximumFlow::run(uint32_t source, uint32_t sink) {
  while (setLevels(source, sink)) {
    current_ = first_;
    while (augment(source, sink)) {
    }
  }
}

// Breadth-first distances from the source along arcs with residual capacity. Returns false once the sink is
// cut off.
bool MaximumFlow::setLevels(uint32_t source, uint32_t sink) {
  std::fill(level_.begin(), level_.end(), kNone);
  queue_.assign(1, source);
  level_[source] = 0;
  for (size_t head = 0; head < queue_.size() && level_[sink] == kNone; ++head)
    for (uint32_t a = first_[queue_[head]]; a != kNone; a = arcs_[a].next)
      if (arcs_[a].residual > 0 && level_[arcs_[a].to] == kNone) {
        level_[arcs_[a].to] = level_[queue_[head]] + 1;
        queue_.push_back(arcs_[a].to);
      }
  return level_[sink] != kNone;
}

// Sends as much as fits along one shortest path. Returns false if there is none.
bool MaximumFlow::augment(uint32_t source, uint32_t sink) {
  path_.clear();
  uint32_t at = source;
  while (at != sink) {
    uint32_t& a = current_[at];
    while (a != kNone && (arcs_[a].residual == 0 || level_[arcs_[a].to] != level_[at] + 1)) a = arcs_[a].next;
    if (a != kNone) {
      path_.push_back(a);
      at = arcs_[a].to;
      continue;
    }
    if (path_.empty()) return false;
    level_[at] = kNone;  // a dead end
    at = arcs_[path_.back() ^ 1].to;
    path_.pop_back();
  }
  int64_t amount = kUnlimited;
  for (uint32_t a : path_) amount = std::min(amount, arcs_[a].residual);
  for (uint32_t a : path_) {
    arcs_[a].residual -= amount;
    arcs_[a ^ 1].residual += amount;
  }
  return true;
}

std::vector<uint8_t> MaximumFlow::residualSet(uint32_t from, uint32_t against) const {
  std::vector<uint8_t> isReached(first_.size(), 0);
  std::vector<uint32_t> stack = {from};
  isReached[from] = 1;
  while (!stack.empty()) {
    const uint32_t at = stack.back();
    stack.pop_back();
    for (uint32_t a = first_[at]; a != kNone; a = arcs_[a].next)
      if (arcs_[a ^ against].residual > 0 && !isReached[arcs_[a].to]) {
        isReached[arcs_[a].to] = 1;
        stack.push_back(arcs_[a].to);
      }
  }
  return isReached;
}

}  // namespace limber
