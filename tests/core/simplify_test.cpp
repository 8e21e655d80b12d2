#include "simplify/simplify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "base/parallel.h"
#include "fields/curvature.h"
#include "mesh/quality.h"
#include "mesh/topology.h"
#include "surfaces.h"

namespace limber {
namespace {

constexpr SimplifyOptions kQem{.method = Method::Qem};
constexpr SimplifyOptions kPaper{
    .method = Method::Paper, .strainWeight = 0.05, .curvatureWeight = 1, .qualityWeight = 0.01};

constexpr SimplifyOptions kLimber{
    .method = Method::Limber, .strainWeight = 3, .qualityWeight = 0.1, .sizeWeight = 0.01};

// Fields that vary smoothly and do not depend on how the mesh is numbered, scaled or rotated.
struct Fields {
  std::vector<float> strain, curvature;
  Guidance guidance() const { return {strain, curvature}; }
};
Fields fieldsOf(const TriangleMesh& unit) {
  Fields fields;
  for (uint32_t t = 0; t < unit.triangleCount(); ++t) {
    const Vec3 centre = (unit.corner(t, 0) + unit.corner(t, 1) + unit.corner(t, 2)) / 3;
    fields.strain.push_back(static_cast<float>(0.5 + 0.4 * std::sin(3 * centre.x + centre.y)));
  }
  for (const Vec3& p : unit.positions)
    fields.curvature.push_back(static_cast<float>(0.1 + 0.1 * std::sin(2 * p.y - p.z)));
  return fields;
}

TriangleMesh roughTorus() {
  return surfaces::inFloats(shapes::jittered(shapes::torus(24, 12), 0.02, 11));
}

History run(const TriangleMesh& mesh, const Fields& fields, const SimplifyOptions& options) {
  Job job;
  return simplify(mesh, fields.guidance(), options, job);
}

void expectSameSequence(const History& a, const History& b) {
  EXPECT_EQ(a.kept, b.kept);
  EXPECT_EQ(a.removed, b.removed);
  EXPECT_EQ(a.trianglesAfter, b.trianglesAfter);
}

TEST(Simplify, isTheSameOnAnyNumberOfThreads) {
  const TriangleMesh mesh = surfaces::inFloats(shapes::jittered(shapes::torus(64, 40), 0.01, 2));
  const Fields fields = fieldsOf(mesh);
  for (const SimplifyOptions& options : {kQem, kPaper, kLimber}) {
    const History once = run(mesh, fields, options);
    for (int threads : {1, 2, 3}) {
      setThreadCount(threads);
      const History again = run(mesh, fields, options);
      expectSameSequence(once, again);
      EXPECT_EQ(once.positions, again.positions);
    }
    setThreadCount(1);
  }
}

TEST(Simplify, doesNotDependOnTheUnitsOfTheFile) {
  const TriangleMesh mesh = roughTorus();
  const Fields fields = fieldsOf(mesh);
  for (const double scale : {1.0 / 1024, 64.0}) {
    TriangleMesh scaled = mesh;
    for (Vec3& p : scaled.positions) p *= scale;
    for (const SimplifyOptions& options : {kQem, kPaper, kLimber})
      expectSameSequence(run(scaled, fields, options), run(mesh, fields, options));
  }
}

TEST(Simplify, doesNotDependOnTheAxes) {
  const TriangleMesh mesh = roughTorus();
  const Fields fields = fieldsOf(mesh);
  TriangleMesh turned = mesh;
  for (Vec3& p : turned.positions) p = {-p.y, p.z, -p.x};
  for (const SimplifyOptions& options : {kQem, kPaper, kLimber})
    expectSameSequence(run(turned, fields, options), run(mesh, fields, options));
}

TEST(Simplify, doesNotDependOnTheNumberingWhereNoCostsAreEqual) {
  const TriangleMesh mesh = roughTorus();
  std::mt19937 random(4);
  std::vector<uint32_t> number(mesh.vertexCount());
  std::iota(number.begin(), number.end(), 0);
  std::shuffle(number.begin(), number.end(), random);
  TriangleMesh renumbered = mesh;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) renumbered.positions[number[v]] = mesh.positions[v];
  for (Triangle& t : renumbered.triangles) t = {number[t[1]], number[t[2]], number[t[0]]};
  std::shuffle(renumbered.triangles.begin(), renumbered.triangles.end(), random);

