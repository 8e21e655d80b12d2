#include "elastic/solvers/solver_vibration.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/disjoint_sets.h"
#include "base/parallel.h"
#include "elastic/followed_modes.h"
#include "elastic/pins.h"
#include "elastic/solve_modes.h"
#include "linear/dense/tall_product.h"
#include "linear/eigen_search.h"
#include "linear/shifted_pencil.h"
#include "mesh/topology.h"

namespace limber {
namespace {

constexpr double kFloatRounding = std::numeric_limits<float>::epsilon() / 2;
constexpr double kMinBendShare = 1e-6;  // of the eigenvalue with all constraints, in the rough estimate
constexpr int kRoughSteps = 3;          // of inverse iteration, at most, for that estimate
constexpr double kCloseToShift = 0.25;  // an estimate above this times the shift is good enough
constexpr double kManyRoundings = 100;  // rounding errors of a mode search over those of one sum of forces
constexpr double kDoubleRounding = std::numeric_limits<double>::epsilon() / 2;

// All polynomials of degree up to 2 as displacements along each axis: a matrix (3 v + c) x 30.
Eigen::MatrixXd quadraticMotions(const TriangleMesh& mesh, Eigen::Index unknownCount) {
  const Bounds box = bounds(mesh);
  const Vec3 middle = 0.5 * (box.low + box.high);
  const double size = std::max(box.diagonal(), 1e-300);
  Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(unknownCount, 30);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const Vec3 p = (mesh.positions[v] - middle) / size;
    const double terms[10] = {1,         p.x,       p.y,       p.z,       p.x * p.x,
                              p.y * p.y, p.z * p.z, p.x * p.y, p.y * p.z, p.z * p.x};
    for (int k = 0; k < 10; ++k)
      for (int axis = 0; axis < 3; ++axis)
        motions(3 * static_cast<Eigen::Index>(v) + axis, 3 * k + axis) = terms[k];
  }
  return motions;
}

// K times the columns of x.
Eigen::MatrixXd forces(const SparsePencil& pencil, const Eigen::MatrixXd& x) {
  Eigen::MatrixXd forces(x.rows(), x.cols());
  parallelFor(static_cast<size_t>(x.cols()), 1, [&](size_t column, size_t) {
    const auto c = static_cast<Eigen::Index>(column);
    forces.col(c).noalias() = pencil.k * x.col(c);
  });
  return forces;
}

// The first eigenvalue after `zeros` zero ones of the pencil within the span of columns. Directions with
// almost no mass are ignored.
double ritzValue(const SparsePencil& pencil, const Eigen::MatrixXd& span, int zeros) {
  const Eigen::MatrixXd stiffness = transposedProduct(span, forces(pencil, span)),
                        mass = transposedProduct(span, pencil.m.asDiagonal() * span);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> masses(mass);
  const double least = 1e-9 * masses.eigenvalues().maxCoeff();
  const auto first = (masses.eigenvalues().array() < least).count();
  const Eigen::MatrixXd basis =
      masses.eigenvectors().rightCols(mass.cols() - first) *
      masses.eigenvalues().tail(mass.cols() - first).cwiseSqrt().cwiseInverse().asDiagonal();
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(
                                     basis.transpose() * stiffness * basis, Eigen::EigenvaluesOnly)
                                     .eigenvalues();
  return values.size() > zeros ? values[zeros] : values[values.size() - 1];
}

// An upper bound on the eigenvalues that rounding gives to motions without resistance: where forces cancel,
// the rounding error of each remains in the sum.
double eigenvalueOfRounding(const SparsePencil& pencil) {
  double stiffness = 0;
  for (Eigen::Index u = 0; u < pencil.m.size(); ++u)
    if (pencil.m[u] > 0) stiffness += pencil.k.coeff(u, u);
  return kManyRoundings * kDoubleRounding * stiffness / pencil.m.sum();
}

// The value, or the smallest allowed one if it is smaller or not a number.
double notBelow(double least, double value) {
  return value > least ? value : least;
}

// Whether bending elements join all triangles, so that only rigid motions meet no resistance: a triangle
// keeps its shape, a hinge the angle between two of them, and Morley's element all angles about an edge.
// Springs across a flat edge do not resist bending.
bool bendingJoinsAll(const TriangleMesh& mesh, const SolverStiffness& stiffness) {
  const uint32_t first = stiffness.stretchCount();
  if (first == stiffness.count() || stiffness[first].vertexCount == 2) return false;
  for (uint32_t c = first; c < stiffness.count(); ++c)
    if (!stiffness.resists(c)) return false;
  const bool isMorley = stiffness[first].vertexCount == 3;
  const Topology topology = buildIncidence(mesh);
  DisjointSets pieces(mesh.triangleCount());
  for (const Topology::Edge& edge : topology.edges)
    if (isMorley || edge.useCount == 2)
      for (const uint32_t t : topology.trianglesAt(edge)) pieces.unite(topology.trianglesAt(edge)[0], t);
  const std::vector<uint32_t> roots = pieces.roots();
  return std::ranges::all_of(roots, [](uint32_t root) { return root == 0; });
}

// The eigenvalue of a motion across triangles that tilt by the rounding of positions to float32, so that
// they stretch although they should only turn. 0 for a mesh without masses.
double eigenvalueOfTilt(const TriangleMesh& mesh, const SparsePencil& pencil) {
  std::vector<double> local;  // squared frequencies of single vertices while all others are fixed
  for (Eigen::Index u = 0; u < pencil.m.size(); ++u)
    if (pencil.m[u] > 0) local.push_back(pencil.k.coeff(u, u) / pencil.m[u]);
  if (local.empty()) return 0;
  const auto middle = local.begin() + static_cast<ptrdiff_t>(local.size() / 2);
  std::ranges::nth_element(local, middle);
  double length = 0;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    length += limber::length(mesh.corner(t, 1) - mesh.corner(t, 0));
  const double edge = length / std::max<double>(1, mesh.triangleCount());
  const double tilt = kFloatRounding * bounds(mesh).diagonal() / edge;
  return *middle * tilt * tilt;
}

// Makes columns orthogonal to rigid motions in the mass product. Massless unknowns are left as they are.
void removeRigidMotions(const Eigen::MatrixXd& rigid, const ShiftedPencil& shifted,
                        Eigen::MatrixXd& columns) {
  const Eigen::MatrixXd gram = shifted.massProduct(rigid, rigid);
  columns -= rigid * gram.ldlt().solve(shifted.massProduct(rigid, columns));
}

}  // namespace

