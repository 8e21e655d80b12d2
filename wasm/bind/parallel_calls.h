#pragma once

// Functions of the core that JavaScript can call many times at once, for example for the bodies of a scene,
// so that all threads are busy although each call is small.

#include <deque>
#include <exception>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/parallel_jobs.h"
#include "bind/function.h"

namespace limber {

// Converts `error` to an Error object, as `Guarded` returns it.
val jsErrorOf(const std::exception_ptr& error);

// A JavaScript value for each index of a list of arguments.
template <size_t>
using Argument = val;

// A `Call` is one call of a function: its constructor copies `kArguments` JavaScript values, `run(job)` runs
// it on any thread, and `write` converts the result to a JavaScript value. The last two steps are separate
// because only the calling thread may touch JavaScript values.
template <class Call, class Indices = std::make_index_sequence<Call::kArguments>>
class ParallelCalls;

template <class Call, size_t... I>
class ParallelCalls<Call, std::index_sequence<I...>> {
 public:
  // A single call.
  static val call(const Argument<I>&... arguments) {
    const Call call(arguments...);
    return call.write(call.run(theJob));
  }

  // `lists`: an array with the arguments of each call. Returns an array of results, with an Error object for
  // each call that has thrown. Throws Cancelled, and whatever the constructors of the calls throw.
  static val callAll(const val& lists) {
    std::deque<Call> calls = callsOf(lists);
    const size_t count = calls.size();
    std::vector<std::optional<Result>> results(count);
    std::vector<std::exception_ptr> errors(count);
    parallelJobs(count, Call::kPhase, theJob, [&](size_t i, Job& job) {
      try {
        results[i] = calls[i].run(job);
      } catch (const Cancelled&) {
        throw;
      } catch (...) {
        errors[i] = std::current_exception();
      }
    });
    val out = val::array();
    for (size_t i = 0; i < count; ++i)
      out.set(i, errors[i] ? jsErrorOf(errors[i]) : calls[i].write(*results[i]));
    return out;
  }

 private:
  using Result = decltype(std::declval<const Call&>().run(std::declval<Job&>()));

  static std::deque<Call> callsOf(const val& lists) {
    std::deque<Call> calls;
    const auto count = lists["length"].as<uint32_t>();
    for (uint32_t i = 0; i < count; ++i) {
      const val arguments = lists[i];
      calls.emplace_back(arguments[I]...);
    }
    return calls;
  }
};

// The functions that `callAll` can call, by name, on this thread; see offeredFunctions.
inline std::map<std::string, val (*)(const val& lists)>& parallelFunctions() {
  static thread_local std::map<std::string, val (*)(const val& lists)> functions;
  return functions;
}

// Like `offer`, for a function that `callAll` can also call.
template <class Call>
void offerParallel(const char* name) {
  offer<&ParallelCalls<Call>::call>(name);
  parallelFunctions()[name] = &ParallelCalls<Call>::callAll;
}

}  // namespace limber
