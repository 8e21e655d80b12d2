#include "bind/parallel_calls.h"

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
  const auto found = parallelFunctions().find(name);
  if (found == parallelFunctions().end())
    throw std::invalid_argument("The core makes no calls of \"" + name + "\" in parallel.");
  return found->second(lists);
}

}  // namespace
}  // namespace limber

EMSCRIPTEN_BINDINGS(limber_parallel_calls) {
  using namespace limber;
  offer<&jsCallAll>("callAll");
}
