#include "modes/eigensolver.h"

#include <Spectra/SymEigsSolver.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "modes/dense_eigensolver.h"
#include "modes/factorisation.h"

namespace limber {

namespace {

constexpr int kDenseLimit = 240;  // unknowns with mass
constexpr int kExtraPairs = 4;    // computed beyond the wanted ones, to find a gap and catch whole clusters
constexpr double kZeroRatio = 1e-4;  // an eigenvalue below this part of the shift's size is a zero mode
constexpr double kGoodResidual = 1e-8;
constexpr double kTrustedInverseResidual = 1e-2;  // the eigenvalue's error is of the size of its square

// All that is asked of the model here.
class Pencil {
 public:
  Pencil(const StiffnessModel& model, Job& job) : model_(model), factorisation_(model), job_(job) {
    for (Eigen::Index i = 0; i < model.mass.size(); ++i)
      if (model.mass[i] > 0) heavy_.push_back(i);
    rootMass_ = model.mass(heavy_).cwiseSqrt();
  }

  void shiftTo(double sigma) {
    job_.begin(Phase::Factorise);
    factorisation_.factorise(sigma, job_);
  }
  uint32_t countBelow(double lambda) {
    shiftTo(lambda);
    return factorisation_.negativePivots();
  }
  uint64_t factorNonzeros() const { return factorisation_.nonzeros(); }
  Eigen::Index heavyCount() const { return rootMass_.size(); }
  Job& job() const { return job_; }

  // M^1/2 (K - sigma M)^-1 M^1/2 on the unknowns with mass.
  Eigen::VectorXd invert(const Eigen::Ref<const Eigen::VectorXd>& x) const {
    Eigen::VectorXd full = Eigen::VectorXd::Zero(model_.mass.size());
    full(heavy_) = rootMass_.cwiseProduct(x);
    factorisation_.solve(full);
    return rootMass_.cwiseProduct(full(heavy_));
  }

  // (K - sigma M)^-1 M phi for each column, all unknowns: one step of inverse iteration.
  Eigen::MatrixXd iterate(const Eigen::MatrixXd& phi) const {
    Eigen::MatrixXd out(phi.rows(), phi.cols());
    for (Eigen::Index k = 0; k < phi.cols(); ++k) {
      Eigen::VectorXd x = model_.mass.cwiseProduct(phi.col(k));
      factorisation_.solve(x);
      out.col(k) = x / std::sqrt(x.cwiseProduct(model_.mass).dot(x));
      job_.check();
    }
    return out;
  }

  // From scaled unknowns with mass to all unknowns; the massless ones are filled in by `iterate`.
  Eigen::MatrixXd expand(const Eigen::MatrixXd& y) const {
    Eigen::MatrixXd phi = Eigen::MatrixXd::Zero(model_.mass.size(), y.cols());
    phi(heavy_, Eigen::all) = rootMass_.cwiseInverse().asDiagonal() * y;
    return phi;
  }
  Eigen::MatrixXd restrict(const Eigen::MatrixXd& phi) const {
    return rootMass_.asDiagonal() * phi(heavy_, Eigen::all);
  }

  // |phi - (lambda - sigma) (K - sigma M)^-1 M phi| / |phi| over the displacements: where needle triangles
  // make K so stiff that rounding alone fills the residual, this still tells whether a pair is right.
  double inverseResidual(double lambda, double sigma, const Eigen::VectorXd& phi) const {
    Eigen::VectorXd x = model_.mass.cwiseProduct(phi);
    factorisation_.solve(x);
    const Eigen::VectorXd own = phi(heavy_);
    return (own - (lambda - sigma) * x(heavy_)).norm() / own.norm();
  }

  double residual(double lambda, const Eigen::VectorXd& phi) const {
    const Eigen::VectorXd inertia = model_.mass.cwiseProduct(phi);
    return (model_.stiffness * phi - lambda * inertia).norm() / (std::abs(lambda) * inertia.norm());
  }

