#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "base/job.h"
#include "elastic/solvers/solver_stiffness.h"
#include "linear/refine_eigenpairs.h"

namespace limber {

// Finds the lowest modes of one connected mesh in a solver model, pinned at some of its vertices or
// free, for any factors on its constraints. The symbolic factorisation is computed once and shared by all
// clampings.
//
// Eigenvalues in (rad/s)^2, to about 1e-4; phi over the unknowns of SolverStiffness, mass-normalised. All
// solves throw Cancelled, and std::runtime_error as solveModes.
class SolverVibration {
 public:
  // The vibrating body. `masses`: kg per vertex. `pinned`: empty, or vertices that leave no rigid motion
  // free.
  struct Setting {
    const TriangleMesh& mesh;
    const SolverStiffness& stiffness;
    std::vector<double> masses;
    std::vector<uint32_t> pinned;
  };

  // Keeps references to mesh and stiffness, which must outlive it.
  SolverVibration(Setting setting, std::shared_ptr<const FactorStructure> structure);

  // The lowest `count` elastic modes and some more, from scratch. `scale`: a rough estimate of the first
  // eigenvalue, > 0. EigenSolution::nullity exceeds `rigidMotionCount` if the solver's energy leaves other
  // motions without resistance.
  EigenSolution solve(std::span<const double> factors, int count, double scale, Job& job) const;
  struct Refined {
    std::span<const double> factors;
    int count;
    FactorSharing* sharing = nullptr;  // of this mesh in all clampings; the free body has to be solved first
  };
  // The same from `start`, more than `count` modes of a very similar body. They are refined, and those that
  // it lacks are found; if that does not converge, the search starts from scratch. Accurate for eigenvalues
  // and mass inner products.
  EigenSolution solveFrom(const ModeBasis& start, const Refined& refined, Job& job) const;
  // Refines modes of nearly the same factors and masses, by inverse iteration; finds the modes that the start
  // approximates. `count` of them are exact; it returns as many as the start has.
  ModeBasis follow(std::span<const double> factors, const ModeBasis& start, int count, Job& job) const;

  void setMasses(std::vector<double> masses) { setting_.masses = std::move(masses); }

  // 6 if nothing is pinned, else 0.
  int rigidMotionCount() const { return setting_.pinned.empty() ? 6 : 0; }
  const SolverStiffness& stiffness() const { return setting_.stiffness; }
  const std::vector<double>& masses() const { return setting_.masses; }
  const std::vector<uint32_t>& pinned() const { return setting_.pinned; }
  const std::vector<uint32_t>& clampedUnknowns() const { return clamped_; }

  // What a search from scratch has to know, with factors of 1.
  struct Estimate {
    // Elastic eigenvalues that are 0 up to the rounding of positions to float32: there are some if a sheet of
    // springs is flat, or if sheets swing about an edge or a vertex that they share. 0 if something is
    // pinned.
    uint32_t noiseCount;
    // The first elastic one within a power of ten; 0 if there is noise.
    double firstEigenvalue;
  };
  // Takes one to three factorisations.
  Estimate estimate(Job& job) const;

 private:
  SparsePencil pencilOf(std::span<const double> factors) const;
  // From a few steps of inverse iteration that start between the eigenvalues of quadratic displacements with
  // all constraints and with the bending constraints only.
  double roughFirstEigenvalue(Job& job) const;
  Estimate estimateAboveNoise(Job& job) const;
  double refinedFirstEigenvalue(double rough, Eigen::MatrixXd motions, Job& job) const;
  Eigen::MatrixXd startFor(const SparsePencil& pencil, const ModeBasis& start) const;
  RefineOptions refineOptionsFor(const ModeBasis& start, int count) const;

  Setting setting_;
  std::vector<uint32_t> clamped_;  // unknowns
  std::shared_ptr<const FactorStructure> structure_;
};

// The symbolic factorisation of a stiffness. Throws Cancelled.
std::shared_ptr<const FactorStructure> structureOf(const SolverStiffness& stiffness, const Job& job);

}  // namespace limber
