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

// A mesh during a search, with its evaluation.
struct SearchState {
  TriangleMesh mesh;
  Mismatch mismatch;         // of its modes
  SurfaceFit surface;        // of its distance from the original
  ModalTarget::Modes modes;  // where the search for the next mesh's modes starts

  // The mean square of the mismatch, times the square of the ratio by which the mean square distance exceeds
  // that of `budget` (a root mean square distance). Less is better.
  double merit(double budget) const;
};

// The input of a search.
struct SearchProblem {
  const FitPart& part;
  const ClosestPointTree& treeOfOriginal;
  const FitSamples& samples;  // of part.original
  ModalTarget& target;
};

// Evaluates modes and surface of meshes that have the triangles of problem.part.result.
class StateEvaluator {
 public:
  // Keeps references to what the problem refers to and to the job.
  StateEvaluator(const SearchProblem& problem, Job& job);

  // Brings all of a state up to date with its mesh. Modes at several thicknesses and the surface fit are
  // found in parallel. Throws Cancelled.
  void evaluate(SearchState& state);

  const Topology& topology() const { return topology_; }

 private:
  SearchProblem problem_;
  Job& job_;
  Topology topology_;
};

}  // namespace limber