std::shared_ptr<const FactorStructure> structureOf(const SolverStiffness& stiffness, const Job& job) {
  return std::make_shared<const FactorStructure>(factorStructure(stiffness.pattern(), job));
}

SolverVibration::SolverVibration(Setting setting, std::shared_ptr<const FactorStructure> structure)
    : setting_(std::move(setting)),
      clamped_(setting_.stiffness.clampedUnknowns(setting_.pinned)),
      structure_(std::move(structure)) {}

SparsePencil SolverVibration::pencilOf(std::span<const double> factors) const {
  SparsePencil pencil = setting_.stiffness.pencil(factors, setting_.masses);
  if (!clamped_.empty()) clampUnknowns(pencil, clamped_);
  return pencil;
}

EigenSolution SolverVibration::solve(std::span<const double> factors, int count, double scale,
                                     Job& job) const {
  EigenOptions options;
  options.pairCount = count + kSpareModes;
  options.spareCount = kSpareModes;
  options.expectedNullity = rigidMotionCount();
  options.scale = scale;
  options.structure = structure_;
  options.isRough = true;
  return solveModes(pencilOf(factors), options, job);
}

// The columns to refine: rigid motions, mass-normalised, and those of a start.
Eigen::MatrixXd SolverVibration::startFor(const SparsePencil& pencil, const ModeBasis& start) const {
  Eigen::MatrixXd columns = startColumns(
      setting_.mesh, start, {static_cast<Eigen::Index>(pencil.unknownCount()), clamped_, rigidMotionCount()});
  for (int k = 0; k < rigidMotionCount(); ++k)
    columns.col(k) /= std::sqrt(columns.col(k).cwiseAbs2().dot(pencil.m));
  return columns;
}

RefineOptions SolverVibration::refineOptionsFor(const ModeBasis& start, int count) const {
  RefineOptions options = followOptions(start, count);
  options.structure = structure_;
  return options;
}

