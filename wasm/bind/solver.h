#pragma once

#include "bind/convert.h"
#include "elastic/solvers/solver_model.h"

namespace limber {

template <>
struct Names<StretchElement> {
  static constexpr std::array list = {"membrane", "edge-springs"};
  static constexpr const char* what = "stretch element";
};

template <>
struct Names<BendElement> {
  static constexpr std::array list = {"morley", "hinge-area", "hinge-length", "hinge", "cross-springs"};
  static constexpr const char* what = "bending element";
};

template <>
struct Names<MassRule> {
  static constexpr std::array list = {"area", "vertex"};
  static constexpr const char* what = "rule for masses";
};

template <>
struct Fields<SolverModel> {
  static constexpr auto list =
      std::tuple(field("stretch", &SolverModel::stretch), field("bend", &SolverModel::bend),
                 field("mass", &SolverModel::mass));
};

template <>
struct Fields<SolverConstants> {
  static constexpr auto list = std::tuple(
      field("stretch", &SolverConstants::stretch), field("secondStretch", &SolverConstants::secondStretch),
      field("bend", &SolverConstants::bend), field("poisson", &SolverConstants::poisson),
      field("surfaceDensity", &SolverConstants::surfaceDensity), field("unit", &SolverConstants::unit));
};

}  // namespace limber
