#include "pipeline/modal_target.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "pipeline/assignment.h"
#include "pipeline/find_modes.h"
#include "pipeline/shape_transfer.h"

namespace limber {

namespace {

constexpr std::array<double, 3> kThickness = {0.5, 1, 2};  // of the material's
constexpr std::array<double, 3> kWeight = {0.5, 1, 0.5};
constexpr size_t kMiddle = 1;
constexpr double kNoMac = 0.2, kMac = 0.6;     // a pair counts from the one on, fully from the other on
constexpr double kNear = 0.3;                  // eigenvalues this close count as neighbours
constexpr double kCoupling = 0.5;              // weight of what couples neighbours
constexpr int kMargin = 4;                     // modes beyond the fitted ones that may be partners
constexpr uint32_t kRefinedVertices = 120000;  // above, each thickness gets a coarse solve of its own

ShellMaterial thicker(ShellMaterial material, double factor) {
  material.thickness *= factor;
  return material;
}

// Modes by way of a coarse copy, refined where the mesh is not too large (pipeline/find_modes.h).
ShellVibration vibrateCoarsely(const TriangleMesh& mesh, const ShellMaterial& material, int count, Job& job) {
  const ModesOptions options{Model::Shell, count, material.thickness, 1, material.poisson, 1, 1};
  const ModeSet set = findModes(mesh, options, false, job);
  const auto rows = 3 * static_cast<Eigen::Index>(mesh.vertexCount()),
             columns = static_cast<Eigen::Index>(set.modes.size());
  ShellVibration found{material.thickness, Eigen::VectorXd(columns), Eigen::MatrixXd(rows, columns)};
  for (Eigen::Index k = 0; k < columns; ++k) {
    const Mode& mode = set.modes[static_cast<size_t>(k)];
    found.lambda[k] = mode.omega * mode.omega;
    for (Eigen::Index row = 0; row < rows; ++row)
      found.phi(row, k) = set.shapes[mode.layer * static_cast<size_t>(rows) + static_cast<size_t>(row)];
  }
  return found;
}

bool areNear(double a, double b) {
  return std::abs(a - b) <= kNear * std::max(a, b);
}

// Residuals of the diagonal, and of what couples modes of nearby frequencies.
Mismatch mismatchOf(const TriangleMesh& mesh, const Topology& topology, const ShellMaterial& material,
                    const Eigen::MatrixXd& psi, const ModalTarget::Aligned& aligned,
                    const Eigen::VectorXd& wanted, const Job& job) {
  std::vector<ModePair> pairs;
  std::vector<double> residuals, scales;
  Mismatch mismatch;
  for (int i = 0; i < wanted.size(); ++i)
    for (int j = i; j < wanted.size(); ++j) {
      const double weight = std::sqrt(aligned.weight[i] * aligned.weight[j]) * (i == j ? 1 : kCoupling);
      if (!(weight > 0) || (i != j && !areNear(wanted[i], wanted[j]))) continue;
      const double size = std::sqrt(wanted[i] * wanted[j]);
      const double residual = aligned.stiffness(i, j) / size - (i == j);
      pairs.push_back({i, j, 0.5 * (aligned.stiffness(i, i) + aligned.stiffness(j, j))});
      scales.push_back(std::sqrt(weight) / size);
      residuals.push_back(std::sqrt(weight) * residual);
      if (i == j) mismatch.squares += weight * residual * residual;
      if (i == j) mismatch.weight += weight;
    }
  mismatch.residual =
      Eigen::Map<Eigen::VectorXd>(residuals.data(), static_cast<Eigen::Index>(residuals.size()));
  mismatch.slope =
      shellSensitivity(mesh, topology, material, psi, pairs, job) *
      Eigen::Map<Eigen::VectorXd>(scales.data(), static_cast<Eigen::Index>(scales.size())).asDiagonal();
  return mismatch;
}

Mismatch join(const std::vector<Mismatch>& parts) {
  Mismatch all;
  Eigen::Index count = 0;
  for (const Mismatch& part : parts) count += part.residual.size();
  all.residual.resize(count);
  all.slope.resize(parts[0].slope.rows(), count);
  count = 0;
  for (const Mismatch& part : parts) {
    all.residual.segment(count, part.residual.size()) = part.residual;
    all.slope.middleCols(count, part.residual.size()) = part.slope;
    count += part.residual.size();
    all.squares += part.squares;
    all.weight += part.weight;
  }
  return all;
}

}  // namespace

ModalTarget::ModalTarget(const TriangleMesh& original, const ShellMaterial& material, int modeCount, Job& job)
    : original_(original), material_(material), modeCount_(modeCount), rootMass_(rootMasses(original)) {
  const Topology topology = buildTopology(original);
  const bool isLarge = original.vertexCount() > kExactVertices;
  const auto solve = [&](size_t k, const ShellVibration* start) {
    const ShellMaterial here = thicker(material, kThickness[k]);
    const bool isCoarse = isLarge && (!start || original.vertexCount() > kRefinedVertices);
    return isCoarse ? vibrateCoarsely(original, here, modeCount, job)
                    : vibrate(original, topology, here, modeCount, start, job);
  };
  reference_[kMiddle] = solve(kMiddle, nullptr);
  if (empty()) return;
  for (size_t k : {size_t{0}, size_t{2}}) reference_[k] = solve(k, &reference_[kMiddle]);
  for (ShellVibration& reference : reference_) {
    const Eigen::Index count = std::min<Eigen::Index>(reference.lambda.size(), modeCount);
    reference.lambda.conservativeResize(count);
    reference.phi = massNormalised(reference.phi.topLeftCorner(rootMass_.size(), count), rootMass_);
  }
}

void ModalTarget::bind(const TriangleMesh& mesh) {
  binding_ = closestPoints(original_, mesh);
}

// The mesh's modes, turned within neighbourhoods of frequencies so that they are as close to the original's
// as they can be. Modes of nearly the same frequency come in any mixture: compared one by one they would be
// pushed about for nothing.
ModalTarget::Aligned ModalTarget::align(const ShellVibration& found, const Eigen::MatrixXd& carried,
                                        size_t k) const {
  const Eigen::VectorXd& wanted = reference_[k].lambda;
  Eigen::MatrixXd turn = carried.transpose() * reference_[k].phi;  // found x wanted
  const std::vector<int> partner = assign(turn.transpose().cwiseAbs2());
  Aligned aligned;
  aligned.weight = Eigen::VectorXd::Zero(wanted.size());
  for (Eigen::Index i = 0; i < wanted.size(); ++i) {
    const int p = partner[static_cast<size_t>(i)];
    for (Eigen::Index j = 0; j < found.lambda.size(); ++j)
      if (p < 0 || !areNear(found.lambda[j], found.lambda[p])) turn(j, i) = 0;
    aligned.weight[i] =
        kWeight[k] * std::clamp((turn.col(i).squaredNorm() - kNoMac) / (kMac - kNoMac), 0.0, 1.0);
  }
  // The closest orthonormal columns (polar factor).
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(turn, Eigen::ComputeThinU | Eigen::ComputeThinV);
  aligned.turn = svd.matrixU() * svd.matrixV().transpose();
  aligned.stiffness = aligned.turn.transpose() * found.lambda.asDiagonal() * aligned.turn;
  return aligned;
}

Mismatch ModalTarget::compare(const TriangleMesh& mesh, const Topology& topology, Job& job) {
  const Eigen::Index displacements = 3 * static_cast<Eigen::Index>(mesh.vertexCount());
  const Eigen::Index unknowns = displacements + static_cast<Eigen::Index>(topology.edges.size());
  std::vector<Mismatch> parts;
  for (size_t k = 0; k < kCount; ++k) {
    const ShellMaterial material = thicker(material_, kThickness[k]);
    const bool continues = last_[k].phi.rows() == unknowns;
    ShellVibration& found = last_[k] =
        vibrate(mesh, topology, material, modeCount_ + kMargin, continues ? &last_[k] : nullptr, job);
    const Eigen::MatrixXd carried =
        massNormalised(transfer(found.phi.topRows(displacements), mesh, binding_), rootMass_);
    const Aligned aligned = align(found, carried, k);
    parts.push_back(
        mismatchOf(mesh, topology, material, found.phi * aligned.turn, aligned, reference_[k].lambda, job));
    job.check();
  }
  return join(parts);
}

}  // namespace limber
