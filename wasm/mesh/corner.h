#pragma once

#include <cstdint>

namespace limber {

// A corner of a triangle, packed: 4 * triangle + (0, 1 or 2).
using Corner = uint32_t;
inline uint32_t triangleOf(Corner corner) {
  return corner >> 2;
}
inline int indexOf(Corner corner) {
  return static_cast<int>(corner & 3);
}
inline int nextIndex(int c) {
  return c == 2 ? 0 : c + 1;
}
inline int previousIndex(int c) {
  return c == 0 ? 2 : c - 1;
}

}  // namespace limber
