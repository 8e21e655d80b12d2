#include "fit/search/search_state.h"

#include <algorithm>
#include <vector>

#include "base/parallel.h"
#include "fit/tuning.h"

namespace limber {

double SearchState::merit(double budget) const {
  const double excess = std::max(1.0, surface.meanSquare / (budget * budget));
  return mismatch.meanSquare() * excess * excess;
}

StateEvaluator::StateEvaluator(const SearchProblem& problem, Job& job)
    : problem_(problem), job_(job), topology_(buildTopology(problem.part.result)) {}

void StateEvaluator::evaluate(SearchState& state) {
  ModalTarget& target = problem_.target;
  target.bind(state.mesh);
  const std::vector<size_t> thicknesses = target.thicknesses();
  std::vector<Mismatch> mismatches(thicknesses.size());
  // The longest comparison comes first. The surface fit comes second and not last, because towards its end it
  // uses fewer threads.
  const auto evaluateItem = [&](size_t item) {
    const size_t k = item == 0 ? 0 : item - 1;
    if (item != 1)
      mismatches[k] = target.compare(state.mesh, thicknesses[k], job_);
    else
      state.surface = fitSurface(state.mesh, topology_, problem_.samples,
                                 {.evenness = tuning::search::kEvenness,
                                  .featureEdges = &problem_.part.featureEdges,
                                  .startTriangles = state.surface.closestTriangles},
                                 job_);
  };
  parallelFor(mismatches.size() + 1, target.areParallel() ? 1 : mismatches.size() + 1,
              [&](size_t begin, size_t end) {
                for (size_t item = begin; item < end; ++item) evaluateItem(item);
              });
  problem_.part.flatRegions.stiffen(state.surface.hessian);
  state.mismatch = join(mismatches);
  state.modes = target.lastModes();
}

}  // namespace limber
