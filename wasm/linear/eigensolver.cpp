#include "linear/eigensolver.h"

#include <Spectra/SymEigsSolver.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "base/memory.h"
#include "linear/block_lanczos.h"
#include "linear/dense/dense_eigensolver.h"
#include "linear/eigen_search.h"
#include "linear/shifted_pencil.h"

namespace limber {

namespace {

constexpr int kDenseLimit = 120;  // heavy unknowns: pencils with no more are solved densely
constexpr int kExtraPairs = 4;    // in addition to the wanted ones, to find a gap and complete clusters
constexpr int kBasisBeyond = 24;  // Lanczos vectors in addition to the wanted pairs
constexpr int kLanczosRestarts = 100;
// For block Lanczos in a rough search: vectors of a block, and blocks in addition to two vectors for each
// pair.
constexpr Eigen::Index kBlockSize = 16, kBlocksBeyond = 8;
constexpr double kLanczosTolerance = 1e-10;
constexpr double kDenseZeroRatio = 1e-12;  // of the largest eigenvalue, for dense solves
// A shift within these multiples of the first positive eigenvalue is good enough: Lanczos converges well, and
// another shift would cost a factorisation.
constexpr double kSmallestShift = 0.005, kLargestShift = 15;
constexpr double kBestShift = 0.5;     // times the first positive eigenvalue, for the next attempt
constexpr double kShiftStep = 0.1;     // of a shift on its way down to the gap above zero eigenvalues
constexpr int kLastPass = 3;           // of the search for a good shift, counted from 0
constexpr int kMissingAttempts = 4;    // searches for missing members of clusters
constexpr int kMissingExtraPairs = 2;  // sought in addition to the missing ones
constexpr double kGoodResidual = 1e-8, kGoodInverseResidual = 1e-10, kRoughInverseResidual = 1e-3;
constexpr double kRoundedResidual = 5e-8;  // above this, the residual is evaluated with more digits
constexpr int kExtendedSteps = 3;          // of iterative refinement for that
constexpr int kRefinements = 5;
constexpr double kSlowProgress = 0.5;  // refinement ends once a step leaves more than this part of the error
constexpr int kBlocksOfSearch = 5;     // of vectors, allocated at once while found pairs are refined

// The operator that Spectra multiplies with: the inverted pencil, projected away from the known pairs.
class InverseOperator {
 public:
  using Scalar = double;
  InverseOperator(const ShiftedPencil& pencil, const Eigen::MatrixXd& known, int expectedCalls)
      : pencil_(pencil), known_(known), expectedCalls_(expectedCalls) {}
  Eigen::Index rows() const { return pencil_.heavyCount(); }
  Eigen::Index cols() const { return pencil_.heavyCount(); }
  void perform_op(const double* in, double* out) const {
    pencil_.job().report(std::min(0.99, static_cast<double>(++calls_) / expectedCalls_));
    Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(in, rows());
    project(x);
    x = pencil_.invert(x);
    project(x);
    Eigen::Map<Eigen::VectorXd>(out, rows()) = x;
  }

