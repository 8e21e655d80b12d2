#include "fit/tune/trial/implicit_system.h"

#include <algorithm>
#include <numeric>

#include "base/parallel.h"
#include "mesh/eigen_vec3.h"

namespace limber {
namespace {

constexpr size_t kGrain = 256;  // constraints that a thread takes at once

auto coordinatesOf(Eigen::VectorXd& unknowns, uint32_t index) {
  return unknowns.segment<3>(3 * static_cast<Eigen::Index>(index));
}

std::span<const uint32_t> verticesOf(const SolverConstraint& constraint) {
  return {constraint.vertices.data(), constraint.vertexCount};
}

}  // namespace

ImplicitSystem::ImplicitSystem(const ConstrainedBody& body, double inertia, const Job& job)
    : constraints_(body.constraints),
      masses_(body.masses.begin(), body.masses.end()),
      factors_(body.factors.begin(), body.factors.end()),
      barrier_(body.mesh.triangles, body.constraints.rest(), body.barrierStiffness) {
  numberVertices(body.pins);
  addPointSprings(body, inertia);
  buildPattern();
  structure_ = std::make_shared<const FactorStructure>(factorStructure(pencil_, job));
}

void ImplicitSystem::numberVertices(const Pins& pins) {
  indexOf_.assign(masses_.size(), 0);
  for (const uint32_t v : pins.vertices) indexOf_[v] = kNone;
  for (uint32_t v = 0; v < indexOf_.size(); ++v) {
    if (indexOf_[v] == kNone) continue;
    indexOf_[v] = static_cast<uint32_t>(free_.size());
    free_.push_back(v);
  }
}

// Per vertex the mean of the diagonal of K at rest over its coordinates.
std::vector<double> ImplicitSystem::restStiffness() const {
  std::vector<double> stiffness(masses_.size(), 0);
  for (uint32_t c = 0; c < constraints_.count(); ++c) {
    const ConstraintStrain at = constraints_.strainAt(c, constraints_.rest());
    for (int k = 0; k < constraints_[c].vertexCount; ++k)
      stiffness[constraints_[c].vertices[k]] +=
          factorOf(c) * at.jacobian.middleCols<3>(3 * k).squaredNorm() / 3;
  }
  return stiffness;
}

void ImplicitSystem::addPointSprings(const ConstrainedBody& body, double inertia) {
  if (body.pins.points.empty()) return;
  const std::vector<double> stiffness = restStiffness();
  for (const SurfacePoint& point : body.pins.points) {
    PointSpring spring{body.mesh.triangles[point.triangle], {}, 0, {}};
    for (int c = 0; c < 3; ++c) {
      const uint32_t v = spring.vertices[c];
      spring.weights[c] = point.barycentric[c];
      spring.stiffness = std::max(spring.stiffness, kPointStiffness * (stiffness[v] + inertia * masses_[v]));
      spring.target += constraints_.rest()[v] * spring.weights[c];
    }
    points_.push_back(spring);
  }
}

// Vertices are coupled if a constraint or a pinned point involves both.
void ImplicitSystem::buildPattern() {
  std::vector<std::vector<uint32_t>> neighbours(free_.size());
  const auto couple = [&](std::span<const uint32_t> vertices) {
    for (const uint32_t v : vertices)
      for (const uint32_t w : vertices)
        if (indexOf_[v] != kNone && indexOf_[w] != kNone) neighbours[indexOf_[v]].push_back(indexOf_[w]);
  };
  for (uint32_t c = 0; c < constraints_.count(); ++c) couple(verticesOf(constraints_[c]));
  for (const PointSpring& spring : points_) couple(spring.vertices);
  for (size_t i = 0; i < barrier_.count(); ++i) couple(barrier_.vertices(i));
  for (uint32_t i = 0; i < free_.size(); ++i) {
    neighbours[i].push_back(i);
    std::ranges::sort(neighbours[i]);
    const auto repeated = std::ranges::unique(neighbours[i]);
    neighbours[i].erase(repeated.begin(), repeated.end());
  }
  reserveEntries(neighbours);
  for (uint32_t c = 0; c < constraints_.count(); ++c)
    starts_.push_back(blockStarts(verticesOf(constraints_[c])));
  parts_.resize(constraints_.count());
}

void ImplicitSystem::reserveEntries(const std::vector<std::vector<uint32_t>>& neighbours) {
  neighbourStart_.push_back(0);
  for (const auto& of : neighbours) {
    neighbours_.insert(neighbours_.end(), of.begin(), of.end());
    neighbourStart_.push_back(static_cast<uint32_t>(neighbours_.size()));
  }
  const auto unknowns = static_cast<Eigen::Index>(unknownCount());
  pencil_.k.resize(unknowns, unknowns);
  pencil_.k.resizeNonZeros(9 * static_cast<Eigen::Index>(neighbours_.size()));
  pencil_.m.resize(unknowns);
  pencil_.firstUnknown.push_back(0);
  int* row = pencil_.k.innerIndexPtr();
  int* column = pencil_.k.outerIndexPtr();
  for (uint32_t i = 0; i < free_.size(); ++i) {
    for (uint32_t axis = 0; axis < 3; ++axis) {
      *column++ = static_cast<int>(row - pencil_.k.innerIndexPtr());
      for (const uint32_t j : neighbours[i])
        for (uint32_t other = 0; other < 3; ++other) *row++ = static_cast<int>(3 * j + other);
    }
    pencil_.m.segment<3>(3 * static_cast<Eigen::Index>(i)).setConstant(masses_[free_[i]]);
    pencil_.firstUnknown.push_back(3 * (i + 1));
  }
  *column = static_cast<int>(row - pencil_.k.innerIndexPtr());
  std::fill_n(pencil_.k.valuePtr(), pencil_.k.nonZeros(), 0.0);
}

void ImplicitSystem::setPointTargets(std::span<const Vec3> targets) {
  for (size_t i = 0; i < points_.size(); ++i) points_[i].target = targets[i];
}

Vec3 ImplicitSystem::gapOf(const PointSpring& spring, std::span<const Vec3> positions) const {
  Vec3 gap = -spring.target;
  for (int c = 0; c < 3; ++c) gap += positions[spring.vertices[c]] * spring.weights[c];
  return gap;
}

double ImplicitSystem::energyAt(std::span<const Vec3> positions) const {
  std::vector<double> energies(constraints_.count());
  parallelFor(energies.size(), kGrain, [&](size_t begin, size_t end) {
    for (size_t c = begin; c < end; ++c) {
      const auto index = static_cast<uint32_t>(c);
      energies[c] = factorOf(index) * constraints_.energyAt(index, positions);
    }
  });
  double sum = std::accumulate(energies.begin(), energies.end(), barrier_.energyAt(positions));
  for (const PointSpring& spring : points_)
    sum += 0.5 * spring.stiffness * squaredLength(gapOf(spring, positions));
  return sum;
}

void ImplicitSystem::addPointSpringsTo(std::span<const Vec3> positions, Eigen::VectorXd& gradient) const {
  for (const PointSpring& spring : points_) {
    const Eigen::Vector3d force = spring.stiffness * eigen(gapOf(spring, positions));
    for (int c = 0; c < 3; ++c)
      if (const uint32_t i = indexOf_[spring.vertices[c]]; i != kNone)
        coordinatesOf(gradient, i) += spring.weights[c] * force;
  }
}

void ImplicitSystem::addForces(std::span<const uint32_t> vertices, const ConstraintStrain& at, double factor,
                               Eigen::VectorXd& gradient) const {
  const Eigen::Matrix<double, 12, 1> force = factor * (at.jacobian.transpose() * at.strain);
  for (size_t k = 0; k < vertices.size(); ++k)
    if (const uint32_t i = indexOf_[vertices[k]]; i != kNone)
      coordinatesOf(gradient, i) += force.segment<3>(3 * static_cast<Eigen::Index>(k));
}

void ImplicitSystem::addBarrier(std::span<const Vec3> positions, Eigen::VectorXd& gradient) {
  for (size_t i = 0; i < barrier_.count(); ++i) {
    if (!barrier_.isActive(i, positions)) continue;
    const Linearisation at{barrier_.strainAt(i, positions)};
    addForces(barrier_.vertices(i), at.strain, 1, gradient);
    addBlocks(barrier_.vertices(i), blockStarts(barrier_.vertices(i)), at, 1);
  }
}

Eigen::VectorXd ImplicitSystem::linearise(std::span<const Vec3> positions, StressKind kind) {
  parallelFor(parts_.size(), kGrain, [&](size_t begin, size_t end) {
    for (size_t c = begin; c < end; ++c) {
      const auto index = static_cast<uint32_t>(c);
      parts_[c].strain = constraints_.strainAt(index, positions);
      parts_[c].stress = constraints_.stressStiffnessAt(index, positions, kind);
    }
  });
  std::fill_n(pencil_.k.valuePtr(), pencil_.k.nonZeros(), 0.0);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(unknownCount());
  for (uint32_t c = 0; c < parts_.size(); ++c) {
    const std::span<const uint32_t> vertices = verticesOf(constraints_[c]);
    addForces(vertices, parts_[c].strain, factorOf(c), gradient);
    addBlocks(vertices, starts_[c], parts_[c], factorOf(c));
  }
  addBarrier(positions, gradient);
  addPointSpringsTo(positions, gradient);
  addPointBlocks();
  return gradient;
}

// For block (i, j): the stride of its columns is 3 times the number of neighbours of j.
uint32_t ImplicitSystem::blockStart(uint32_t i, uint32_t j) const {
  const auto first = neighbours_.begin() + neighbourStart_[j],
             last = neighbours_.begin() + neighbourStart_[j + 1];
  return 9 * neighbourStart_[j] + 3 * static_cast<uint32_t>(std::lower_bound(first, last, i) - first);
}

ImplicitSystem::BlockStarts ImplicitSystem::blockStarts(std::span<const uint32_t> vertices) const {
  BlockStarts starts;
  starts.fill(kNone);
  for (size_t k = 0; k < vertices.size(); ++k)
    for (size_t l = 0; l < vertices.size(); ++l)
      if (indexOf_[vertices[k]] != kNone && indexOf_[vertices[l]] != kNone)
        starts[4 * k + l] = blockStart(indexOf_[vertices[k]], indexOf_[vertices[l]]);
  return starts;
}

void ImplicitSystem::addTo(uint32_t start, uint32_t column, const Eigen::Matrix3d& block) {
  const uint32_t height = 3 * (neighbourStart_[column + 1] - neighbourStart_[column]);
  double* value = pencil_.k.valuePtr() + start;
  for (int c = 0; c < 3; ++c, value += height)
    for (int r = 0; r < 3; ++r) value[r] += block(r, c);
}

void ImplicitSystem::addBlocks(std::span<const uint32_t> vertices, const BlockStarts& starts,
                               const Linearisation& at, double factor) {
  const auto& jacobian = at.strain.jacobian;
  const bool hasOneRow = vertices.size() != 3 || jacobian.bottomRows<2>().isZero(0);
  for (size_t k = 0; k < vertices.size(); ++k)
    for (size_t l = 0; l <= k; ++l) {
      if (starts[4 * k + l] == kNone) continue;
      const auto row = static_cast<Eigen::Index>(k), column = static_cast<Eigen::Index>(l);
      Eigen::Matrix3d block;
      if (hasOneRow)
        block.noalias() = (factor * jacobian.block<1, 3>(0, 3 * row))
                              .transpose()
                              .lazyProduct(jacobian.block<1, 3>(0, 3 * column));
      else
        block.noalias() = (factor * jacobian.block<3, 3>(0, 3 * row))
                              .transpose()
                              .lazyProduct(jacobian.block<3, 3>(0, 3 * column));
      block.diagonal().array() += factor * at.stress(row, column);
      addTo(starts[4 * k + l], indexOf_[vertices[l]], block);
      if (k != l) addTo(starts[4 * l + k], indexOf_[vertices[k]], block.transpose());
    }
}

void ImplicitSystem::addPointBlocks() {
  for (const PointSpring& spring : points_)
    for (int k = 0; k < 3; ++k)
      for (int l = 0; l < 3; ++l) {
        const uint32_t i = indexOf_[spring.vertices[k]], j = indexOf_[spring.vertices[l]];
        if (i == kNone || j == kNone) continue;
        const uint32_t height = 3 * (neighbourStart_[j + 1] - neighbourStart_[j]);
        double* block = pencil_.k.valuePtr() + blockStart(i, j);
        for (uint32_t axis = 0; axis < 3; ++axis)
          block[axis * (height + 1)] += spring.stiffness * spring.weights[k] * spring.weights[l];
      }
}

}  // namespace limber
