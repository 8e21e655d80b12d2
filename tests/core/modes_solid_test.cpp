#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "modes/eigensolver.h"
#include "modes/solid.h"
#include "shapes.h"

namespace limber {
namespace {

// Elastic angular frequencies of a free body, E = rho = 1, in the body's own units.
struct Frequencies {
  uint32_t zeroCount;
  std::vector<double> omega;
  double mass;
};

TriangleMesh scaledToUnit(TriangleMesh body) {
  const Bounds box = bounds(body);
  for (Vec3& p : body.positions) p = (p - box.low) / box.diagonal();
  return body;
}

Frequencies solve(const TriangleMesh& body, uint32_t targetCells, int count = 6) {
  Job job;
  const double diagonal = bounds(body).diagonal();
  const SolidModel solid = solidModel(scaledToUnit(body), {0.3, targetCells}, job);
  const EigenPairs pairs = solveEigenproblem(solid.model, {count, 6, 1}, job);
  Frequencies result{pairs.zeroCount, {}, solid.model.mass.sum() / 3 * std::pow(diagonal, 3)};
  for (double lambda : pairs.lambda) result.omega.push_back(std::sqrt(lambda) / diagonal);
  return result;
}

TEST(SolidModes, aBarBendsTwistsAndStretchesAsBeamTheorySays) {
  for (uint32_t cells : {48u, 192u, 400u, 1536u, 4000u}) {
    const Frequencies bar = solve(shapes::box(8, 8, 24, 0.125), cells);
    printf("%u mass %.5f zeros %u:", cells, bar.mass, bar.zeroCount);
    for (double omega : bar.omega) printf(" %.4f", omega);
    printf("\n");
  }
}

}  // namespace
}  // namespace limber
