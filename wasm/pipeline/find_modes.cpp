#include "pipeline/find_modes.h"

#include "mesh/topology.h"
#include "modes/part_modes.h"
#include "pipeline/coarse_part.h"

namespace limber {

namespace {

constexpr uint32_t kCoarseVertices = 8000;     // of the copy, at the least
constexpr uint32_t kCoarsestVertices = 40000;  // where nothing refines its modes
constexpr int kSpareModes = 6;  // beyond the wanted ones: the subspace converges by the first one left out

PartModes solveCoarsely(const Part& part, const ModesOptions& options, Job& job) {
  const bool isRefined = part.mesh.vertexCount() <= kRefinedVertices;
  const CoarsePart coarse = coarsen(part, isRefined ? kCoarseVertices : kCoarsestVertices, job);
  ModesOptions coarseOptions = options;
  if (isRefined) coarseOptions.modeCount += kSpareModes;
  PartModes modes = solvePart(coarse.part, coarseOptions, job);
  const Prolongation prolongation(part.mesh, coarse);
  for (auto& shape : modes.shapes) {
    job.check();
    shape = prolongation.prolong(shape);
    for (uint32_t v : part.pinned) shape[v] = {};
    normaliseShape(shape);
  }
  modes.coarseVertices = coarse.part.mesh.vertexCount();
  return isRefined && !modes.omega.empty() ? refineShell(part, modes, options, job) : modes;
}

}  // namespace

ModeSet findModes(const TriangleMesh& mesh, const ModesOptions& options, bool exact, Job& job) {
  checkModesOptions(mesh, options);
  const std::vector<Part> parts = partsOf(mesh, buildTopology(mesh), options);
  std::vector<PartModes> modes;
  for (const Part& part : parts) {
    const bool isLarge = part.model == Model::Shell && part.mesh.vertexCount() > kExactVertices;
    modes.push_back(isLarge && !exact ? solveCoarsely(part, options, job) : solvePart(part, options, job));
  }
  return collectModes(mesh, parts, modes, options);
}

}  // namespace limber
