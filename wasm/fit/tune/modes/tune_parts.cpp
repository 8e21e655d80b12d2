#include "fit/tune/modes/tune_parts.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

#include "base/parallel.h"
#include "compare/assignment.h"
#include "mesh/component_frame.h"
#include "mesh/topology.h"
#include "mesh/vertex_areas.h"
#include "transfer/shape_transfer.h"

namespace limber {
namespace {

constexpr double kMinShare = 1e-3;  // of the area of a body: smaller parts do not matter

struct ConnectedBody {
  const TriangleMesh& mesh;
  Topology topology;
  MeshParts parts;
  std::vector<uint32_t> matters;  // parts that matter
};

ConnectedBody bodyOf(const TriangleMesh& mesh) {
  ConnectedBody body{mesh, buildTopology(mesh), {}, {}};
  body.parts = splitMesh(mesh, body.topology.componentOfVertex, body.topology.componentCount);
  std::vector<double> areas;
  for (const MeshParts::Part& part : body.parts.parts) areas.push_back(surfaceArea(part.mesh));
  const double total = std::accumulate(areas.begin(), areas.end(), 0.0);
  for (uint32_t p = 0; p < areas.size(); ++p)
    if (areas[p] >= kMinShare * total) body.matters.push_back(p);
  return body;
}

// For each part of the original that matters, the part of the result to which most of its vertices are
// closest; each is used once.
std::vector<uint32_t> partners(const ConnectedBody& original, const ConnectedBody& result) {
  if (original.matters.size() != result.matters.size())
    throw std::invalid_argument("Of parts with at least a thousandth of the area the original has " +
                                std::to_string(original.matters.size()) + " and the coarse mesh has " +
                                std::to_string(result.matters.size()) +
                                "; tune a mesh that has the same parts.");
  if (original.matters.size() == 1) return {result.matters[0]};
  std::vector<uint32_t> rowOf(original.parts.parts.size(), kNone), columnOf(result.parts.parts.size(), kNone);
  for (uint32_t i = 0; i < original.matters.size(); ++i) rowOf[original.matters[i]] = i;
  for (uint32_t i = 0; i < result.matters.size(); ++i) columnOf[result.matters[i]] = i;
  const auto size = static_cast<Eigen::Index>(original.matters.size());
  Eigen::MatrixXd votes = Eigen::MatrixXd::Zero(size, size);
  const std::vector<ClosestPoint> points = closestPoints(result.mesh, original.mesh);
  for (uint32_t v = 0; v < result.mesh.vertexCount(); ++v) {
    const uint32_t part = original.topology.componentOfVertex[original.mesh.triangles[points[v].triangle][0]];
    const uint32_t column = columnOf[result.topology.componentOfVertex[v]];
    if (rowOf[part] == kNone || column == kNone) continue;
    votes(rowOf[part], column) +=
        1.0 / result.parts.parts[result.topology.componentOfVertex[v]].mesh.vertexCount();
  }
  std::vector<uint32_t> partner;
  for (const int column : assign(votes)) partner.push_back(result.matters[static_cast<size_t>(column)]);
  return partner;
}

// The indices of each part's constraints among those of the body, in the same order.
std::vector<std::vector<uint32_t>> constraintsOfParts(const ConnectedBody& body,
                                                      const SolverStiffness& whole) {
  std::vector<std::vector<uint32_t>> constraints(body.parts.parts.size());
  for (uint32_t c = 0; c < whole.count(); ++c)
    constraints[body.topology.componentOfVertex[whole[c].vertices[0]]].push_back(c);
  return constraints;
}

SolverPart solverPart(MeshParts::Part& part, const SolverModel& model, const SolverConstants& constants,
                      const Job& job) {
  SolverPart solver;
  solver.mesh = std::move(part.mesh);
  solver.vertices = std::move(part.vertices);
  solver.stiffness =
      std::make_unique<SolverStiffness>(solver.mesh, buildTopology(solver.mesh), model, constants);
  solver.structure = structureOf(*solver.stiffness, job);
  return solver;
}

std::vector<double> chosen(std::span<const double> values, const std::vector<uint32_t>& ids) {
  std::vector<double> some;
  some.reserve(ids.size());
  for (const uint32_t id : ids) some.push_back(values[id]);
  return some;
}

}  // namespace

std::vector<double> SolverPart::vertexValues(std::span<const double> ofBody) const {
  return chosen(ofBody, vertices);
}

std::vector<double> SolverPart::constraintValues(std::span<const double> ofBody) const {
  return chosen(ofBody, constraints);
}

Eigen::MatrixXd PartPair::carryToResult(const Eigen::MatrixXd& values) const {
  Eigen::MatrixXd carried =
      Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(result.mesh.vertexCount()), values.cols());
  for (size_t v = 0; v < points.size(); ++v)
    for (int c = 0; c < 3; ++c)
      carried.middleRows<3>(3 * static_cast<Eigen::Index>(result.mesh.triangles[points[v].triangle][c])) +=
          points[v].barycentric[c] * values.middleRows<3>(3 * static_cast<Eigen::Index>(v));
  return carried;
}

std::deque<PartPair> pairParts(const TuneBodies& bodies, Job& job) {
  ConnectedBody original = bodyOf(bodies.original), result = bodyOf(bodies.result);
  const std::vector<uint32_t> partner = partners(original, result);
  auto resultConstraints = constraintsOfParts(result, bodies.resultStiffness);
  std::deque<PartPair> pairs;
  for (size_t i = 0; i < partner.size(); ++i) {
    PartPair& pair = pairs.emplace_back();
    parallelFor(2, 1, [&](size_t body, size_t) {
      if (body == 0)
        pair.original = solverPart(original.parts.parts[original.matters[i]], bodies.model,
                                   bodies.originalConstants, job);
      else
        pair.result = solverPart(result.parts.parts[partner[i]], bodies.model, bodies.resultConstants, job);
    });
    pair.result.constraints = std::move(resultConstraints[partner[i]]);
    pair.points = closestPoints(pair.original.mesh, pair.result.mesh);
  }
  return pairs;
}

}  // namespace limber
