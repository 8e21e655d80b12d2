#include "elastic/part_modes.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "elastic/displacement.h"
#include "elastic/laplacian.h"
#include "elastic/pins.h"
#include "elastic/refine_pinned_faces.h"
#include "elastic/shell_vibration.h"
#include "elastic/solid/lattice_grid.h"
#include "elastic/solid/solid.h"
#include "elastic/solve_modes.h"
#include "mesh/eigen_vec3.h"
#include "mesh/principal_axes.h"

namespace limber {

namespace {

// The stiffness of the spring at a pinned point of a solid, relative to that of a cell (E times its size).
// Pins yield by about its inverse, and residuals lose accuracy by this factor.
constexpr double kPinStiffness = 1e4;

// Rough estimates of the first elastic eigenvalue in the frame of a part.
constexpr double kSolidScale = 0.5, kLaplacianScale = 5;

constexpr int kRefineSteps = 4;

// Displacements within this relative distance of the largest one count as equal: the first of them decides,
// so that rounding does not.
constexpr double kTie = 1e-9;

// The modes of a part from a solution; displacement(v, k) returns that of vertex v in pair k.
template <class Displacement>
PartModes gather(const Part& part, const EigenSolution& solution, const Displacement& displacement) {
  PartModes modes;
  modes.zeroModesExpected = rigidMotionsLeft(part.mesh, part.pinned);
  modes.zeroModesFound = solution.nullity;
  modes.residual = solution.residual;
  modes.axis.assign(solution.residual.size(), -1);
  modes.factorNonzeros = solution.factorNonzeros;
  modes.basis.lambda = solution.basis.lambda;
  modes.basis.phi.resize(3 * static_cast<Eigen::Index>(part.mesh.vertexCount()), solution.basis.modeCount());
  parallelFor(static_cast<size_t>(solution.basis.modeCount()), 1, [&](size_t begin, size_t end) {
    for (auto k = static_cast<Eigen::Index>(begin); k < static_cast<Eigen::Index>(end); ++k) {
      for (uint32_t v = 0; v < part.mesh.vertexCount(); ++v)
        modes.basis.phi.col(k).segment<3>(3 * static_cast<Eigen::Index>(v)) = eigen(displacement(v, k));
      normaliseShape(modes.basis.phi.col(k));
    }
  });
  return modes;
}

// An estimate of the bytes that a shell takes, before anything is allocated: K and its structure take about a
// kilobyte per triangle, L about 38 n log2(n) numbers for n vertices (measured on scans). Once the structure
// of L is known, the eigensolver asks again.
uint64_t estimatedMemory(const TriangleMesh& mesh) {
  const double n = std::max(2.0, static_cast<double>(mesh.vertexCount()));
  return static_cast<uint64_t>(1000.0 * mesh.triangleCount() + 38 * sizeof(double) * n * std::log2(n));
}

// A part as a shell with everything that its solves need.
class PartShell {
 public:
  PartShell(const Part& part, const ModesOptions& options, Job& job)
      : part_(part),
        topology_(beginAssembly(part, job)),
        shell_(part.mesh, topology_,
               {options.material.poisson, kRoughTolerance, kRefineSteps, part.pinned,
                static_cast<int>(rigidMotionsLeft(part.mesh, part.pinned))},
               job),
        request_{options.material.thickness / part.diagonal, options.modeCount} {}

  PartModes solve(Job& job) const { return gathered(shell_.solveExactly(part_.mesh, request_, job)); }
  PartModes refine(const ModeBasis& start, Job& job) const {
    return gathered(shell_.refine(part_.mesh, start, request_, job));
  }

 private:
  static Topology beginAssembly(const Part& part, Job& job) {
    job.begin(Phase::Assemble);
    requireMemoryToSolve(estimatedMemory(part.mesh));
    return buildTopology(part.mesh);
  }
  PartModes gathered(const EigenSolution& solution) const {
    return gather(part_, solution,
                  [&](uint32_t v, Eigen::Index k) { return displacementAt(solution.basis.phi.col(k), v); });
  }

