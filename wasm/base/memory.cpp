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

// What the heap may still grow by, and what was given back within it.
uint64_t systemMemoryLeft() {
#ifdef __EMSCRIPTEN__
  const uint64_t ungrown = emscripten_get_heap_max() - reinterpret_cast<uintptr_t>(sbrk(0));
  return ungrown + static_cast<size_t>(mallinfo().fordblks);
#else
  return UINT64_MAX;
#endif
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

uint64_t memoryLeft() {
  const uint64_t system = systemMemoryLeft();
  return cap == 0 ? system : std::min<uint64_t>(system, cap);
}

void requireMemory(uint64_t bytes, const char* what) {
  const uint64_t left = memoryLeft();
  if (bytes <= left) return;
  throw std::runtime_error(std::string(what) + " would take about " + inWords(bytes) +
                           " of memory, but only " + inWords(left) +
                           " are left: use the coarse solve, or reduce the mesh first.");
}

}  // namespace limber
