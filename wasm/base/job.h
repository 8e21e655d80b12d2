#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <stdexcept>

namespace limber {

// The phase of a long call. web/engine/core/core.ts lists the names that users read, in the same order.
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

// Thrown by a running call after another thread has requested cancellation.
struct Cancelled : std::runtime_error {
  Cancelled() : std::runtime_error("The calculation was cancelled.") {}
};

// Progress and cancellation of one running call; other threads may use both while the call runs. The four
// words are contiguous so that a page can read them from shared memory: [0] whether to cancel (0 or 1), [1]
// phase, [2] progress in 1/10,000 of the phase, [3] unused.
class Job {
 public:
  Job() = default;
  // A part of another running call, which must outlive it: it is cancelled with that call, and its own phases
  // and progress are not shown.
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
  // Sets the progress of the phase, `fraction` in [0, 1]. The thread that runs the call must call this at
  // least every 50 ms; pool threads call `check` instead. Throws Cancelled.
  void report(double fraction);
  // Starts a phase and hides the phases and progress of all calls until `leave`; only `reportWhole` is shown.
  // For a call that consists of many calls with phases of their own; see WholePhase. Throws Cancelled.
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
  int32_t depth_ = 0;  // nesting depth of `enter`
};

// Shows one phase during its lifetime and hides the phases of nested calls.
class WholePhase {
 public:
  WholePhase(Job& job, Phase phase) : job_(job) { job_.enter(phase); }
  ~WholePhase() { job_.leave(); }
  WholePhase(const WholePhase&) = delete;
  // `fraction`: progress of the whole call, in [0, 1]. Throws Cancelled.
  void report(double fraction) { job_.reportWhole(fraction); }

 private:
  Job& job_;
};

}  // namespace limber
