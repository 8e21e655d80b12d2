#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "base/job.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "base/parallel_jobs.h"

namespace limber {
namespace {

std::vector<double> squares(int threads) {
  setThreadCount(threads);
  std::vector<double> out(1000);
  parallelFor(out.size(), 7, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) out[i] = static_cast<double>(i) * static_cast<double>(i);
  });
  setThreadCount(1);
  return out;
}

TEST(ParallelFor, visitsEveryItemOnceForAnyNumberOfThreads) {
  const auto expected = squares(1);
  EXPECT_EQ(expected[31], 961);
  for (int threads : {2, 3, 4}) EXPECT_EQ(squares(threads), expected);
}

TEST(ParallelFor, rethrowsTheErrorOfTheFirstRange) {
  for (int threads : {1, 4}) {
    setThreadCount(threads);
    std::string message;
    try {
      parallelFor(100, 10, [](size_t begin, size_t) {
        if (begin >= 30) throw std::runtime_error("range " + std::to_string(begin));
      });
    } catch (const std::runtime_error& error) {
      message = error.what();
    }
    EXPECT_EQ(message, "range 30");
  }
  setThreadCount(1);
}

// Counts 20 x 50 items by loops within a loop.
std::vector<int> innerSums() {
  std::vector<int> sums(20);
  parallelFor(sums.size(), 1, [&](size_t begin, size_t) {
    std::vector<int> ones(50);
    parallelFor(ones.size(), 5, [&](size_t b, size_t e) {
      for (size_t i = b; i < e; ++i) ones[i] = 1;
    });
    sums[begin] = std::accumulate(ones.begin(), ones.end(), 0);
  });
  return sums;
}

TEST(ParallelFor, innerLoopsEndBeforeTheirCallersGoOn) {
  for (int threads : {1, 2, 3, 5}) {
    setThreadCount(threads);
    for (int round = 0; round < 200; ++round) EXPECT_EQ(innerSums(), std::vector<int>(20, 50));
  }
  setThreadCount(1);
}

#if LIMBER_THREADS
// Records the threads that call it.
class Visitors {
 public:
  void enter() {
    const std::lock_guard lock(mutex_);
    threads_.insert(std::this_thread::get_id());
  }
  size_t count() const {
    const std::lock_guard lock(mutex_);
    return threads_.size();
  }

 private:
  mutable std::mutex mutex_;
  std::set<std::thread::id> threads_;
};

TEST(ParallelFor, aThreadWithNothingLeftToDoHelpsInInnerLoops) {
  setThreadCount(2);
  Visitors visitors;
  const auto start = std::chrono::steady_clock::now();
  const auto isLate = [&] { return std::chrono::steady_clock::now() - start > std::chrono::seconds(20); };
  // One of two outer ranges ends at once; the other begins inner loops until another thread helps.
  parallelFor(2, 1, [&](size_t outer, size_t) {
    while (outer == 1 && visitors.count() < 2 && !isLate())
      parallelFor(100, 1, [&](size_t, size_t) { visitors.enter(); });
  });
  setThreadCount(1);
  EXPECT_EQ(visitors.count(), 2);
}

TEST(ParallelFor, aThreadHelpsInALoopThatBeganWhileItWasBusy) {
  setThreadCount(2);
  Visitors visitors;
  std::atomic<bool> isBusy = false;
  const auto start = std::chrono::steady_clock::now();
  const auto waitFor = [&](const auto& condition) {
    while (!condition() && std::chrono::steady_clock::now() - start < std::chrono::seconds(20))
      std::this_thread::yield();
  };
  // One of two outer ranges begins a long inner loop, while the other keeps its thread busy and then ends.
  parallelFor(2, 1, [&](size_t outer, size_t) {
    if (outer == 1) {
      isBusy = true;
      return waitFor([&] { return visitors.count() > 0; });
    }
    waitFor([&] { return isBusy.load(); });
    parallelFor(2000, 1, [&](size_t, size_t) {
      visitors.enter();
      if (visitors.count() < 2) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    });
  });
  setThreadCount(1);
  EXPECT_EQ(visitors.count(), 2);
}
#endif

TEST(ParallelFor, rethrowsAnInnerErrorThroughTheOuterLoop) {
  setThreadCount(3);
  try {
    parallelFor(4, 1, [](size_t outer, size_t) {
      parallelFor(8, 1, [&](size_t inner, size_t) {
        if (outer == 2 && inner >= 3) throw std::runtime_error("range " + std::to_string(inner));
      });
    });
    ADD_FAILURE() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "range 3");
  }
  setThreadCount(1);
}

