#pragma once

#include <cstdint>

namespace limber {

// How collapses are priced: the index of a row of CostPolicies (simplify/cost/policies.h), which names the
// methods. The enumerators are for C++ callers.
enum class Method : int32_t { Qem = 0, Paper = 1, Limber = 2 };

}  // namespace limber
