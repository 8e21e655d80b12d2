#pragma once

#include <span>
#include <string>

#include "fuzz_input.h"

namespace limber::fuzz {

// A door of the core: draws arguments and calls functions with them. Ends the program with a sentence where a
// function breaks a promise; exceptions that carry a sentence for the user are no failures.
struct Door {
  const char* name;
  void (*enter)(FuzzInput& input);
};
std::span<const Door> doors();

// Enters a door with these bytes.
void enter(const Door& door, std::span<const uint8_t> bytes);

// Ends the program with a sentence unless `holds`.
void require(bool holds, const char* what);

void enterWeld(FuzzInput& input);
void enterSimplify(FuzzInput& input);
void enterTransfer(FuzzInput& input);
void enterModes(FuzzInput& input);
void enterFit(FuzzInput& input);
void enterSimulate(FuzzInput& input);
void enterTune(FuzzInput& input);

}  // namespace limber::fuzz
