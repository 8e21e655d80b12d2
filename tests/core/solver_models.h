#pragma once

// The solvers of the panel with the constants of one thin shell.

#include <utility>

#include "elastic/solvers/solver_model.h"
#include "mesh/triangle_mesh.h"

namespace limber::solver_models {

inline constexpr std::pair<const char*, SolverModel> kModels[] = {
    {"shell", {StretchElement::Membrane, BendElement::Morley, MassRule::Area}},
    {"hinge-shell", {StretchElement::Membrane, BendElement::HingeByArea, MassRule::Vertex}},
    {"hinges by length", {StretchElement::Membrane, BendElement::HingeByLength, MassRule::Area}},
    {"dihedral", {StretchElement::EdgeSprings, BendElement::Hinge, MassRule::Area}},
    {"springs", {StretchElement::EdgeSprings, BendElement::CrossSprings, MassRule::Area}},
    {"edge springs with Morley's element",
     {StretchElement::EdgeSprings, BendElement::Morley, MassRule::Area}},
};

// Thickness 3 % of the diagonal, E = 1e5 Pa, 1000 kg/m3; springs across a twentieth as stiff as edges.
inline SolverConstants constantsOf(const SolverModel& model, const TriangleMesh& mesh) {
  const double poisson = 0.3, young = 1e5, thickness = 0.03 * bounds(mesh).diagonal();
  const double plane = young * thickness / (1 - poisson * poisson), d = plane * thickness * thickness / 12;
  SolverConstants constants;
  constants.poisson = poisson;
  constants.surfaceDensity = 1000 * thickness;
  constants.stretch = plane * (1 - poisson) / 2;
  constants.secondStretch = plane * poisson;
  if (model.stretch == StretchElement::EdgeSprings) constants.stretch = young * thickness;
  constants.bend = d;
  if (model.bend == BendElement::HingeByLength) constants.bend = 30 * d / bounds(mesh).diagonal();
  if (model.bend == BendElement::Hinge) constants.bend = 3 * d;
  if (model.bend == BendElement::CrossSprings) constants.bend = 0.05 * constants.stretch;
  return constants;
}

}  // namespace limber::solver_models
