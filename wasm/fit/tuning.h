#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

// The numbers of the modal fit that were found by experiment, in one place. Each has its unit and its
// meaning, and, where measured, the trade-off between larger and smaller values. The measurements are in
// docs/experiments.md. Lengths are relative to the diagonal of the original's component; a "mean square" is
// the weighted mean square of relative errors of eigenvalues, whose root is twice the relative error of
// frequencies.
namespace limber::tuning {

// The surface fit: the quadratic model of the distance between samples of the original and the result.
namespace surface {
// A sample attracts a face only if the cosine between their normals is at least this. Higher values keep thin
// sheets apart, but lose samples at sharp edges.
inline constexpr double kMinCosine = -0.3;
// A sample at this many root mean square distances weighs twice as much as one at distance 0, and farther
// ones more. Halving it keeps paws and tips in place, doubling it favours the mean distance.
inline constexpr double kFarDistance = 3;
// The largest factor by which the weight of a sample grows with its distance. It bounds the effect of
// outliers.
inline constexpr double kMaxFarWeight = 20;
// A vertex is on a crease with respect to a direction in which the covariance of its normals reaches this
// fraction of the largest eigenvalue. Doubling it lets vertices slide off blunt edges, halving it fixes those
// of curved surfaces.
inline constexpr double kCreaseRatio = 1 / 6.0;
// Weight of the distance from borders and feature edges relative to the distance from the surface, per length
// of an edge. Doubling it straightens borders at the cost of the adjacent surface.
inline constexpr double kBorderWeight = 3;
// Samples for each triangle of the result. Fewer make the mean distance larger (a quarter of them by
// 7 %) at the same frequencies; more cost time.
inline constexpr uint32_t kSamplesPerTriangle = 6, kLargeSamplesPerTriangle = 2;
}  // namespace surface

// The rounds of edge flips and surface fits that come before the search for modes.
namespace surface_rounds {
// Number of rounds. A fourth one brought no gain.
inline constexpr int kRounds = 3;
// Damping of a round's step, relative to the area around a vertex. Halving it allows longer steps along the
// surface, for which the model is less accurate.
inline constexpr double kDamping = 1e-3;
// Weight, relative to that of the distance, of moving a vertex along the surface to the middle of its
// triangles. Doubling it makes triangles more regular at the cost of distance.
inline constexpr double kEvenness = 0.003;
// A flip may displace the surface by this fraction of the deviation limit.
inline constexpr double kMaxLift = 0.02;
}  // namespace surface_rounds

// How far the search may move the surface. Better frequencies cost distance.
namespace budget {
// The root mean square distance may grow to this many times that of the result before the fit. With 1.25 (and
// 6.3e-4 below) frequency errors are 7 % larger and distances 8 % smaller.
inline constexpr double kGrowth = 1.45;
// It may also grow to this fraction of the diagonal, which matters if the result is close to the original.
inline constexpr double kMin = 7e-4;
}  // namespace budget

// The parameters of a search that differ between small and large components.
struct SearchEffort {
  int mostRounds;             // limit on Gauss-Newton rounds
  double goodEnough;          // mean square at which the search ends
  double initialDamping;      // of the first step, relative to the area around a vertex
  double mostResidualWeight;  // squared distance budgets that a sum of squared residuals of 1 may cost
};

// A hundred rounds instead of 24 lower the error by 3 %. The search ends at a frequency error of 0.05 %. A
// weight of 100 instead of 700 nearly doubles the frequency error and lowers the distance by 18 %.
inline constexpr SearchEffort kSearch{24, 1e-6, 0.01, 700};
// Large components have small errors, so residuals are nearly linear and long steps are accurate: less
// damping, fewer rounds, and an end at a frequency error of 0.01 %.
inline constexpr SearchEffort kLargeSearch{6, 4e-8, 5e-4, 3500};

namespace search {
// Residuals are clipped to this value in a step, because the model is linear. Doubling it raises the error by
// 5 %.
inline constexpr double kMaxResidual = 0.1;
// The smallest weight of residuals, in squared budgets: a step improves frequencies even when the budget is
// spent.
inline constexpr double kMinResidualWeight = 1;
// Weight of evenness during the search: see surface_rounds::kEvenness. Between 0.0005 and 0.001 it costs
// hardly anything.
inline constexpr double kEvenness = 1e-3;
// Weight of a vertex's displacement from the start of the search, relative to that of the distance. Nothing
// else keeps vertices from sliding along flat walls, and walls whose triangles have slid far buckle in other
// spots in large motions. A third of this weight lowers the frequency error by a quarter and raises the
// motion deviation by 7 %.
inline constexpr double kStartWeight = 1e-3;
// A state whose merit exceeds the best one's by this factor is dropped, and the best one is restored.
inline constexpr double kLost = 1.5;
// If the mean square after the search is above this (a frequency error of 2.5 %), the fit is repeated without
// flips and surface rounds, which can harm a mesh of slivers more than a search can repair.
inline constexpr double kRetryAbove = 2.5e-3;
}  // namespace search

// Levenberg-Marquardt damping: see Damping. Gains are fractions of the predicted decrease of the residuals.
namespace damping {
inline constexpr double kMin = 3e-4, kMax = 1e5;  // range of mu; at kMax the search ends
// Below kPoorGain the damping is multiplied by kIncrease; above kGoodGain it is divided by kDecrease. Other
// thresholds and factors gave errors up to 5 % larger.
inline constexpr double kPoorGain = 0.3, kGoodGain = 0.7;
inline constexpr double kIncrease = 3, kDecrease = 1.5;
// If speed is favoured and the gain exceeds kFullGain, the damping is divided by kFastDecrease.
inline constexpr double kFullGain = 0.85, kFastDecrease = 3;
// A vertex that the guard limits to less than kBlocked of its displacement is blocked: its damping scale is
// multiplied by kBlockedIncrease in each round in which it is, and divided by kFreedDecrease afterwards. The
// steps of the other vertices then no longer rely on it, which lowered the error of nine meshes from 0.98 to
// 0.76 %.
inline constexpr double kBlocked = 0.5, kBlockedIncrease = 4, kFreedDecrease = 3;
inline constexpr double kMaxScale = 1e6;  // of the damping scale
}  // namespace damping

// Convergence of a search: see StopRule. `Root` values are differences of the root of a mean square.
namespace stopping {
// Rounds over which progress is judged. Two instead of three save 8 % of the time and raise the error by 5 %.
inline constexpr size_t kPatience = 3;
// The search ends if kPatience rounds leave more than kStagnant of the merit and lower its root by less than
// kLittleRoot (0.1 % in frequency).
inline constexpr double kStagnant = 0.9, kLittleRoot = 2e-3;
// If speed is favoured, it ends below kFine (0.26 % in frequency) once they lower the root by less than
// kLittleRootOfFine.
inline constexpr double kFine = 2.7e-5, kLittleRootOfFine = 2.8e-3;
// Speed is favoured if the result has more than this many vertices: rounds then take tenths of a second.
inline constexpr uint32_t kFavourSpeedVertices = 1000;
// With more than this many vertices rounds take seconds, and 0.1 % in frequency (as a mean square) is enough.
inline constexpr uint32_t kManyVertices = 5000;
inline constexpr double kGoodEnoughOfMany = 4e-6;
}  // namespace stopping

// The modes that the search fits: see ModalTarget.
namespace target {
inline constexpr size_t kThicknesses = 3;
// Thicknesses of the shell at which modes are compared, as multiples of the material's.
inline constexpr std::array<double, kThicknesses> kThickness = {0.5, 1, 2};
// The weight of a mode at each of them. A larger weight of one lowers its error and raises the others'.
inline constexpr std::array<double, kThicknesses> kWeight = {0.4, 1, 1.4};
// The first kFirst modes count fully, and the later ones of the middle thickness kLaterWeight times as much;
// 1.15 instead raises the error of modes 11 to 20 by 4 %.
inline constexpr int kFirst = 10;
inline constexpr double kLaterWeight = 1.27;
// A mode counts if its MAC with its partner exceeds kNoMac, and fully from kMac on.
inline constexpr double kNoMac = 0.2, kMac = 0.6;
// Eigenvalues whose gap is at most this fraction of the larger one are neighbours: modes are aligned within
// neighbourhoods. Between 0.35 and 0.7 frequencies are equally accurate; smaller values lower the MAC, larger
// ones take longer.
inline constexpr double kNear = 0.55;
// Weight of the off-diagonal residuals of neighbours at each thickness, which preserve the shapes of modes.
// When it rises from 0.5 to 10, the lowest MAC of a bar rises from 0.79 to 0.93 at the same frequencies.
inline constexpr std::array<double, kThicknesses> kCoupling = {0, 1.5, 0};
// Beyond this gap the weight falls off in proportion to the gap, as the mixing of the two modes does.
inline constexpr double kClose = 0.2;
inline constexpr int kLargeModes = 16;  // fitted modes of large components, at both thicknesses
inline constexpr int kMargin = 4;       // additional modes that may be partners of the fitted ones
// Relative tolerance of eigenvalues. Large components have small errors, so that it must be smaller.
inline constexpr double kTolerance = 1e-3, kLargeTolerance = 1e-4;
inline constexpr int kOriginalSteps = 8;  // of inverse iteration, at most, for the original's modes
// If the original has at most this many vertices, its three thicknesses are solved in parallel: memory allows
// it.
inline constexpr uint32_t kParallelVertices = 30000;
}  // namespace target

// Large components, which are fitted in few rounds without flips. Their sizes are in modes/vertex_limits.h.
namespace large {
// Measured bytes that the fit takes per vertex of the original.
inline constexpr uint64_t kBytesPerVertex = 20000;
}  // namespace large

}  // namespace limber::tuning
