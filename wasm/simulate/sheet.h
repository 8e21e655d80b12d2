#pragma once

#include <cstdint>

#include "simulate/blocks.h"

namespace limber {

// An isotropic elastic sheet, SI units.
struct Sheet {
  double young, poisson, thickness, density;
  double stretching() const { return young * thickness; }  // N/m
  double bending() const {                                 // N m
    return young * thickness * thickness * thickness / (12 * (1 - poisson * poisson));
  }
};

// What constraints are made with.
struct ConstraintOptions {
  Sheet sheet;
  const Blocks& blocks;
  double substep;  // seconds
  uint32_t order;  // see `colour`
};

}  // namespace limber
