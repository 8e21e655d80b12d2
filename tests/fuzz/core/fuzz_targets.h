#pragma once

#include <span>
#include <string>

#include "fuzz_input.h"

namespace limber::fuzz {

// A fuzz target of the core: draws arguments and calls functions with them. Ends the program with a sentence where a
// function breaks a promise; exceptions that carry a sentence for the user are no failures.
struct FuzzTarget {
  const char* name;
  void (*run)(FuzzInput& input);
};
std::span<const FuzzTarget> targets();

// Runs a target with these bytes.
void runTarget(const FuzzTarget& target, std::span<const uint8_t> bytes);

// Ends the program with a sentence unless `holds`.
void require(bool holds, const char* what);

void fuzzWeld(FuzzInput& input);
void fuzzQuery(FuzzInput& input);
void fuzzSimplify(FuzzInput& input);
void fuzzTransfer(FuzzInput& input);
void fuzzModes(FuzzInput& input);
void fuzzCompare(FuzzInput& input);
void fuzzFit(FuzzInput& input);
void fuzzSimulate(FuzzInput& input);
void fuzzTune(FuzzInput& input);

}  // namespace limber::fuzz
