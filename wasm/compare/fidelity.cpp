#include "compare/fidelity.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "compare/assignment.h"
#include "mesh/topology.h"
#include "transfer/shape_transfer.h"

namespace limber {

namespace {

constexpr int kMargin = 8;  // modes beyond the compared ones, so that a mode may change its place
constexpr double kNeighbourhood = 0.10;  // modes this close in frequency are compared as one subspace

ShellModes lowestModes(const TriangleMesh& mesh, const FidelityOptions& options, double thickness, int count,
                       Job& job) {
  const ModesOptions modesOptions{Model::Shell,    count,           thickness,   options.young,
                                  options.poisson, options.density, options.unit};
  const ModeSet set = computeModes(mesh, modesOptions, job);
  const auto component = buildTopology(mesh).componentOfVertex;
  const size_t n = mesh.vertexCount(),
               listed = std::min<size_t>(set.modes.size(), static_cast<size_t>(count));
  ShellModes lowest;
  lowest.shapes.assign(3 * n * listed, 0);
  for (size_t k = 0; k < listed; ++k) {
    const Mode& mode = set.modes[k];
    lowest.omega.push_back(mode.omega);
    for (size_t v = 0; v < n; ++v)
      if (component[v] == mode.component)
        for (size_t c = 0; c < 3; ++c)
          lowest.shapes[(k * n + v) * 3 + c] = set.shapes[(mode.ordinal * n + v) * 3 + c];
  }
  return lowest;
}

// One column per mode, rows 3 * v + c.
Eigen::MatrixXd columnsOf(const ShellModes& modes) {
  const auto count = static_cast<Eigen::Index>(modes.omega.size());
  const auto rows = count > 0 ? static_cast<Eigen::Index>(modes.shapes.size()) / count : 0;
  return Eigen::Map<const Eigen::MatrixXf>(modes.shapes.data(), rows, count).cast<double>();
}

// The modes of both bodies at one thickness, paired.
struct Pairing {
  std::vector<double> ratio;  // other / original frequency by the original's mode; 0 where it has no partner
  std::vector<double> subspaceMac;  // by the original's mode
};

// How much of `shape` lies in the span of those columns of `shapes` whose frequency is close to that of
// column `match`.
double subspaceMac(const Eigen::VectorXd& shape, const Eigen::MatrixXd& shapes,
                   const std::vector<double>& omega, int match) {
  std::vector<Eigen::Index> close;
  for (size_t k = 0; k < omega.size(); ++k)
    if (std::abs(omega[k] - omega[match]) <= kNeighbourhood * omega[match])
      close.push_back(static_cast<Eigen::Index>(k));
  const Eigen::MatrixXd span = shapes(Eigen::all, close);
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(span);
  const Eigen::MatrixXd basis =
      qr.householderQ() * Eigen::MatrixXd::Identity(span.rows(), std::min(span.cols(), qr.rank()));
  return (basis.transpose() * shape).squaredNorm();
}

class Comparison {
 public:
  Comparison(const TriangleMesh& original, const TriangleMesh& other, const FidelityOptions& options,
             Job& job)
      : original_(original),
        other_(other),
        options_(options),
        job_(job),
        points_(closestPoints(original, other)),
        rootMass_(rootMasses(original)) {}

  Pairing pair(double thickness, int count) const {
    return pairWith(lowestModes(original_, options_, thickness, count, job_), thickness, count);
  }

  // `a`: the original's modes.
  Pairing pairWith(const ShellModes& a, double thickness, int count) const {
    const ShellModes b = lowestModes(other_, options_, thickness, count + kMargin, job_);
    const Eigen::MatrixXd shapesA = massNormalised(columnsOf(a), rootMass_);
    const Eigen::MatrixXd shapesB = massNormalised(transfer(columnsOf(b), other_, points_), rootMass_);
    const Eigen::MatrixXd mac = (shapesA.transpose() * shapesB).cwiseAbs2();
    const std::vector<int> partner = assign(mac);
    Pairing pairing;
    for (size_t i = 0; i < a.omega.size(); ++i) {
      const int j = partner[i];
      pairing.ratio.push_back(j < 0 ? 0 : b.omega[j] / a.omega[i]);
      pairing.subspaceMac.push_back(
          j < 0 ? 0 : subspaceMac(shapesA.col(static_cast<Eigen::Index>(i)), shapesB, b.omega, j));
    }
    return pairing;
  }

