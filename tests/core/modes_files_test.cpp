#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "elastic/modes.h"
#include "mesh/repair/weld.h"
#include "shared_meshes.h"

namespace limber {
namespace {

// Real meshes of ../shared; skipped visibly where they are absent.
class ModesOfFiles : public testing::TestWithParam<const char*> {};

TEST_P(ModesOfFiles, haveSixZeroModesAndResidualsBelowTheLimit) {
  const auto path = shared_meshes::folder() / GetParam();
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "../shared/meshes/" << GetParam() << " is not here";
  const auto soup = shared_meshes::readObj(path);
  Job job;
  const TriangleMesh mesh = weld(soup.positions, soup.indices, {}, job).mesh;
  const double diagonal = bounds(mesh).diagonal();
  const ModeSet set =
      computeModes(mesh, {ElasticModel::Shell, 12, {1e6, 0.3, 1000, 0.02 * diagonal, 1}}, job);
  EXPECT_EQ(set.components[0].zeroModesFound, 6u);
  double worst = 0;
  for (const Mode& mode : set.modes) worst = std::max(worst, mode.residual);
  EXPECT_LE(worst, 1e-7);
}

INSTANTIATE_TEST_SUITE_P(Shared, ModesOfFiles,
                         testing::Values("derived_eiffel_6156.obj", "spot_uv.obj", "skirt_4k.obj",
                                         "pyramid_frame_genus4.obj"));

}  // namespace
}  // namespace limber
