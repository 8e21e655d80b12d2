// The phases of a step on threads, and the choice of the number of threads.

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

#include "base/parallel.h"
#include "simulate/schedule.h"

namespace limber {
namespace {

TEST(Schedule, everyItemRunsOncePerRepeatAndAfterThePhaseBefore) {
  for (const int threads : {1, 2, 5}) {
    setThreadCount(threads);
    const size_t counts[] = {37, 0, 8, 1};
    const int repeats = 50;
    std::vector<std::vector<int>> ran;
    for (const size_t count : counts) ran.emplace_back(count, 0);
    std::atomic<int> disorder = 0;
    std::vector<SolverPhase> phases;
    for (size_t s = 0; s < ran.size(); ++s)
      phases.push_back({counts[s], 3, [&, s](size_t begin, size_t end, int repeat) {
                          const size_t before = s == 2 ? 0 : s == 3 ? 2 : 3;
                          const int expected = s == 0 ? repeat : repeat + 1;
                          for (const int times : ran[before]) disorder += times != expected;
                          for (size_t i = begin; i < end; ++i) disorder += ran[s][i]++ != repeat;
                        }});
    runSchedule({{}, phases, {}, repeats}, threads > 1, Job());
    EXPECT_EQ(disorder, 0);
    for (const auto& phase : ran)
      for (const int times : phase) EXPECT_EQ(times, repeats);
  }
  setThreadCount(1);
}

TEST(Schedule, aCancelledRunEndsEarlyOnAnyNumberOfThreads) {
  for (const int threads : {1, 3}) {
    setThreadCount(threads);
    Job job;
    std::atomic<int> ran = 0;
    const std::vector<SolverPhase> phases = {{64, 4, [&](size_t, size_t, int repeat) {
                                                ++ran;
                                                if (repeat == 10) job.requestCancel();
                                              }}};
    EXPECT_THROW(runSchedule({{}, phases, {}, 1000}, threads > 1, job), Cancelled);
    EXPECT_LT(ran, 20 * 16);
  }
  setThreadCount(1);
}

TEST(Helpers, threadsWithoutWorkTakePartAndEveryItemStillRunsOncePerRepeat) {
  for (const int threads : {1, 2, 4}) {
    setThreadCount(threads);
    const int repeats = 200;
    std::vector<std::vector<int>> ran(2, std::vector<int>(24, 0));
    std::atomic<int> disorder = 0;
    const auto scheduleOf = [&](std::vector<int>& items) {
      const auto count = [&](size_t begin, size_t end, int repeat) {
        for (size_t i = begin; i < end; ++i) disorder += items[i]++ != 2 * repeat;
      };
      const auto countAgain = [&](size_t begin, size_t end, int repeat) {
        for (size_t i = begin; i < end; ++i) disorder += items[(i + 7) % 24]++ != 2 * repeat + 1;
      };
      return Schedule{{}, {{24, 1, count}, {24, 5, countAgain}}, {}, repeats};
    };
    Helpers helpers(ran.size());
    parallelFor(ran.size() + 3, 1, [&](size_t i, size_t) {
      if (i >= ran.size()) return helpers.help();
      helpers.run(scheduleOf(ran[i]), Job());
      helpers.endTask();
    });
    EXPECT_EQ(disorder, 0);
    for (const auto& items : ran)
      for (const int times : items) EXPECT_EQ(times, 2 * repeats);
  }
  setThreadCount(1);
}

// Makes steps that take threaded(step) or serial(step) seconds, depending on the choice; returns their total
// seconds.
template <class Threaded, class Serial>
double passed(ThreadChoice& choice, int steps, Threaded threaded, Serial serial) {
  double sum = 0;
  for (int step = 0; step < steps; ++step) {
    const double seconds = choice.threaded() ? threaded(step) : serial(step);
    choice.record(seconds);
    sum += seconds;
  }
  return sum;
}

TEST(ThreadChoice, takesWhatIsFasterAndFollowsWhenThatChanges) {
  ThreadChoice choice;
  const auto slow = [](int) { return 3.0; };
  const auto fast = [](int) { return 2.0; };
  EXPECT_LT(passed(choice, 1000, fast, slow), 1.02 * 2000);
  EXPECT_LT(passed(choice, 1000, slow, fast), 1.03 * 2000);
  EXPECT_LT(passed(choice, 1000, fast, slow), 1.07 * 2000);
}

TEST(ThreadChoice, costsLittleWhereThreadsAreInEachOthersWay) {
  ThreadChoice choice;
  EXPECT_LT(passed(choice, 2000, [](int) { return 9.0; }, [](int) { return 3.0; }), 1.05 * 6000);
}

}  // namespace
}  // namespace limber
