// Both fits, under constraints and limits: topology and locked vertices stay, positions stay finite.

#include "fit/modal_fit.h"
#include "fit/shape_fit.h"
#include "mesh/repair/inspect.h"
#include "promises.h"
#include "simplify/simplify.h"
#include "soup.h"

namespace limber::fuzz {
namespace {

template <class Options>
void drawLimits(Options& options, FuzzInput& input) {
  options.keepsSeams = input.chance(128);
  if (input.chance(64)) options.maxDeviation = input.real(0, 1);
  if (input.chance(64)) options.minAngle = input.real(0, 59);
}

void requireFitted(const MeshAt& before, const MeshAt& after) {
  requireMesh(after.mesh);
  require(after.mesh.triangleCount() == before.mesh.triangleCount(), "a fit keeps the number of faces");
  require(inspect(after.mesh).genus == inspect(before.mesh).genus, "a fit keeps the genus");
}

}  // namespace

void fuzzFit(FuzzInput& input) {
  const TriangleMesh mesh = drawMesh(input, 120);
  std::vector<uint8_t> locked;
  std::vector<uint32_t> pinned;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    locked.push_back(input.chance(16));
    if (input.chance(16)) pinned.push_back(v);
  }
  Job job;
  const History history = simplify(mesh, {}, {.method = Method::Limber, .sizeWeight = 0.01}, job);
  const MeshAt level = meshAt(mesh, history, input.below(mesh.triangleCount() + 1));
  ShapeFitOptions shape;
  drawLimits(shape, input);
  shape.locked = locked;
  shape.pinned = PinnedVertices(pinned);
  requireFitted(level, fitShape(mesh, level, shape, job).result);
  if (!input.chance(64)) return;
  ModalFitOptions modal;
  drawLimits(modal, input);
  modal.thickness = input.real(0.001, 0.1);
  modal.modeCount = 3;
  modal.locked = locked;
  modal.pinned = PinnedVertices(pinned);
  requireFitted(level, fitModes(mesh, level, modal, job).result);
}

}  // namespace limber::fuzz
