#pragma once

#include <cstdint>
#include <span>

#include "elastic/material.h"
#include "elastic/solvers/solver_model.h"
#include "simulate/blocks.h"

namespace limber {

// A thin elastic plate, in SI units. Stretching and bending may have different materials, as in a solver with
// a constant for each.
struct Sheet {
  double stretching = 0;      // E h, N/m
  double poisson = 0;         // of the membrane, in (-1, 1)
  double bending = 0;         // D, N m
  double bendingPoisson = 0;  // in (-1, 1)
  double surfaceDensity = 0;  // kg/m2
};

// The plate of a material: D = E h^3 / (12 (1 - nu^2)).
Sheet sheetOf(const ElasticMaterial& material);
// The plate of a solver's constants. With Lame's constants in plane stress, lambda and mu, nu = lambda /
// (lambda + 2 mu) and E = 2 mu (1 + nu).
Sheet sheetOf(const SolverConstants& constants);

// The common parameters of all constraints of a body.
struct ConstraintOptions {
  Sheet sheet;
  const Blocks& blocks;
  double substep;  // seconds
  uint32_t order;  // see `colour`
};

// Factors on the stiffness of constraints, by constraint; empty if all are 1.
using StiffnessFactors = std::span<const double>;

inline double factorOf(StiffnessFactors factors, size_t constraint) {
  return factors.empty() ? 1 : factors[constraint];
}

}  // namespace limber
