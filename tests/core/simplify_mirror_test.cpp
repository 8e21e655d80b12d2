#include <gtest/gtest.h>

#include <stdexcept>

#include "mirrored.h"
#include "same_topology.h"
#include "simplify/simplify.h"
#include "simplify/symmetry/mirror.h"

namespace limber {
namespace {

using mirrored::box, mirrored::Doubled, mirrored::facesOf, mirrored::sheet;

constexpr Method kMethods[] = {Method::Qem, Method::Paper, Method::Limber};

History run(const Doubled& whole, Method method, uint32_t stopFaces, double maxDeviation = 0) {
  Job job;
  SimplifyOptions options{.method = method, .qualityWeight = 0.1, .sizeWeight = 0.01, .stopFaces = stopFaces};
  options.constraints.mirror = whole.mirror;
  options.maxDeviation = maxDeviation;
  return simplify(whole.mesh, {}, options, job);
}

TEST(Mirror, bothSidesStayImagesOfEachOtherBitByBit) {
  for (const Doubled& whole : {sheet(), box()})
    for (const Method method : kMethods)
      for (const uint32_t faces : {300u, 120u, 40u, 0u}) {
        const TriangleMesh mesh = meshAt(whole.mesh, run(whole, method, faces), 0).mesh;
        EXPECT_EQ(facesOf(mesh, 1), facesOf(mesh, -1)) << faces;
      }
}

TEST(Mirror, keepsTopologyAndReachesFarDown) {
  for (const Doubled& whole : {sheet(), box()})
    for (const Method method : kMethods) {
      const TriangleMesh floor = meshAt(whole.mesh, run(whole, method, 0), 0).mesh;
      expectSameTopology(whole.mesh, floor);
      EXPECT_LT(floor.triangleCount(), 40u);
    }
}

TEST(Mirror, isKeptTogetherWithALargestDeviation) {
  const Doubled whole = box();
  const TriangleMesh mesh = meshAt(whole.mesh, run(whole, Method::Limber, 0, 0.05), 0).mesh;
  EXPECT_EQ(facesOf(mesh, 1), facesOf(mesh, -1));
  EXPECT_LT(mesh.triangleCount(), whole.mesh.triangleCount() / 2);
}

TEST(Mirror, whatIsNoSymmetryIsRefusedWithASentence) {
  const Doubled good = sheet();
  std::vector<Doubled> bad(4, good);
  std::swap(bad[0].mirror[1], bad[0].mirror[2]);
  bad[1].mesh.positions[5].z += 0.1;
  bad[2].mesh.triangles.pop_back();
  bad[3].mirror.pop_back();
  for (const Doubled& whole : bad) EXPECT_THROW(run(whole, Method::Qem, 0), std::invalid_argument);
}

}  // namespace
}  // namespace limber
