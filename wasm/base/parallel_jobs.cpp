#include "base/parallel_jobs.h"

#include <atomic>
#include <thread>

#include "base/parallel.h"

namespace limber {

void parallelJobs(size_t count, Phase phase, Job& whole,
                  const std::function<void(size_t i, Job& job)>& work) {
  if (count == 0) return;
  WholePhase shown(whole, phase);
  std::atomic<size_t> done = 0;
  const auto caller = std::this_thread::get_id();
  parallelFor(count, 1, [&](size_t i, size_t) {
    Job job(whole);
    work(i, job);
    const double fraction = static_cast<double>(++done) / static_cast<double>(count);
    if (std::this_thread::get_id() == caller) shown.report(fraction);
  });
  shown.report(1);  // other threads may have run every item
}

}  // namespace limber
