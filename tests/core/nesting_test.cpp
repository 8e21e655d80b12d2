#include "mesh/nesting.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "shapes.h"
#include "surfaces.h"

namespace limber {
namespace {

TriangleMesh inverted(TriangleMesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

TriangleMesh moved(TriangleMesh mesh, const Vec3& by) {
  for (Vec3& p : mesh.positions) p += by;
  return mesh;
}

using Hosts = std::vector<uint32_t>;

Hosts hostsOf(const TriangleMesh& mesh) {
  return solidHosts(mesh, buildTopology(mesh));
}

TEST(Nesting, aClosedShellIsItsOwnHostWhicheverWayItIsWound) {
  for (const TriangleMesh& mesh : {shapes::sphere(2), shapes::torus(12, 8), shapes::box(2, 2, 6, 0.5)}) {
    EXPECT_EQ(hostsOf(mesh), Hosts{0});
    EXPECT_EQ(hostsOf(inverted(mesh)), Hosts{0});
  }
}

TEST(Nesting, openClashingAndFlatSurfacesBoundNothing) {
  TriangleMesh hole = shapes::sphere(2);
  hole.triangles.pop_back();
  TriangleMesh clash = shapes::sphere(2);
  std::swap(clash.triangles[5][0], clash.triangles[5][1]);
  TriangleMesh flat = shapes::box(2, 2, 2, 1);
  for (Vec3& p : flat.positions) p.z = 0;
  for (const TriangleMesh& mesh : {hole, clash, flat, shapes::grid(3, 3), surfaces::threeSheets(3)})
    EXPECT_EQ(hostsOf(mesh), Hosts{kNone});
}

TEST(Nesting, aShellWoundTheOtherWayInsideIsACavity) {
  const TriangleMesh hollow = shapes::together(shapes::sphere(2), inverted(shapes::sphere(1, 0.5)));
  EXPECT_EQ(hostsOf(hollow), (Hosts{0, 0}));
  EXPECT_EQ(hostsOf(inverted(hollow)), (Hosts{0, 0}));
  const TriangleMesh cavityFirst = shapes::together(inverted(shapes::sphere(1, 0.5)), shapes::sphere(2));
  EXPECT_EQ(hostsOf(cavityFirst), (Hosts{1, 1}));
}

TEST(Nesting, aShellWoundTheSameWayInsideIsABodyOfItsOwn) {
  EXPECT_EQ(hostsOf(shapes::together(shapes::sphere(2), shapes::sphere(1, 0.5))), (Hosts{0, 1}));
}

TEST(Nesting, whatFloatsInACavityIsABodyWithItsOwnCavities) {
  TriangleMesh onion = shapes::sphere(2);
  for (int shell = 1; shell < 4; ++shell) {
    const TriangleMesh next = shapes::sphere(2, 1 - 0.2 * shell);
    onion = shapes::together(onion, shell % 2 ? inverted(next) : next);
  }
  EXPECT_EQ(hostsOf(onion), (Hosts{0, 0, 2, 2}));
}

TEST(Nesting, besideIsNotInside) {
  const TriangleMesh beside = moved(inverted(shapes::sphere(1, 0.2)), {0, 0, -1.5});
  EXPECT_EQ(hostsOf(shapes::together(shapes::sphere(2), beside)), (Hosts{0, 1}));
  // Within the torus' bounding box, in its hole.
  EXPECT_EQ(hostsOf(shapes::together(shapes::torus(24, 12), inverted(shapes::sphere(1, 0.2)))),
            (Hosts{0, 1}));
}

TEST(Nesting, anOpenSurfaceIsNoHost) {
  TriangleMesh open = shapes::sphere(2);
  open.triangles.pop_back();
  EXPECT_EQ(hostsOf(shapes::together(open, inverted(shapes::sphere(1, 0.5)))), (Hosts{kNone, 1}));
}

TEST(Nesting, manyBubblesInABlockAreAllItsCavities) {
  TriangleMesh block = shapes::box(4, 4, 4, 1);
  for (int i = 0; i < 64; ++i)
    block = shapes::together(
        block, moved(inverted(shapes::sphere(0, 0.3)), {i / 16 + 0.5, i / 4 % 4 + 0.5, i % 4 + 0.5}));
  EXPECT_EQ(hostsOf(block), Hosts(65, 0));
}

}  // namespace
}  // namespace limber
