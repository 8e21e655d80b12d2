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

// Waiting this many loads is some ten microseconds: far more than threads on cores of their own need.
constexpr int kSpins = 5000;
constexpr std::chrono::microseconds kNap(50);
// A thread that has had to nap so often leaves: somebody else needs the cores.
constexpr int kPatience = 3;

// All chunks of all repeats have one number, in the order of their stages. Threads take the next number, and
// start it once every chunk of earlier stages has ended. So nobody is waited for who has not begun: any
// number of threads, at any time, gets through, and each but the last may leave.
class Chunks {
 public:
  Chunks(std::span<const Stage> stages, int repeats, const Job& job) : stages_(stages), job_(job) {
    for (size_t stage = 0; stage < stages.size(); ++stage) {
      const auto first = static_cast<uint32_t>(chunks_.size());
      for (size_t begin = 0; begin < stages[stage].count; begin += stages[stage].grain)
        chunks_.push_back({stage, begin, std::min(begin + stages[stage].grain, stages[stage].count), first});
    }
    total_ = static_cast<uint64_t>(repeats) * chunks_.size();
  }

  void work() {
    ++members_;
    int patience = kPatience;
    while (!abandoned_ && !(patience < 0 && leave())) {
      const uint64_t number = taken_++;
      if (number >= total_) break;
      const uint64_t repeat = number / chunks_.size();
      const Chunk& chunk = chunks_[number % chunks_.size()];
      patience -= waitFor(repeat * chunks_.size() + chunk.stageStart);
      if (abandoned_) break;
      stages_[chunk.stage].body(chunk.begin, chunk.end, static_cast<int>(repeat));
      ended_.fetch_add(1, std::memory_order_release);
      if (chunk.begin == 0 && job_.cancelRequested()) abandoned_ = true;
    }
  }

  bool somebodyLeft() const { return somebodyLeft_; }

 private:
  struct Chunk {
    size_t stage, begin, end;
    uint32_t stageStart;  // number of the stage's first chunk within a repeat
  };

  // Returns how often it has napped.
  int waitFor(uint64_t ended) const {
    int naps = 0;
    for (int spins = 0; ended_.load(std::memory_order_acquire) < ended && !abandoned_; ++spins) {
      if (spins < kSpins) continue;
      std::this_thread::sleep_for(kNap);
      ++naps;
    }
    return naps;
  }

  // False for the last one, who must stay.
  bool leave() {
    int members = members_;
    while (members > 1)
      if (members_.compare_exchange_weak(members, members - 1)) {
        somebodyLeft_ = true;
        return true;
      }
    return false;
  }

  std::span<const Stage> stages_;
  const Job& job_;
  std::vector<Chunk> chunks_;
  uint64_t total_ = 0;
  std::atomic<uint64_t> taken_ = 0, ended_ = 0;
  std::atomic<int> members_ = 0;
  std::atomic<bool> abandoned_ = false, somebodyLeft_ = false;
};

}  // namespace

bool runStages(std::span<const Stage> stages, int repeats, bool threaded, const Job& job) {
  if (threaded && threadCount() > 1) {
    Chunks chunks(stages, repeats, job);
    parallelFor(static_cast<size_t>(threadCount()), 1, [&](size_t, size_t) { chunks.work(); });
    job.check();
    return !chunks.somebodyLeft();
  }
  for (int repeat = 0; repeat < repeats; ++repeat) {
    job.check();
    for (const Stage& stage : stages)
      if (stage.count) stage.body(0, stage.count, repeat);
  }
  return true;
}

}  // namespace limber
