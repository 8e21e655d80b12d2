#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "compare/surface_distance.h"
#include "mesh/quality.h"
#include "mesh/repair/inspect.h"
#include "simplify/simplify.h"
#include "surfaces.h"

namespace limber {
namespace {

constexpr Method kMethods[] = {Method::Qem, Method::Paper, Method::Limber};

SimplifyOptions optionsOf(Method method) {
  return {.method = method, .qualityWeight = 0.1, .sizeWeight = 0.01};
}

History run(const TriangleMesh& mesh, const SimplifyOptions& options) {
  Job job;
  return simplify(mesh, {}, options, job);
}

std::vector<TriangleMesh> curvedMeshes() {
  TriangleMesh waves = shapes::grid(20, 20);
  for (Vec3& p : waves.positions) p.z = 0.1 * std::sin(7 * p.x) * std::cos(6 * p.y);
  return {surfaces::inFloats(shapes::sphere(3)), surfaces::inFloats(shapes::torus(24, 16)),
          surfaces::inFloats(waves), surfaces::inFloats(shapes::jittered(surfaces::doubleTorus(), 0.1, 2)),
          surfaces::inFloats(shapes::box(4, 4, 12, 0.25))};
}

TEST(Targets, theSurfaceStaysWithinTheLargestDeviation) {
  for (const TriangleMesh& mesh : curvedMeshes())
    for (const Method method : {Method::Qem, Method::Limber}) {
      uint32_t facesBefore = mesh.triangleCount();
      for (const double percent : {0.2, 2.0}) {
        SimplifyOptions options = optionsOf(method);
        options.maxDeviation = percent / 100 * bounds(mesh).diagonal();
        const History history = run(mesh, options);
        const TriangleMesh end = meshAt(mesh, history, 0).mesh;
        Job job;
        EXPECT_LE(measureSurfaceDistance(mesh, end, {}, job).hausdorff, 1.02 * options.maxDeviation)
            << percent << " % at " << end.triangleCount() << " of " << mesh.triangleCount();
        EXPECT_LE(end.triangleCount(), facesBefore);
        facesBefore = end.triangleCount();
        if (history.refused.deviation > 0) {
          EXPECT_EQ(history.stop, StopReason::Deviation);
        }
      }
      EXPECT_LT(facesBefore, mesh.triangleCount() / 3);
    }
}

TEST(Targets, noCollapseMakesAnAngleSmallerThanTheSmallestWanted) {
  for (const TriangleMesh& mesh : curvedMeshes())
    for (const Method method : kMethods)
      for (const double angle : {10.0, 25.0}) {
        SimplifyOptions options = optionsOf(method);
        options.minAngle = angle;
        const History history = run(mesh, options);
        const double least = std::min(angle, measureQuality(mesh).minAngle);
        for (uint32_t faces = mesh.triangleCount(); faces > 8; faces /= 2)
          EXPECT_GE(measureQuality(meshAt(mesh, history, faces).mesh).minAngle, least - 1e-4) << faces;
        EXPECT_LT(meshAt(mesh, history, 0).mesh.triangleCount(), mesh.triangleCount() / (angle > 20 ? 1 : 3));
      }
}

TEST(Targets, theHistorySaysWhyItEnds) {
  const TriangleMesh sphere = surfaces::inFloats(shapes::sphere(3));
  SimplifyOptions options = optionsOf(Method::Qem);
  EXPECT_EQ(run(sphere, options).stop, StopReason::Exhausted);
  options.stopFaces = 100;
  const History target = run(sphere, options);
  EXPECT_EQ(target.stop, StopReason::Target);
  EXPECT_EQ(target.trianglesAfter.back(), 100u);
  EXPECT_EQ(target.refused.topology + target.refused.flip, 0u);
  options.maxDeviation = 0.02;
  EXPECT_EQ(run(sphere, options).stop, StopReason::Deviation);
  options.maxDeviation = 0;
  options.minAngle = 40;
  const History angle = run(sphere, options);
  EXPECT_EQ(angle.stop, StopReason::Angle);
  EXPECT_GT(angle.refused.angle, 0u);
}

TEST(Targets, whatIsOutOfRangeIsRefusedWithASentence) {
  const TriangleMesh sphere = shapes::sphere(1);
  EXPECT_THROW(run(sphere, {.maxDeviation = -1}), std::invalid_argument);
  EXPECT_THROW(run(sphere, {.maxDeviation = std::nan("")}), std::invalid_argument);
  EXPECT_THROW(run(sphere, {.minAngle = 60}), std::invalid_argument);
}

}  // namespace
}  // namespace limber
