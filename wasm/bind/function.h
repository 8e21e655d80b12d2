#pragma once

// How a function is offered to JavaScript: under its name, with exceptions returned as Error objects, which
// web/engine/core/load_core.ts throws. So no destructor on the C++ stack is skipped.

#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/job.h"

namespace limber {

using emscripten::val;

// The job of the running call; there is one call at a time.
inline Job theJob;

// The names of all functions that `offer` has offered on this thread, for load_core.ts. Emscripten runs the
// EMSCRIPTEN_BINDINGS blocks on every thread of the pool, some at the same time.
inline std::vector<std::string>& offeredFunctions() {
  static thread_local std::vector<std::string> names;
  return names;
}

inline val jsError(const char* name, const std::string& message) {
  val error = val::global("Error").new_(message);
  error.set("name", std::string(name));
  return error;
}

// The exception that is being handled as an Error object.
inline val errorOfCurrentException() {
  try {
    throw;
  } catch (const Cancelled& error) {
    return jsError("Cancelled", error.what());
  } catch (const std::bad_alloc&) {
    return jsError("Error",
                   "Not enough memory for a mesh of this size: reduce it first, or ask for fewer modes.");
  } catch (const std::exception& error) {
    return jsError("Error", error.what());
  }
}

// `f` with every exception turned into an Error object that is returned.
template <auto f>
struct Guarded;
template <typename... Arguments, val (*f)(Arguments...)>
struct Guarded<f> {
  static val call(Arguments... arguments) {
    try {
      return f(arguments...);
    } catch (...) {
      return errorOfCurrentException();
    }
  }
};

// To be called in an EMSCRIPTEN_BINDINGS block.
template <auto f>
void offer(const char* name) {
  emscripten::function(name, &Guarded<f>::call);
  offeredFunctions().push_back(name);
}

}  // namespace limber
