#include "elastic/solvers/solver_constraints.h"

#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>

#include "mesh/vertex_areas.h"

namespace limber {
namespace {

void requireConstant(bool isInRange, const char* name, double value, const char* range) {
  if (isInRange && std::isfinite(value)) return;
  throw std::invalid_argument("The " + std::string(name) + " of a solver is " + std::to_string(value) +
                              "; set it to a number " + range + ".");
}

void requireConstants(const SolverModel& model, const SolverConstants& constants) {
  if (model.bend == BendElement::Morley)
    throw std::invalid_argument(
        "Morley's bending element has no constraints; its stiffness is elastic/shell.h.");
  requireConstant(constants.stretch > 0, "stretch stiffness", constants.stretch, "above 0");
  requireConstant(constants.bend >= 0, "bending stiffness", constants.bend, "of at least 0");
  requireConstant(constants.unit > 0, "unit", constants.unit, "of metres above 0");
  if (model.stretch == StretchElement::Membrane)
    requireConstant(constants.stretch + constants.secondStretch >= 0, "second Lame constant",
                    constants.secondStretch, "of at least minus the shear modulus");
}

// The corner of triangle t that is not on the edge; none if the triangle has no such corner.
std::optional<uint32_t> cornerOpposite(const TriangleMesh& mesh, uint32_t t, const Topology::Edge& edge) {
  for (const uint32_t v : mesh.triangles[t])
    if (v != edge.a && v != edge.b) return v;
  return std::nullopt;
}

}  // namespace

SolverConstraints::SolverConstraints(const TriangleMesh& rest, const Topology& topology,
                                     const SolverModel& model, const SolverConstants& constants) {
  requireConstants(model, constants);
  rest_.reserve(rest.vertexCount());
  for (const Vec3& p : rest.positions) rest_.push_back(p * constants.unit);
  addStretch(rest, topology, model.stretch, constants);
  stretchCount_ = count();
  addBends(rest, topology, model.bend, constants.bend);
}

void SolverConstraints::addStretch(const TriangleMesh& mesh, const Topology& topology, StretchElement element,
                                   const SolverConstants& constants) {
  if (element == StretchElement::EdgeSprings) {
    for (const auto& [a, b, firstUse, useCount] : topology.edges) {
      constraints_.push_back({ConstraintKind::Stretch, 1, 2, {a, b}});
      elementOf_.push_back(static_cast<uint32_t>(springs_.size()));
      springs_.emplace_back(constants.stretch, at<2>(constraints_.back(), rest_));
    }
    return;
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    constraints_.push_back({ConstraintKind::Stretch, 3, 3, {a, b, c}});
    elementOf_.push_back(static_cast<uint32_t>(membranes_.size()));
    membranes_.emplace_back(constants.stretch, constants.secondStretch, at<3>(constraints_.back(), rest_));
  }
}

void SolverConstraints::addBends(const TriangleMesh& mesh, const Topology& topology, BendElement element,
                                 double bend) {
  for (const Topology::Edge& edge : topology.edges) {
    const auto triangles = topology.trianglesAt(edge);
    if (triangles.size() != 2) continue;
    const auto first = cornerOpposite(mesh, triangles[0], edge),
               second = cornerOpposite(mesh, triangles[1], edge);
    if (!first || !second || *first == *second) continue;
    if (element == BendElement::CrossSprings) {
      constraints_.push_back({ConstraintKind::Bend, 1, 2, {*first, *second}});
      elementOf_.push_back(static_cast<uint32_t>(springs_.size()));
      springs_.emplace_back(bend, at<2>(constraints_.back(), rest_));
    } else {
      constraints_.push_back({ConstraintKind::Bend, 1, 4, {edge.a, edge.b, *first, *second}});
      elementOf_.push_back(static_cast<uint32_t>(hinges_.size()));
      hinges_.emplace_back(element, bend, at<4>(constraints_.back(), rest_));
    }
  }
}

template <size_t N>
std::array<Vec3, N> SolverConstraints::at(const SolverConstraint& constraint,
                                          std::span<const Vec3> positions) const {
  std::array<Vec3, N> corners;
  for (size_t k = 0; k < N; ++k) corners[k] = positions[constraint.vertices[k]];
  return corners;
}

ConstraintStrain SolverConstraints::strainAt(uint32_t c, std::span<const Vec3> positions) const {
  const SolverConstraint& constraint = constraints_[c];
  const uint32_t element = elementOf_[c];
  if (constraint.vertexCount == 2) return springs_[element].strainAt(at<2>(constraint, positions));
  if (constraint.vertexCount == 3) return membranes_[element].strainAt(at<3>(constraint, positions));
  return hinges_[element].strainAt(at<4>(constraint, positions));
}

Eigen::Matrix4d SolverConstraints::stressStiffnessAt(uint32_t c, std::span<const Vec3> positions,
                                                     StressKind kind) const {
  const SolverConstraint& constraint = constraints_[c];
  const uint32_t element = elementOf_[c];
  if (constraint.vertexCount == 2)
    return springs_[element].stressStiffnessAt(at<2>(constraint, positions), kind);
  if (constraint.vertexCount == 3)
    return membranes_[element].stressStiffnessAt(at<3>(constraint, positions), kind);
  return Eigen::Matrix4d::Zero();
}

double SolverConstraints::energyAt(uint32_t c, std::span<const Vec3> positions) const {
  return 0.5 * strainAt(c, positions).strain.squaredNorm();
}

std::vector<double> solverMasses(const TriangleMesh& mesh, MassRule rule, const SolverConstants& constants) {
  requireConstant(constants.surfaceDensity > 0, "surface density", constants.surfaceDensity,
                  "of kg/m2 above 0");
  const double density = constants.surfaceDensity * constants.unit * constants.unit;
  std::vector<double> masses = vertexAreas(mesh);
  const double total = density * std::accumulate(masses.begin(), masses.end(), 0.0);
  masses = rule == MassRule::Area ? lumpedAreas(mesh) : std::vector<double>(mesh.vertexCount(), 1.0);
  const double scale = total / std::accumulate(masses.begin(), masses.end(), 0.0);
  for (double& mass : masses) mass *= scale;
  return masses;
}

}  // namespace limber
