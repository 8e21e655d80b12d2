#include "modes/coarse_vibration.h"

#include "modes/coarse_part.h"

namespace limber {

ModeBasis coarseVibration(const TriangleMesh& mesh, const CoarseVibrationOptions& options, Job& job) {
  Part part;
  part.model = ElasticModel::Shell;
  part.mesh = mesh;
  part.pinned.assign(options.pinned.begin(), options.pinned.end());
  const CoarsePart coarse = coarsen(part, options.vertices, job);
  const TriangleMesh& copy = coarse.part.mesh;
  const Topology topology = buildTopology(copy);
  const VibratingShell shell(copy, topology, {.poisson = options.poisson, .pinned = coarse.part.pinned}, job);
  const ModeBasis found = shell.solve(copy, options.request, job);
  return {found.lambda, Prolongation(part, coarse).prolong(found.phi, job)};
}

}  // namespace limber
