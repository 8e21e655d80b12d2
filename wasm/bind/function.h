#pragma once

// Exports functions to JavaScript under their names. Exceptions are returned as Error objects, which
// web/engine/core/load_core.ts throws, so that no destructor on the C++ stack is skipped.

#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/job.h"

namespace limber {

using emscripten::val;

// The job of the running call; only one call runs at a time.
inline Job theJob;

// The names of all functions that `offer` has exported on this thread, for load_core.ts. Emscripten runs the
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

// Converts the exception that is being handled to an Error object.
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

// Calls `f`; an exception is returned as an Error object.
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

// Exports `f`. Must be called in an EMSCRIPTEN_BINDINGS block.
template <auto f>
void offer(const char* name) {
  emscripten::function(name, &Guarded<f>::call);
  offeredFunctions().push_back(name);
}

}  // namespace limber
