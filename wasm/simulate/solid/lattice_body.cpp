#include "simulate/solid/lattice_body.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "elastic/solid/lattice.h"
#include "elastic/solid/lattice_mass.h"
#include "elastic/solid/solid.h"
#include "mesh/component_frame.h"
#include "mesh/nesting.h"
#include "mesh/topology.h"

namespace limber {

namespace {

// The smallest mass of a node, relative to the heaviest node of its cells, and the smallest filled fraction
// from which the stiffness of a cell is computed, so that nodes at the rim of a sliver follow their
// neighbours.
constexpr double kLightest = 0.01, kMinFilled = 0.01;
// A cell that is full to within this fraction has the matrix of a full cell.
constexpr double kFull = 1e-9;

using HourglassMatrix = Eigen::Matrix<double, 12, 12>;
using CellMatrix = Hexahedron::Matrix;

CellMeasure filledUp(const CellMeasure& filled) {
  const auto along = lagrangeIntegrals(1);
  CellMeasure measure = stiffnessMeasure(filled);
  const double missing = std::max(0.0, kMinFilled - filledFraction(measure));
  for (int q = 0; q < 27; ++q) measure[q] += missing * along[q % 3] * along[q / 3 % 3] * along[q / 9];
  return measure;
}

std::array<double, 6> momentsOf(const CellMeasure& measure) {
  std::array<double, 6> sums{};
  for (int q = 0; q < 27; ++q) {
    const double xi = q % 3 - 1.0, eta = q / 3 % 3 - 1.0, zeta = q / 9 - 1.0;
    const double terms[6] = {xi, eta, zeta, eta * zeta, zeta * xi, xi * eta};
    for (int i = 0; i < 6; ++i) sums[i] += measure[q] * terms[i];
  }
  for (double& sum : sums) sum /= filledFraction(measure);
  return sums;
}

// The stiffness of the mean strain alone, for E = 1.
CellMatrix meanStiffness(const std::array<Vec3, 8>& gradients, double volume, double poisson) {
  const double lambda = poisson / ((1 + poisson) * (1 - 2 * poisson)), mu = 0.5 / (1 + poisson);
  CellMatrix k;
  for (int j = 0; j < 8; ++j)
    for (int i = 0; i < 8; ++i)
      for (int b = 0; b < 3; ++b)
        for (int a = 0; a < 3; ++a)
          k(3 * i + a, 3 * j + b) =
              volume * (lambda * gradients[i][a] * gradients[j][b] + mu * gradients[i][b] * gradients[j][a] +
                        (a == b ? mu * dot(gradients[i], gradients[j]) : 0));
  return k;
}

// A stiffness that vanishes on linear displacements, as a matrix over hourglass amplitudes. Rounding may make
// eigenvalues negative; these are set to 0.
HourglassMatrix overAmplitudes(const CellMatrix& stiffness) {
  Eigen::Matrix<double, 12, 24> amplitudes = Eigen::Matrix<double, 12, 24>::Zero();
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 8; ++k)
      for (int axis = 0; axis < 3; ++axis)
        amplitudes(3 * i + axis, 3 * k + axis) = amplitudeSign(kHourglassMasks[i], k) / 8.0;
  const HourglassMatrix matrix = amplitudes * stiffness * amplitudes.transpose();
  const Eigen::SelfAdjointEigenSolver<HourglassMatrix> solver(0.5 * (matrix + matrix.transpose()));
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).asDiagonal() *
         solver.eigenvectors().transpose();
}

CellRest cellRest(const Hexahedron& brick, const Vec3& size, const CellMeasure& filled,
                  const ElasticMaterial& material) {
  const CellMeasure measure = filledUp(filled);
  const double volume = filledFraction(measure) * size.x * size.y * size.z, unit = material.unit;
  CellRest rest = {size * unit, volume * unit * unit * unit, momentsOf(measure), {}};
  const auto gradients = meanGradients(size, rest.moments);
  rest.hourglass =
      overAmplitudes(brick.stiffness(measure) - meanStiffness(gradients, volume, material.poisson)) *
      (material.young * unit);
  return rest;
}

void raiseLightMasses(const Lattice& lattice, std::vector<double>& masses) {
  std::vector<double> heaviest(masses.size(), 0.0);
  for (uint32_t copy = 0; copy < lattice.copyCount(); ++copy) {
    double most = 0;
    for (int k = 0; k < 8; ++k) most = std::max(most, masses[lattice.copyNodes[8 * copy + k]]);
    for (int k = 0; k < 8; ++k) {
      double& own = heaviest[lattice.copyNodes[8 * copy + k]];
      own = std::max(own, most);
    }
  }
  double before = 0, after = 0;
  for (size_t node = 0; node < masses.size(); ++node) {
    before += masses[node];
    masses[node] = std::max(masses[node], kLightest * heaviest[node]);
    after += masses[node];
  }
  for (double& mass : masses) mass *= before / after;
}

// Appends the lattices of parts to a body.
class LatticeBodyBuilder {
 public:
  LatticeBodyBuilder(LatticeBody& body, const ElasticMaterial& material, const Vec3& cellSize, Job& job)
      : body_(body), material_(material), cellSize_(cellSize), job_(job) {}

