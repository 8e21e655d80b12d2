// The entry of libFuzzer for one door, whose name the build defines as LIMBER_DOOR.

#include <cstring>

#include "doors.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  for (const limber::fuzz::Door& door : limber::fuzz::doors())
    if (std::strcmp(door.name, LIMBER_DOOR) == 0) limber::fuzz::enter(door, {data, size});
  return 0;
}
