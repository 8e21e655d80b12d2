#include "base/memory.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <stdexcept>
#include <string>

#ifdef __EMSCRIPTEN__
#include <emscripten/heap.h>
#include <malloc.h>
#include <unistd.h>
#endif

namespace limber {

namespace {

std::atomic<uint64_t> cap = 0;
std::atomic<uint64_t> heapLimit = UINT64_MAX;

// Bytes by which the heap may still grow.
uint64_t ungrownMemory() {
#ifdef __EMSCRIPTEN__
  const uint64_t most = std::min<uint64_t>(emscripten_get_heap_max(), heapLimit);
  const uint64_t taken = reinterpret_cast<uintptr_t>(sbrk(0));
  return most > taken ? most - taken : 0;
#else
  return UINT64_MAX;
#endif
}

// Bytes that are free within the heap. Slow: walks the whole heap.
uint64_t freedMemory() {
#ifdef __EMSCRIPTEN__
  return static_cast<size_t>(mallinfo().fordblks);
#else
  return 0;
#endif
}

uint64_t capped(uint64_t bytes) {
  return cap == 0 ? bytes : std::min<uint64_t>(bytes, cap);
}

std::string inWords(uint64_t bytes) {
  char text[32];
  const auto size = static_cast<double>(bytes);
  std::snprintf(text, sizeof text, size < 1e9 ? "%.0f MB" : "%.1f GB", size / (size < 1e9 ? 1e6 : 1e9));
  return text;
}

}  // namespace

void setMemoryLimit(uint64_t bytes) {
  cap = bytes;
}

void setHeapLimit(uint64_t bytes) {
  heapLimit = bytes;
}

uint64_t memoryLeft() {
  return capped(ungrownMemory() + freedMemory());
}

void requireMemory(uint64_t bytes, const char* what, const char* cure) {
  if (bytes <= capped(ungrownMemory())) return;
  const uint64_t left = memoryLeft();
  if (bytes <= left) return;
  throw std::runtime_error(std::string(what) + " would take about " + inWords(bytes) +
                           " of memory, but only " + inWords(left) + " are left: " + cure + ".");
}

}  // namespace limber
