#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <vector>

#include "base/job.h"

namespace limber {

// A part of a step: items [0, count) that may be processed in parallel, in chunks of `grain` items.
struct SolverPhase {
  size_t count, grain;
  std::function<void(size_t begin, size_t end, int repeat)> body;
};

// A phase that calls run(i, repeat) for each of `count` items.
template <class Run>
SolverPhase phaseOf(size_t count, Run run) {
  return {count, 1, [run](size_t begin, size_t end, int repeat) {
            for (size_t i = begin; i < end; ++i) run(i, repeat);
          }};
}

// All phases of a step: some run once, then some run `repeats` times, then some run once at the end.
struct Schedule {
  std::vector<SolverPhase> before, repeated, after;
  int repeats = 1;
};

// Runs all phases in order; a phase starts when the previous one has ended. `repeat` is 0 before and after.
// With `threaded`, each thread of parallelFor first takes the same share of a phase in every repeat, so that
// its items stay in its cache, and then chunks that other threads have not begun. Between phases threads spin
// instead of sleeping, because a phase lasts only microseconds. Throws Cancelled; a phase may then be only
// partly done. Phase functions must not throw.
void runSchedule(const Schedule& schedule, bool threaded, const Job& job);

// Lets threads that have finished their own work take part in the schedules of other threads. Constructed for
// `taskCount` tasks, each of which must call `endTask` once, also if it fails.
class Helpers {
 public:
  explicit Helpers(size_t taskCount) : tasksLeft_(taskCount) {}

  // Runs a schedule on this thread and on all helpers. Returns an estimate of the seconds that this has
  // saved: the time that helpers worked on it, minus the time that this thread waited for them. Throws
  // Cancelled.
  double run(const Schedule& schedule, const Job& job);
  void endTask();
  // Helps the run with the fewest helpers, until all tasks have ended.
  void help();

 private:
  struct Run;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Run*> runs_;  // not yet finished
  size_t tasksLeft_;
};

// Chooses between one thread and all threads by measured step times: if other programs use the cores, threads
// wait for each other and one thread is faster. The other choice is tried at intervals, more often after it
// has won, and immediately when the current choice becomes slow.
class ThreadChoice {
 public:
  bool threaded() const { return usual_ != isTrial_; }
  // Records the time of a step on the threads that were chosen for it.
  void record(double seconds);

 private:
  static constexpr int kFirstInterval = 2, kLongestInterval = 128;  // steps between trials
  static constexpr double kSlower = 1.2;  // a trial starts when the other choice is faster by this factor

  double seconds_[2] = {0, 0};  // of a step on one thread and on all threads; 0 until known
  bool usual_ = true, isTrial_ = false;
  int interval_ = kFirstInterval, stepsToTrial_ = kFirstInterval;
};

}  // namespace limber
