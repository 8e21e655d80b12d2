#include "compare/fidelity.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "compare/assignment.h"
#include "mesh/topology.h"
#include "modes/find_modes.h"
#include "transfer/shape_transfer.h"

namespace limber {

namespace {

constexpr int kMargin = 8;  // extra modes of the other body, because the order of modes may differ
constexpr double kNeighbourhood = 0.10;  // modes within this relative distance in frequency form one subspace

// The lowest modes of a body's shell, as columns over its vertices.
ModeBasis lowestShellModes(const TriangleMesh& mesh, const ElasticMaterial& material, int count, Job& job) {
  const ModeSet set = findModes(mesh, {ElasticModel::Shell, count, material}, true, job);
  return lowestModes(set, buildTopology(mesh).componentOfVertex, static_cast<size_t>(count));
}

ElasticMaterial atThickness(ElasticMaterial material, double factor) {
  material.thickness *= factor;
  return material;
}

// The modes of the original paired with those of the other body at one thickness.
struct Pairing {
  std::vector<double> ratio;  // per mode of the original: other / original frequency; 0 without a partner
  std::vector<double> subspaceMac;  // per mode of the original
};

// The squared length of the projection of `shape` onto those columns of `shapes` whose frequency is close to
// that of column `match`.
double subspaceMac(const Eigen::VectorXd& shape, const Eigen::MatrixXd& shapes, const Eigen::VectorXd& omega,
                   int match) {
  std::vector<Eigen::Index> close;
  for (Eigen::Index k = 0; k < omega.size(); ++k)
    if (std::abs(omega[k] - omega[match]) <= kNeighbourhood * omega[match]) close.push_back(k);
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

  // `factor` on the thickness of both bodies.
  Pairing pair(double factor, int count) const {
    return pairWith(lowestShellModes(original_, atThickness(options_.material, factor), count, job_), factor,
                    count);
  }

  // `original`: its modes at that thickness.
  Pairing pairWith(const ModeBasis& original, double factor, int count) const {
    const ModeBasis other =
        lowestShellModes(other_, atThickness(options_.material, factor), count + kMargin, job_);
    const Eigen::MatrixXd shapes = massNormalised(original.phi, rootMass_);
    const Eigen::MatrixXd otherShapes = massNormalised(transfer(other.phi, other_, points_), rootMass_);
    const Eigen::MatrixXd mac = (shapes.transpose() * otherShapes).cwiseAbs2();
    const std::vector<int> partner = assign(mac);
    const Eigen::VectorXd omega = original.lambda.cwiseSqrt(), otherOmega = other.lambda.cwiseSqrt();
    Pairing pairing;
    for (Eigen::Index i = 0; i < original.modeCount(); ++i) {
      const int j = partner[static_cast<size_t>(i)];
      pairing.ratio.push_back(j < 0 ? 0 : otherOmega[j] / omega[i]);
      pairing.subspaceMac.push_back(j < 0 ? 0 : subspaceMac(shapes.col(i), otherShapes, otherOmega, j));
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

// The mean of |factor * ratio - 1| over modes first .. last - 1, in %; NaN if there are none.
double meanError(const std::vector<double>& ratio, size_t first, size_t last, double factor = 1) {
  last = std::min(last, ratio.size());
  double sum = 0;
  for (size_t i = first; i < last; ++i) sum += std::abs(factor * ratio[i] - 1);
  return last > first ? 100 * sum / static_cast<double>(last - first)
                      : std::numeric_limits<double>::quiet_NaN();
}

// The factor on all frequencies that minimises sum (factor * ratio - 1)^2. The mean of |factor * ratio - 1|
// can still be larger than without it, since one large error outweighs many small ones; the factor is then 1.
double bestFactor(const std::vector<double>& ratio, size_t count) {
  double sum = 0, squares = 0;
  for (size_t i = 0; i < std::min(count, ratio.size()); ++i) {
    sum += ratio[i];
    squares += ratio[i] * ratio[i];
  }
  const double factor = squares > 0 ? sum / squares : 1;
  return meanError(ratio, 0, count, factor) < meanError(ratio, 0, count) ? factor : 1;
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

ModeBasis shellModes(const TriangleMesh& mesh, const FidelityOptions& options, Job& job) {
  return lowestShellModes(mesh, options.material, 2 * options.modeCount, job);
}

FrequencyErrors frequencyErrors(const TriangleMesh& original, const ModeBasis& modes,
                                const TriangleMesh& other, const FidelityOptions& options, Job& job) {
  requireTriangles(original, other);
  if (modes.phi.size() != 3 * static_cast<Eigen::Index>(original.vertexCount()) * modes.modeCount())
    throw std::invalid_argument("The modes to compare with are those of another mesh.");
  job.begin(Phase::Compare);
  const Comparison comparison(original, other, options, job);
  const Pairing pairing = comparison.pairWith(modes, 1, 2 * options.modeCount);
  const auto count = static_cast<size_t>(options.modeCount);
  return {meanError(pairing.ratio, 0, count), largestError(pairing.ratio, count)};
}

Fidelity compareFidelity(const TriangleMesh& original, const TriangleMesh& other,
                         const FidelityOptions& options, Job& job) {
  requireTriangles(original, other);
  job.begin(Phase::Compare);
  const Comparison comparison(original, other, options, job);
  const auto count = static_cast<size_t>(options.modeCount);
  const Pairing pairing = comparison.pair(1, 2 * options.modeCount);
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
  fidelity.frequencyErrorThin = meanError(comparison.pair(0.5, options.modeCount).ratio, 0, count);
  fidelity.frequencyErrorThick = meanError(comparison.pair(2, options.modeCount).ratio, 0, count);
  return fidelity;
}

double calibrationFactor(const TriangleMesh& original, const TriangleMesh& other,
                         const FidelityOptions& options, Job& job) {
  requireTriangles(original, other);
  job.begin(Phase::Compare);
  // With the same number of modes as compareFidelity, so that the pairs are the same.
  const Pairing pairing = Comparison(original, other, options, job).pair(1, 2 * options.modeCount);
  const double factor = bestFactor(pairing.ratio, static_cast<size_t>(options.modeCount));
  return factor * factor;
}

}  // namespace limber
