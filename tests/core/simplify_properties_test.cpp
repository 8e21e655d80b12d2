#include <gtest/gtest.h>

#include <map>
#include <numeric>

#include "base/parallel.h"
#include "mesh/topology.h"
#include "same_topology.h"
#include "simplify/simplify.h"
#include "surfaces.h"

// Properties that must hold for any mesh and any constraints. Seeded generators draw both; every failure
// reports the seed.

namespace limber {
namespace {

class Random {
 public:
  explicit Random(uint32_t seed) : engine_(seed) {}
  double real(double low, double high) { return low + (high - low) * (engine_() / 4294967296.0); }
  uint32_t below(uint32_t count) { return engine_() % count; }
  bool chance(double p) { return real(0, 1) < p; }

 private:
  std::mt19937 engine_;
};

TriangleMesh randomMesh(Random& random) {
  const double noise = random.chance(0.3) ? 0 : random.real(0, 0.02);
  const auto size = static_cast<int>(6 + random.below(10));
  TriangleMesh mesh;
  switch (random.below(6)) {
    case 0:
      mesh = shapes::sphere(2 + static_cast<int>(random.below(2)));
      break;
    case 1:
      mesh = shapes::torus(2 * size, size);
      break;
    case 2:
      mesh = shapes::grid(size, size + 3);
      break;
    case 3:
      mesh = surfaces::annulus(2 * size, 4);
      break;
    case 4:
      mesh = shapes::box(4, 5, size, 0.2);
      break;
    default:
      return surfaces::randomVoxels(random.below(1000));
  }
  if (random.chance(0.3)) mesh = shapes::together(mesh, shapes::box(2, 3, 2, 0.1));
  return surfaces::inFloats(shapes::jittered(mesh, noise, random.below(1000)));
}

// A mesh, fields and constraints that own their storage.
struct Trial {
  TriangleMesh mesh;
  std::vector<float> strain, curvature, keep, attributes;
  std::vector<uint32_t> wedges, groups, pinnedSets;
  std::vector<uint8_t> locked;
  SimplifyOptions options;

