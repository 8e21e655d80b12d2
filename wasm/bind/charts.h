#pragma once

#include <cstdint>
#include <vector>

#include "bind/convert.h"
#include "mesh/charts.h"

namespace limber {

// The storage behind Charts; a temporary must live as long as its view.
struct ChartLists {
  std::vector<uint32_t> wedges, groups;

  Charts view() const { return {wedges, groups}; }
};

template <>
struct Fields<ChartLists> {
  static constexpr auto list =
      std::tuple(field("wedges", &ChartLists::wedges), field("groups", &ChartLists::groups));
};

}  // namespace limber
