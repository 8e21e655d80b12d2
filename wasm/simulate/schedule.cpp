#include "simulate/schedule.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <thread>
#include <vector>

#include "base/parallel.h"

namespace limber {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// The number of checks of a waiting thread before it first reads the clock; a check takes a nanosecond or
// less.
constexpr int kSpins = 2000;
// A thread that has waited this long (for a long phase, or for a thread that has lost its core) starts to
// sleep.
constexpr std::chrono::microseconds kSpinning(300), kNap(50);

// The chunks of all phases of a schedule. Every chunk is claimed once per repeat, and no thread waits for an
// unclaimed chunk, so any number of threads can join at any time, and the schedule always ends.
class Chunks {
 public:
  Chunks(const Schedule& schedule, const Job& job)
      : schedule_(schedule), job_(job), threads_(static_cast<size_t>(threadCount())) {
    for (const auto* phases : {&schedule.before, &schedule.repeated, &schedule.after})
      for (const SolverPhase& phase : *phases) chunkCount_ += chunksOf(phase);
    claims_ = std::vector<std::atomic<int>>(chunkCount_);
  }

  // Works through the schedule as thread number `thread`. Returns the seconds spent waiting for other
  // threads.
  double work(size_t thread) {
    Cursor cursor = {thread, 0, 0, 0};
    workThrough(schedule_.before, 1, cursor);
    workThrough(schedule_.repeated, schedule_.repeats, cursor);
    workThrough(schedule_.after, 1, cursor);
    return cursor.waited;
  }

 private:
  // The position of a thread in the schedule: `firstChunk` is the index of the first chunk of its phase, and
  // `ended` is the number of chunks that have ended once all phases up to this one have.
  struct Cursor {
    size_t thread, firstChunk;
    uint64_t ended;
    double waited;  // seconds
  };
  static size_t chunksOf(const SolverPhase& phase) { return (phase.count + phase.grain - 1) / phase.grain; }

  void workThrough(const std::vector<SolverPhase>& phases, int repeats, Cursor& cursor) {
    const size_t first = cursor.firstChunk;
    for (int repeat = 0; repeat < repeats; ++repeat) {
      cursor.firstChunk = first;
      for (const SolverPhase& phase : phases) {
        if (abandoned_) return;
        cursor.ended += chunksOf(phase);
        if (ended_.load(std::memory_order_acquire) < cursor.ended) {
          if (const uint64_t done = workOn(phase, repeat, cursor))
            ended_.fetch_add(done, std::memory_order_release);
          if (job_.cancelRequested()) abandoned_ = true;
          cursor.waited += waitFor(cursor.ended);
        }
        cursor.firstChunk += chunksOf(phase);
      }
    }
  }

  // Takes the chunks of this thread first, then those that other threads have not begun, starting with the
  // ones that their owners would reach last. Returns the number of completed chunks.
  uint64_t workOn(const SolverPhase& phase, int repeat, const Cursor& cursor) {
    const size_t count = chunksOf(phase);
    const size_t first = count * cursor.thread / threads_,
                 own = count * (cursor.thread + 1) / threads_ - first;
    uint64_t done = 0;
    for (size_t i = 0; i < count && !abandoned_; ++i) {
      const size_t chunk = i < own ? first + i : (first + own + count - 1 - i) % count;
      if (!claim(cursor.firstChunk + chunk, repeat)) continue;
      const size_t begin = chunk * phase.grain;
      phase.body(begin, std::min(begin + phase.grain, phase.count), repeat);
      ++done;
    }
    return done;
  }

  // Returns false if another thread has claimed the chunk.
  bool claim(size_t chunk, int repeat) {
    std::atomic<int>& claims = claims_[chunk];
    int expected = repeat;
    return claims.load(std::memory_order_relaxed) == repeat &&
           claims.compare_exchange_strong(expected, repeat + 1, std::memory_order_relaxed);
  }

