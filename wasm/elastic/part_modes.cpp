#include "elastic/part_modes.h"

#include <algorithm>
#include <cmath>

#include "base/memory.h"
#include "elastic/laplacian.h"
#include "elastic/pinned_patch.h"
#include "elastic/pins.h"
#include "elastic/shell.h"
#include "elastic/solid/solid.h"
#include "linear/eigensolver.h"
#include "mesh/principal_axes.h"

namespace limber {

namespace {

// A spring at a pinned point of a solid, against the stiffness of a cell (E times its size): pins give way by
// about its inverse, and residuals lose as many digits.
constexpr double kPinStiffness = 1e4;

std::vector<Vec3> pinnedPoints(const Part& part) {
  std::vector<Vec3> points;
  for (uint32_t v : part.pinned) points.push_back(part.mesh.positions[v]);
  return points;
}

// `displacement(v, k)` gives vertex v's in pair k.
template <class Displacement>
PartModes gather(const Part& part, const EigenPairs& pairs, const Displacement& displacement) {
  PartModes modes{
      rigidMotionsLeft(pinnedPoints(part)), pairs.zeroCount, {}, {}, {}, {}, pairs.factorNonzeros, 0};
  for (Eigen::Index k = 0; k < pairs.lambda.size(); ++k) {
    std::vector<Vec3> shape(part.mesh.vertexCount());
    for (uint32_t v = 0; v < shape.size(); ++v) shape[v] = displacement(v, k);
    normaliseShape(shape);
    modes.omega.push_back(std::sqrt(pairs.lambda[k]));
    modes.residual.push_back(pairs.residual[static_cast<size_t>(k)]);
    modes.axis.push_back(-1);
    modes.shapes.push_back(std::move(shape));
  }
  return modes;
}

// K and its structure take about a kilobyte a triangle, and L about 38 n log2(n) numbers for n vertices
// (measured on scans); an estimate before anything is taken. Once L's structure is known, the eigensolver
// asks again.
uint64_t estimatedMemory(const TriangleMesh& mesh) {
  const double n = std::max(2.0, static_cast<double>(mesh.vertexCount()));
  return static_cast<uint64_t>(1000.0 * mesh.triangleCount() + 38 * sizeof(double) * n * std::log2(n));
}

StiffnessModel pinnedShell(const Part& part, const ModesOptions& options, Job& job) {
  job.begin(Phase::Assemble);
  requireMemory(estimatedMemory(part.mesh), "Solving this mesh as it is");
  const double thickness = options.thickness / part.diagonal;
  const Topology topology = buildTopology(part.mesh);
  StiffnessModel model = shellModel(part.mesh, topology, thickness, options.poisson);
  if (!part.pinned.empty()) holdUnknowns(model, heldUnknowns(part.mesh, topology, part.pinned));
  return model;
}

PartModes gatherShell(const Part& part, const EigenPairs& pairs) {
  return gather(part, pairs, [&](uint32_t v, Eigen::Index k) {
    const auto row = 3 * static_cast<Eigen::Index>(v);
    return Vec3{pairs.phi(row, k), pairs.phi(row + 1, k), pairs.phi(row + 2, k)};
  });
}

PartModes solveShell(const Part& part, const ModesOptions& options, Job& job) {
  const StiffnessModel model = pinnedShell(part, options, job);
  const double thickness = options.thickness / part.diagonal;
  const auto zeros = static_cast<int>(rigidMotionsLeft(pinnedPoints(part)));
  const double scale = roughFirstEigenvalue(thickness, !part.pinned.empty());
  return gatherShell(part, solveEigenproblem(model, {options.modeCount, zeros, scale, nullptr}, job));
}

double enclosedVolume(const TriangleMesh& mesh) {
  double sum = 0;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    sum += dot(mesh.corner(t, 0), cross(mesh.corner(t, 1), mesh.corner(t, 2))) / 6;
  return std::abs(sum);
}

PartModes solveSolid(const Part& part, const ModesOptions& options, Job& job) {
  job.begin(Phase::Assemble);
  SolidOptions solidOptions;
  solidOptions.poisson = options.poisson;
  TriangleMesh mesh = part.mesh;
  std::vector<uint32_t> pinned = part.pinned;
  if (!pinned.empty())  // to about the size of a cell
    refinePinnedFaces(mesh, pinned, std::cbrt(enclosedVolume(mesh) / solidOptions.targetCells));
  SolidModel solid = solidModel(mesh, solidOptions, job);
  for (uint32_t v : pinned)
    holdPoint(solid.model, {&solid.embeddingNodes[8 * size_t{v}], &solid.embeddingWeights[8 * size_t{v}]},
              kPinStiffness * solid.cellSize);
  const auto zeros = static_cast<int>(rigidMotionsLeft(pinnedPoints(part)));
  const EigenPairs pairs = solveEigenproblem(solid.model, {options.modeCount, zeros, 0.5, nullptr}, job);
  return gather(part, pairs, [&](uint32_t v, Eigen::Index k) {
    Vec3 sum;
    for (size_t i = 8 * size_t{v}; i < 8 * size_t{v} + 8; ++i) {
      const auto row = static_cast<Eigen::Index>(solid.model.firstUnknown[solid.embeddingNodes[i]]);
      sum +=
          solid.embeddingWeights[i] * Vec3{pairs.phi(row, k), pairs.phi(row + 1, k), pairs.phi(row + 2, k)};
    }
    return sum;
  });
}

// Each scalar mode along each principal axis in turn, or along the one direction.
PartModes solveLaplacian(const Part& part, const ModesOptions& options, Job& job) {
  job.begin(Phase::Assemble);
  StiffnessModel model = laplacianModel(part.mesh, buildTopology(part.mesh));
  if (!part.pinned.empty()) holdUnknowns(model, part.pinned);
  std::vector<Vec3> axes(1);
  if (options.direction >= 0) {
    axes[0][options.direction] = 1;
  } else {
    const auto principal = principalAxes(part.mesh).axis;
    axes.assign(principal.begin(), principal.end());
  }
  const auto axisCount = static_cast<int>(axes.size());
  const int scalarZeros = part.pinned.empty() ? 1 : 0;
  const EigenPairs pairs = solveEigenproblem(
      model, {(options.modeCount + axisCount - 1) / axisCount, scalarZeros, 5, nullptr}, job);
  PartModes modes;
  modes.zeroModesExpected = static_cast<uint32_t>(axisCount * scalarZeros);
  modes.zeroModesFound = static_cast<uint32_t>(axisCount) * pairs.zeroCount;
  modes.factorNonzeros = pairs.factorNonzeros;
  for (Eigen::Index k = 0; k < pairs.lambda.size(); ++k)
    for (int axis = 0; axis < axisCount && static_cast<int>(modes.omega.size()) < options.modeCount; ++axis) {
      std::vector<Vec3> shape(part.mesh.vertexCount());
      for (size_t v = 0; v < shape.size(); ++v)
        shape[v] = axes[static_cast<size_t>(axis)] * pairs.phi(static_cast<Eigen::Index>(v), k);
      normaliseShape(shape);
      modes.omega.push_back(std::sqrt(pairs.lambda[k]));
      modes.residual.push_back(pairs.residual[static_cast<size_t>(k)]);
      modes.axis.push_back(options.direction >= 0 ? -1 : axis);
      modes.shapes.push_back(std::move(shape));
    }
  return modes;
}

}  // namespace

PartModes refineShell(const Part& part, const PartModes& start, const ModesOptions& options, Job& job) {
  const StiffnessModel model = pinnedShell(part, options, job);
  const auto displacements = 3 * static_cast<Eigen::Index>(part.mesh.vertexCount());
  const Eigen::Index rigid = part.pinned.empty() ? 6 : 0,
                     elastic = static_cast<Eigen::Index>(start.shapes.size());
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(model.unknownCount(), rigid + elastic);
  if (rigid > 0) columns.topLeftCorner(displacements, rigid) = rigidMotions(part.mesh);
  for (Eigen::Index k = 0; k < elastic; ++k)
    for (Eigen::Index row = 0; row < displacements; ++row)
      columns(row, rigid + k) = start.shapes[static_cast<size_t>(k)][static_cast<size_t>(row / 3)][row % 3];
  RefineOptions refine;
  refine.shift = -0.5 * start.omega[0] * start.omega[0];
  refine.elasticCount = options.modeCount;
  PartModes modes = gatherShell(part, refineEigenpairs(model, columns, refine, job));
  modes.zeroModesFound = start.zeroModesFound;
  modes.coarseVertices = start.coarseVertices;
  return modes;
}

void normaliseShape(std::vector<Vec3>& shape) {
  size_t largest = 0;
  for (size_t v = 1; v < shape.size(); ++v)
    if (squaredLength(shape[v]) > squaredLength(shape[largest]) * (1 + 1e-9)) largest = v;
  const Vec3& peak = shape[largest];
  int axis = 0;
  for (int other = 1; other < 3; ++other)
    if (std::abs(peak[other]) > std::abs(peak[axis]) * (1 + 1e-9)) axis = other;
  const double size = length(peak);
  if (!(size > 0)) return;
  const double scale = (peak[axis] < 0 ? -1 : 1) / size;
  for (Vec3& p : shape) p *= scale;
}

PartModes solvePart(const Part& part, const ModesOptions& options, Job& job) {
  if (part.pinned.size() == part.mesh.positions.size()) return {};
  if (part.model == Model::Laplacian) return solveLaplacian(part, options, job);
  return part.model == Model::Solid ? solveSolid(part, options, job) : solveShell(part, options, job);
}

}  // namespace limber
