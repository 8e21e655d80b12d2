#pragma once

#include <cstdint>

namespace limber {

// Bytes that can still be allocated: in WebAssembly the rest of the largest heap; natively unbounded unless a
// limit is set.
uint64_t memoryLeft();

// Caps what memoryLeft() returns; 0 removes the cap. For tests.
void setMemoryLimit(uint64_t bytes);

// Throws std::runtime_error with one sentence if fewer than `bytes` are left. `what` begins the sentence,
// such as "The exact solve". To be called before the memory is allocated.
void requireMemory(uint64_t bytes, const char* what);

}  // namespace limber
