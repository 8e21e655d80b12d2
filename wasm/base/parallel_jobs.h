#pragma once

#include <cstddef>
#include <functional>

#include "base/job.h"

namespace limber {

// Calls work(i, job) for each i in [0, count) on all threads, each with its own job, a part of `whole`.
// Results are the same for any number of threads if each call writes only to its own item. `whole` shows
// `phase`; its progress is the share of calls that have finished. Rethrows the first exception in item order;
// throws Cancelled.
void parallelJobs(size_t count, Phase phase, Job& whole, const std::function<void(size_t i, Job& job)>& work);

}  // namespace limber
