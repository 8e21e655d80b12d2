#pragma once

#include <cstdint>
#include <span>

namespace limber {

// The data that bound the charts of a surface. If both are empty, each chart is a whole component.
struct Charts {
  std::span<const uint32_t> wedges;  // [3 * t + c]: equal for corners at one vertex that share all attributes
  std::span<const uint32_t> groups;  // [t]: the primitive or material
};

}  // namespace limber
