// The range of the factors of bending constraints, which depends on the resolution.

#include "fit/tune/steps/factor_range.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fit/tune/tune_solver.h"
#include "shapes.h"
#include "solver_models.h"
#include "surfaces.h"

namespace limber {
namespace {

void expectFactors(const FactorRange& range, double least, double most) {
  EXPECT_NEAR(std::exp(range.least), least, 1e-12 * least);
  EXPECT_NEAR(std::exp(range.most), most, 1e-12 * most);
}

TEST(FactorRange, ContainsTheFactorThatTheResolutionAsksFor) {
  expectFactors(bendRange(BendElement::Morley, 2), 0.1, 10);
  expectFactors(bendRange(BendElement::HingeByArea, 2), 0.1, 10);
  expectFactors(bendRange(BendElement::Hinge, 2), 0.1, 10);
  expectFactors(bendRange(BendElement::HingeByLength, 2), 0.05, 10);
  expectFactors(bendRange(BendElement::CrossSprings, 2), 0.1 / 16, 10);
  expectFactors(bendRange(BendElement::CrossSprings, 0.5), 0.1, 160);
}

// Rings of regular triangles, the coarse one with edges 2.5 times as long: its springs across edges resist
// bending about 2.5^4 = 39 times as much, which no factor of 0.1 can correct.
TEST(FactorRange, LetsSpringsBendAsEasilyOnAMuchCoarserMesh) {
  const TriangleMesh fine = surfaces::inFloats(shapes::torus(80, 40)),
                     coarse = surfaces::inFloats(shapes::torus(32, 16));
  TuneOptions options;
  options.model = {StretchElement::EdgeSprings, BendElement::CrossSprings, MassRule::Area};
  options.original = options.result = solver_models::constantsOf(options.model, fine);
  options.tune = TuneKind::Global;
  Job job;
  const Tuned tuned = tuneSolver(fine, coarse, options, job);
  EXPECT_LT(tuned.bendFactor, 0.1);
  EXPECT_GT(tuned.bendFactor, 0.1 / 39);
  EXPECT_GT(tuned.frequencies.errorUntouched, 100);
  EXPECT_LT(tuned.frequencies.errorTuned, 10);
}

}  // namespace
}  // namespace limber
