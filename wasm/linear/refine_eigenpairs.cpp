#include "linear/refine_eigenpairs.h"

#include <algorithm>
#include <cmath>

#include "base/memory.h"
#include "linear/block_lanczos.h"
#include "linear/eigen_search.h"
#include "linear/shifted_pencil.h"

namespace limber {
namespace {

constexpr int kBlocksOfRefinement = 4;  // of vectors that are allocated at the same time
constexpr int kBlocksOfLanczos = 6;     // of its basis, at most
constexpr int kRandomColumns = 4;       // beside a start, to find what it lacks
constexpr int kLeastBlocks = 3;         // that random columns need for that
// A shared shift is at most this multiple of the own one, so that the first eigenvalue is far above the
// threshold of zero ones.
constexpr double kLargestSharedShift = 100;

// A start for block Lanczos, over the heavy unknowns: orthonormal up to the quality of `start`.
Eigen::MatrixXd withRandomColumns(const ShiftedPencil& pencil, const Eigen::MatrixXd& start) {
  Eigen::MatrixXd columns(pencil.heavyCount(), start.cols() + kRandomColumns);
  columns << pencil.restrict(start),
      randomColumns(pencil.heavyCount(), kRandomColumns).colwise().normalized();
  return columns;
}

bool takesBase(const RefineOptions& options) {
  return options.sharing && options.sharing->base &&
         options.sharing->shift >= kLargestSharedShift * options.shift;
}

bool providesBase(const RefineOptions& options) {
  return options.sharing && !options.sharing->base && !options.sharing->unknowns.empty() &&
         options.differing.empty();
}

std::shared_ptr<Factorisation> newFactorisation(const SparsePencil& pencil, const RefineOptions& options,
                                                Job& job) {
  if (takesBase(options))
    return std::make_shared<Factorisation>(pencil, options.sharing->base, options.differing);
  std::shared_ptr<Factorisation> own = factorisationOf(pencil, options.structure, job);
  if (providesBase(options))
    for (const std::vector<uint32_t>& unknowns : options.sharing->unknowns) own->keepFor(unknowns);
  return own;
}

// An estimate of the relative error of eigenvalues: the smaller of their last change and the square of the
// inverse residual, because the error of an eigenvector enters its eigenvalue squared.
double errorOf(const EigenSearch& search, const Eigen::VectorXd& before, Eigen::Index first,
               Eigen::Index count) {
  if (count <= 0) return 0;
  const auto lambda = search.lambda.segment(first, count);
  const double change = (lambda - before.segment(first, count)).cwiseAbs().cwiseQuotient(lambda).maxCoeff();
  return std::min(change, search.inverseResidual.segment(first, count).cwiseAbs2().maxCoeff());
}

// The vectors over all unknowns. If massless unknowns are not 0, this takes another step of inverse
// iteration.
EigenSearch wholePairs(const ShiftedPencil& pencil, const BlockLanczosPairs& pairs) {
  Eigen::MatrixXd phi = pencil.expand(pairs.phi);
  if (!pencil.masslessAreZero())
    phi = pencil.inverseStep(phi) * (pairs.lambda.array() - pencil.shift()).matrix().asDiagonal();
  return {{pairs.lambda, std::move(phi)}, pairs.inverseResidual};
}

// Inverse iteration from `start` until the pairs that have to be exact have converged, or the step limit is
// reached.
EigenSearch refineFrom(ShiftedPencil& pencil, const Eigen::MatrixXd& start, const RefineOptions& options,
                       Job& job) {
  if (options.admit) options.admit(pencil.memoryWith(kBlocksOfRefinement * static_cast<int>(start.cols())));
  pencil.shiftTo(options.shift);
  job.begin(Phase::Solve);
  EigenSearch search{{Eigen::VectorXd::Zero(start.cols()), start}};
  for (int step = 0; step < options.largestStepCount; ++step) {
    const Eigen::VectorXd before = search.lambda;
    inverseIterate(pencil, search);
    const Eigen::Index zeros = zeroPairs(search, options.shift);
    const Eigen::Index count = std::min<Eigen::Index>(options.pairCount, search.lambda.size() - zeros);
    job.report(static_cast<double>(step + 1) / options.largestStepCount);
    if (errorOf(search, before, zeros, count - options.spareCount) < options.tolerance) break;
  }
  return search;
}

EigenSolution solutionOf(const ShiftedPencil& pencil, const EigenSearch& search,
                         const RefineOptions& options) {
  EigenSolution solution = collectPairs(search, zeroPairs(search, pencil.shift()), options.pairCount);
  solution.factorNonzeros = pencil.factorNonzeros();
  for (Eigen::Index k = 0; options.residuals && k < solution.basis.lambda.size(); ++k)
    solution.residual.push_back(pencil.residual(solution.basis.lambda[k], solution.basis.phi.col(k)));
  return solution;
}

}  // namespace

EigenSolution refineEigenpairs(const SparsePencil& pencil, const Eigen::MatrixXd& start,
                               const RefineOptions& options, Job& job) {
  ShiftedPencil shifted(pencil, options.structure, job);
  return solutionOf(shifted, refineFrom(shifted, start, options, job), options);
}

std::optional<EigenSolution> refineLowestEigenpairs(const SparsePencil& pencil, const Eigen::MatrixXd& start,
                                                    const RefineOptions& options, Job& job) {
  if (options.spareCount < 1) return std::nullopt;  // the last pairs of a block converge slowest
  ShiftedPencil shifted(pencil, newFactorisation(pencil, options, job), job);
  const Eigen::Index columns = start.cols() + kRandomColumns;
  const Eigen::Index mostVectors = std::min(kBlocksOfLanczos * columns, shifted.heavyCount());
  const uint64_t memory = shifted.memoryWith(static_cast<int>(mostVectors + kBlocksBesideBasis * columns));
  if (memory > memoryLeft()) {
    if (!options.sharing || !options.sharing->base) return std::nullopt;
    *options.sharing = {};
    return refineLowestEigenpairs(pencil, start, options, job);
  }
  shifted.shiftTo(takesBase(options) ? options.sharing->shift : options.shift);
  job.begin(Phase::Solve);
  const BlockLanczosPairs pairs = blockLanczos(shifted, withRandomColumns(shifted, start),
                                               {start.cols(), start.cols() - options.spareCount,
                                                std::sqrt(options.tolerance), mostVectors, kLeastBlocks});
  if (providesBase(options) && memory < memoryLeft()) {
    options.sharing->base = shifted.factorisation();
    options.sharing->shift = shifted.shift();
  }
  if (!pairs.hasConverged) return std::nullopt;
  return solutionOf(shifted, wholePairs(shifted, pairs), options);
}

}  // namespace limber