TEST(ThreadCount, refusesLessThanOne) {
  EXPECT_THROW(setThreadCount(0), std::invalid_argument);
}

TEST(Job, throwsOnceCancelledAndStartsAfreshAfterReset) {
  Job job;
  job.begin(Phase::Solve);
  job.report(0.25);
  EXPECT_EQ(job.words[1].load(), static_cast<int32_t>(Phase::Solve));
  EXPECT_EQ(job.words[2].load(), 2500);
  job.requestCancel();
  EXPECT_THROW(job.check(), Cancelled);
  EXPECT_THROW(job.report(0.5), Cancelled);
  job.reset();
  EXPECT_NO_THROW(job.report(0.5));
}

TEST(Job, isCancelledWithTheCallThatItIsAPartOf) {
  Job whole;
  Job part(whole);
  part.begin(Phase::Solve);
  EXPECT_EQ(whole.words[1].load(), static_cast<int32_t>(Phase::Idle));
  EXPECT_NO_THROW(part.check());
  whole.requestCancel();
  EXPECT_THROW(part.check(), Cancelled);
}

TEST(ParallelJobs, runsEveryItemAndShowsTheShareThatHasEnded) {
  for (const int threads : {1, 3}) {
    setThreadCount(threads);
    Job whole;
    std::vector<size_t> ended(100);
    parallelJobs(ended.size(), Phase::Solve, whole, [&](size_t i, Job& job) {
      job.begin(Phase::Strain);
      parallelFor(4, 1, [&](size_t, size_t) { job.check(); });
      ended[i] = i + 1;
    });
    for (size_t i = 0; i < ended.size(); ++i) EXPECT_EQ(ended[i], i + 1);
    EXPECT_EQ(whole.words[1].load(), static_cast<int32_t>(Phase::Solve));
    EXPECT_EQ(whole.words[2].load(), 10000);
  }
  setThreadCount(1);
}

TEST(ParallelJobs, rethrowsTheFirstErrorAndStopsWhereItIsCancelled) {
  setThreadCount(3);
  Job whole;
  try {
    parallelJobs(50, Phase::Solve, whole, [](size_t i, Job&) {
      if (i == 7 || i == 30) throw std::runtime_error("item " + std::to_string(i));
    });
    ADD_FAILURE() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "item 7");
  }
  EXPECT_THROW(parallelJobs(50, Phase::Solve, whole,
                            [&](size_t, Job& job) {
                              whole.requestCancel();
                              job.check();
                            }),
               Cancelled);
  setThreadCount(1);
}

TEST(Job, tellsItsObserverEachPercentOnce) {
  Job job;
  std::vector<double> seen;
  job.observer = [&](Phase, double fraction) { seen.push_back(fraction); };
  job.begin(Phase::Strain);
  for (int i = 0; i <= 1000; ++i) job.report(i / 1000.0);
  EXPECT_EQ(seen.size(), 101u);
}

#ifdef __EMSCRIPTEN__  // Only the heap of WebAssembly has a bound.
TEST(Memory, countsWhatWasGivenBackWithinTheHeap) {
  constexpr size_t kBlock = 10'000'000, kBlocks = 20;
  std::vector<std::vector<char>> blocks;
  for (size_t i = 0; i < kBlocks; ++i) blocks.emplace_back(kBlock, '1');
  const uint64_t full = memoryLeft();
  blocks.erase(blocks.begin(), blocks.end() - 1);  // the last one keeps the heap as large as it is
  EXPECT_GE(memoryLeft(), full + (kBlocks - 1) * kBlock);
  EXPECT_LE(memoryLeft(), full + kBlocks * kBlock);
}
#endif

TEST(Memory, isRefusedInOneSentenceBeforeItIsTaken) {
  setMemoryLimit(1'000'000);
  try {
    requireMemory(2'000'000, "This", "reduce it");
    ADD_FAILURE() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "This would take about 2 MB of memory, but only 1 MB are left: reduce it.");
  }
  EXPECT_NO_THROW(requireMemory(1'000'000, "This", "reduce it"));
  setMemoryLimit(0);
}

}  // namespace
}  // namespace limber
