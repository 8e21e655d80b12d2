#pragma once

#include <cstddef>
#include <functional>

namespace limber {

// Sets the number of threads that parallelFor may use, including the caller's: initially 1, and always 1 in
// the single-threaded build. Must not be called while a parallelFor runs. Throws std::invalid_argument below
// 1.
void setThreadCount(int count);
int threadCount();

// Calls body(begin, end) for consecutive ranges that cover [0, count), each of at most `grain` items. The
// ranges depend on `count` and `grain` alone, never on the number of threads; which thread runs a range, and
// when, is unspecified. Results are therefore the same for any number of threads if each range writes only to
// its own items. After all ranges have finished, the first exception in range order is rethrown. Calls may be
// nested: threads that find no range left in an outer loop help with the inner ones.
void parallelFor(size_t count, size_t grain, const std::function<void(size_t begin, size_t end)>& body);

}  // namespace limber
