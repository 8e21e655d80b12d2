#pragma once

#include "base/job.h"
#include "fit/fit_part.h"
#include "fit/surface/fit_samples.h"
#include "fit/surface/surface_fit.h"
#include "fit/target/mismatch.h"
#include "fit/target/modal_target.h"
#include "mesh/topology.h"
#include "query/closest_point.h"

namespace limber {

// A mesh in the course of a search, with its evaluation.
struct SearchState {
  TriangleMesh mesh;
  Mismatch mismatch;         // of its modes
  SurfaceFit surface;        // of its distance from the original
  ModalTarget::Modes modes;  // the start of the search for the next mesh's modes

  // The mean square of the mismatch, times the square of the ratio by which the mean square distance exceeds
  // that of `budget` (a root mean square distance). Lower is better.
  double merit(double budget) const;
};

// The input of a search.
struct SearchProblem {
  const FitPart& part;
  const ClosestPointTree& treeOfOriginal;
  const FitSamples& samples;  // of part.original
  ModalTarget& target;
};

// Evaluates modes and surface distance of meshes that have the triangles of problem.part.result.
class StateEvaluator {
 public:
  // Keeps references to the objects of the problem and to the job.
  StateEvaluator(const SearchProblem& problem, Job& job);

  // Updates all of a state for its mesh. Modes at several thicknesses and the surface fit are computed in
  // parallel. Throws Cancelled.
  void evaluate(SearchState& state);

  const Topology& topology() const { return topology_; }

 private:
  SearchProblem problem_;
  Job& job_;
  Topology topology_;
};

}  // namespace limber