  void append(const MeshParts::Part& part) {
    const Lattice lattice = buildLattice(part.mesh, cellSize_, job_);
    firstNode_ = static_cast<uint32_t>(body_.nodes.size());
    firstCell_ = static_cast<uint32_t>(body_.cells.size());
    appendNodes(lattice);
    appendCells(lattice);
    for (size_t v = 0; v < part.vertices.size(); ++v) {
      Vec3 local = lattice.points[v];
      for (int axis = 0; axis < 3; ++axis) local[axis] -= lattice.grid.along(axis, local[axis]);
      body_.vertices[part.vertices[v]] = {firstCell_ + lattice.copyOfVertex[v], trilinearWeights(local)};
    }
  }

 private:
  void appendNodes(const Lattice& lattice) {
    const double unit = material_.unit;
    const Vec3& size = lattice.grid.size;
    body_.nodes.resize(firstNode_ + lattice.nodeCount);
    for (uint32_t copy = 0; copy < lattice.copyCount(); ++copy) {
      const auto at = lattice.grid.positionOf(lattice.cells[copy]);
      for (int k = 0; k < 8; ++k) {
        const Vec3 steps = {at[0] + double(k & 1), at[1] + double(k >> 1 & 1), at[2] + double(k >> 2)};
        body_.nodes[firstNode_ + lattice.copyNodes[8 * copy + k]] =
            (lattice.grid.origin + Vec3{steps.x * size.x, steps.y * size.y, steps.z * size.z}) * unit;
      }
    }
    std::vector<double> masses = latticeMass(lattice, Hexahedron(size, material_.poisson));
    raiseLightMasses(lattice, masses);
    for (const double mass : masses) body_.masses.push_back(mass * material_.density * unit * unit * unit);
  }

  void appendCells(const Lattice& lattice) {
    const Hexahedron brick(lattice.grid.size, material_.poisson);
    uint32_t full = kNone;
    for (uint32_t copy = 0; copy < lattice.copyCount(); ++copy) {
      job_.check();
      std::array<uint32_t, 8> nodes;
      for (int k = 0; k < 8; ++k) nodes[k] = firstNode_ + lattice.copyNodes[8 * copy + k];
      body_.cells.push_back(nodes);
      const bool isFull = std::abs(filledFraction(lattice.filled[copy]) - 1) < kFull;
      if (isFull && full != kNone) {
        body_.rest.push_back(CellRest(body_.rest[full]));
        continue;
      }
      if (isFull) full = firstCell_ + copy;
      body_.rest.push_back(cellRest(brick, lattice.grid.size, lattice.filled[copy], material_));
    }
  }

  LatticeBody& body_;
  const ElasticMaterial& material_;
  const Vec3& cellSize_;
  Job& job_;
  uint32_t firstNode_ = 0, firstCell_ = 0;
};

}  // namespace

std::array<Vec3, 8> meanGradients(const Vec3& size, const std::array<double, 6>& moments) {
  const auto& [x, y, z, yz, zx, xy] = moments;
  std::array<Vec3, 8> gradients;
  for (int k = 0; k < 8; ++k) {
    const auto s = [k](int mask) { return amplitudeSign(mask, k); };
    gradients[k] = {(s(1) + s(5) * z + s(3) * y + s(7) * yz) / (4 * size.x),
                    (s(2) + s(6) * z + s(3) * x + s(7) * zx) / (4 * size.y),
                    (s(4) + s(6) * y + s(5) * x + s(7) * xy) / (4 * size.z)};
  }
  return gradients;
}

LatticeBody latticeBody(const TriangleMesh& solids, const Vec3& cellSize, const ElasticMaterial& material,
                        Job& job) {
  const Topology topology = buildTopology(solids);
  const std::vector<uint32_t> hosts = solidHosts(solids, topology);
  std::vector<uint32_t> partOfVertex;
  for (const uint32_t component : topology.componentOfVertex) partOfVertex.push_back(hosts[component]);
  const MeshParts parts = splitMesh(solids, partOfVertex, topology.componentCount);
  LatticeBody body;
  body.vertices.resize(solids.vertexCount());
  LatticeBodyBuilder builder(body, material, cellSize, job);
  for (const MeshParts::Part& part : parts.parts)
    if (part.mesh.triangleCount()) builder.append(part);
  return body;
}

std::vector<uint8_t> solidComponents(const TriangleMesh& mesh) {
  std::vector<uint8_t> isSolid;
  for (const uint32_t host : solidHosts(mesh, buildTopology(mesh))) isSolid.push_back(host != kNone);
  return isSolid;
}

Vec3 solidCellSize(const TriangleMesh& mesh) {
  const Topology topology = buildTopology(mesh);
  const std::vector<uint8_t> isSolid = solidComponents(mesh);
  std::vector<uint32_t> partOfVertex;
  for (const uint32_t component : topology.componentOfVertex) partOfVertex.push_back(isSolid[component]);
  const MeshParts parts = splitMesh(mesh, partOfVertex, 2);
  if (!parts.parts[1].mesh.triangleCount()) return {};
  return latticeGrid(parts.parts[1].mesh, SolidOptions{}.targetCells).size;
}

}  // namespace limber
