#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "base/job.h"
#include "elastic/solvers/solver_stiffness.h"
#include "linear/refine_eigenpairs.h"

namespace limber {

// One connected mesh in a solver of the panel, held at some of its vertices or free: its lowest modes for any
// factors on its constraints. The symbolic factorisation is found once and shared by all clampings.
//
// Eigenvalues in (rad/s)^2, to about 1e-4; phi over the unknowns of SolverStiffness, mass-normalised. All
// solves throw Cancelled, and std::runtime_error as solveModes.
class SolverVibration {
 public:
  // What vibrates. `masses`: kg per vertex. `pinned`: vertices that leave no rigid motion, or none.
  struct Setting {
    const TriangleMesh& mesh;
    const SolverStiffness& stiffness;
    std::vector<double> masses;
    std::vector<uint32_t> pinned;
  };

  // Refers to mesh and stiffness, which must outlive it.
  SolverVibration(Setting setting, std::shared_ptr<const FactorStructure> structure);

  // The lowest `count` elastic modes and some more, from scratch. `scale`: a rough size of the first
  // eigenvalue, > 0. EigenSolution::nullity exceeds `rigidMotionCount` where the solver's energy leaves
  // motions without resistance.
  EigenSolution solve(std::span<const double> factors, int count, double scale, Job& job) const;
  // The same where `start` has modes of a body much like this one, more than `count`. These are refined, and
  // where that does not give the lowest modes, the search is from scratch. That none is missing is proved
  // where nothing is pinned: it takes another factorisation. For eigenvalues and for inner products in the
  // mass.
  EigenSolution solveFrom(const ModeBasis& start, std::span<const double> factors, int count, Job& job) const;
  // Refines modes of nearly the same factors and masses, by inverse iteration; finds the modes that the start
  // approximates. `count` of them are exact; as many are returned as the start has.
  ModeBasis follow(std::span<const double> factors, const ModeBasis& start, int count, Job& job) const;

  void setMasses(std::vector<double> masses) { setting_.masses = std::move(masses); }

  // 6 where nothing is pinned, else 0.
  int rigidMotionCount() const { return setting_.pinned.empty() ? 6 : 0; }
  const SolverStiffness& stiffness() const { return setting_.stiffness; }
  const std::vector<double>& masses() const { return setting_.masses; }
  const std::vector<uint32_t>& pinned() const { return setting_.pinned; }

  // A rough size of the first elastic eigenvalue with factors of 1: from between what quadratic displacements
  // give with all constraints and with those of bending alone, by some steps of inverse iteration. Within a
  // power of ten. One to three factorisations.
  double roughFirstEigenvalue(Job& job) const;
  // Elastic eigenvalues below the size that positions rounded to float32 give to motions without any
  // resistance: more than none where a sheet of springs is flat, or where sheets swing about an edge or a
  // vertex that they share. None, and nothing to factorise, where bending elements join all triangles; one
  // factorisation otherwise.
  uint32_t countNoise(std::span<const double> factors, Job& job) const;

 private:
  SparsePencil pencilOf(std::span<const double> factors) const;
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
