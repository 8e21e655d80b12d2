#include "elastic/shell_vibration.h"

#include <gtest/gtest.h>

#include "shapes.h"
#include "transfer/shape_transfer.h"

namespace limber {
namespace {

// In the frame where the diagonal is 1.
TriangleMesh unit(TriangleMesh mesh) {
  const double diagonal = bounds(mesh).diagonal();
  for (Vec3& p : mesh.positions) p = p / diagonal;
  return mesh;
}

TriangleMesh egg(uint32_t cuts) {
  TriangleMesh mesh = shapes::sphere(cuts);
  for (Vec3& p : mesh.positions) p = {1.4 * p.x, p.y * (1 + 0.2 * p.x), 0.8 * p.z};
  return unit(mesh);
}

TEST(VibratingShell, followsAMeshThatMovesToWhereASearchFromScratchEnds) {
  const TriangleMesh mesh = egg(3), moved = shapes::jittered(mesh, 0.002, 5);
  const Topology topology = buildTopology(mesh);
  Job job;
  const WholePhase phase(job, Phase::Fit);
  const VibratingShell shell(mesh, topology, {0.3, 1e-6, 12}, job);
  const ShellVibration followed = shell.follow(moved, shell.solve(mesh, 0.02, 8, job), 8, job),
                       searched = shell.solve(moved, 0.02, 8, job);
  for (int k = 0; k < 8; ++k) EXPECT_NEAR(followed.lambda[k], searched.lambda[k], 1e-4 * searched.lambda[k]);
}

TEST(VibratingShell, findsTheModesOfAFineMeshFromThoseOfACoarseOne) {
  const TriangleMesh fine = egg(4), coarse = egg(3);
  const Topology fineTopology = buildTopology(fine), coarseTopology = buildTopology(coarse);
  Job job;
  const WholePhase phase(job, Phase::Fit);
  const VibratingShell fineShell(fine, fineTopology, {0.3, 1e-6, 12}, job),
      coarseShell(coarse, coarseTopology, {0.3, 1e-6, 12}, job);
  ShellVibration start = coarseShell.solve(coarse, 0.02, 8, job);
  start.phi = transfer(start.phi.topRows(3 * static_cast<Eigen::Index>(coarse.vertexCount())), coarse,
                       closestPoints(fine, coarse));
  const ShellVibration followed = fineShell.follow(fine, start, 8, job),
                       searched = fineShell.solve(fine, 0.02, 8, job);
  for (int k = 0; k < 8; ++k) EXPECT_NEAR(followed.lambda[k], searched.lambda[k], 1e-4 * searched.lambda[k]);
}

}  // namespace
}  // namespace limber