 private:
  void project(Eigen::VectorXd& x) const {
    if (known_.cols() > 0) x -= known_ * (known_.transpose() * x);
  }
  const ShiftedPencil& pencil_;
  const Eigen::MatrixXd& known_;
  int expectedCalls_;
  mutable int calls_ = 0;
};

// Pairs to search for, and how many of them, the first ones, have to be exact.
struct PairCounts {
  int count, exact;
};

// `count` pairs of lowest lambda by block Lanczos, the first `exact` of them to the accuracy of a rough
// search. Returns nothing if they do not converge, if memory is short, or if all pairs are zero: of a
// multiple zero eigenvalue a block finds as many copies as it has vectors, and none of the pairs above.
std::optional<EigenSearch> roughSearch(const ShiftedPencil& pencil, PairCounts sought) {
  const Eigen::Index size = pencil.heavyCount(), mostVectors = 2 * sought.count + kBlocksBeyond * kBlockSize;
  const uint64_t memory = sizeof(double) * static_cast<uint64_t>(pencil.unknownCount()) *
                          static_cast<uint64_t>(mostVectors + kBlocksBesideBasis * kBlockSize);
  if (mostVectors > size || memory > memoryLeft()) return std::nullopt;
  pencil.job().begin(Phase::Solve);
  const BlockLanczosPairs pairs =
      blockLanczos(pencil, randomColumns(size, kBlockSize),
                   {sought.count, sought.exact, kRoughInverseResidual, mostVectors});
  if (!pairs.hasConverged) return std::nullopt;
  EigenSearch search{{pairs.lambda, pencil.expand(pairs.phi)}, pairs.inverseResidual};
  if (zeroPairs(search, pencil.shift()) == sought.count) return std::nullopt;
  return search;
}

// Up to `count` pairs of lowest lambda that are orthogonal to the columns of `known` (heavy unknowns only).
EigenSearch lanczos(const ShiftedPencil& pencil, const Eigen::MatrixXd& known, PairCounts sought,
                    bool isRough) {
  if (isRough && known.cols() == 0)
    if (std::optional<EigenSearch> search = roughSearch(pencil, sought)) return *std::move(search);
  pencil.job().begin(Phase::Solve);
  const auto size = static_cast<int>(pencil.heavyCount());
  const int wanted = std::min(sought.count, size - 1), basis = std::min(size, wanted + kBasisBeyond);
  InverseOperator inverse(pencil, known, basis + kBasisBeyond);
  Spectra::SymEigsSolver<InverseOperator> solver(inverse, wanted, basis);
  Eigen::VectorXd start = randomColumns(size, 1);
  if (known.cols() > 0) start -= known * (known.transpose() * start);
  try {
    solver.init(start.data());
    solver.compute(Spectra::SortRule::LargestAlge, kLanczosRestarts,
                   isRough ? kRoughTolerance : kLanczosTolerance);
  } catch (const Cancelled&) {
    throw;
  } catch (const std::runtime_error&) {  // Spectra's message is about its internals
    throw NoConvergence(
        "The modes could not be computed: look for coordinates, thicknesses or material constants of wildly "
        "different size.");
  }
  return {
      {solver.eigenvalues().cwiseInverse().array() + pencil.shift(), pencil.expand(solver.eigenvectors())}};
}

// The error of a pair relative to the tolerance: at most 1 once the pair has converged.
double relativeError(const ShiftedPencil& pencil, const EigenSearch& search, Eigen::Index k, bool isRough) {
  if (isRough) return search.inverseResidual[k] / kRoughInverseResidual;
  return std::max(pencil.residual(search.lambda[k], search.phi.col(k)) / kGoodResidual,
                  search.inverseResidual[k] / kGoodInverseResidual);
}

// Iterates until the wanted pairs have converged or hardly improve any more. Pairs with known residuals come
// from roughSearch and have converged, except in massless unknowns.
void refine(const ShiftedPencil& pencil, EigenSearch& search, const EigenOptions& options) {
  const bool haveConverged = search.inverseResidual.size() == search.phi.cols();
  if (haveConverged && pencil.masslessAreZero()) return;
  double before = HUGE_VAL;
  for (int step = 0; step < kRefinements; ++step) {
    inverseIterate(pencil, search);
    const Eigen::Index first = zeroPairs(search, pencil.shift());
    const Eigen::Index last = std::min<Eigen::Index>(first + exactCount(options), search.lambda.size());
    double worst = 0;
    for (Eigen::Index k = first; k < last; ++k)
      worst = std::max(worst, relativeError(pencil, search, k, options.isRough));
    if (worst <= 1 || worst > kSlowProgress * before) return;
    before = worst;
  }
}

// Counts by inertia the zero eigenvalues that no pair represents. Leaves a shift between them and the others.
void countZeros(ShiftedPencil& pencil, double sigma, EigenSearch& search) {
  const Eigen::Index zeros = zeroPairs(search, sigma);
  const double limit = kZeroRatio * std::abs(sigma),
               first = zeros < search.lambda.size() ? search.lambda[zeros] : limit;
  const auto below = static_cast<Eigen::Index>(pencil.countBelow(std::sqrt(limit * first)));
  search.hiddenZeros = std::max<Eigen::Index>(0, below - zeros);
}

// Adds the members of clusters that a single start vector has missed, until inertia counts no more of them.
// An attempt searches for at most as many pairs as are already known: if K is singular up to rounding,
// inertia counts hundreds that do not exist, and the search for them would take hours. Zero eigenvalues are
// only counted: a search from above does not find them.
void addMissing(ShiftedPencil& pencil, EigenSearch& search, const EigenOptions& options) {
  const double sigma = pencil.shift();
  double searchShift = sigma;
  bool areZerosCounted = false;
  for (int attempt = 0; attempt < kMissingAttempts; ++attempt) {
    const Eigen::Index lastWanted = zeroPairs(search, sigma) + exactCount(options) - 1;
    const bool isShort = lastWanted + 1 >= search.lambda.size();
    int missing = isShort ? 0 : missingPairs(pencil, search, lastWanted);
    // A few missing ones can be searched without another factorisation.
    const bool areHidden = isShort || missing > options.pairCount || (missing > 0 && attempt > 0);
    if (areHidden && !areZerosCounted) {
      areZerosCounted = true;
      countZeros(pencil, sigma, search);
      missing -= static_cast<int>(search.hiddenZeros);
      if (search.hiddenZeros > 0) searchShift = pencil.shift();
    }
    if (missing <= 0) return;
    pencil.shiftTo(searchShift);
    const int sought = std::min(missing + kMissingExtraPairs, static_cast<int>(search.lambda.size()));
    const EigenSearch more = lanczos(pencil, pencil.restrict(search.phi), {sought, sought}, options.isRough);
    Eigen::MatrixXd all(search.phi.rows(), search.phi.cols() + more.phi.cols());
    all << search.phi, more.phi;
    search.phi = all;
    refine(pencil, search, options);
  }
}

// The pairs above the zero eigenvalues if there are too many zeros for a search: with a shift between both,
// the zeros are at the other end of the inverted spectrum. The search for that shift starts at `top`.
EigenSearch searchAbove(ShiftedPencil& pencil, Eigen::Index zeros, double top, const EigenOptions& options) {
  double shift = top;
  while (static_cast<Eigen::Index>(pencil.countBelow(shift)) > zeros && shift > kZeroRatio * top)
    shift *= kShiftStep;
  const int sought = std::min(options.pairCount + kExtraPairs, static_cast<int>(pencil.heavyCount() - zeros));
  EigenSearch search;
  search.phi.resize(pencil.unknownCount(), 0);
  if (sought > 0) {
    search = lanczos(pencil, {}, {sought, std::min(sought, exactCount(options))}, options.isRough);
    refine(pencil, search, options);
  }
  search.hiddenZeros = zeros;
  return search;
}

// The lowest pairs. Repeats the search with another shift until the shift suits the pairs found.
EigenSearch searchLowest(ShiftedPencil& pencil, const EigenOptions& options) {
  double sigma = -options.scale;
  int zeros = options.expectedNullity;
  for (int pass = 0;; ++pass) {
    pencil.shiftTo(sigma);
    const PairCounts sought{zeros + options.pairCount + kExtraPairs, zeros + exactCount(options)};
    EigenSearch search = lanczos(pencil, {}, sought, options.isRough);
    zeros = static_cast<int>(zeroPairs(search, sigma));
    const bool isLast = pass == kLastPass || search.lambda.size() >= pencil.heavyCount() - 1;
    if (zeros < search.lambda.size()) {
      const double first = search.lambda[zeros];
      const bool isGoodShift = -sigma > kSmallestShift * first && -sigma < kLargestShift * first;
      const bool isComplete = search.lambda.size() >= zeros + options.pairCount;
      if (isLast || (isGoodShift && isComplete)) {
        refine(pencil, search, options);
        return search;
      }
      if (!isGoodShift) sigma = -kBestShift * first;
    } else {
      const double limit = -kZeroRatio * sigma;
      const uint32_t below = pencil.countBelow(limit);
      if (isLast || pencil.countBelow(kZeroRatio * limit) == below)
        return searchAbove(pencil, below, -sigma, options);
      sigma *= kZeroRatio;
      zeros = options.expectedNullity;
    }
  }
}

// Replaces large residuals by those of phi with more digits: on small or thin elements the rounding of phi to
// doubles alone makes the residual large although the pair is accurate.
void refineBelowRounding(ShiftedPencil& pencil, double sigma, EigenSolution& solution) {
  if (std::all_of(solution.residual.begin(), solution.residual.end(),
                  [](double r) { return r <= kRoundedResidual; }))
    return;
  if (pencil.shift() != sigma) pencil.shiftTo(sigma);
  for (size_t k = 0; k < solution.residual.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    if (solution.residual[k] > kRoundedResidual)
      solution.residual[k] = pencil.extendedResidual(solution.basis.lambda[column],
                                                     solution.basis.phi.col(column), kExtendedSteps);
  }
}

EigenSolution solveBySearch(const SparsePencil& pencil, const EigenOptions& options, Job& job) {
  ShiftedPencil shifted(pencil, options.structure, job);
  const int found = options.expectedNullity + options.pairCount + kExtraPairs;
  if (options.admit) options.admit(shifted.memoryWith(kBasisBeyond + kBlocksOfSearch * found));
  EigenSearch search = searchLowest(shifted, options);
  const double sigma = shifted.shift();
  addMissing(shifted, search, options);
  EigenSolution solution = collectPairs(search, zeroPairs(search, sigma), options.pairCount);
  solution.factorNonzeros = shifted.factorNonzeros();
  if (options.isRough) return solution;
  for (Eigen::Index k = 0; k < solution.basis.lambda.size(); ++k)
    solution.residual.push_back(shifted.residual(solution.basis.lambda[k], solution.basis.phi.col(k)));
  refineBelowRounding(shifted, sigma, solution);
  return solution;
}

EigenSolution solveSmall(const SparsePencil& pencil, const EigenOptions& options, Job& job) {
  job.begin(Phase::Solve);
  const ModeBasis dense = solveDensely(pencil);
  const double largest = dense.lambda.size() ? dense.lambda[dense.lambda.size() - 1] : 0;
  const auto zeros = (dense.lambda.array() < kDenseZeroRatio * largest).count();
  EigenSolution solution =
      collectPairs({dense, Eigen::VectorXd::Zero(dense.lambda.size())}, zeros, options.pairCount);
  for (Eigen::Index k = 0; k < solution.basis.lambda.size(); ++k) {
    const Eigen::VectorXd inertia = pencil.m.cwiseProduct(solution.basis.phi.col(k));
    const Eigen::VectorXd force = pencil.k * solution.basis.phi.col(k) - solution.basis.lambda[k] * inertia;
    solution.residual.push_back(force.norm() / (solution.basis.lambda[k] * inertia.norm()));
  }
  const Eigen::Index n = pencil.m.size();
  solution.factorNonzeros = static_cast<uint64_t>(n * (n + 1) / 2);
  return solution;
}

}  // namespace

EigenSolution solveEigenproblem(const SparsePencil& pencil, const EigenOptions& options, Job& job) {
  const bool isSmall = (pencil.m.array() > 0).count() <= kDenseLimit;
  return isSmall ? solveSmall(pencil, options, job) : solveBySearch(pencil, options, job);
}

}  // namespace limber
