// Tuning for solvers of the panel with any constants.

#include "fit/tune/tune_solver.h"
#include "promises.h"
#include "simplify/simplify.h"
#include "soup.h"

namespace limber::fuzz {
namespace {

SolverConstants drawConstants(FuzzInput& input) {
  const auto drawn = [&](double usual) {
    if (input.chance(16)) return static_cast<double>(input.anyFloat());
    return input.chance(64) ? usual * std::pow(10, input.real(-6, 6)) : usual;
  };
  SolverConstants constants;
  constants.stretch = drawn(1e4);
  constants.secondStretch = drawn(5e3);
  constants.bend = drawn(1e-2);
  constants.surfaceDensity = drawn(10);
  return constants;
}

}  // namespace

void fuzzTune(FuzzInput& input) {
  const TriangleMesh mesh = drawMesh(input, 60);
  Job job;
  const History history = simplify(mesh, {}, {.method = Method::Limber, .sizeWeight = 0.01}, job);
  const TriangleMesh result = meshAt(mesh, history, input.below(mesh.triangleCount() + 1)).mesh;
  TuneOptions options;
  options.model = {static_cast<StretchElement>(input.byte() % 2), static_cast<BendElement>(input.byte() % 5),
                   static_cast<MassRule>(input.byte() % 2)};
  options.original = options.result = drawConstants(input);
  options.tune = static_cast<TuneKind>(input.byte() % 3);
  options.tunedMass = static_cast<MassRule>(input.byte() % 2);
  options.runsTrial = input.chance(32);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    if (input.chance(16)) options.pinnedOriginal.push_back(v);
  const Tuned tuned = tuneSolver(mesh, result, options, job);
  requireFinite(tuned.stretchFactors, "a factor on stretching is finite");
  requireFinite(tuned.bendFactors, "a factor on bending is finite");
  requireFinite(tuned.masses, "a mass is finite");
}

}  // namespace limber::fuzz
