#include "elastic/shell_vibration.h"

#include <gtest/gtest.h>

#include "shapes.h"
#include "transfer/shape_transfer.h"

namespace limber {
namespace {

constexpr VibrationRequest kRequest{0.02, 8};

// Scales the mesh to a bounding diagonal of 1.
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
  const ModeBasis followed = shell.follow(moved, shell.solve(mesh, kRequest, job), kRequest, job),
                  searched = shell.solve(moved, kRequest, job);
  for (int k = 0; k < 8; ++k) EXPECT_NEAR(followed.lambda[k], searched.lambda[k], 1e-4 * searched.lambda[k]);
}

TEST(VibratingShell, findsTheModesOfAFineMeshFromThoseOfACoarseOne) {
  const TriangleMesh fine = egg(4), coarse = egg(3);
  const Topology fineTopology = buildTopology(fine), coarseTopology = buildTopology(coarse);
  Job job;
  const WholePhase phase(job, Phase::Fit);
  const VibratingShell fineShell(fine, fineTopology, {0.3, 1e-6, 12}, job),
      coarseShell(coarse, coarseTopology, {0.3, 1e-6, 12}, job);
  ModeBasis start = coarseShell.solve(coarse, kRequest, job);
  start.phi = transfer(start.phi.topRows(3 * static_cast<Eigen::Index>(coarse.vertexCount())), coarse,
                       closestPoints(fine, coarse));
  const ModeBasis followed = fineShell.follow(fine, start, kRequest, job),
                  searched = fineShell.solve(fine, kRequest, job);
  for (int k = 0; k < 8; ++k) EXPECT_NEAR(followed.lambda[k], searched.lambda[k], 1e-4 * searched.lambda[k]);
}

// A pin leaves three rigid motions free, which have to be among the columns that are refined.
TEST(VibratingShell, findsTheModesOfAMeshThatTurnsAboutAPin) {
  const TriangleMesh fine = egg(4), coarse = egg(3);
  const Topology fineTopology = buildTopology(fine), coarseTopology = buildTopology(coarse);
  const std::vector<uint32_t> pinned{0};
  const VibrationOptions options{0.3, kRoughTolerance, 4, pinned, 3};
  Job job;
  const VibratingShell fineShell(fine, fineTopology, options, job),
      coarseShell(coarse, coarseTopology, options, job);
  ModeBasis start = coarseShell.solve(coarse, kRequest, job);
  start.phi = transfer(start.phi.topRows(3 * static_cast<Eigen::Index>(coarse.vertexCount())), coarse,
                       closestPoints(fine, coarse));
  const EigenSolution refined = fineShell.refine(fine, start, kRequest, job),
                      exact = fineShell.solveExactly(fine, kRequest, job);
  EXPECT_EQ(refined.nullity, 3u);
  for (int k = 0; k < 8; ++k)
    EXPECT_NEAR(refined.basis.lambda[k], exact.basis.lambda[k], 2e-4 * exact.basis.lambda[k]) << k;
}

}  // namespace
}  // namespace limber