  // Waits until `ended` chunks have ended. Returns the seconds that it has waited.
  double waitFor(uint64_t ended) const {
    const auto hasEnded = [&] { return ended_.load(std::memory_order_acquire) >= ended || abandoned_; };
    if (hasEnded()) return 0;
    const auto start = Clock::now();
    for (int spins = 0; spins < kSpins && !hasEnded();) ++spins;
    while (!hasEnded())
      if (Clock::now() - start > kSpinning) std::this_thread::sleep_for(kNap);
    return secondsSince(start);
  }

  const Schedule& schedule_;
  const Job& job_;
  const size_t threads_;
  size_t chunkCount_ = 0;
  std::vector<std::atomic<int>> claims_;  // per chunk: the number of repeats in which it has been claimed
  alignas(64) std::atomic<uint64_t> ended_ = 0;
  alignas(64) std::atomic<bool> abandoned_ = false;
};

void runAlone(const std::vector<SolverPhase>& phases, int repeats, const Job& job) {
  for (int repeat = 0; repeat < repeats; ++repeat) {
    job.check();
    for (const SolverPhase& phase : phases)
      if (phase.count) phase.body(0, phase.count, repeat);
  }
}

}  // namespace

void runSchedule(const Schedule& schedule, bool threaded, const Job& job) {
  if (threaded && threadCount() > 1) {
    Chunks chunks(schedule, job);
    parallelFor(static_cast<size_t>(threadCount()), 1, [&](size_t thread, size_t) { chunks.work(thread); });
    job.check();
    return;
  }
  runAlone(schedule.before, 1, job);
  runAlone(schedule.repeated, schedule.repeats, job);
  runAlone(schedule.after, 1, job);
}

struct Helpers::Run {
  Chunks& chunks;
  size_t inside = 0;   // helpers at work
  double seconds = 0;  // that helpers have worked
};

double Helpers::run(const Schedule& schedule, const Job& job) {
  Chunks chunks(schedule, job);
  Run run = {chunks};
  {
    const std::lock_guard lock(mutex_);
    runs_.push_back(&run);
  }
  changed_.notify_all();
  const double waited = chunks.work(0);
  {
    std::unique_lock lock(mutex_);
    std::erase(runs_, &run);
    changed_.wait(lock, [&] { return run.inside == 0; });
  }
  job.check();
  return run.seconds - waited;
}

void Helpers::endTask() {
  {
    const std::lock_guard lock(mutex_);
    --tasksLeft_;
  }
  changed_.notify_all();
}

void Helpers::help() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [&] { return tasksLeft_ == 0 || !runs_.empty(); });
    if (tasksLeft_ == 0) return;
    Run& run = **std::min_element(runs_.begin(), runs_.end(),
                                  [](const Run* a, const Run* b) { return a->inside < b->inside; });
    ++run.inside;
    const size_t thread = run.inside % static_cast<size_t>(threadCount());
    lock.unlock();
    const auto start = Clock::now();
    const double waited = run.chunks.work(thread);
    const double seconds = secondsSince(start) - waited;
    lock.lock();
    run.seconds += seconds;
    --run.inside;
    changed_.notify_all();
  }
}

void ThreadChoice::record(double seconds) {
  const bool recorded = threaded();
  double &own = seconds_[recorded], other = seconds_[!recorded];
  own = own > 0 && !isTrial_ ? 0.5 * (own + seconds) : seconds;
  if (!isTrial_) {
    --stepsToTrial_;
    isTrial_ = stepsToTrial_ <= 0 || (other > 0 && own > kSlower * other);
    return;
  }
  const bool isBetter = own < other;
  usual_ = isBetter ? recorded : usual_;
  interval_ = isBetter ? kFirstInterval : std::min(2 * interval_, kLongestInterval);
  stepsToTrial_ = interval_;
  isTrial_ = false;
}

}  // namespace limber