  for (const SimplifyOptions& options : {kQem, kPaper, kLimber}) {
    const History a = run(mesh, fieldsOf(mesh), options);
    const History b = run(renumbered, fieldsOf(renumbered), options);
    EXPECT_EQ(a.trianglesAfter, b.trianglesAfter);
    for (uint32_t faces : {400u, 200u, 60u, 0u}) {
      const TriangleMesh p = meshAt(mesh, a, faces).mesh, q = meshAt(renumbered, b, faces).mesh;
      ASSERT_EQ(p.vertexCount(), q.vertexCount());
      for (const Vec3& point : p.positions) {
        double nearest = 1;
        for (const Vec3& other : q.positions) nearest = std::min(nearest, length(point - other));
        EXPECT_LT(nearest, 1e-5) << faces;
      }
    }
  }
}

TEST(Simplify, takesAFlatRegionBeforeACurvedOne) {
  // The right half of the sheet is wavy.
  TriangleMesh sheet = shapes::grid(24, 12, 2, 1);
  for (Vec3& p : sheet.positions)
    if (p.x > 1) p.z = 0.05 * std::sin(20 * p.x) * std::sin(17 * p.y);
  sheet = surfaces::inFloats(sheet);
  Job job;
  const TriangleMesh half = meshAt(sheet, simplify(sheet, {}, kQem, job), sheet.triangleCount() / 2).mesh;
  const auto right = std::ranges::count_if(half.positions, [](const Vec3& p) { return p.x > 1; });
  EXPECT_GT(right, 0.9 * half.vertexCount() - 12);
}

TEST(Simplify, keepsTrianglesWhereTheStrainRanksHigh) {
  const TriangleMesh sphere = surfaces::inFloats(shapes::sphere(4));
  Fields fields;
  for (uint32_t t = 0; t < sphere.triangleCount(); ++t) {
    const double z = (sphere.corner(t, 0).z + sphere.corner(t, 1).z + sphere.corner(t, 2).z) / 3;
    fields.strain.push_back(static_cast<float>(0.5 + 0.5 * z));
  }
  const auto upperShare = [&](double weight) {
    const SimplifyOptions options{.method = Method::Paper, .strainWeight = weight, .qualityWeight = 0.01};
    const TriangleMesh mesh = meshAt(sphere, run(sphere, fields, options), 600).mesh;
    const auto upper = std::ranges::count_if(mesh.positions, [](const Vec3& p) { return p.z > 0; });
    return static_cast<double>(upper) / mesh.vertexCount();
  };
  EXPECT_NEAR(upperShare(0), 0.5, 0.08);
  EXPECT_GT(upperShare(1), 0.6);
  EXPECT_GT(upperShare(50), 0.8);
}

// Table 3 of the paper: the rows with the curvature term alone and with the quality term.
TEST(Simplify, raisesTheMeanAngleOfTheBarByTheQualityTerm) {
  const TriangleMesh bar = shapes::box(8, 8, 24, 0.125);
  Job job;
  Fields fields;
  fields.curvature = meanCurvature(bar, buildTopology(bar), job).vertex;
  const float largest = *std::ranges::max_element(fields.curvature);
  for (float& value : fields.curvature) value /= largest;
  const auto meanAngle = [&](double qualityWeight) {
    const SimplifyOptions options{
        .method = Method::Paper, .curvatureWeight = 1, .qualityWeight = qualityWeight};
    return measureQuality(meshAt(bar, run(bar, fields, options), 950).mesh).meanMinAngle;
  };
  EXPECT_GT(meanAngle(0.01), meanAngle(0) + 0.5);
}

TEST(Simplify, makesNoSliverWhereThereIsNone) {
  const SimplifyOptions options{.method = Method::Limber, .qualityWeight = 0.1, .sizeWeight = 0.01};
  for (uint32_t seed = 1; seed <= 8; ++seed) {
    TriangleMesh mesh = shapes::jittered(shapes::torus(48, 24), 0.01, seed);
    for (Vec3& p : mesh.positions)
      p = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    Job job;
    const History history = simplify(mesh, {}, options, job);
    for (const double ratio : {0.5, 0.25}) {
      const auto faces = static_cast<uint32_t>(ratio * mesh.triangleCount());
      EXPECT_GT(measureQuality(meshAt(mesh, history, faces).mesh).minAngle, 8) << seed << " at " << ratio;
    }
  }
}

TEST(Simplify, withoutGuidanceOrQualityIsQem) {
  const TriangleMesh mesh = roughTorus();
  const SimplifyOptions bare{.method = Method::Paper};
  expectSameSequence(run(mesh, fieldsOf(mesh), bare), run(mesh, {}, kQem));
  expectSameSequence(run(mesh, {}, {.method = Method::Paper, .strainWeight = 1, .curvatureWeight = 1}),
                     run(mesh, {}, kQem));
}

TEST(Simplify, refusesGuidanceOfTheWrongSizeAndWeightsThatAreNone) {
  const TriangleMesh mesh = shapes::sphere(1);
  Fields fields;
  fields.strain.resize(79);
  try {
    run(mesh, fields, kPaper);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "The strain that guides the simplification has 79 values, but the mesh has 80 triangles: "
                 "compute it for this mesh.");
  }
  fields = {};
  fields.curvature.resize(1);
  EXPECT_THROW(run(mesh, fields, kPaper), std::invalid_argument);
  EXPECT_THROW(run(mesh, {}, {.strainWeight = -1}), std::invalid_argument);
  EXPECT_THROW(run(mesh, {}, {.qualityWeight = std::nan("")}), std::invalid_argument);
}

TEST(Simplify, reportsProgressThatRisesAndStopsWhenItIsCancelled) {
  const TriangleMesh mesh = shapes::torus(64, 40);
  Job job;
  double last = 0;
  job.observer = [&](Phase phase, double fraction) {
    EXPECT_EQ(phase, Phase::Simplify);
    EXPECT_GE(fraction, last);
    last = fraction;
  };
  simplify(mesh, {}, kQem, job);
  EXPECT_EQ(last, 1);

  job.observer = [&](Phase, double fraction) {
    if (fraction > 0.4) job.requestCancel();
  };
  job.reset();
  EXPECT_THROW(simplify(mesh, {}, kQem, job), Cancelled);
}

}  // namespace
}  // namespace limber
