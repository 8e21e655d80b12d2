#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <vector>

#include "base/job.h"

namespace limber {

// A part of a step: items [0, count) that may be worked on at the same time, in chunks of `grain`.
struct Stage {
  size_t count, grain;
  std::function<void(size_t begin, size_t end, int repeat)> body;
};

// What a step consists of: stages that run once, stages that run `repeats` times over, and stages that run
// once at the end.
struct Schedule {
  std::vector<Stage> before, repeated, after;
  int repeats = 1;
};

// Runs all stages in order; a stage starts when all of the one before has ended. `repeat` is 0 before and
// after. With `threaded`, each thread of parallelFor takes the same share of a stage in every repeat, so that
// it finds its items in its own cache, then what others have not begun; between stages they spin, for stages
// of some microseconds would not pay for sleeping threads. Throws Cancelled, with the stages left at some
// chunk in between. Bodies must not throw.
void runStages(const Schedule& schedule, bool threaded, const Job& job);

// Lets threads that have nothing left of their own take part in what others run. Made for `taskCount` tasks;
// each calls `endTask` once, however it ends.
class Helpers {
 public:
  explicit Helpers(size_t taskCount) : tasksLeft_(taskCount) {}

  // Runs a schedule on this thread and on all that help meanwhile. Returns the seconds that these have worked
  // on it, less those that this thread has waited for them: what it would have taken alone, roughly, less
  // what it has. Throws Cancelled.
  double run(const Schedule& schedule, const Job& job);
  void endTask();
  // Helps whatever run has the fewest helpers, until all tasks have ended.
  void help();

 private:
  struct Run;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Run*> runs_;  // open ones
  size_t tasksLeft_;
};

// Chooses between one thread and all by what steps take: where other programs use the cores, threads wait for
// each other, and one is faster. The other choice is tried now and then, more often after it has won, and at
// once when the usual one becomes slow.
class ThreadChoice {
 public:
  bool threaded() const { return usual_ != isTrial_; }
  // What a step took on the threads that were chosen for it.
  void tell(double seconds);

 private:
  static constexpr int kFirstInterval = 2, kLongestInterval = 128;  // steps between trials
  static constexpr double kSlower = 1.2;                            // calls for a trial

  double seconds_[2] = {0, 0};  // of a step, on one thread and on all; 0 until known
  bool usual_ = true, isTrial_ = false;
  int interval_ = kFirstInterval, stepsToTrial_ = kFirstInterval;
};

}  // namespace limber
