#pragma once

// Functions of the core of which JavaScript makes many calls at once, as for the bodies of a scene, so that
// all threads work although each call is small.

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

// `error` as an Error object, as `Guarded` returns it.
val jsErrorOf(const std::exception_ptr& error);

// A value of JavaScript for each index of a list of arguments.
template <size_t>
using Argument = val;

// A `Call` is one call of a function: it copies `kArguments` values of JavaScript when it is made, is run on
// any thread by `run(job)`, and `write` makes a value of JavaScript of the result. The last two steps are
// apart because only the thread of the call may touch values of JavaScript.
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

  // `lists`: an array with the arguments of each call. Returns an array of results, with an Error object
  // where a call has thrown. Throws Cancelled, and what making the calls throws.
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

// The functions of `callAll` by their names, on this thread, see offeredFunctions.
inline std::map<std::string, val (*)(const val& lists)>& parallelFunctions() {
  static thread_local std::map<std::string, val (*)(const val& lists)> functions;
  return functions;
}

// As `offer`, of a function that `callAll` can call, too.
template <class Call>
void offerParallel(const char* name) {
  offer<&ParallelCalls<Call>::call>(name);
  parallelFunctions()[name] = &ParallelCalls<Call>::callAll;
}

}  // namespace limber
