// The entry of libFuzzer for one target, whose name the build defines as LIMBER_FUZZ_TARGET.

#include <cstring>

#include "fuzz_targets.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  for (const limber::fuzz::FuzzTarget& target : limber::fuzz::targets())
    if (std::strcmp(target.name, LIMBER_FUZZ_TARGET) == 0) limber::fuzz::runTarget(target, {data, size});
  return 0;
}
