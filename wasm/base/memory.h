#pragma once

#include <cstdint>

namespace limber {

// Bytes that can still be allocated: in WebAssembly up to the largest heap size; natively unbounded unless a
// limit is set.
uint64_t memoryLeft();

// Caps what memoryLeft() returns; 0 removes the cap. For tests.
void setMemoryLimit(uint64_t bytes);

// Reports that the WebAssembly memory was created with a maximum of `bytes`, below the maximum of the
// program.
void setHeapLimit(uint64_t bytes);

// Throws std::runtime_error with one sentence if less than `bytes` are left: "<what> would take about 2 GB of
// memory, but only 1 GB are left: <cure>." Call it before allocating.
void requireMemory(uint64_t bytes, const char* what, const char* cure);

}  // namespace limber
