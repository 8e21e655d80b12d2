#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "mesh/topology.h"
#include "modes/eigensolver.h"
#include "modes/laplacian.h"
#include "modes/mass.h"
#include "modes/modes.h"
#include "modes/shell.h"

namespace limber {

namespace {

// One component, moved and scaled so that its box starts at 0 and its diagonal is 1.
struct Part {
  TriangleMesh mesh;
  std::vector<uint32_t> vertexOfBody;
  double diagonal = 0;
};

std::vector<Part> partsOf(const TriangleMesh& body, const Topology& topology) {
  std::vector<Part> parts(topology.componentCount);
  std::vector<uint32_t> local(body.vertexCount());
  for (uint32_t v = 0; v < body.vertexCount(); ++v) {
    Part& part = parts[topology.componentOfVertex[v]];
    local[v] = part.mesh.vertexCount();
    part.mesh.positions.push_back(body.positions[v]);
    part.vertexOfBody.push_back(v);
  }
  for (const Triangle& t : body.triangles)
    parts[topology.componentOfVertex[t[0]]].mesh.triangles.push_back({local[t[0]], local[t[1]], local[t[2]]});
  for (Part& part : parts) {
    const Bounds box = bounds(part.mesh);
    part.diagonal = box.diagonal() > 0 ? box.diagonal() : 1;
    for (Vec3& p : part.mesh.positions) p = (p - box.low) / part.diagonal;
  }
  return parts;
}

// The elastic modes of one part in units of the frame: shapes over its vertices, largest displacement 1.
struct PartModes {
  uint32_t zeroModesExpected = 0, zeroModesFound = 0;
  std::vector<double> omega, residual;
  std::vector<int32_t> axis;
  std::vector<std::vector<Vec3>> shapes;
  uint64_t factorNonzeros = 0;
};

// Scales a shape to a largest displacement of 1 and turns it so that the largest component there is positive.
void normalise(std::vector<Vec3>& shape) {
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

PartModes shellModes(const Part& part, const ModesOptions& options, Job& job) {
  job.begin(Phase::Assemble);
  const double thickness = options.thickness / part.diagonal;
  const StiffnessModel model = shellModel(part.mesh, buildTopology(part.mesh), thickness, options.poisson);
  // In this frame the first lambda is 40 h^2 for a strip, 60 for a plate, 100 to 2000 for most closed bodies.
  const EigenPairs pairs = solveEigenproblem(model, {options.modeCount, 6, 300 * thickness * thickness}, job);
  PartModes modes{6, pairs.zeroCount, {}, pairs.residual, {}, {}, pairs.factorNonzeros};
  for (Eigen::Index k = 0; k < pairs.lambda.size(); ++k) {
    std::vector<Vec3> shape(part.mesh.vertexCount());
    for (size_t v = 0; v < shape.size(); ++v)
      for (int axis = 0; axis < 3; ++axis)
        shape[v][axis] = pairs.phi(3 * static_cast<Eigen::Index>(v) + axis, k);
    normalise(shape);
    modes.omega.push_back(std::sqrt(pairs.lambda[k]));
    modes.axis.push_back(-1);
    modes.shapes.push_back(std::move(shape));
  }
  return modes;
}

// The principal axes of the surface, from the thinnest extent to the longest; each points to its positive
// side.
std::vector<Vec3> principalAxes(const TriangleMesh& mesh) {
  const auto areas = lumpedAreas(mesh);
  Vec3 centre;
  double total = 0;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    centre += mesh.positions[v] * areas[v];
    total += areas[v];
  }
  centre *= 1 / total;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const Vec3 p = mesh.positions[v] - centre;
    const Eigen::Vector3d offset(p.x, p.y, p.z);
    covariance += areas[v] * offset * offset.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  std::vector<Vec3> axes;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d axis = solver.eigenvectors().col(k);
    int largest = 0;
    for (int c = 1; c < 3; ++c)
      if (std::abs(axis[c]) > std::abs(axis[largest]) + 1e-9) largest = c;
    const double sign = axis[largest] < 0 ? -1 : 1;
    axes.push_back({sign * axis[0], sign * axis[1], sign * axis[2]});
  }
  return axes;
}

// Each scalar mode three times, along each principal axis in turn.
PartModes laplacianModes(const Part& part, const ModesOptions& options, Job& job) {
  job.begin(Phase::Assemble);
  const StiffnessModel model = laplacianModel(part.mesh, buildTopology(part.mesh));
  const EigenPairs pairs = solveEigenproblem(model, {(options.modeCount + 2) / 3, 1, 5}, job);
  const auto axes = principalAxes(part.mesh);
  PartModes modes{3, 3 * pairs.zeroCount, {}, {}, {}, {}, pairs.factorNonzeros};
  for (Eigen::Index k = 0; k < pairs.lambda.size(); ++k)
    for (int32_t axis = 0; axis < 3 && static_cast<int>(modes.omega.size()) < options.modeCount; ++axis) {
      std::vector<Vec3> shape(part.mesh.vertexCount());
      for (size_t v = 0; v < shape.size(); ++v)
        shape[v] = axes[axis] * pairs.phi(static_cast<Eigen::Index>(v), k);
      normalise(shape);
      modes.omega.push_back(std::sqrt(pairs.lambda[k]));
      modes.residual.push_back(pairs.residual[static_cast<size_t>(k)]);
      modes.axis.push_back(axis);
      modes.shapes.push_back(std::move(shape));
    }
  return modes;
}

void checkOptions(const ModesOptions& options) {
  const auto require = [](bool holds, const char* sentence) {
    if (!holds) throw std::invalid_argument(sentence);
  };
  require(options.modeCount >= 1, "The number of modes must be at least 1.");
  require(options.thickness > 0, "The thickness must be larger than 0.");
  require(options.young > 0 && options.density > 0, "Young's modulus and density must be larger than 0.");
  require(options.poisson > -1 && options.poisson < 0.5, "Poisson's ratio must lie between -1 and 0.5.");
  require(options.unit > 0, "The unit must be a positive number of metres.");
}

void addPart(ModeSet& set, uint32_t component, const Part& part, const PartModes& modes, double toRadians) {
  const size_t vertexCount = set.shapes.size() / (3 * std::max<size_t>(1, set.layerCount));
  for (uint32_t layer = 0; layer < modes.omega.size(); ++layer) {
    set.modes.push_back(
        {modes.omega[layer] * toRadians, modes.residual[layer], component, layer, modes.axis[layer]});
    for (size_t v = 0; v < part.vertexOfBody.size(); ++v)
      for (int c = 0; c < 3; ++c)
        set.shapes[(layer * vertexCount + part.vertexOfBody[v]) * 3 + c] =
            static_cast<float>(modes.shapes[layer][v][c]);
  }
  set.components.push_back({part.mesh.triangleCount(), modes.zeroModesExpected, modes.zeroModesFound,
                            static_cast<uint32_t>(modes.omega.size())});
  set.factorNonzeros = std::max(set.factorNonzeros, modes.factorNonzeros);
}

}  // namespace

ModeSet computeModes(const TriangleMesh& mesh, const ModesOptions& options, Job& job) {
  checkOptions(options);
  if (mesh.triangles.empty())
    throw std::invalid_argument("The mesh has no usable triangle, so it has no modes.");
  const std::vector<Part> parts = partsOf(mesh, buildTopology(mesh));
  ModeSet set;
  set.layerCount = static_cast<uint32_t>(options.modeCount);
  set.shapes.assign(3 * size_t{mesh.vertexCount()} * set.layerCount, 0.0f);
  for (uint32_t component = 0; component < parts.size(); ++component) {
    const Part& part = parts[component];
    const PartModes modes =
        options.model == Model::Shell ? shellModes(part, options, job) : laplacianModes(part, options, job);
    // In the frame E, rho and the diagonal are 1: omega = omega_frame sqrt(E / rho) / L.
    const double toRadians = std::sqrt(options.young / options.density) / (part.diagonal * options.unit);
    addPart(set, component, part, modes, toRadians);
  }
  std::stable_sort(set.modes.begin(), set.modes.end(),
                   [](const Mode& a, const Mode& b) { return a.omega < b.omega; });
  return set;
}

}  // namespace limber