  const Part& part_;
  Topology topology_;
  VibratingShell shell_;
  VibrationRequest request_;
};

PartModes solveSolid(const Part& part, const ModesOptions& options, Job& job) {
  job.begin(Phase::Assemble);
  SolidOptions solidOptions;
  solidOptions.targetCells = latticeCells(part, options);
  solidOptions.poisson = options.material.poisson;
  TriangleMesh mesh = part.mesh;
  std::vector<uint32_t> pinned = part.pinned;
  if (!pinned.empty())
    refinePinnedFaces(mesh, pinned, longestSide(latticeGrid(mesh, solidOptions.targetCells).size));
  SolidModel solid = solidModel(mesh, solidOptions, job);
  for (uint32_t v : pinned)
    addPointSpring(solid.pencil,
                   {&solid.embeddingNodes[8 * size_t{v}], &solid.embeddingWeights[8 * size_t{v}]},
                   kPinStiffness * solid.cellSize);
  const auto zeros = static_cast<int>(rigidMotionsLeft(part.mesh, part.pinned));
  const EigenSolution solution = solveModes(solid.pencil, {options.modeCount, zeros, kSolidScale}, job);
  return gather(part, solution, [&](uint32_t v, Eigen::Index k) {
    Vec3 sum;
    for (size_t i = 8 * size_t{v}; i < 8 * size_t{v} + 8; ++i)
      sum += solid.embeddingWeights[i] * displacementAt(solution.basis.phi.col(k), solid.embeddingNodes[i]);
    return sum;
  });
}

// The axes along which a Laplacian moves: the given direction, or the principal axes in turn.
std::vector<Vec3> axesOf(const Part& part, int direction) {
  if (direction < 0) {
    const auto principal = principalAxes(part.mesh).axis;
    return {principal.begin(), principal.end()};
  }
  std::vector<Vec3> axes(1);
  axes[0][direction] = 1;
  return axes;
}

// Each scalar mode is listed once along each axis.
PartModes solveLaplacian(const Part& part, const ModesOptions& options, Job& job) {
  job.begin(Phase::Assemble);
  SparsePencil pencil = laplacianPencil(part.mesh, buildTopology(part.mesh));
  if (!part.pinned.empty()) clampUnknowns(pencil, part.pinned);
  const std::vector<Vec3> axes = axesOf(part, options.direction);
  const auto axisCount = static_cast<int>(axes.size());
  const int scalarZeros = part.pinned.empty() ? 1 : 0;
  const EigenSolution solution = solveModes(
      pencil, {(options.modeCount + axisCount - 1) / axisCount, scalarZeros, kLaplacianScale}, job);
  const Eigen::Index modeCount =
      std::min<Eigen::Index>(options.modeCount, solution.basis.modeCount() * axisCount);
  PartModes modes;
  modes.zeroModesExpected = static_cast<uint32_t>(axisCount * scalarZeros);
  modes.zeroModesFound = static_cast<uint32_t>(axisCount) * solution.nullity;
  modes.factorNonzeros = solution.factorNonzeros;
  modes.basis.lambda.resize(modeCount);
  modes.basis.phi.resize(3 * static_cast<Eigen::Index>(part.mesh.vertexCount()), modeCount);
  for (Eigen::Index mode = 0; mode < modeCount; ++mode) {
    const Eigen::Index k = mode / axisCount;
    const auto axis = static_cast<int>(mode % axisCount);
    modes.basis.lambda[mode] = solution.basis.lambda[k];
    for (Eigen::Index v = 0; v < solution.basis.phi.rows(); ++v)
      modes.basis.phi.col(mode).segment<3>(3 * v) =
          eigen(axes[static_cast<size_t>(axis)] * solution.basis.phi(v, k));
    normaliseShape(modes.basis.phi.col(mode));
    modes.residual.push_back(solution.residual[static_cast<size_t>(k)]);
    modes.axis.push_back(options.direction >= 0 ? -1 : axis);
  }
  return modes;
}

}  // namespace

uint32_t latticeCells(const Part& part, const ModesOptions& options) {
  constexpr double kFewestCells = 64;  // four in each direction, because bending needs some
  constexpr double kGuidingCells = 1200;
  if (options.guidedParts == 0) return SolidOptions{}.targetCells;
  const double resolving = std::pow(part.mesh.triangleCount() / 6.0, 1.5);
  return static_cast<uint32_t>(std::clamp(resolving, kFewestCells, kGuidingCells));
}

PartModes refineShell(const Part& part, const PartModes& start, const ModesOptions& options, Job& job) {
  // The squares of the rounded frequencies, not the eigenvalues themselves: the shift, and therefore the last
  // bits of the result, depend on them.
  const ModeBasis approximate{start.basis.lambda.cwiseSqrt().cwiseAbs2(), start.basis.phi};
  PartModes modes = PartShell(part, options, job).refine(approximate, job);
  modes.zeroModesFound = start.zeroModesFound;
  modes.coarseVertices = start.coarseVertices;
  return modes;
}

void normaliseShape(Eigen::Ref<Eigen::VectorXd> shape) {
  const auto vertexCount = static_cast<size_t>(shape.size() / 3);
  Vec3 peak = displacementAt(shape, 0);
  for (size_t v = 1; v < vertexCount; ++v) {
    const Vec3 displacement = displacementAt(shape, v);
    if (squaredLength(displacement) > squaredLength(peak) * (1 + kTie)) peak = displacement;
  }
  int axis = 0;
  for (int other = 1; other < 3; ++other)
    if (std::abs(peak[other]) > std::abs(peak[axis]) * (1 + kTie)) axis = other;
  const double size = length(peak);
  if (!(size > 0)) return;
  shape *= (peak[axis] < 0 ? -1 : 1) / size;
}

PartModes solvePart(const Part& part, const ModesOptions& options, Job& job) {
  if (part.pinned.size() == part.mesh.positions.size()) return {};
  if (part.model == ElasticModel::Laplacian) return solveLaplacian(part, options, job);
  return part.model == ElasticModel::Solid ? solveSolid(part, options, job)
                                           : PartShell(part, options, job).solve(job);
}

}  // namespace limber
