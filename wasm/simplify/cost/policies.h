#pragma once

#include <concepts>
#include <span>
#include <tuple>

#include "simplify/cost/limber.h"
#include "simplify/cost/paper.h"
#include "simplify/cost/qem.h"
#include "simplify/simplify_options.h"

namespace limber {

// The requirements on a cost policy: how a method prices collapses. The collapse loop is compiled once for
// each policy.
//
// Costs are evaluated lazily: each edge first has a bound, below which its cost never falls while its own
// ends do not change. `setBounds` gives edges cheap bounds and may be called for different edges at the same
// time; `raiseBounds` gives better ones, which stay valid as long, and sets the targets. `bound` and `target`
// return the values set last; a target is the optimum of the edge. `cost` may be called for edges with a
// raised bound, or with one that is the cost; `terms` are the parts of the cost at an optimum.
//
// - boundsAreCosts: whether the bounds of `setBounds` are the costs themselves.
// - followsNeighbourhood: whether edges have to be queued again by their bounds when their ends or the
//   triangles around these change. Otherwise they keep their position in the queue, or get that of
//   `expectedCost`, and are priced again when they come up: most have become more expensive, or have been
//   removed by then. Only an edge that has become cheaper comes up late, which has no visible effect on the
//   distance of the result (0.5 % less for qem on 18 meshes at 25 %).
//   Deviation: the paper recomputes all scores that a collapse changes.
// - kTolerance: of two costs whose ratio is below this, either may go first; 1 for an exact order.
// - expectedCost(edge, cost): an estimate of the cost of an edge after its own ends have changed; `cost` is
//   its previous cost.
// - collapse: must be called before the mesh carries out a collapse; updates the data of the kept vertex.
template <class Cost>
concept CostPolicy = std::constructible_from<Cost, const TriangleMesh&, const CollapseMesh&, const Guidance&,
                                             const SimplifyOptions&> &&
                     requires(Cost costs, const Cost& known, uint32_t edge, std::span<const uint32_t> edges) {
                       { Cost::kName } -> std::convertible_to<std::string_view>;
                       { Cost::kTolerance } -> std::convertible_to<double>;
                       { known.boundsAreCosts() } -> std::same_as<bool>;
                       { known.followsNeighbourhood() } -> std::same_as<bool>;
                       { known.optimum(edge) } -> std::same_as<Optimum>;
                       { known.bound(edge) } -> std::same_as<float>;
                       { known.target(edge) } -> std::same_as<Vec3>;
                       { known.cost(edge) } -> std::same_as<double>;
                       { known.terms(edge, Optimum{}) } -> std::same_as<CostTerms>;
                       { costs.expectedCost(edge, 1.0) } -> std::same_as<double>;
                       costs.setBounds(edges);
                       costs.raiseBounds(edges);
                       costs.collapse(Collapse{});
                     };

// The methods: a new one needs a policy in a file of its own and a row here. `Method` is the index of a row.
using CostPolicies = std::tuple<QemCost, PaperCost, LimberCost>;

// Calls task.template operator()<Policy>() with the policy of a method and returns the result.
template <size_t row = 0, class Task>
auto withPolicy(Method method, const Task& task) {
  using Policy = std::tuple_element_t<row, CostPolicies>;
  static_assert(CostPolicy<Policy>);
  if constexpr (row + 1 < std::tuple_size_v<CostPolicies>)
    if (static_cast<size_t>(method) != row) return withPolicy<row + 1>(method, task);
  return task.template operator()<Policy>();
}

}  // namespace limber
