#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "compare/fidelity.h"
#include "fit/modal_fit.h"
#include "mesh/topology.h"
#include "mirrored.h"
#include "same_topology.h"
#include "simplify/simplify.h"
#include "simplify/symmetry/mirror.h"
#include "simplify/symmetry/mirror_images.h"

namespace limber {
namespace {

using mirrored::Doubled;

Job theJob;

TriangleMesh moved(TriangleMesh mesh, const Vec3& way) {
  for (Vec3& p : mesh.positions) p += way;
  return mesh;
}

// Rotated about z.
TriangleMesh turned(TriangleMesh mesh, double angle) {
  for (Vec3& p : mesh.positions)
    p = {p.x * std::cos(angle) - p.y * std::sin(angle), p.x * std::sin(angle) + p.y * std::cos(angle), p.z};
  return mesh;
}

TEST(MirrorImages, ofADoubledMeshAreItsHalves) {
  for (const Doubled& whole : {mirrored::sheet(), mirrored::box()}) {
    EXPECT_EQ(findMirrorImages(whole.mesh, {}, 0, theJob).partners, whole.mirror);
    EXPECT_EQ(findMirrorImages(whole.mesh, {}, kAnyAxis, theJob).partners, whole.mirror);
    EXPECT_EQ(findMirrorImages(moved(whole.mesh, {3, -2, 1}), {}, 0, theJob).partners, whole.mirror);
  }
}

TEST(MirrorImages, areFoundAcrossAPrincipalAxis) {
  const Doubled whole = mirrored::sheet();
  const TriangleMesh mesh = surfaces::inFloats(turned(whole.mesh, 0.4));
  EXPECT_EQ(findMirrorImages(mesh, {}, kAnyAxis, theJob).partners, whole.mirror);
  EXPECT_TRUE(findMirrorImages(mesh, {}, 0, theJob).partners.empty());
}

TEST(MirrorImages, ofWhatHasNoneAreCounted) {
  Doubled whole = mirrored::sheet();
  const MirrorImages across = findMirrorImages(whole.mesh, {}, 1, theJob);
  EXPECT_TRUE(across.partners.empty());
  EXPECT_GT(across.asymmetricVertices, whole.mesh.vertexCount() / 2);
  // All diagonals of a grid run one way, and the quads in the middle lie across the plane: its vertices have
  // images, its triangles have none, however the quads are split.
  const MirrorImages grid = findMirrorImages(shapes::grid(5, 4), {}, 0, theJob);
  EXPECT_TRUE(grid.partners.empty() && grid.corners.empty());
  EXPECT_EQ(grid.asymmetricVertices, 0u);
  EXPECT_EQ(grid.asymmetricTriangles, 40u);
  whole.mesh.positions[5].z += 0.1;
  const MirrorImages dented = findMirrorImages(whole.mesh, {}, 0, theJob);
  EXPECT_TRUE(dented.partners.empty());
  EXPECT_GT(dented.asymmetricVertices, 0u);
}

TEST(MirrorImages, refuseAFlatMeshAsItsOwnImage) {
  EXPECT_TRUE(findMirrorImages(shapes::grid(4, 4), {}, 2, theJob).partners.empty());
}

// The mesh with quads split according to `corners`.
TriangleMesh recut(const TriangleMesh& mesh, const std::vector<uint32_t>& corners) {
  TriangleMesh cut{mesh.positions, {}};
  for (size_t corner = 0; corner < corners.size(); corner += 3) {
    Triangle triangle;
    for (size_t k = 0; k < 3; ++k)
      triangle[k] = mesh.triangles[corners[corner + k] / 3][corners[corner + k] % 3];
    cut.triangles.push_back(triangle);
  }
  return cut;
}

uint32_t changedTriangles(const std::vector<uint32_t>& corners) {
  uint32_t changed = 0;
  for (uint32_t t = 0; 3 * t < corners.size(); ++t)
    changed += corners[3 * t] != 3 * t || corners[3 * t + 1] != 3 * t + 1 || corners[3 * t + 2] != 3 * t + 2;
  return changed;
}

TEST(MatchSplits, cutsTheQuadsOfOneSideTheOtherWay) {
  for (const TriangleMesh& mesh : {shapes::grid(6, 4), shapes::torus(24, 12)}) {
    const MirrorImages images = findMirrorImages(mesh, {}, 0, theJob);
    ASSERT_EQ(images.corners.size(), 3 * size_t{mesh.triangleCount()});
    EXPECT_EQ(images.asymmetricTriangles, mesh.triangleCount());
    const TriangleMesh cut = recut(mesh, images.corners);
    EXPECT_EQ(trianglesWithoutImage(cut, images.partners), 0u);
    EXPECT_EQ(changedTriangles(images.corners), mesh.triangleCount() / 2);
    const MirrorImages again = findMirrorImages(cut, {}, 0, theJob);
    EXPECT_EQ(again.partners, images.partners);
    EXPECT_TRUE(again.corners.empty());
    // No triangle is lost or flipped.
    expectSameTopology(mesh, cut);
    for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
      EXPECT_GT(dot(areaNormal(mesh, t), areaNormal(cut, t)), 0) << t;
  }
}

TEST(MatchSplits, cutsNoneWhereASeamRuns) {
  const TriangleMesh mesh = shapes::grid(4, 2);
  const std::vector<uint32_t> corners = findMirrorImages(mesh, {}, 0, theJob).corners;
  std::vector<uint32_t> groups(mesh.triangleCount(), 0), wedges;
  uint32_t first = 0;
  while (corners[3 * size_t{first}] == 3 * first && corners[3 * size_t{first} + 1] == 3 * first + 1 &&
         corners[3 * size_t{first} + 2] == 3 * first + 2)
    ++first;
  // If a quad on one side must not be flipped, its image on the other side is flipped instead.
  groups[first] = 1;
  const MirrorImages other = findMirrorImages(mesh, {{}, groups}, 0, theJob);
  ASSERT_FALSE(other.corners.empty());
  EXPECT_EQ(other.corners[3 * size_t{first}], 3 * first);
  EXPECT_EQ(trianglesWithoutImage(recut(mesh, other.corners), other.partners), 0u);
  // If each triangle is a chart of its own, no quad can be flipped.
  for (uint32_t corner = 0; corner < 3 * mesh.triangleCount(); ++corner) wedges.push_back(corner);
  const MirrorImages none = findMirrorImages(mesh, {wedges, {}}, 0, theJob);
  EXPECT_TRUE(none.corners.empty() && none.partners.empty());
  EXPECT_EQ(none.asymmetricTriangles, mesh.triangleCount());
}

TEST(MatchSplits, preferAPlaneThatTakesNone) {
  const TriangleMesh torus = shapes::torus(24, 12);
  const MirrorImages upDown = findMirrorImages(torus, {}, 2, theJob);
  const TriangleMesh cut = recut(torus, upDown.corners);
  EXPECT_FALSE(findMirrorImages(cut, {}, 0, theJob).corners.empty());
  const MirrorImages found = findMirrorImages(cut, {}, kAnyAxis, theJob);
  EXPECT_EQ(found.partners, upDown.partners);
  EXPECT_TRUE(found.corners.empty());
}

// A mesh, a symmetric result of it, and that result after a fit with the mirror symmetry and after one
// without.
struct Fit {
  Doubled whole;
  MeshAt reduced;
  ModalFitResult fitted, plain;
};

ModalFitOptions fitOptions(const Doubled& whole) {
  return {.thickness = 0.05, .modeCount = 4, .mirror = whole.mirror};
}

MeshAt reduce(const Doubled& whole, uint32_t faces) {
  // A small weight of quality leaves edges to flip.
  SimplifyOptions options{.method = Method::Limber, .qualityWeight = 0.02, .sizeWeight = 0.01};
  options.stopFaces = faces;
  options.constraints.mirror = whole.mirror;
  return meshAt(whole.mesh, simplify(whole.mesh, {}, options, theJob), 0);
}

Fit fit(const Doubled& whole, uint32_t faces) {
  const MeshAt reduced = reduce(whole, faces);
  ModalFitOptions options = fitOptions(whole);
  ModalFitResult fitted = fitModes(whole.mesh, reduced, options, theJob);
  options.mirror = {};
  return {whole, reduced, std::move(fitted), fitModes(whole.mesh, reduced, options, theJob)};
}

const Fit& fittedSheet() {
  static const Fit once = fit(mirrored::sheet(), 80);
  return once;
}

const Fit& fittedBox() {
  static const Fit once = fit(mirrored::box(), 240);
  return once;
}

TEST(MirroredFit, isItsOwnImage) {
  for (const auto& [whole, reduced, fitted, plain] : {fittedSheet(), fittedBox()}) {
    const TriangleMesh& mesh = fitted.result.mesh;
    EXPECT_EQ(mirrored::facesOf(mesh, 1), mirrored::facesOf(mesh, -1));
    EXPECT_NE(mirrored::facesOf(mesh, 1), mirrored::facesOf(reduced.mesh, 1));
    EXPECT_NE(mirrored::facesOf(plain.result.mesh, 1), mirrored::facesOf(plain.result.mesh, -1));
    EXPECT_EQ(buildTopology(mesh).edges.size(), buildTopology(reduced.mesh).edges.size());
    EXPECT_EQ(fitted.flips % 2, 0u);
  }
  EXPECT_GT(fittedSheet().fitted.flips, 0u);
}

TEST(MirroredFit, isAboutAsGoodAsOneThatDoesNotKnow) {
  for (const Fit& fit : {fittedSheet(), fittedBox()}) {
    EXPECT_LT(fit.fitted.errorAfter[0], 0.5 * fit.fitted.errorBefore[0]);
    EXPECT_LT(fit.fitted.errorAfter[0], 2 * fit.plain.errorAfter[0] + 0.05);
  }
}

// The error that the fit returns is that of its result, not of a mesh before it is mirrored.
TEST(MirroredFit, tellsTheErrorOfItsResult) {
  const auto& [whole, reduced, fitted, plain] = fittedBox();
  const auto errorOf = [&](const TriangleMesh& mesh) {
    const FidelityOptions options{4, {1e6, 0.3, 1000, 0.05, 1}};
    return compareFidelity(whole.mesh, mesh, options, theJob).frequencyErrorMean;
  };
  EXPECT_LT(errorOf(fitted.result.mesh), 2 * fitted.errorAfter[0]);
  EXPECT_LT(errorOf(fitted.result.mesh), 0.5 * errorOf(reduced.mesh));
}

TEST(MirroredFit, givesEveryCornerOneThatLayAtItsVertex) {
  const Flips& flips = fittedSheet().fitted.result.flips;
  const TriangleMesh& mesh = fittedSheet().fitted.result.mesh;
  for (uint32_t corner = 0; corner < flips.corners.size(); ++corner) {
    const uint32_t was = flips.corners[corner];
    EXPECT_EQ(flips.triangles[was / 3][was % 3], mesh.triangles[corner / 3][corner % 3]);
  }
}

TEST(MirroredFit, locksTheImagesOfLockedVertices) {
  const auto& [whole, reduced, fitted, plain] = fittedSheet();
  std::vector<uint8_t> locked(whole.mesh.vertexCount(), 0);
  const uint32_t original = reduced.inputOfVertex[7];
  const uint32_t image = reduced.vertexOfInput[whole.mirror[original]];
  locked[original] = 1;
  ModalFitOptions options = fitOptions(whole);
  options.locked = locked;
  const TriangleMesh mesh = fitModes(whole.mesh, reduced, options, theJob).result.mesh;
  EXPECT_EQ(mesh.positions[7], reduced.mesh.positions[7]);
  EXPECT_EQ(mesh.positions[image], reduced.mesh.positions[image]);
  EXPECT_NE(fitted.result.mesh.positions[7], reduced.mesh.positions[7]);
  EXPECT_EQ(mirrored::facesOf(mesh, 1), mirrored::facesOf(mesh, -1));
}

TEST(MirroredFit, leavesLockedVerticesWhereTheyWereWhereTheResultIsNearlySymmetric) {
  const Doubled whole = mirrored::sheet();
  MeshAt reduced = reduce(whole, 80);
  std::vector<uint8_t> locked(whole.mesh.vertexCount(), 0);
  for (uint32_t v = 0; v < reduced.mesh.vertexCount(); ++v) {
    reduced.mesh.positions[v].y += static_cast<float>(1e-6 * std::sin(1.0 + v));
    locked[reduced.inputOfVertex[v]] = v % 5 == 0;
  }
  ModalFitOptions options = fitOptions(whole);
  options.locked = locked;
  const TriangleMesh mesh = fitModes(whole.mesh, reduced, options, theJob).result.mesh;
  for (uint32_t v = 0; v < mesh.vertexCount(); v += 5)
    EXPECT_EQ(mesh.positions[v], reduced.mesh.positions[v]);
  EXPECT_NE(mesh.positions, reduced.mesh.positions);
}

// Every edge of one side is a seam, so no flip can be repeated there.
TEST(MirroredFit, doesNotFlipWhereTheImageIsASeam) {
  const auto& [whole, reduced, fitted, plain] = fittedSheet();
  std::vector<uint32_t> wedges;
  for (uint32_t t = 0; t < whole.mesh.triangleCount(); ++t)
    for (const uint32_t v : whole.mesh.triangles[t]) {
      const double x = whole.mesh.corner(t, 0).x + whole.mesh.corner(t, 1).x + whole.mesh.corner(t, 2).x;
      wedges.push_back(x < 0 ? whole.mesh.vertexCount() + 3 * t + v % 3 : v);
    }
  ModalFitOptions options = fitOptions(whole);
  options.charts = {wedges, {}};
  EXPECT_EQ(fitModes(whole.mesh, reduced, options, theJob).flips, 0u);
}

// Of two bodies that are images of each other, the second follows the first.
TEST(MirroredFit, takesOneOfTwoComponentsForBoth) {
  const TriangleMesh half = moved(shapes::jittered(shapes::grid(12, 10), 0.02, 6), {3, 0, 0});
  const Doubled whole = mirrored::doubled(surfaces::inFloats(half));
  const MeshAt reduced = reduce(whole, 160);
  const ModalFitResult fitted = fitModes(whole.mesh, reduced, fitOptions(whole), theJob);
  ASSERT_EQ(fitted.errorAfter.size(), 1u);
  EXPECT_LT(fitted.errorAfter[0], 0.5 * fitted.errorBefore[0]);
  const TriangleMesh& mesh = fitted.result.mesh;
  EXPECT_EQ(mirrored::facesOf(mesh, 1), mirrored::facesOf(mesh, -1));
  EXPECT_NE(mirrored::facesOf(mesh, 1), mirrored::facesOf(reduced.mesh, 1));
  const Flips& flips = fitted.result.flips;
  EXPECT_GT(fitted.flips, 0u);
  for (uint32_t corner = 0; corner < flips.corners.size(); ++corner) {
    const uint32_t was = flips.corners[corner];
    EXPECT_EQ(flips.triangles[was / 3][was % 3], mesh.triangles[corner / 3][corner % 3]);
  }
}

TEST(MirroredFit, refusesAResultThatIsNotItsOwnImage) {
  const Doubled whole = mirrored::sheet();
  const uint32_t faces = whole.mesh.triangleCount() - 1;
  const History once = simplify(whole.mesh, {}, {.method = Method::Qem, .stopFaces = faces}, theJob);
  ASSERT_EQ(once.collapseCount(), 1u);
  ASSERT_NE(whole.mirror[once.removed[0]], once.removed[0]) << "a vertex on the plane";
  const MeshAt lopsided = meshAt(whole.mesh, once, faces);
  EXPECT_THROW(fitModes(whole.mesh, lopsided, fitOptions(whole), theJob), std::invalid_argument);
}

}  // namespace
}  // namespace limber
