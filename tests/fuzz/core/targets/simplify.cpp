// Histories under any options and constraints: topology stays, limits hold, every level is a mesh.

#include "simplify/simplify.h"

#include "mesh/repair/inspect.h"
#include "promises.h"
#include "simplify/why_kept.h"
#include "soup.h"

namespace limber::fuzz {
namespace {

struct Lists {
  std::vector<float> strain, curvature, keep, attributes, textureWeights;
  std::vector<uint32_t> wedges, groups, pinnedSets;
  std::vector<uint8_t> locked;
};

template <class T>
void draw(std::vector<T>& list, FuzzInput& input, size_t count, uint32_t values) {
  if (!input.chance(80)) return;
  const uint32_t period = 1 + input.byte();
  std::vector<T> pattern(period);
  for (T& value : pattern) value = static_cast<T>(input.byte() % values);
  for (size_t i = 0; i < count; ++i) list.push_back(pattern[i % period]);
}

double drawWeight(FuzzInput& input) {
  return input.chance(32) ? static_cast<double>(input.anyFloat()) : input.real(0, 3);
}

SimplifyOptions drawOptions(FuzzInput& input) {
  SimplifyOptions options;
  options.method = static_cast<Method>(input.byte() % 3);
  options.strainWeight = drawWeight(input);
  options.curvatureWeight = drawWeight(input);
  options.qualityWeight = drawWeight(input);
  options.sizeWeight = drawWeight(input);
  if (input.chance(64)) options.stopFaces = input.below(200);
  if (input.chance(64)) options.maxDeviation = input.anyFloat();
  if (input.chance(64)) options.minAngle = input.real(-1, 61);
  if (input.chance(64)) options.deferBeyond = input.anyFloat();
  options.recordErrors = input.chance(128);
  options.constraints.creaseAngle = input.chance(64) ? input.real(-1, 181) : 0;
  options.constraints.borders = input.chance(64) ? Borders::Fixed : Borders::Free;
  return options;
}

void drawLists(Lists& lists, SimplifyOptions& options, const TriangleMesh& mesh, FuzzInput& input) {
  const size_t vertices = mesh.vertexCount(), triangles = mesh.triangleCount();
  draw(lists.strain, input, triangles, 2);
  draw(lists.curvature, input, vertices, 2);
  draw(lists.keep, input, vertices, 2);
  draw(lists.groups, input, triangles, 3);
  draw(lists.pinnedSets, input, vertices, 8);
  draw(lists.locked, input, vertices, 2);
  if (input.chance(80))
    for (const Triangle& corners : mesh.triangles)
      for (const uint32_t v : corners) lists.wedges.push_back(2 * v + (input.byte() & 1));
  options.constraints.wedges = lists.wedges;
  options.constraints.groups = lists.groups;
  options.constraints.keep = lists.keep;
  options.constraints.locked = lists.locked;
  options.constraints.pinnedSets = lists.pinnedSets;
  if (input.chance(64)) {
    options.constraints.attributeDimension = 1 + input.byte() % 3;
    draw(lists.attributes, input,
         (lists.wedges.empty() ? 1 : 2) * vertices * options.constraints.attributeDimension, 200);
    draw(lists.textureWeights, input, triangles, 2);
    options.constraints.attributes = lists.attributes;
    options.constraints.textureWeights = lists.textureWeights;
    options.constraints.displacementFields = options.constraints.attributeDimension / 3;
    if (lists.attributes.empty()) options.constraints.attributeDimension = 0;
  }
}

void requireSameTopology(const Inspection& before, const Inspection& after) {
  require(after.components == before.components, "the number of components stays");
  require(after.boundaryLoops == before.boundaryLoops, "the number of boundary loops stays");
  require(after.genus == before.genus, "the genus stays");
  require(after.eulerCharacteristic == before.eulerCharacteristic, "the Euler characteristic stays");
  require(after.nonManifoldEdges == before.nonManifoldEdges, "non-manifold edges stay");
  require(after.nonManifoldVertices == before.nonManifoldVertices, "non-manifold vertices stay");
}

}  // namespace

void fuzzSimplify(FuzzInput& input) {
  const TriangleMesh mesh = drawMesh(input, 300);
  SimplifyOptions options = drawOptions(input);
  Lists lists;
  drawLists(lists, options, mesh, input);
  Job job;
  const History history = simplify(mesh, {lists.strain, lists.curvature}, options, job);
  require(history.collapseCount() == 0 || history.trianglesAfter.back() > 0 || mesh.triangles.empty(),
          "some triangle is left");
  requireFinite(history.errors, "an estimated deviation is finite");
  const Inspection before = inspect(mesh);
  for (const uint32_t faces : {0u, mesh.triangleCount() / 2, input.below(mesh.triangleCount() + 2)}) {
    const MeshAt level = meshAt(mesh, history, faces);
    requireMesh(level.mesh);
    requireSameTopology(before, inspect(level.mesh));
  }
  if (input.chance(64))
    whyKept({mesh, {lists.strain, lists.curvature}, options, history}, mesh.triangleCount() / 2, job);
}

}  // namespace limber::fuzz
