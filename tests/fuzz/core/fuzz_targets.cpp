#include "fuzz_targets.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <stdexcept>

namespace limber::fuzz {

std::span<const FuzzTarget> targets() {
  static constexpr std::array kTargets = {
      FuzzTarget{"weld", fuzzWeld},         FuzzTarget{"query", fuzzQuery},
      FuzzTarget{"simplify", fuzzSimplify}, FuzzTarget{"transfer", fuzzTransfer},
      FuzzTarget{"modes", fuzzModes},       FuzzTarget{"compare", fuzzCompare},
      FuzzTarget{"fit", fuzzFit},           FuzzTarget{"simulate", fuzzSimulate},
      FuzzTarget{"tune", fuzzTune}};
  return kTargets;
}

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "Broken promise: %s\n", what);
  std::abort();
}

void runTarget(const FuzzTarget& target, std::span<const uint8_t> bytes) {
  FuzzInput input(bytes);
  try {
    target.run(input);
  } catch (const std::bad_alloc&) {
    require(false, "small inputs fit into the memory");
  } catch (const std::logic_error& error) {
    // std::invalid_argument is a refusal; std::out_of_range and the like come from a container.
    require(dynamic_cast<const std::invalid_argument*>(&error) != nullptr, error.what());
    require(std::string(error.what()).ends_with("."), error.what());
  } catch (const std::runtime_error& error) {
    require(std::string(error.what()).ends_with("."), error.what());
  }
}

}  // namespace limber::fuzz
