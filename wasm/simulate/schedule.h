#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "base/job.h"

namespace limber {

// A part of a substep: items [0, count) that may be worked on at the same time, in chunks of `grain`.
struct Stage {
  size_t count, grain;
  std::function<void(size_t begin, size_t end, int repeat)> body;
};

// Runs all stages in order, `repeats` times; a stage starts when all of the one before has ended. With
// `threaded`, chunks are handed out to the threads of parallelFor, which spin between stages: for stages of
// some microseconds, which a pool's sleeping threads would not pay for. Returns false where
// threads had to wait for each other for long, as they do where other programs use the cores: better do
// without for a while. Throws Cancelled, with the stages left at some chunk in between. Bodies must not
// throw.
bool runStages(std::span<const Stage> stages, int repeats, bool threaded, const Job& job);

}  // namespace limber
