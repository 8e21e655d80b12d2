#pragma once

#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "base/job.h"
#include "elastic/solvers/solver_vibration.h"
#include "query/closest_point.h"

namespace limber {

// A connected part of a body in a solver.
struct SolverPart {
  TriangleMesh mesh;
  std::vector<uint32_t> vertices;     // per vertex: its id in the body
  std::vector<uint32_t> constraints;  // per constraint its index in the body; only for results
  std::unique_ptr<const SolverStiffness> stiffness;
  std::shared_ptr<const FactorStructure> structure;

  // The values of this part, selected from those of the body.
  std::vector<double> vertexValues(std::span<const double> ofBody) const;
  std::vector<double> constraintValues(std::span<const double> ofBody) const;
};

// A part of the original and the corresponding part of the coarse mesh.
struct PartPair {
  SolverPart original, result;
  std::vector<ClosestPoint> points;  // per vertex of the original part: its closest point of the other

  // Carries values per vertex of the original part over to the result: the value of each vertex is
  // distributed to the corners of its closest point by barycentric weights. Rows 3 v + c for three values per
  // vertex.
  Eigen::MatrixXd carryToResult(const Eigen::MatrixXd& values) const;
};

struct TuneBodies {
  const TriangleMesh& original;
  const TriangleMesh& result;
  const SolverModel& model;
  const SolverConstants& originalConstants;
  const SolverConstants& resultConstants;
  const SolverStiffness& resultStiffness;  // of the whole coarse mesh
};

// Pairs the parts of both bodies that matter: those with at least a thousandth of the area. Pairs ascend by
// the parts of the original. A deque, because other objects refer to its elements. Throws
// std::invalid_argument with a sentence if the numbers of parts differ, and Cancelled.
std::deque<PartPair> pairParts(const TuneBodies& bodies, Job& job);

}  // namespace limber
