#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "base/job.h"
#include "linear/refine_eigenpairs.h"
#include "mesh/topology.h"

namespace limber {

struct VibrationOptions {
  double poisson = 0.3;
  double tolerance = 1e-3;                // on the relative error of eigenvalues, when a start is refined
  int largestStepCount = 4;               // of inverse iteration
  std::span<const uint32_t> pinned = {};  // vertex ids
  int freeMotions = 0;                    // rigid motions that the pins leave free; six without pins
};

struct VibrationRequest {
  double thickness = 0;  // in units of the mesh, > 0
  int modeCount = 0;     // elastic modes
};

// Finds the modes of a shell; all code that solves a shell uses this class. The vertices may move while the
// triangles stay the same, so that the structure of the factorisation is found once. In a frame where E = rho
// = 1 and the bounding diagonal is about 1.
//
// The rows of phi are the shell's unknowns: displacements (3 v + c), then edge rotations. All solves may run
// in parallel within a WholePhase. They throw Cancelled, and std::runtime_error as solveModes does.
class VibratingShell {
 public:
  // Keeps a reference to `topology`, which all meshes of later calls share. Throws Cancelled.
  VibratingShell(const TriangleMesh& mesh, const Topology& topology, const VibrationOptions& options,
                 const Job& job);

  // Solves exactly, with residuals and a proof that no mode is missing.
  EigenSolution solveExactly(const TriangleMesh& mesh, const VibrationRequest& request, Job& job) const;
  // Solves approximately, to about 1e-4 in eigenvalues. Returns up to six more modes than requested, which
  // are less accurate.
  ModeBasis solve(const TriangleMesh& mesh, const VibrationRequest& request, Job& job) const;

  // Both refine `start`, which approximates the modes of nearly the same mesh, by inverse iteration. Its phi
  // may lack the rows of edge rotations. They only find the modes that the start approximates. `refine`
  // returns the requested modes, with residuals; `follow` returns as many as the start has, of which the
  // requested ones are exact.
  EigenSolution refine(const TriangleMesh& mesh, const ModeBasis& start, const VibrationRequest& request,
                       Job& job) const;
  ModeBasis follow(const TriangleMesh& mesh, const ModeBasis& start, const VibrationRequest& request,
                   Job& job) const;

  Eigen::Index unknownCount() const { return structure_->unknownCount; }

 private:
  SparsePencil pencilOf(const TriangleMesh& mesh, double thickness) const;
  int freeMotions() const;  // rigid ones
  EigenOptions searchOptions(const VibrationRequest& request) const;
  // Refines with the tolerance, number of steps and structure that all refinements of this shell use.
  EigenSolution refined(const SparsePencil& pencil, const Eigen::MatrixXd& columns, RefineOptions options,
                        Job& job) const;

  const Topology& topology_;
  VibrationOptions options_;
  std::vector<uint32_t> clamped_;  // unknowns; empty if the shell is free
  std::shared_ptr<const FactorStructure> structure_;
};

}  // namespace limber
