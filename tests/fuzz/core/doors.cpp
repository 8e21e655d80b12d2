#include "doors.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <stdexcept>

namespace limber::fuzz {

std::span<const Door> doors() {
  static constexpr std::array kDoors = {Door{"weld", enterWeld},         Door{"simplify", enterSimplify},
                                        Door{"transfer", enterTransfer}, Door{"modes", enterModes},
                                        Door{"fit", enterFit},           Door{"simulate", enterSimulate},
                                        Door{"tune", enterTune}};
  return kDoors;
}

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "Broken promise: %s\n", what);
  std::abort();
}

void enter(const Door& door, std::span<const uint8_t> bytes) {
  FuzzInput input(bytes);
  try {
    door.enter(input);
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
