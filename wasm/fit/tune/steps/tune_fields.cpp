#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "fit/tune/steps/factor_range.h"
#include "fit/tune/steps/tune_steps.h"
#include "linear/factorisation.h"
#include "mesh/vertex_areas.h"

namespace limber {
namespace {

constexpr int kRounds = 6;
constexpr double kSettled = 3e-3;  // a step in logarithms below which there is no gain

// Smooth fields over the vertices of a mesh: the inverse covariance m + l^2 S up to a factor, m the areas of
// the vertices over their mean and S differences along edges. In a regular mesh, whose vertices have six
// edges of length e, sum_j (x_i - x_j) is -(3/2) e^2 times the second derivatives of x; so l^2 S has the
// weight (2/3) (l / e)^2 on every edge.
SparsePencil smoothness(const TriangleMesh& mesh, double length) {
  const Topology topology = buildTopology(mesh);
  const std::vector<double> areas = lumpedAreas(mesh);
  const double mean = std::accumulate(areas.begin(), areas.end(), 0.0) / mesh.vertexCount();
  double squares = 0;
  for (const Topology::Edge& edge : topology.edges)
    squares += squaredLength(mesh.positions[edge.b] - mesh.positions[edge.a]);
  const double weight =
      2.0 / 3 * length * length * static_cast<double>(topology.edges.size()) / std::max(squares, 1e-300);
  SparsePencil pencil;
  std::vector<Eigen::Triplet<double>> entries;
  for (const Topology::Edge& edge : topology.edges)
    for (const auto& [i, j, value] : {std::tuple(edge.a, edge.a, weight),
                                      {edge.b, edge.b, weight},
                                      {edge.a, edge.b, -weight},
                                      {edge.b, edge.a, -weight}})
      entries.emplace_back(static_cast<int>(i), static_cast<int>(j), value);
  const auto size = static_cast<Eigen::Index>(mesh.vertexCount());
  pencil.k.resize(size, size);
  pencil.k.setFromTriplets(entries.begin(), entries.end());
  pencil.m.resize(size);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) pencil.m[v] = areas[v] / mean;
  for (uint32_t v = 0; v <= mesh.vertexCount(); ++v) pencil.firstUnknown.push_back(v);
  return pencil;
}

double totalArea(const TriangleMesh& mesh) {
  const std::vector<double> areas = vertexAreas(mesh);
  return std::accumulate(areas.begin(), areas.end(), 0.0);
}

// Unknowns: logarithms of the bending field, then of the stretch field if that is tuned.
class FieldUnknowns {
 public:
  FieldUnknowns(const TuneConstraints& constraints, const GlobalFactors& start)
      : constraints_(constraints), vertexCount_(constraints.mesh.vertexCount()), start_(start) {}

  Eigen::Index count() const {
    return (constraints_.tunesStretch ? 2 : 1) * static_cast<Eigen::Index>(vertexCount_);
  }

  std::vector<double> factors(const Eigen::VectorXd& x) const {
    std::vector<double> all = factorsOf(start_, constraints_);
    for (size_t c = 0; c < all.size(); ++c)
      if (isTuned(c)) all[c] *= meanOver(c, x);
    return all;
  }

  // The nearest unknowns for which factors are within their range.
  Eigen::VectorXd bounded(Eigen::VectorXd x) const {
    const auto bound = [](auto field, const FactorRange& range, double factor) {
      const double start = std::log(factor);
      field = field.cwiseMax(range.least - start).cwiseMin(range.most - start).eval();
    };
    bound(x.head(vertexCount_), constraints_.bendRange, start_.bend);
    if (constraints_.tunesStretch) bound(x.tail(vertexCount_), constraints_.stretchRange, start_.stretch);
    return x;
  }

  // Derivatives with respect to the unknowns from those with respect to the logarithms of factors.
  Eigen::MatrixXd gathered(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& x) const {
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(jacobian.rows(), count());
    for (size_t c = 0; c < constraints_.all.size(); ++c) {
      if (!isTuned(c)) continue;
      const SolverConstraint& constraint = constraints_.all[c];
      const double whole = meanOver(c, x) * constraint.vertexCount;
      for (uint32_t k = 0; k < constraint.vertexCount; ++k) {
        const Eigen::Index u = unknownOf(c, constraint.vertices[k]);
        sums.col(u) += jacobian.col(static_cast<Eigen::Index>(c)) * (std::exp(x[u]) / whole);
      }
    }
    return sums;
  }

