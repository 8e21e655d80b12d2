#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <stdexcept>

namespace limber {

// What a long call is doing; the names that people read live in web/engine/core/core.ts in the same order.
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

// Thrown out of a running call after somebody asked it to stop.
struct Cancelled : std::runtime_error {
  Cancelled() : std::runtime_error("The calculation was cancelled.") {}
};

// Progress of one running call, and the wish to cancel it. Both may be used from other threads while the call
// runs. The four words lie in one block so that a page can read them from shared memory: [0] cancel wish (0
// or 1), [1] phase, [2] progress in 1/10,000 of the phase, [3] unused.
class Job {
 public:
  std::atomic<int32_t> words[4] = {};

  // Called on the calling thread whenever the phase or the whole percent changes; for builds without shared
  // memory.
  std::function<void(Phase, double fraction)> observer;

  void reset();
  void requestCancel() { words[0].store(1, std::memory_order_relaxed); }
  bool cancelRequested() const { return words[0].load(std::memory_order_relaxed) != 0; }

  // Starts a phase at progress 0. Throws Cancelled.
  void begin(Phase phase);
  // Sets the progress of the phase, `fraction` in [0, 1]. Throws Cancelled. Call it at least every 50 ms of
  // work, from the thread that runs the call; pool threads use `check`.
  void report(double fraction);
  // From now on phases and progress within are not shown, until `leave`: for a call made of many that tell
  // their own. Only `reportWhole` shows. See WholePhase.
  void enter(Phase phase);
  void leave() { --depth_; }
  void reportWhole(double fraction);
  // Throws Cancelled if somebody asked to stop. Cheap, and safe from any thread.
  void check() const {
    if (cancelRequested()) throw Cancelled();
  }

 private:
  int32_t observedPercent_ = -1;
  int32_t depth_ = 0;
};

// One phase for as long as it lives, whatever is called meanwhile.
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
