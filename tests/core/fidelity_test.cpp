#include "compare/fidelity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "compare/assignment.h"
#include "shapes.h"

namespace limber {
namespace {

FidelityOptions optionsFor(const TriangleMesh& mesh, int modeCount = 10) {
  return {modeCount, {1e6, 0.3, 1000, 0.02 * bounds(mesh).diagonal(), 1}};
}

TEST(Assignment, findsTheBestPairingOfEveryKind) {
  std::mt19937 random(11);
  for (const auto& [rows, columns] : {std::pair{5, 5}, {4, 6}, {6, 4}}) {
    Eigen::MatrixXd value(rows, columns);
    for (double& entry : value.reshaped()) entry = random() % 1000;
    const auto found = assign(value);
    double total = 0;
    for (int row = 0; row < rows; ++row)
      if (found[row] >= 0) total += value(row, found[row]);
    // All permutations of the longer side.
    const int size = std::max(rows, columns);
    std::vector<int> order(size);
    std::iota(order.begin(), order.end(), 0);
    double best = 0;
    do {
      double sum = 0;
      for (int row = 0; row < rows; ++row)
        if (order[row] < columns) sum += value(row, order[row]);
      best = std::max(best, sum);
    } while (std::next_permutation(order.begin(), order.end()));
    EXPECT_EQ(total, best) << rows << " x " << columns;
  }
}

TEST(Fidelity, aBodyIsLikeItself) {
  const TriangleMesh mesh = shapes::jittered(shapes::grid(8, 10), 0.02, 1);
  Job job;
  const Fidelity fidelity = compareFidelity(mesh, mesh, optionsFor(mesh), job);
  EXPECT_LT(fidelity.frequencyErrorMax, 1e-6);
  EXPECT_LT(fidelity.frequencyErrorHigh, 1e-6);
  EXPECT_NEAR(fidelity.macMin, 1, 1e-6);
  EXPECT_NEAR(fidelity.calibrationFactor, 1, 1e-8);
}

TEST(Fidelity, aFoldedSheetIsLikeItselfThoughItsHalvesLieOnEachOther) {
  TriangleMesh mesh = shapes::grid(16, 10, 2, 1);
  for (Vec3& p : mesh.positions) p.x = std::min(p.x, 2 - p.x);
  Job job;
  EXPECT_NEAR(compareFidelity(mesh, mesh, optionsFor(mesh), job).macMin, 1, 1e-6);
}

TEST(FrequencyErrors, areThoseOfTheWholeComparison) {
  const TriangleMesh mesh = shapes::jittered(shapes::grid(8, 10), 0.02, 1), other = shapes::grid(6, 7);
  const FidelityOptions options = optionsFor(mesh, 6);
  Job job;
  const ModeBasis modes = shellModes(mesh, options, job);
  EXPECT_EQ(modes.modeCount(), 12);
  const FrequencyErrors errors = frequencyErrors(mesh, modes, other, options, job);
  const Fidelity fidelity = compareFidelity(mesh, other, options, job);
  EXPECT_EQ(errors.mean, fidelity.frequencyErrorMean);
  EXPECT_EQ(errors.max, fidelity.frequencyErrorMax);
  EXPECT_GT(errors.max, 0);
  EXPECT_THROW(frequencyErrors(other, modes, mesh, options, job), std::invalid_argument);
}

TEST(Fidelity, doesNotDependOnTheNumberingOfVertices) {
  const TriangleMesh mesh = shapes::sphere(2);
  TriangleMesh other;
  const uint32_t n = mesh.vertexCount();
  for (uint32_t v = 0; v < n; ++v) other.positions.push_back(mesh.positions[n - 1 - v]);
  for (const Triangle& t : mesh.triangles)
    other.triangles.push_back({n - 1 - t[0], n - 1 - t[1], n - 1 - t[2]});
  Job job;
  const Fidelity fidelity = compareFidelity(mesh, other, optionsFor(mesh), job);
  EXPECT_LT(fidelity.frequencyErrorMax, 1e-4);
  EXPECT_GT(fidelity.macMin, 0.999);
}

TEST(Fidelity, aCoarserPlateIsCloseAndAStretchedOneIsNot) {
  const TriangleMesh fine = shapes::grid(20, 20), coarse = shapes::grid(10, 10);
  TriangleMesh stretched = coarse;
  for (Vec3& p : stretched.positions) p.x *= 1.3;
  Job job;
  const Fidelity near = compareFidelity(fine, coarse, optionsFor(fine), job);
  EXPECT_LT(near.frequencyErrorMean, 6);
  EXPECT_GT(near.frequencyErrorMean, 0);
  EXPECT_LE(near.frequencyErrorCalibrated, near.frequencyErrorMean + 1e-9);
  EXPECT_GT(near.macMin, 0.98);
  const Fidelity far = compareFidelity(fine, stretched, optionsFor(fine), job);
  EXPECT_GT(far.frequencyErrorMean, 2 * near.frequencyErrorMean);
}

TEST(Fidelity, aUniformlySofterBodyIsCalibratedByOneFactor) {
  // Twice the size at the same thickness and density lowers all bending frequencies of a plate by the same
  // factor.
  const TriangleMesh plate = shapes::grid(10, 10);
  TriangleMesh larger = plate;
  for (Vec3& p : larger.positions) p *= 1.02;
  Job job;
  const Fidelity fidelity = compareFidelity(plate, larger, optionsFor(plate), job);
  EXPECT_NEAR(fidelity.frequencyErrorMean, 100 * (1 - 1 / (1.02 * 1.02)), 0.2);
  EXPECT_LT(fidelity.frequencyErrorCalibrated, 0.2);
  EXPECT_NEAR(fidelity.calibrationFactor, std::pow(1.02, 4), 0.01);
}

TEST(Fidelity, aBodyWithFewerModesThanAskedIsStillCompared) {
  TriangleMesh triangle;
  triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.triangles = {{0, 1, 2}};
  Job job;
  const Fidelity fidelity = compareFidelity(triangle, triangle, optionsFor(triangle), job);
  EXPECT_LT(fidelity.frequencyErrorMax, 1e-6);
  EXPECT_NEAR(fidelity.macMean, 1, 1e-6);
  EXPECT_TRUE(std::isnan(fidelity.frequencyErrorHigh)) << "no modes 11 to 20";
}

TEST(Fidelity, noFactorOnTheStiffnessIsUsedThatRaisesTheMeanError) {
  // Most modes are those of the first sheet, which stays as it is; those of the second one rise.
  const TriangleMesh sheet = shapes::grid(8, 8);
  const auto besides = [&](double size) {
    TriangleMesh second = sheet;
    for (Vec3& p : second.positions) p = p * size + Vec3{2, 0, 0};
    return shapes::together(sheet, second);
  };
  const TriangleMesh original = besides(0.6), other = besides(0.54);
  Job job;
  const Fidelity fidelity = compareFidelity(original, other, optionsFor(sheet), job);
  EXPECT_GT(fidelity.frequencyErrorMean, 1);
  EXPECT_EQ(fidelity.frequencyErrorCalibrated, fidelity.frequencyErrorMean);
  EXPECT_EQ(fidelity.calibrationFactor, 1);
  EXPECT_EQ(calibrationFactor(original, other, optionsFor(sheet), job), 1);
}

}  // namespace
}  // namespace limber