 private:
  const TriangleMesh &original_, &other_;
  const FidelityOptions& options_;
  Job& job_;
  std::vector<ClosestPoint> points_;
  Eigen::VectorXd rootMass_;
};

// Mean of |factor * ratio - 1| over modes first .. last - 1, in %; 0 where there are none.
double meanError(const std::vector<double>& ratio, size_t first, size_t last, double factor = 1) {
  last = std::min(last, ratio.size());
  double sum = 0;
  for (size_t i = first; i < last; ++i) sum += std::abs(factor * ratio[i] - 1);
  return last > first ? 100 * sum / static_cast<double>(last - first) : 0;
}

// The factor on all frequencies that makes sum (factor * ratio - 1)^2 smallest.
double bestFactor(const std::vector<double>& ratio, size_t count) {
  double sum = 0, squares = 0;
  for (size_t i = 0; i < std::min(count, ratio.size()); ++i) {
    sum += ratio[i];
    squares += ratio[i] * ratio[i];
  }
  return squares > 0 ? sum / squares : 1;
}

double largestError(const std::vector<double>& ratio, size_t count) {
  double largest = 0;
  for (size_t i = 0; i < std::min(count, ratio.size()); ++i)
    largest = std::max(largest, 100 * std::abs(ratio[i] - 1));
  return largest;
}

void requireTriangles(const TriangleMesh& original, const TriangleMesh& other) {
  if (original.triangles.empty() || other.triangles.empty())
    throw std::invalid_argument("A mesh without a usable triangle cannot be compared.");
}

}  // namespace

ShellModes shellModes(const TriangleMesh& mesh, const FidelityOptions& options, Job& job) {
  return lowestModes(mesh, options, options.thickness, 2 * options.modeCount, job);
}

FrequencyErrors frequencyErrors(const TriangleMesh& original, const ShellModes& modes,
                                const TriangleMesh& other, const FidelityOptions& options, Job& job) {
  requireTriangles(original, other);
  if (modes.shapes.size() != 3 * size_t{original.vertexCount()} * modes.omega.size())
    throw std::invalid_argument("The modes to compare with are those of another mesh.");
  job.begin(Phase::Compare);
  const Comparison comparison(original, other, options, job);
  const Pairing pairing = comparison.pairWith(modes, options.thickness, 2 * options.modeCount);
  const auto count = static_cast<size_t>(options.modeCount);
  return {meanError(pairing.ratio, 0, count), largestError(pairing.ratio, count)};
}

Fidelity compareFidelity(const TriangleMesh& original, const TriangleMesh& other,
                         const FidelityOptions& options, Job& job) {
  requireTriangles(original, other);
  job.begin(Phase::Compare);
  const Comparison comparison(original, other, options, job);
  const auto count = static_cast<size_t>(options.modeCount);
  const Pairing pairing = comparison.pair(options.thickness, 2 * options.modeCount);
  Fidelity fidelity;
  fidelity.frequencyErrorMean = meanError(pairing.ratio, 0, count);
  fidelity.frequencyErrorMax = largestError(pairing.ratio, count);
  fidelity.frequencyErrorHigh = meanError(pairing.ratio, count, 2 * count);
  const double factor = bestFactor(pairing.ratio, count);
  fidelity.calibrationFactor = factor * factor;
  fidelity.frequencyErrorCalibrated = meanError(pairing.ratio, 0, count, factor);
  const auto macs = std::min(count, pairing.subspaceMac.size());
  fidelity.macMin = macs ? 1 : 0;
  for (size_t i = 0; i < macs; ++i) {
    fidelity.macMin = std::min(fidelity.macMin, pairing.subspaceMac[i]);
    fidelity.macMean += pairing.subspaceMac[i] / static_cast<double>(macs);
  }
  fidelity.frequencyErrorThin =
      meanError(comparison.pair(options.thickness / 2, options.modeCount).ratio, 0, count);
  fidelity.frequencyErrorThick =
      meanError(comparison.pair(options.thickness * 2, options.modeCount).ratio, 0, count);
  return fidelity;
}

double calibrationFactor(const TriangleMesh& original, const TriangleMesh& other,
                         const FidelityOptions& options, Job& job) {
  requireTriangles(original, other);
  job.begin(Phase::Compare);
  // As many modes as compareFidelity has, for the same pairs.
  const Pairing pairing =
      Comparison(original, other, options, job).pair(options.thickness, 2 * options.modeCount);
  const double factor = bestFactor(pairing.ratio, static_cast<size_t>(options.modeCount));
  return factor * factor;
}

}  // namespace limber
