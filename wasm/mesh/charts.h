#pragma once

#include <cstdint>
#include <span>

namespace limber {

// What tells one chart of a surface from the next. Both may be empty: then nothing but the mesh's own borders
// parts it.
struct Charts {
  std::span<const uint32_t> wedges;  // per corner 3 * t + c: equal at a vertex where all attributes are
  std::span<const uint32_t> groups;  // per triangle: what it is drawn with
};

}  // namespace limber
