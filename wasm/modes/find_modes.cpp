#include "modes/find_modes.h"

#include <atomic>
#include <thread>
#include <vector>

#include "base/parallel.h"
#include "elastic/part_modes.h"
#include "mesh/topology.h"
#include "modes/coarse_part.h"

namespace limber {

namespace {

constexpr uint32_t kCoarseVertices = 8000;     // of the copy, at the least
constexpr uint32_t kCoarsestVertices = 40000;  // where nothing refines its modes
constexpr uint32_t kSmallPart = 4000;          // vertices of one that is solved beside others
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

PartModes solveOne(const Part& part, const ModesOptions& options, bool exact, Job& job) {
  const bool isLarge = part.model == Model::Shell && part.mesh.vertexCount() > kExactVertices;
  return isLarge && !exact ? solveCoarsely(part, options, job) : solvePart(part, options, job);
}

// Small parts, of which each would keep few threads busy. Progress is the share of those that are done.
void solveSideBySide(const std::vector<Part>& parts, const std::vector<size_t>& small,
                     const ModesOptions& options, std::vector<PartModes>& modes, Job& job) {
  WholePhase phase(job, Phase::Solve);
  std::atomic<size_t> done = 0;
  const auto caller = std::this_thread::get_id();
  parallelFor(small.size(), 1, [&](size_t at, size_t) {
    modes[small[at]] = solvePart(parts[small[at]], options, job);
    const double fraction = static_cast<double>(++done) / static_cast<double>(small.size());
    if (std::this_thread::get_id() == caller) phase.report(fraction);
  });
}

}  // namespace

ModeSet findModes(const TriangleMesh& mesh, const ModesOptions& options, bool exact, Job& job) {
  checkModesOptions(mesh, options);
  const std::vector<Part> parts = partsOf(mesh, buildTopology(mesh), options);
  std::vector<PartModes> modes(parts.size());
  std::vector<size_t> small;
  for (size_t i = 0; i < parts.size(); ++i)
    if (parts.size() > 1 && parts[i].mesh.vertexCount() <= kSmallPart)
      small.push_back(i);
    else
      modes[i] = solveOne(parts[i], options, exact, job);
  if (!small.empty()) solveSideBySide(parts, small, options, modes, job);
  return collectModes(mesh, parts, modes, options);
}

}  // namespace limber
