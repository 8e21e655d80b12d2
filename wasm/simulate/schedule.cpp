#include "simulate/schedule.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

#include "base/parallel.h"

namespace limber {

namespace {

// All chunks of all repeats have one number, in the order of their stages. Threads take the next number, and
// start it once every chunk of earlier stages has ended. So nobody is waited for who has not begun: any
// number of threads, at any time, gets through.
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
    for (uint64_t number = taken_++; number < total_ && !abandoned_; number = taken_++) {
      const uint64_t repeat = number / chunks_.size();
      const Chunk& chunk = chunks_[number % chunks_.size()];
      if (!waitFor(repeat * chunks_.size() + chunk.stageStart)) return;
      stages_[chunk.stage].body(chunk.begin, chunk.end, static_cast<int>(repeat));
      ended_.fetch_add(1, std::memory_order_release);
      if (chunk.begin == 0 && job_.cancelRequested()) abandoned_ = true;
    }
  }

 private:
  struct Chunk {
    size_t stage, begin, end;
    uint32_t stageStart;  // number of the stage's first chunk within a repeat
  };

  bool waitFor(uint64_t ended) const {
    for (int spins = 0; ended_.load(std::memory_order_acquire) < ended; ++spins) {
      if (abandoned_) return false;
      if (spins > 20000) std::this_thread::yield();
    }
    return true;
  }

  std::span<const Stage> stages_;
  const Job& job_;
  std::vector<Chunk> chunks_;
  uint64_t total_ = 0;
  std::atomic<uint64_t> taken_ = 0, ended_ = 0;
  std::atomic<bool> abandoned_ = false;
};

}  // namespace

void runStages(std::span<const Stage> stages, int repeats, bool threaded, const Job& job) {
  if (threaded && threadCount() > 1) {
    Chunks chunks(stages, repeats, job);
    parallelFor(static_cast<size_t>(threadCount()), 1, [&](size_t, size_t) { chunks.work(); });
    job.check();
    return;
  }
  for (int repeat = 0; repeat < repeats; ++repeat) {
    job.check();
    for (const Stage& stage : stages)
      if (stage.count) stage.body(0, stage.count, repeat);
  }
}

}  // namespace limber