  Guidance guidance() const { return {strain, curvature}; }
  History run() const {
    Job job;
    SimplifyOptions request = options;
    request.constraints.wedges = wedges;
    request.constraints.groups = groups;
    request.constraints.locked = locked;
    request.constraints.keep = keep;
    request.constraints.pinnedSets = pinnedSets;
    request.constraints.attributes = attributes;
    return simplify(mesh, guidance(), request, job);
  }
};

// The fields are functions of position, so they do not depend on the numbering of the mesh.
void drawLists(Trial& trial, Random& random) {
  const TriangleMesh& mesh = trial.mesh;
  const Vec3 cut{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
  const double at = random.real(-0.3, 0.3);
  const bool hasGroups = random.chance(0.5), hasWedges = random.chance(0.5), hasPins = random.chance(0.5),
             hasLocks = random.chance(0.5), hasKeep = random.chance(0.5), hasAttributes = random.chance(0.5);
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const Vec3 centre = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3;
    trial.strain.push_back(static_cast<float>(0.5 + 0.4 * std::sin(3 * centre.x + centre.y)));
    if (hasGroups) trial.groups.push_back(dot(cut, centre) > at);
    for (const uint32_t v : mesh.triangles[t])
      if (hasWedges) trial.wedges.push_back(v + (centre.y > at ? mesh.vertexCount() : 0));
  }
  const uint32_t wedges = hasWedges ? 2 * mesh.vertexCount() : mesh.vertexCount();
  for (uint32_t wedge = 0; hasAttributes && wedge < wedges; ++wedge) {
    const Vec3& p = mesh.positions[wedge % mesh.vertexCount()];
    trial.attributes.push_back(
        static_cast<float>(0.2 * p.x + (wedge < mesh.vertexCount() ? 0.1 : 0.4) * p.y * p.z));
  }
  trial.options.constraints.attributeDimension = hasAttributes ? 1 : 0;
  for (const Vec3& p : mesh.positions) {
    trial.curvature.push_back(static_cast<float>(0.1 + 0.1 * std::sin(2 * p.y - p.z)));
    if (hasKeep) trial.keep.push_back(p.z > at ? 0.5f : 0);
    if (hasPins) trial.pinnedSets.push_back((p.x > 0.5 ? 1u : 0u) | (p.y > 0.4 ? 4u : 0u));
    if (hasLocks) trial.locked.push_back(std::sin(40 * p.x + 13 * p.y + 5 * p.z) > 0.9);
  }
}

Trial draw(uint32_t seed) {
  Random random(seed);
  Trial trial;
  trial.mesh = randomMesh(random);
  trial.options.method = static_cast<Method>(random.below(3));
  trial.options.strainWeight = random.real(0, 3);
  trial.options.curvatureWeight = random.real(0, 1);
  trial.options.qualityWeight = random.chance(0.3) ? 0 : random.real(0, 0.2);
  trial.options.sizeWeight = random.real(0, 0.05);
  trial.options.constraints.creaseAngle = random.chance(0.3) ? random.real(20, 80) : 0;
  trial.options.constraints.borders = random.chance(0.3) ? Borders::Fixed : Borders::Free;
  if (random.chance(0.2)) trial.options.minAngle = random.real(5, 30);
  if (random.chance(0.2)) trial.options.maxDeviation = random.real(0.01, 0.1);
  drawLists(trial, random);
  return trial;
}

void expectLocksKept(const Trial& trial, const MeshAt& at) {
  for (uint32_t v = 0; v < trial.mesh.vertexCount(); ++v) {
    const uint32_t survivor = at.vertexOfInput[v];
    ASSERT_NE(survivor, kNone);
    if (!trial.pinnedSets.empty() && trial.pinnedSets[v] != 0) {
      ASSERT_EQ(trial.pinnedSets[at.inputOfVertex[survivor]], trial.pinnedSets[v]);
    }
    if (trial.locked.empty() || !trial.locked[v]) continue;
    ASSERT_EQ(at.inputOfVertex[survivor], v);
    ASSERT_EQ(at.mesh.positions[survivor], trial.mesh.positions[v]);
  }
}

void expectBordersKept(const Trial& trial, const MeshAt& at) {
  for (const Topology topology = buildTopology(trial.mesh); const auto& edge : topology.edges) {
    if (edge.useCount != 1) continue;
    for (const uint32_t v : {edge.a, edge.b})
      ASSERT_EQ(at.mesh.positions[at.vertexOfInput[v]], trial.mesh.positions[v]);
  }
}

// The unit normals of the triangles, by the input triangle that each of them was.
std::map<uint32_t, Vec3> normalsOf(const MeshAt& at) {
  std::map<uint32_t, Vec3> normals;
  for (uint32_t t = 0; t < at.mesh.triangleCount(); ++t)
    normals[at.inputOfTriangle[t]] = normalized(areaNormal(at.mesh, t));
  return normals;
}

void expectNoFlip(const Trial& trial, const History& history, uint32_t i) {
  const uint32_t before = i == 0 ? trial.mesh.triangleCount() : history.trianglesAfter[i - 1];
  const auto from = normalsOf(meshAt(trial.mesh, history, before));
  for (const auto& [t, normal] : normalsOf(meshAt(trial.mesh, history, history.trianglesAfter[i])))
    ASSERT_GT(dot(normal, from.at(t)), 0.1) << "triangle " << t << " at collapse " << i;
}

class Properties : public ::testing::TestWithParam<uint32_t> {};

TEST_P(Properties, topologyLocksAndBordersAreKeptAndNoFaceFlips) {
  const Trial trial = draw(GetParam());
  const History history = trial.run();
  for (uint32_t i = 0; i < history.collapseCount(); i += 1 + history.collapseCount() / 12) {
    const MeshAt at = meshAt(trial.mesh, history, history.trianglesAfter[i]);
    expectSameTopology(trial.mesh, at.mesh);
    expectLocksKept(trial, at);
    if (trial.options.constraints.borders == Borders::Fixed) expectBordersKept(trial, at);
    expectNoFlip(trial, history, i);
  }
}

TEST_P(Properties, aReplayStepByStepEqualsTheMeshAtThatCount) {
  const Trial trial = draw(GetParam());
  const History history = trial.run();
  surfaces::Replay replay(trial.mesh, history);
  for (uint32_t i = 0; i < history.collapseCount(); ++i) {
    replay.step(i);
    if (i % 29 != 0 && i + 1 != history.collapseCount()) continue;
    const MeshAt at = meshAt(trial.mesh, history, history.trianglesAfter[i]);
    ASSERT_EQ(at.mesh.triangleCount(), replay.triangles().size());
    for (uint32_t t = 0; t < at.mesh.triangleCount(); ++t)
      for (int c = 0; c < 3; ++c)
        ASSERT_EQ(at.mesh.corner(t, c), replay.positions()[replay.triangles()[t][c]]);
  }
}

TEST_P(Properties, everyRunAndEveryNumberOfThreadsGivesTheSameBits) {
  const Trial trial = draw(GetParam());
  const History once = trial.run();
  for (const int threads : {1, 3}) {
    setThreadCount(threads);
    const History again = trial.run();
    EXPECT_EQ(again.kept, once.kept);
    EXPECT_EQ(again.removed, once.removed);
    EXPECT_EQ(again.positions, once.positions);
  }
  setThreadCount(1);
}

TEST_P(Properties, aRotationByRightAnglesRotatesTheResult) {
  Trial trial = draw(GetParam());
  const History straight = trial.run();
  for (Vec3& p : trial.mesh.positions) p = {-p.y, p.z, -p.x};
  const History turned = trial.run();
  EXPECT_EQ(turned.kept, straight.kept);
  EXPECT_EQ(turned.removed, straight.removed);
}

INSTANTIATE_TEST_SUITE_P(Seed, Properties, ::testing::Range(1u, 29u));

}  // namespace
}  // namespace limber