  // Rayleigh-Ritz: the best eigenpairs within the span of the columns, ascending.
  void ritz(Eigen::MatrixXd& phi, Eigen::VectorXd& lambda) const {
    const Eigen::MatrixXd k = phi.transpose() * (model_.stiffness * phi);
    const Eigen::MatrixXd m = phi.transpose() * (model_.mass.asDiagonal() * phi);
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver((k + k.transpose()) / 2,
                                                                           (m + m.transpose()) / 2);
    lambda = solver.eigenvalues();
    phi *= solver.eigenvectors();
  }

 private:
  const StiffnessModel& model_;
  Factorisation factorisation_;
  Job& job_;
  std::vector<Eigen::Index> heavy_;
  Eigen::VectorXd rootMass_;
};

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

// Up to `count` eigenvectors of lowest lambda (scaled unknowns with mass) orthogonal to `known`, in any
// order.
Eigen::MatrixXd lanczos(const Pencil& pencil, const Eigen::MatrixXd& known, int count) {
  pencil.job().begin(Phase::Solve);
  const auto size = static_cast<int>(pencil.heavyCount());
  const int wanted = std::min(count, size - 1), basis = std::min(size, 2 * wanted + 12);
  InverseOperator inverse(pencil, known, 2 * basis);
  Spectra::SymEigsSolver<InverseOperator> solver(inverse, wanted, basis);
  Eigen::VectorXd start = startVector(size);
  if (known.cols() > 0) start -= known * (known.transpose() * start);
  solver.init(start.data());
  solver.compute(Spectra::SortRule::LargestAlge, 300, 1e-10);
  return solver.eigenvectors();
}

struct Search {
  Eigen::VectorXd lambda;  // zero modes too, ascending
  Eigen::MatrixXd phi;
};

Eigen::Index zeroCount(const Search& search, double sigma) {
  return (search.lambda.array() < kZeroRatio * std::abs(sigma)).count();
}

double worstResidual(const Pencil& pencil, const Search& search, Eigen::Index first, Eigen::Index last) {
  double worst = 0;
  for (Eigen::Index k = first; k < last; ++k)
    worst = std::max(worst, pencil.residual(search.lambda[k], search.phi.col(k)));
  return worst;
}

// Block inverse iteration until the wanted residuals are good or no longer fall.
void refine(const Pencil& pencil, Search& search, double sigma, int elasticCount) {
  double before = HUGE_VAL;
  for (int step = 0; step < 6; ++step) {
    search.phi = pencil.iterate(search.phi);
    pencil.ritz(search.phi, search.lambda);
    const Eigen::Index first = zeroCount(search, sigma);
    const double worst = worstResidual(pencil, search, first,
                                       std::min<Eigen::Index>(first + elasticCount, search.lambda.size()));
    if (worst < kGoodResidual || (step > 0 && worst > 0.5 * before)) return;
    before = worst;
  }
}

// The eigenvalue index after which the widest relative gap lies, from the last wanted pair on: a place to
// count below.
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
void addMissing(Pencil& pencil, Search& search, double sigma, int elasticCount) {
  for (int attempt = 0; attempt < 4; ++attempt) {
    const Eigen::Index lastWanted = zeroCount(search, sigma) + elasticCount - 1;
    if (lastWanted + 1 >= search.lambda.size()) return;
    const Eigen::Index gap = gapAfter(search, lastWanted);
    const double between = (search.lambda[gap] + search.lambda[gap + 1]) / 2;
    const auto missing = static_cast<int>(pencil.countBelow(between)) - static_cast<int>(gap + 1);
    pencil.shiftTo(sigma);
    if (missing <= 0) return;
    const Eigen::MatrixXd known = pencil.restrict(search.phi);
    const Eigen::MatrixXd more = pencil.expand(lanczos(pencil, known, missing + 2));
    Eigen::MatrixXd all(search.phi.rows(), search.phi.cols() + more.cols());
    all << search.phi, more;
    search.phi = all;
    refine(pencil, search, sigma, elasticCount);
  }
}

EigenPairs collect(const Search& search, Eigen::Index zeros, int elasticCount) {
  EigenPairs pairs;
  pairs.zeroCount = static_cast<uint32_t>(zeros);
  const Eigen::Index count = std::min<Eigen::Index>(elasticCount, search.lambda.size() - zeros);
  pairs.lambda = search.lambda.segment(zeros, count);
  pairs.phi = search.phi.middleCols(zeros, count);
  return pairs;
}

void requireConvergence(const Pencil& pencil, const EigenPairs& pairs, double sigma) {
  Eigen::Index good = 0;
  for (Eigen::Index k = 0; k < pairs.lambda.size(); ++k)
    good += pencil.inverseResidual(pairs.lambda[k], sigma, pairs.phi.col(k)) <= kTrustedInverseResidual;
  if (good == pairs.lambda.size()) return;
  throw std::runtime_error(
      "The modes did not converge: only " + std::to_string(good) + " of " +
      std::to_string(pairs.lambda.size()) +
      " can be trusted; remove needle triangles, weld the mesh or make the shell thicker.");
}

EigenPairs solveBySearch(const StiffnessModel& model, const EigenOptions& options, Job& job) {
  Pencil pencil(model, job);
  double sigma = -options.scale;
  int zeros = options.zeroExpected;
  Search search;
  for (int pass = 0;; ++pass) {
    pencil.shiftTo(sigma);
    search.phi = pencil.expand(lanczos(pencil, {}, zeros + options.elasticCount + kExtraPairs));
    refine(pencil, search, sigma, options.elasticCount);
    zeros = static_cast<int>(zeroCount(search, sigma));
    if (zeros >= search.lambda.size()) {  // nothing elastic yet: look further
      zeros += options.elasticCount;
      if (pass < 3) continue;
      break;
    }
    const double first = search.lambda[zeros];
    const bool isComplete = search.lambda.size() >= zeros + options.elasticCount;
    const bool isGoodShift = -sigma > 0.02 * first && -sigma < 30 * first;
    if (pass >= 2 || (isComplete && isGoodShift)) break;
    if (!isGoodShift) sigma = -0.5 * first;
  }
  addMissing(pencil, search, sigma, options.elasticCount);
  EigenPairs pairs = collect(search, zeroCount(search, sigma), options.elasticCount);
  pairs.factorNonzeros = pencil.factorNonzeros();
  for (Eigen::Index k = 0; k < pairs.lambda.size(); ++k)
    pairs.residual.push_back(pencil.residual(pairs.lambda[k], pairs.phi.col(k)));
  requireConvergence(pencil, pairs, sigma);
  return pairs;
}

EigenPairs solveSmall(const StiffnessModel& model, const EigenOptions& options, Job& job) {
  job.begin(Phase::Solve);
  const DensePairs dense = solveDensely(model);
  const double largest = dense.lambda.size() ? dense.lambda[dense.lambda.size() - 1] : 0;
  const auto zeros = (dense.lambda.array() < 1e-9 * largest).count();
  EigenPairs pairs = collect({dense.lambda, dense.phi}, zeros, options.elasticCount);
  for (Eigen::Index k = 0; k < pairs.lambda.size(); ++k) {
    const Eigen::VectorXd inertia = model.mass.cwiseProduct(pairs.phi.col(k));
    const Eigen::VectorXd force = model.stiffness * pairs.phi.col(k) - pairs.lambda[k] * inertia;
    pairs.residual.push_back(force.norm() / (pairs.lambda[k] * inertia.norm()));
  }
  const Eigen::Index n = model.mass.size();
  pairs.factorNonzeros = static_cast<uint64_t>(n * (n + 1) / 2);
  return pairs;
}

}  // namespace

EigenPairs solveEigenproblem(const StiffnessModel& model, const EigenOptions& options, Job& job) {
  const bool isSmall = (model.mass.array() > 0).count() <= kDenseLimit;
  return isSmall ? solveSmall(model, options, job) : solveBySearch(model, options, job);
}

}  // namespace limber
