// What is carried from an original to its result: corners of attributes, bindings, pins.

#include "mesh/charts.h"
#include "promises.h"
#include "simplify/simplify.h"
#include "soup.h"
#include "transfer/bind_meshes.h"
#include "transfer/carry_pins.h"
#include "transfer/corner_sources.h"

namespace limber::fuzz {

void fuzzTransfer(FuzzInput& input) {
  const TriangleMesh mesh = drawMesh(input, 200);
  std::vector<uint32_t> wedges, groups, pinned;
  for (const Triangle& corners : mesh.triangles) {
    groups.push_back(input.byte() % 3);
    for (const uint32_t v : corners) wedges.push_back(2 * v + (input.byte() & 1));
  }
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    if (input.chance(64)) pinned.push_back(v);
  const bool hasSeams = input.chance(128);
  SimplifyOptions options;
  options.method = Method::Limber;
  if (hasSeams) options.constraints.wedges = wedges, options.constraints.groups = groups;
  Job job;
  const History history = simplify(mesh, {}, options, job);
  const MeshAt level = meshAt(mesh, history, input.below(mesh.triangleCount() + 1));
  const Charts charts = hasSeams ? Charts{wedges, groups} : Charts{};
  const CornerSources sources = sourceOfCorners(mesh, charts, level, job);
  require(sources.triangle.size() == 3 * level.mesh.triangles.size(), "every corner has a source");
  for (const uint32_t t : sources.triangle)
    require(t < mesh.triangleCount(), "the source of a corner exists");
  requireFinite(sources.barycentric, "the place of a source is finite");
  const Binding binding = bindToResult(mesh, level, job);
  requireFinite(binding.barycentric, "the place of a bound vertex is finite");
  for (const uint32_t t : binding.triangle)
    require(t == kNone || t < level.mesh.triangleCount(), "a bound vertex lies on a triangle that exists");
  const Pins pins = carryPins(mesh, pinned, level.mesh);
  for (const uint32_t v : pins.vertices) require(v < level.mesh.vertexCount(), "a carried pin exists");
}

}  // namespace limber::fuzz
