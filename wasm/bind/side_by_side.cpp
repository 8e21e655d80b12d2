#include "bind/side_by_side.h"

#include <stdexcept>

namespace limber {

val jsErrorOf(const std::exception_ptr& error) {
  try {
    std::rethrow_exception(error);
  } catch (...) {
    return errorOfCurrentException();
  }
}

namespace {

// Calls the function `name` once for each list of arguments.
val jsCallAll(const std::string& name, const val& lists) {
  const auto found = sideBySideFunctions().find(name);
  if (found == sideBySideFunctions().end())
    throw std::invalid_argument("The core makes no calls of \"" + name + "\" side by side.");
  return found->second(lists);
}

}  // namespace
}  // namespace limber

EMSCRIPTEN_BINDINGS(limber_side_by_side) {
  using namespace limber;
  offer<&jsCallAll>("callAll");
}
