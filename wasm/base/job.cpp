#include "base/job.h"

#include <algorithm>

namespace limber {

void Job::reset() {
  for (auto& word : words) word.store(0, std::memory_order_relaxed);
  observedPercent_ = -1;
  depth_ = 0;
}

void Job::enter(Phase phase) {
  begin(phase);
  ++depth_;
}

void Job::begin(Phase phase) {
  if (depth_ > 0) return check();
  words[1].store(static_cast<int32_t>(phase), std::memory_order_relaxed);
  observedPercent_ = -1;
  report(0);
}

void Job::report(double fraction) {
  if (depth_ > 0) return check();
  reportWhole(fraction);
}

void Job::reportWhole(double fraction) {
  const double clamped = std::clamp(fraction, 0.0, 1.0);
  words[2].store(static_cast<int32_t>(clamped * 10000), std::memory_order_relaxed);
  const auto percent = static_cast<int32_t>(clamped * 100);
  if (observer && percent != observedPercent_) {
    observedPercent_ = percent;
    observer(static_cast<Phase>(words[1].load(std::memory_order_relaxed)), clamped);
  }
  check();
}

}  // namespace limber
