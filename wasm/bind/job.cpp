// The running call, the threads and the memory.

#include <emscripten/heap.h>

#include "base/memory.h"
#include "base/parallel.h"
#include "bind/function.h"

namespace limber {
namespace {

uintptr_t jobAddress() {
  return reinterpret_cast<uintptr_t>(&theJob.words[0]);
}

// Must be called before each call: clears the cancellation request and the progress. `observer` is null, or
// called with (phase, fraction) on this thread.
void resetJob(const val& observer) {
  theJob.reset();
  theJob.observer = nullptr;
  if (!observer.isNull())
    theJob.observer = [observer](Phase phase, double fraction) {
      observer(static_cast<int>(phase), fraction);
    };
}

void limitHeap(double bytes) {
  setHeapLimit(static_cast<uint64_t>(bytes));
}

double peakHeapBytes() {
  return static_cast<double>(emscripten_get_heap_size());
}

val functionNames() {
  val out = val::array();
  for (const std::string& name : offeredFunctions()) out.call<void>("push", name);
  return out;
}

}  // namespace
}  // namespace limber

EMSCRIPTEN_BINDINGS(limber_job) {
  using namespace limber;
  emscripten::function("setThreadCount", &setThreadCount);
  emscripten::function("threadCount", &threadCount);
  emscripten::function("jobAddress", &jobAddress);
  emscripten::function("resetJob", &resetJob);
  emscripten::function("limitHeap", &limitHeap);
  emscripten::function("peakHeapBytes", &peakHeapBytes);
  emscripten::function("functionNames", &functionNames);
}
