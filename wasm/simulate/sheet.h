#pragma once

#include <cstdint>

#include "elastic/material.h"
#include "simulate/blocks.h"

namespace limber {

// A thin elastic plate whose material is in SI units: the thickness is in metres and the unit is 1.
struct Sheet {
  ElasticMaterial material;

  // E h, in N/m.
  double stretching() const { return material.young * material.thickness; }
  // D = E h^3 / (12 (1 - nu^2)), in N m.
  double bending() const {
    const double h = material.thickness, nu = material.poisson;
    return material.young * h * h * h / (12 * (1 - nu * nu));
  }
};

// What all constraints of a body are made with.
struct ConstraintOptions {
  Sheet sheet;
  const Blocks& blocks;
  double substep;  // seconds
  uint32_t order;  // see `colour`
};

}  // namespace limber