ModeBasis SolverVibration::follow(std::span<const double> factors, const ModeBasis& start, int count,
                                  Job& job) const {
  if (start.modeCount() == 0) return start;
  if (setting_.stiffness.unknownCount() <= kFewUnknowns) {
    const int sought = std::max(count, static_cast<int>(start.modeCount()) - kSpareModes);
    return solve(factors, sought, start.lambda[0], job).basis;
  }
  const SparsePencil pencil = pencilOf(factors);
  return refineModes(pencil, startFor(pencil, start), refineOptionsFor(start, count), job).basis;
}

EigenSolution SolverVibration::solveFrom(const ModeBasis& start, const Refined& refined, Job& job) const {
  const SparsePencil pencil = pencilOf(refined.factors);
  RefineOptions options = refineOptionsFor(start, refined.count);
  options.sharing = refined.sharing;
  options.differing = clamped_;
  std::optional<EigenSolution> found = refineLowestEigenpairs(pencil, startFor(pencil, start), options, job);
  return found ? *std::move(found) : solve(refined.factors, refined.count, start.lambda[0], job);
}

double SolverVibration::roughFirstEigenvalue(Job& job) const {
  const uint32_t stretches = setting_.stiffness.stretchCount();
  std::vector<double> factors(setting_.stiffness.count(), 1.0);
  Eigen::MatrixXd motions = quadraticMotions(setting_.mesh, setting_.stiffness.unknownCount());
  for (const uint32_t row : clamped_) motions.row(row).setZero();
  const SparsePencil whole = pencilOf(factors);
  const double all =
      notBelow(eigenvalueOfRounding(whole) / kZeroRatio, ritzValue(whole, motions, rigidMotionCount()));
  std::fill_n(factors.begin(), stretches, 0.0);
  const double bend = ritzValue(pencilOf(factors), motions, rigidMotionCount());
  return refinedFirstEigenvalue(std::sqrt(all * notBelow(kMinBendShare * all, bend)), motions, job);
}

// Each step of inverse iteration damps the components that are far stiffer than the shift, so that a shift
// that is far too large comes down step by step. If more than rigid motions meet no resistance, such as
// sheets that swing about a shared edge, it comes down to these, but no further than a search can distinguish
// from zero.
double SolverVibration::refinedFirstEigenvalue(double rough, Eigen::MatrixXd motions, Job& job) const {
  const SparsePencil pencil = pencilOf(std::vector<double>(setting_.stiffness.count(), 1.0));
  const double least = eigenvalueOfRounding(pencil) / kZeroRatio;
  ShiftedPencil shifted(pencil, structure_, job);
  requireMemoryToSolve(shifted.memoryWith(2 * static_cast<int>(motions.cols())));
  for (int step = 0; step < kRoughSteps; ++step) {
    shifted.shiftTo(-rough);
    motions = shifted.inverseStep(motions);
    const double before = rough;
    rough = notBelow(least, ritzValue(pencil, motions, rigidMotionCount()));
    if (rough > kCloseToShift * before) break;
  }
  return rough;
}

SolverVibration::Estimate SolverVibration::estimate(Job& job) const {
  if (!setting_.pinned.empty() || bendingJoinsAll(setting_.mesh, setting_.stiffness))
    return {0, roughFirstEigenvalue(job)};
  return estimateAboveNoise(job);
}

// Inertia counts the eigenvalues of noise at a shift that is far below the elastic ones, so that one step of
// inverse iteration from quadratic displacements that are orthogonal to rigid motions finds the first of
// these.
SolverVibration::Estimate SolverVibration::estimateAboveNoise(Job& job) const {
  const SparsePencil pencil = pencilOf(std::vector<double>(setting_.stiffness.count(), 1.0));
  Eigen::MatrixXd motions = quadraticMotions(setting_.mesh, setting_.stiffness.unknownCount());
  ShiftedPencil shifted(pencil, structure_, job);
  requireMemoryToSolve(shifted.memoryWith(2 * static_cast<int>(motions.cols())));
  const double rounding = eigenvalueOfRounding(pencil);
  const uint32_t below = shifted.countBelow(std::max(eigenvalueOfTilt(setting_.mesh, pencil), rounding));
  const auto rigid = static_cast<uint32_t>(rigidMotionCount());
  if (below > rigid) return {below - rigid, 0};
  removeRigidMotions(startFor(pencil, {}), shifted, motions);
  return {0, notBelow(rounding / kZeroRatio, ritzValue(pencil, shifted.inverseStep(motions), 0))};
}

}  // namespace limber
