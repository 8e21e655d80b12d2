#include "modes/find_modes.h"

#include <stdexcept>
#include <vector>

#include "base/parallel_jobs.h"
#include "elastic/followed_modes.h"
#include "elastic/mode_conversions.h"
#include "elastic/part_modes.h"
#include "mesh/topology.h"
#include "modes/coarse_part.h"
#include "modes/equal_parts.h"

namespace limber {

namespace {

// Whether modes only guide, so that only the strain rank of each triangle is derived from them.
bool guidesAlone(const ModesOptions& options) {
  return options.guidedParts > 0;
}

PartModes solveCoarsely(const Part& part, const ModesOptions& options, Job& job) {
  const bool isRefined = part.mesh.vertexCount() <= kRefinedVertices && !guidesAlone(options);
  const uint32_t unrefined = guidesAlone(options) ? kGuidingCopyVertices : kUnrefinedCopyVertices;
  const CoarsePart coarse = coarsen(part, isRefined ? kCoarseVertices : unrefined, job);
  ModesOptions coarseOptions = options;
  if (isRefined) coarseOptions.modeCount += kSpareModes;
  PartModes modes = solvePart(coarse.part, coarseOptions, job);
  modes.basis.phi = Prolongation(part, coarse).prolong(modes.basis.phi, job);
  for (Eigen::Index k = 0; k < modes.basis.modeCount(); ++k) normaliseShape(modes.basis.phi.col(k));
  modes.coarseVertices = coarse.part.mesh.vertexCount();
  return isRefined && modes.basis.modeCount() > 0 ? refineShell(part, modes, options, job) : modes;
}

PartModes solveOne(const Part& part, const ModesOptions& options, bool exact, Job& job) {
  const uint32_t most = guidesAlone(options) ? kGuidingCopyVertices : kExactVertices;
  const bool isLarge = part.model == ElasticModel::Shell && part.mesh.vertexCount() > most;
  return isLarge && !exact ? solveCoarsely(part, options, job) : solvePart(part, options, job);
}

// As `solveOne`, but if modes only guide, a part that cannot be solved has no modes and records the reason.
PartModes solveOrSkip(const Part& part, const ModesOptions& options, bool exact, Job& job) {
  if (!guidesAlone(options)) return solveOne(part, options, exact, job);
  try {
    return solveOne(part, options, exact, job);
  } catch (const Cancelled&) {
    throw;
  } catch (const std::runtime_error& error) {
    PartModes none;
    none.failure = error.what();
    return none;
  }
}

// A part and the destination of its modes.
struct PartTask {
  const Part& part;
  PartModes& modes;
};

}  // namespace

ModeSet findModes(const TriangleMesh& mesh, const ModesOptions& asked, bool exact, Job& job) {
  checkModesOptions(mesh, asked);
  const std::vector<Part> parts = partsOf(mesh, buildTopology(mesh), asked);
  ModesOptions options = asked;
  options.guidedParts *= static_cast<uint32_t>(parts.size());
  std::vector<PartModes> modes(parts.size());
  const std::vector<size_t> first = firstEqualParts(mesh, parts);
  std::vector<PartTask> small;
  for (size_t i = 0; i < parts.size(); ++i)
    if (first[i] != i)
      continue;
    else if (parts.size() > 1 && parts[i].mesh.vertexCount() <= kSmallPartVertices)
      small.push_back({parts[i], modes[i]});
    else
      modes[i] = solveOrSkip(parts[i], options, exact, job);
  parallelJobs(small.size(), Phase::Solve, job,
               [&](size_t i, Job& own) { small[i].modes = solveOrSkip(small[i].part, options, exact, own); });
  for (size_t i = 0; i < parts.size(); ++i)
    if (first[i] != i) modes[i] = modes[first[i]];
  return collectModes(mesh, parts, modes, options);
}

}  // namespace limber
