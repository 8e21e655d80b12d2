#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <stdexcept>

namespace limber {

// What a long call is doing. web/engine/core/core.ts has the names that users read, in the same order.
enum class Phase : int32_t {
  Idle = 0,
  Weld = 1,
  Assemble = 2,
  Factorise = 3,
  Solve = 4,
  Strain = 5,
  Curvature = 6,
  Simplify = 7,
  Measure = 8,
  Compare = 9,
  Fit = 10,
  Simulate = 11,
  Mirror = 12,
};

// Thrown by a running call after another thread has requested that it stops.
struct Cancelled : std::runtime_error {
  Cancelled() : std::runtime_error("The calculation was cancelled.") {}
};

// Progress and cancellation of one running call; other threads may use both while the call runs. The four
// words lie in one block so that a page can read them from shared memory: [0] whether to cancel (0 or 1), [1]
// phase, [2] progress in 1/10,000 of the phase, [3] unused.
class Job {
 public:
  Job() = default;
  // A part of another running call, which must outlive it: it is cancelled with that call, and its phases and
  // progress are not shown.
  explicit Job(const Job& whole) : whole_(&whole) {}

  std::atomic<int32_t> words[4] = {};

  // Called on the thread of the running call whenever the phase or the whole percent changes. For builds
  // without shared memory.
  std::function<void(Phase, double fraction)> observer;

  void reset();
  void requestCancel() { words[0].store(1, std::memory_order_relaxed); }
  bool cancelRequested() const {
    return words[0].load(std::memory_order_relaxed) != 0 || (whole_ && whole_->cancelRequested());
  }

  // Starts a phase at progress 0. Throws Cancelled.
  void begin(Phase phase);
  // Sets the progress of the phase, `fraction` in [0, 1]. To be called at least every 50 ms by the thread
  // that runs the call; pool threads call `check`. Throws Cancelled.
  void report(double fraction);
  // Starts a phase and hides the phases and progress of all calls until `leave`; only `reportWhole` is shown.
  // For a call that is made of many calls with phases of their own, see WholePhase. Throws Cancelled.
  void enter(Phase phase);
  void leave() { --depth_; }
  void reportWhole(double fraction);
  // Throws Cancelled if cancellation was requested. Cheap, and safe from any thread.
  void check() const {
    if (cancelRequested()) throw Cancelled();
  }

 private:
  const Job* whole_ = nullptr;
  int32_t observedPercent_ = -1;
  int32_t depth_ = 0;  // of nested calls of `enter`
};

// Shows one phase during its lifetime, whatever is called meanwhile.
class WholePhase {
 public:
  WholePhase(Job& job, Phase phase) : job_(job) { job_.enter(phase); }
  ~WholePhase() { job_.leave(); }
  WholePhase(const WholePhase&) = delete;
  // `fraction` of the whole, in [0, 1]. Throws Cancelled.
  void report(double fraction) { job_.reportWhole(fraction); }

 private:
  Job& job_;
};

}  // namespace limber
