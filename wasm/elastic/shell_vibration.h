#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "base/job.h"
#include "linear/factor_structure.h"
#include "linear/stiffness_model.h"
#include "mesh/topology.h"

namespace limber {

// Elastic modes of a shell in a frame where E = rho = 1 and the diagonal is about 1. phi: unknowns x
// modes, mass-normalised; its first 3 x vertexCount rows are displacements, and the rest may be 0 in a start.
struct ShellVibration {
  double thickness = 0;
  Eigen::VectorXd lambda;
  Eigen::MatrixXd phi;
};

struct VibrationOptions {
  double poisson = 0.3;
  double tolerance = 1e-3;  // on the relative error of eigenvalues, where a start is followed
  int largestStepCount = 4;
  std::span<const uint32_t> pinned = {};  // vertices; they must leave no rigid motion free
};

// A shell whose vertices may move while its triangles stay. All calls may run side by side, within a
// WholePhase.
class VibratingShell {
 public:
  // Keeps a reference to `topology`, that of all meshes that are asked for.
  VibratingShell(const TriangleMesh& mesh, const Topology& topology, const VibrationOptions& options,
                 const Job& job);

  // Some more than `modeCount` elastic modes are found, which are less exact.
  ShellVibration solve(const TriangleMesh& mesh, double thickness, int modeCount, Job& job) const;

  // By inverse iteration from the vibration of nearly the same mesh, at the start's thickness. Finds what the
  // start approximates, and as many modes, of which `modeCount` are exact.
  ShellVibration follow(const TriangleMesh& mesh, const ShellVibration& start, int modeCount, Job& job) const;

  // The shell's unknowns: displacements, then rotations of edges.
  Eigen::Index unknownCount() const { return structure_->unknownCount; }

 private:
  StiffnessModel modelOf(const TriangleMesh& mesh, double thickness) const;

  const Topology& topology_;
  VibrationOptions options_;
  std::vector<uint32_t> held_;  // unknowns; none of a free shell
  std::shared_ptr<const FactorStructure> structure_;
};

}  // namespace limber