 private:
  bool isStretch(size_t c) const { return c < constraints_.stretchCount; }
  bool isTuned(size_t c) const { return constraints_.tunesStretch || !isStretch(c); }
  Eigen::Index unknownOf(size_t c, uint32_t v) const {
    return (isStretch(c) ? static_cast<Eigen::Index>(vertexCount_) : 0) + v;
  }
  double meanOver(size_t c, const Eigen::VectorXd& x) const {
    const SolverConstraint& constraint = constraints_.all[c];
    double sum = 0;
    for (uint32_t k = 0; k < constraint.vertexCount; ++k)
      sum += std::exp(x[unknownOf(c, constraint.vertices[k])]);
    return sum / constraint.vertexCount;
  }

  const TuneConstraints& constraints_;
  uint32_t vertexCount_;
  GlobalFactors start_;
};

// The covariance of a field times the columns of J^T, for each of the two fields.
Eigen::MatrixXd smoothed(const Factorisation& prior, const Eigen::MatrixXd& jacobian, uint32_t vertexCount,
                         const Job& job) {
  Eigen::MatrixXd columns = jacobian.transpose();
  for (Eigen::Index first = 0; first < columns.rows(); first += vertexCount) {
    Eigen::MatrixXd field = columns.middleRows(first, vertexCount);
    prior.solve(field, job);
    columns.middleRows(first, vertexCount) = field;
  }
  return columns;
}

// Splits a field with its factor into one of mean 1 and the factor.
std::vector<double> withMeanOne(const Eigen::Ref<const Eigen::VectorXd>& logarithms, double& factor) {
  Eigen::VectorXd field = logarithms.array().exp();
  const double mean = field.mean();
  factor *= mean;
  field /= mean;
  return {field.begin(), field.end()};
}

}  // namespace

VertexFields tuneFields(TuneProblem& problem, const TuneConstraints& constraints, const GlobalFactors& start,
                        Job& job) {
  const TriangleMesh& mesh = constraints.mesh;
  const FieldUnknowns unknowns(constraints, start);
  const auto modes = static_cast<double>(problem.residuals().size());
  const SparsePencil pencil = smoothness(mesh, std::sqrt(totalArea(mesh) / modes));
  Factorisation prior(pencil, job);
  prior.factorise(-1, job);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(unknowns.count()), best = x;
  const double squares = problem.residuals().squaredNorm();
  double bestError = problem.fittedError(), variance = 0;
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::MatrixXd jacobian = unknowns.gathered(problem.jacobian(), x);
    const Eigen::MatrixXd columns = smoothed(prior, jacobian, mesh.vertexCount(), job);
    Eigen::MatrixXd gram = jacobian * columns;
    if (round == 0) variance = squares / 2 / std::max(gram.trace(), 1e-300);
    gram *= variance;
    gram.diagonal().array() += std::max(squares / (2 * modes), kMinScatter);
    const Eigen::VectorXd wanted = problem.residuals() - jacobian * x;
    const Eigen::VectorXd next = -variance * columns * gram.ldlt().solve(wanted);
    const Eigen::VectorXd bounded = unknowns.bounded(next);
    const double step = (bounded - x).cwiseAbs().maxCoeff();
    x = bounded;
    problem.moveTo(unknowns.factors(x), job);
    if (!problem.isDefinite()) break;
    if (problem.fittedError() < bestError) {
      bestError = problem.fittedError();
      best = x;
    }
    if (step < kSettled) break;
  }
  const std::vector<double> factors = unknowns.factors(best);
  if (problem.factors() != factors) problem.moveTo(factors, job);
  VertexFields fields{std::vector<double>(mesh.vertexCount(), 1.0), {}, start};
  fields.bend = withMeanOne(best.head(mesh.vertexCount()), fields.factors.bend);
  if (constraints.tunesStretch)
    fields.stretch = withMeanOne(best.tail(mesh.vertexCount()), fields.factors.stretch);
  return fields;
}

}  // namespace limber
