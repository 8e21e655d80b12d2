#pragma once

#include <string_view>

#include "simplify/method.h"

namespace limber {

// The method of a name, such as "qem". Throws std::invalid_argument that lists the known names.
Method methodNamed(std::string_view name);

}  // namespace limber
