#include "linear/eigensolver.h"

#include <Spectra/SymEigsSolver.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "linear/dense/dense_eigensolver.h"
#include "linear/dense/dense_product.h"
#include "linear/pencil.h"

namespace limber {

namespace {

constexpr int kDenseLimit = 120;  // unknowns with mass
constexpr int kExtraPairs = 4;    // computed beyond the wanted ones, to find a gap and catch whole clusters
constexpr int kBasisBeyond = 24;  // Lanczos vectors more than pairs
constexpr double kLanczosTolerance = 1e-10, kRoughTolerance = 1e-4;
constexpr double kZeroRatio = 1e-4;  // an eigenvalue below this part of the shift's size is a zero mode
constexpr double kGoodResidual = 1e-8, kGoodInverseResidual = 1e-10, kRoughInverseResidual = 1e-3;
constexpr double kTrustedInverseResidual = 1e-2;  // the eigenvalue's error is of the size of its square
constexpr double kRoundedResidual = 5e-8;         // above it more digits are asked for
constexpr int kRefinements = 5;

// What Spectra multiplies with: the inverted pencil, away from the pairs that are known already.
class InverseOperator {
 public:
  using Scalar = double;
  InverseOperator(const Pencil& pencil, const Eigen::MatrixXd& known, int expectedCalls)
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
  const Pencil& pencil_;
  const Eigen::MatrixXd& known_;
  int expectedCalls_;
  mutable int calls_ = 0;
};

// The same vector for the same size, without any symmetry of the mesh.
Eigen::VectorXd startVector(Eigen::Index size) {
  Eigen::VectorXd x(size);
  uint64_t state = 0x9e3779b97f4a7c15ull;
  for (double& value : x) {
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    value = static_cast<double>(state >> 11) / 9007199254740992.0 - 0.5;
  }
  return x;
}

// Eigenpairs as they are known so far, zero modes too, ascending.
struct Search {
  Eigen::VectorXd lambda;
  Eigen::MatrixXd phi;
  Eigen::VectorXd inverseResidual;
};

// Up to `count` pairs of lowest lambda that are orthogonal to `known` (restricted to the heavy unknowns).
Search lanczos(const Pencil& pencil, const Eigen::MatrixXd& known, int count, bool isRough) {
  pencil.job().begin(Phase::Solve);
  const auto size = static_cast<int>(pencil.heavyCount());
  const int wanted = std::min(count, size - 1), basis = std::min(size, wanted + kBasisBeyond);
  InverseOperator inverse(pencil, known, basis + kBasisBeyond);
  Spectra::SymEigsSolver<InverseOperator> solver(inverse, wanted, basis);
  Eigen::VectorXd start = startVector(size);
  if (known.cols() > 0) start -= known * (known.transpose() * start);
  solver.init(start.data());
  solver.compute(Spectra::SortRule::LargestAlge, 100, isRough ? kRoughTolerance : kLanczosTolerance);
  return {
      solver.eigenvalues().cwiseInverse().array() + pencil.shift(), pencil.expand(solver.eigenvectors()), {}};
}

Eigen::Index zeroCount(const Search& search, double sigma) {
  return (search.lambda.array() < kZeroRatio * std::abs(sigma)).count();
}

// One step of block inverse iteration with Rayleigh-Ritz. As K x = M phi + sigma M x for x = (K - sigma M)^-1
// M phi, x^T K x needs no product with K, whose stiffest entries would only add rounding. The inverse
// residual is that of the pairs before the step.
void iterate(const Pencil& pencil, Search& search) {
  const Eigen::MatrixXd x = pencil.inverseStep(search.phi);
  const Eigen::MatrixXd h = pencil.massProduct(x, search.phi), g = pencil.massProduct(x, x);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> ritz((h + h.transpose()) / 2,
                                                                       (g + g.transpose()) / 2);
  const Eigen::MatrixXd before = product(search.phi, ritz.eigenvectors());
  search.lambda = ritz.eigenvalues().array() + pencil.shift();
  search.phi = product(x, ritz.eigenvectors());
  const Eigen::MatrixXd change = pencil.restrict(before - search.phi * ritz.eigenvalues().asDiagonal());
  search.inverseResidual =
      change.colwise().norm().cwiseQuotient(pencil.restrict(before).colwise().norm()).transpose();
}

// How many times worse than it should be a pair is.
double badness(const Pencil& pencil, const Search& search, Eigen::Index k, bool isRough) {
  if (isRough) return search.inverseResidual[k] / kRoughInverseResidual;
  return std::max(pencil.residual(search.lambda[k], search.phi.col(k)) / kGoodResidual,
                  search.inverseResidual[k] / kGoodInverseResidual);
}

// Steps until the wanted pairs are good or get no better.
void refine(const Pencil& pencil, Search& search, const EigenOptions& options) {
  double before = HUGE_VAL;
  for (int step = 0; step < kRefinements; ++step) {
    iterate(pencil, search);
    const Eigen::Index first = zeroCount(search, pencil.shift());
    const Eigen::Index last = std::min<Eigen::Index>(first + options.elasticCount, search.lambda.size());
    double worst = 0;
    for (Eigen::Index k = first; k < last; ++k)
      worst = std::max(worst, badness(pencil, search, k, options.isRough));
    if (worst <= 1 || worst > 0.5 * before) return;
    before = worst;
  }
}

// The index after which the widest relative gap lies, from the last wanted pair on: a place to count below.
Eigen::Index gapAfter(const Search& search, Eigen::Index lastWanted) {
  Eigen::Index best = lastWanted;
  double widest = -1;
  for (Eigen::Index k = lastWanted; k + 1 < search.lambda.size(); ++k) {
    const double gap = 1 - search.lambda[k] / search.lambda[k + 1];
    if (gap > widest) {
      widest = gap;
      best = k;
    }
  }
  return best;
}

// Adds the pairs that a single start vector missed (members of clusters), as inertia counts them.
void addMissing(Pencil& pencil, Search& search, const EigenOptions& options) {
  const double sigma = pencil.shift();
  for (int attempt = 0; attempt < 4; ++attempt) {
    const Eigen::Index lastWanted = zeroCount(search, sigma) + options.elasticCount - 1;
    if (lastWanted + 1 >= search.lambda.size()) return;
    const Eigen::Index gap = gapAfter(search, lastWanted);
    const double between = (search.lambda[gap] + search.lambda[gap + 1]) / 2;
    const auto missing = static_cast<int>(pencil.countBelow(between)) - static_cast<int>(gap + 1);
    if (missing <= 0) return;
    pencil.shiftTo(sigma);
    const Search more = lanczos(pencil, pencil.restrict(search.phi), missing + 2, options.isRough);
    Eigen::MatrixXd all(search.phi.rows(), search.phi.cols() + more.phi.cols());
    all << search.phi, more.phi;
    search.phi = all;
    refine(pencil, search, options);
  }
}

// The lowest pairs, found with a shift that suits them.
Search searchLowest(Pencil& pencil, const EigenOptions& options) {
  double sigma = -options.scale;
  int zeros = options.zeroExpected;
  for (int pass = 0;; ++pass) {
    pencil.shiftTo(sigma);
    Search search = lanczos(pencil, {}, zeros + options.elasticCount + kExtraPairs, options.isRough);
    zeros = static_cast<int>(zeroCount(search, sigma));
    const bool isLast = pass == 3 || search.lambda.size() >= pencil.heavyCount() - 1;
    if (zeros < search.lambda.size()) {
      const double first = search.lambda[zeros];
      const bool isGoodShift = -sigma > 0.005 * first && -sigma < 15 * first;
      const bool isComplete = search.lambda.size() >= zeros + options.elasticCount;
      if (isLast || (isGoodShift && isComplete)) {
        refine(pencil, search, options);
        return search;
      }
      if (!isGoodShift) sigma = -0.5 * first;
    } else {
      if (isLast) return search;
      sigma *= 10;  // nothing elastic among so many: look further
      zeros = std::min(zeros + options.elasticCount, static_cast<int>(pencil.heavyCount()) - 1);
    }
  }
}

EigenPairs collect(const Search& search, Eigen::Index zeros, int elasticCount) {
  EigenPairs pairs;
  pairs.zeroCount = static_cast<uint32_t>(zeros);
  const Eigen::Index count = std::min<Eigen::Index>(elasticCount, search.lambda.size() - zeros);
  pairs.lambda = search.lambda.segment(zeros, count);
  pairs.phi = search.phi.middleCols(zeros, count);
  for (Eigen::Index k = 0; k < count; ++k) pairs.inverseResidual.push_back(search.inverseResidual[zeros + k]);
  return pairs;
}

void requireConvergence(const EigenPairs& pairs) {
  const auto good = std::count_if(pairs.inverseResidual.begin(), pairs.inverseResidual.end(),
                                  [](double residual) { return residual <= kTrustedInverseResidual; });
  if (static_cast<size_t>(good) == pairs.inverseResidual.size()) return;
  throw std::runtime_error(
      "The modes did not converge: only " + std::to_string(good) + " of " +
      std::to_string(pairs.inverseResidual.size()) +
      " can be trusted; remove needle triangles, weld the mesh or make the shell thicker.");
}

// Where triangles are small or thin, rounding phi to doubles alone fills the residual: there it is taken of
// phi with more digits.
void lookBehindRounding(Pencil& pencil, double sigma, EigenPairs& pairs) {
  if (std::all_of(pairs.residual.begin(), pairs.residual.end(),
                  [](double r) { return r <= kRoundedResidual; }))
    return;
  if (pencil.shift() != sigma) pencil.shiftTo(sigma);
  for (size_t k = 0; k < pairs.residual.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    if (pairs.residual[k] > kRoundedResidual)
      pairs.residual[k] = pencil.extendedResidual(pairs.lambda[column], pairs.phi.col(column), 3);
  }
}

EigenPairs solveBySearch(const StiffnessModel& model, const EigenOptions& options, Job& job) {
  Pencil pencil(model, options.structure, job);
  // Lanczos' basis, and the found pairs a few times over while they are refined.
  pencil.requireMemoryFor(kBasisBeyond + 5 * (options.zeroExpected + options.elasticCount + kExtraPairs));
  Search search = searchLowest(pencil, options);
  const double sigma = pencil.shift();
  addMissing(pencil, search, options);
  EigenPairs pairs = collect(search, zeroCount(search, sigma), options.elasticCount);
  requireConvergence(pairs);
  pairs.factorNonzeros = pencil.factorNonzeros();
  if (options.isRough) return pairs;
  for (Eigen::Index k = 0; k < pairs.lambda.size(); ++k)
    pairs.residual.push_back(pencil.residual(pairs.lambda[k], pairs.phi.col(k)));
  lookBehindRounding(pencil, sigma, pairs);
  return pairs;
}

EigenPairs solveSmall(const StiffnessModel& model, const EigenOptions& options, Job& job) {
  job.begin(Phase::Solve);
  const DensePairs dense = solveDensely(model);
  const double largest = dense.lambda.size() ? dense.lambda[dense.lambda.size() - 1] : 0;
  const auto zeros = (dense.lambda.array() < 1e-12 * largest).count();
  EigenPairs pairs = collect({dense.lambda, dense.phi, Eigen::VectorXd::Zero(dense.lambda.size())}, zeros,
                             options.elasticCount);
  for (Eigen::Index k = 0; k < pairs.lambda.size(); ++k) {
    const Eigen::VectorXd inertia = model.mass.cwiseProduct(pairs.phi.col(k));
    const Eigen::VectorXd force = model.stiffness * pairs.phi.col(k) - pairs.lambda[k] * inertia;
    pairs.residual.push_back(force.norm() / (pairs.lambda[k] * inertia.norm()));
  }
  const Eigen::Index n = model.mass.size();
  pairs.factorNonzeros = static_cast<uint64_t>(n * (n + 1) / 2);
  return pairs;
}

// How far eigenvalues may be off: they changed by less, or shapes did, whose error counts squared.
double errorOf(const Search& search, const Eigen::VectorXd& before, Eigen::Index first, Eigen::Index count) {
  if (count <= 0) return 0;
  const auto lambda = search.lambda.segment(first, count);
  const double change = (lambda - before.segment(first, count)).cwiseAbs().cwiseQuotient(lambda).maxCoeff();
  return std::min(change, search.inverseResidual.segment(first, count).cwiseAbs2().maxCoeff());
}

}  // namespace

EigenPairs solveEigenproblem(const StiffnessModel& model, const EigenOptions& options, Job& job) {
  const bool isSmall = (model.mass.array() > 0).count() <= kDenseLimit;
  return isSmall ? solveSmall(model, options, job) : solveBySearch(model, options, job);
}

EigenPairs refineEigenpairs(const StiffnessModel& model, const Eigen::MatrixXd& start,
                            const RefineOptions& options, Job& job) {
  Pencil pencil(model, options.structure, job);
  pencil.requireMemoryFor(4 * static_cast<int>(start.cols()));
  pencil.shiftTo(options.shift);
  job.begin(Phase::Solve);
  Search search{Eigen::VectorXd::Zero(start.cols()), start, {}};
  Eigen::Index zeros = 0;
  for (int step = 0; step < options.largestStepCount; ++step) {
    const Eigen::VectorXd before = search.lambda;
    iterate(pencil, search);
    zeros = zeroCount(search, options.shift);
    const Eigen::Index count = std::min<Eigen::Index>(options.elasticCount, search.lambda.size() - zeros);
    job.report(static_cast<double>(step + 1) / options.largestStepCount);
    if (errorOf(search, before, zeros, count - options.spareCount) < options.tolerance) break;
  }
  EigenPairs pairs = collect(search, zeros, options.elasticCount);
  pairs.factorNonzeros = pencil.factorNonzeros();
  for (Eigen::Index k = 0; options.residuals && k < pairs.lambda.size(); ++k)
    pairs.residual.push_back(pencil.residual(pairs.lambda[k], pairs.phi.col(k)));
  return pairs;
}

}  // namespace limber
