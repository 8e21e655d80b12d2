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

// Loads between two looks at the clock; each takes a nanosecond or less.
constexpr int kSpins = 2000;
// After so much waiting, for a long stage or for a thread that has lost its core, a thread naps.
constexpr std::chrono::microseconds kSpinning(300), kNap(50);

// Every chunk of every stage is claimed once per repeat, so nobody is waited for who has not begun: any
// number of threads, at any time, gets through.
class Chunks {
 public:
  Chunks(std::span<const Stage> stages, int repeats, const Job& job)
      : stages_(stages), job_(job), repeats_(repeats), threads_(static_cast<size_t>(threadCount())) {
    for (const Stage& stage : stages) {
      starts_.push_back(total_);
      total_ += (stage.count + stage.grain - 1) / stage.grain;
    }
    claims_ = std::vector<std::atomic<int>>(total_);
  }

  void work(size_t thread) {
    for (int repeat = 0; repeat < repeats_; ++repeat)
      for (size_t s = 0; s < stages_.size() && !abandoned_; ++s) {
        const uint64_t all = static_cast<uint64_t>(repeat) * total_ + starts_[s] + chunksOf(s);
        if (ended_.load(std::memory_order_acquire) >= all) continue;
        if (const uint64_t done = workOn(s, repeat, thread))
          ended_.fetch_add(done, std::memory_order_release);
        if (job_.cancelRequested()) abandoned_ = true;
        waitFor(all);
      }
  }

 private:
  size_t chunksOf(size_t s) const { return (s + 1 < stages_.size() ? starts_[s + 1] : total_) - starts_[s]; }

  // Own chunks first, then those that others have not begun, from where these are last to come. Returns how
  // many it has done.
  uint64_t workOn(size_t s, int repeat, size_t thread) {
    const size_t count = chunksOf(s);
    const size_t first = count * thread / threads_, own = count * (thread + 1) / threads_ - first;
    uint64_t done = 0;
    for (size_t i = 0; i < count && !abandoned_; ++i) {
      const size_t chunk = i < own ? first + i : (first + own + count - 1 - i) % count;
      done += claimAndRun(s, chunk, repeat);
    }
    return done;
  }

  // 1 if it has been run, 0 if somebody else has it.
  uint64_t claimAndRun(size_t s, size_t chunk, int repeat) {
    std::atomic<int>& claims = claims_[starts_[s] + chunk];
    int expected = repeat;
    if (claims.load(std::memory_order_relaxed) != repeat ||
        !claims.compare_exchange_strong(expected, repeat + 1, std::memory_order_relaxed))
      return 0;
    const Stage& stage = stages_[s];
    const size_t begin = chunk * stage.grain;
    stage.body(begin, std::min(begin + stage.grain, stage.count), repeat);
    return 1;
  }

  // Until so many chunks have ended.
  void waitFor(uint64_t ended) const {
    const auto hasEnded = [&] { return ended_.load(std::memory_order_acquire) >= ended || abandoned_; };
    for (int spins = 0; spins < kSpins; ++spins)
      if (hasEnded()) return;
    const auto start = Clock::now();
    while (!hasEnded())
      if (Clock::now() - start > kSpinning) std::this_thread::sleep_for(kNap);
  }

  std::span<const Stage> stages_;
  const Job& job_;
  const int repeats_;
  const size_t threads_;
  std::vector<size_t> starts_;            // number of each stage's first chunk
  uint64_t total_ = 0;                    // chunks of a repeat
  std::vector<std::atomic<int>> claims_;  // repeats in which each chunk has been claimed
  alignas(64) std::atomic<uint64_t> ended_ = 0;
  std::atomic<bool> abandoned_ = false;
};

}  // namespace

void runStages(std::span<const Stage> stages, int repeats, bool threaded, const Job& job) {
  if (threaded && threadCount() > 1) {
    Chunks chunks(stages, repeats, job);
    parallelFor(static_cast<size_t>(threadCount()), 1, [&](size_t thread, size_t) { chunks.work(thread); });
    job.check();
    return;
  }
  for (int repeat = 0; repeat < repeats; ++repeat) {
    job.check();
    for (const Stage& stage : stages)
      if (stage.count) stage.body(0, stage.count, repeat);
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
