#pragma once

#include <string_view>

#include "simplify/options.h"

namespace limber {

// The method of a name, such as "qem". Throws std::invalid_argument with the names there are.
Method methodNamed(std::string_view name);

}  // namespace limber
