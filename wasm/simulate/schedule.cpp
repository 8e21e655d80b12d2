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

// Loads between two looks at the clock; each takes a nanosecond or less.
constexpr int kSpins = 2000;
// After so much waiting, for a long stage or for a thread that has lost its core, a thread naps.
constexpr std::chrono::microseconds kSpinning(300), kNap(50);

// Every chunk of every stage is claimed once per repeat, so nobody is waited for who has not begun: any
// number of threads, at any time, gets through.
class Chunks {
 public:
  Chunks(const Schedule& schedule, const Job& job)
      : schedule_(schedule), job_(job), threads_(static_cast<size_t>(threadCount())) {
    for (const auto* stages : {&schedule.before, &schedule.repeated, &schedule.after})
      for (const Stage& stage : *stages) chunkCount_ += chunksOf(stage);
    claims_ = std::vector<std::atomic<int>>(chunkCount_);
  }

  // Returns the seconds that it has waited for other threads.
  double work(size_t thread) {
    Place place = {thread, 0, 0, 0};
    workThrough(schedule_.before, 1, place);
    workThrough(schedule_.repeated, schedule_.repeats, place);
    workThrough(schedule_.after, 1, place);
    return place.waited;
  }

 private:
  // Where a thread is: its number, the number of the stage's first chunk, and the chunks that have ended once
  // all stages up to here have.
  struct Place {
    size_t thread, firstChunk;
    uint64_t ended;
    double waited;  // seconds
  };
  static size_t chunksOf(const Stage& stage) { return (stage.count + stage.grain - 1) / stage.grain; }

  void workThrough(const std::vector<Stage>& stages, int repeats, Place& place) {
    const size_t first = place.firstChunk;
    for (int repeat = 0; repeat < repeats; ++repeat) {
      place.firstChunk = first;
      for (const Stage& stage : stages) {
        if (abandoned_) return;
        place.ended += chunksOf(stage);
        if (ended_.load(std::memory_order_acquire) < place.ended) {
          if (const uint64_t done = workOn(stage, repeat, place))
            ended_.fetch_add(done, std::memory_order_release);
          if (job_.cancelRequested()) abandoned_ = true;
          place.waited += waitFor(place.ended);
        }
        place.firstChunk += chunksOf(stage);
      }
    }
  }

  // Own chunks first, then those that others have not begun, from where these are last to come. Returns how
  // many it has done.
  uint64_t workOn(const Stage& stage, int repeat, const Place& place) {
    const size_t count = chunksOf(stage);
    const size_t first = count * place.thread / threads_, own = count * (place.thread + 1) / threads_ - first;
    uint64_t done = 0;
    for (size_t i = 0; i < count && !abandoned_; ++i) {
      const size_t chunk = i < own ? first + i : (first + own + count - 1 - i) % count;
      if (!claim(place.firstChunk + chunk, repeat)) continue;
      const size_t begin = chunk * stage.grain;
      stage.body(begin, std::min(begin + stage.grain, stage.count), repeat);
      ++done;
    }
    return done;
  }

  // False where somebody else has it.
  bool claim(size_t chunk, int repeat) {
    std::atomic<int>& claims = claims_[chunk];
    int expected = repeat;
    return claims.load(std::memory_order_relaxed) == repeat &&
           claims.compare_exchange_strong(expected, repeat + 1, std::memory_order_relaxed);
  }

  // Until so many chunks have ended. Returns the seconds that took.
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
  std::vector<std::atomic<int>> claims_;  // repeats in which each chunk has been claimed
  alignas(64) std::atomic<uint64_t> ended_ = 0;
  alignas(64) std::atomic<bool> abandoned_ = false;
};

void runAlone(const std::vector<Stage>& stages, int repeats, const Job& job) {
  for (int repeat = 0; repeat < repeats; ++repeat) {
    job.check();
    for (const Stage& stage : stages)
      if (stage.count) stage.body(0, stage.count, repeat);
  }
}

}  // namespace

void runStages(const Schedule& schedule, bool threaded, const Job& job) {
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
  size_t inside = 0;   // helpers
  double seconds = 0;  // of theirs
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

void ThreadChoice::tell(double seconds) {
  const bool told = threaded();
  double &own = seconds_[told], other = seconds_[!told];
  own = own > 0 && !isTrial_ ? 0.5 * (own + seconds) : seconds;
  if (!isTrial_) {
    --stepsToTrial_;
    isTrial_ = stepsToTrial_ <= 0 || (other > 0 && own > kSlower * other);
    return;
  }
  const bool isBetter = own < other;
  usual_ = isBetter ? told : usual_;
  interval_ = isBetter ? kFirstInterval : std::min(2 * interval_, kLongestInterval);
  stepsToTrial_ = interval_;
  isTrial_ = false;
}

}  // namespace limber
