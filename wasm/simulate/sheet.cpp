#include "simulate/sheet.h"

namespace limber {

Sheet sheetOf(const ElasticMaterial& material) {
  const double nu = material.poisson, h = material.thickness * material.unit;
  const double bending = material.young * h * h * h / (12 * (1 - nu * nu));
  return {material.young * h, nu, bending, nu, material.density * h};
}

Sheet sheetOf(const SolverConstants& constants) {
  const double nu = constants.secondStretch / (constants.secondStretch + 2 * constants.stretch);
  return {2 * constants.stretch * (1 + nu), nu, constants.bend, constants.poisson, constants.surfaceDensity};
}

}  // namespace limber
