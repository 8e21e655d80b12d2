#include "fit/modal_target.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <utility>

#include "base/parallel.h"
#include "compare/assignment.h"
#include "elastic/mode_conversions.h"
#include "linear/dense/dense_product.h"
#include "modes/coarse_vibration.h"
#include "modes/find_modes.h"
#include "transfer/shape_transfer.h"

namespace limber {

namespace {

constexpr std::array<double, ModalTarget::kThicknesses> kThickness = {0.5, 1, 2};  // of the material's
constexpr std::array<double, ModalTarget::kThicknesses> kWeight = {0.4, 1, 1.4};
constexpr Eigen::Index kFirst = 10;         // modes that count fully ...
constexpr double kLaterWeight = 1.27;       // ... and what the later ones count
constexpr double kNoMac = 0.2, kMac = 0.6;  // a pair counts from the one on, fully from the other on
constexpr double kNear = 0.55;              // eigenvalues this close count as neighbours
// Weight of what couples neighbours, which keeps their shapes; of those farther apart than kClose it falls
// with the gap, as what they mix does.
constexpr std::array<double, ModalTarget::kThicknesses> kCoupling = {0, 1.5, 0};
constexpr double kClose = 0.2;
constexpr int kLargeModes = 16;          // that are fitted of large meshes, at both thicknesses
constexpr int kMargin = 4;               // modes beyond the fitted ones that may be partners
constexpr uint32_t kSideBySide = 30000;  // vertices of an original that is solved thrice at a time
constexpr double kTolerance = 1e-3, kLargeTolerance = 1e-4;  // of eigenvalues
constexpr int kReferenceSteps = 8;

// The modes of an original too large to be refined, by way of a coarse copy (modes/find_modes.h).
ModeBasis vibrateCoarsely(const TriangleMesh& mesh, const VibrationRequest& request,
                          const ModalTargetOptions& asked, Job& job) {
  ModesOptions options{ElasticModel::Shell, request.modeCount,
                       unitMaterial(request.thickness, asked.material.poisson)};
  options.pinned.assign(asked.pinnedOriginal.begin(), asked.pinnedOriginal.end());
  const ModeSet set = findModes(mesh, options, false, job);
  return lowestModes(set, buildTopology(mesh).componentOfVertex, set.modes.size());
}

double toleranceOf(const ModalTargetOptions& options) {
  return options.isLarge ? kLargeTolerance : kTolerance;
}

// They have no mass: whoever follows the vibration does not need them.
ModeBasis withoutRotations(ModeBasis found, const TriangleMesh& mesh) {
  found.phi.conservativeResize(3 * static_cast<Eigen::Index>(mesh.vertexCount()), Eigen::NoChange);
  return found;
}

// Between eigenvalues, of the larger.
double gapOf(double a, double b) {
  return std::abs(a - b) / std::max(a, b);
}

double closeness(double a, double b) {
  return std::min(1.0, kClose / gapOf(a, b));
}

bool areNear(double a, double b) {
  return gapOf(a, b) <= kNear;
}

// Entries of psi^T K psi that count, and what each is multiplied by.
struct Residuals {
  std::vector<ModePair> pairs;
  std::vector<double> scale;
};

// Of the diagonal, and of what couples modes of nearby frequencies; fills in all but the slope.
Residuals residualsOf(const ModalTarget::Aligned& aligned, const Eigen::VectorXd& wanted, double coupling,
                      Mismatch& mismatch) {
  Residuals found;
  std::vector<double> residuals;
  for (int i = 0; i < wanted.size(); ++i)
    for (int j = i; j < wanted.size(); ++j) {
      const double weight = std::sqrt(aligned.weight[i] * aligned.weight[j]) *
                            (i == j ? 1 : coupling * closeness(wanted[i], wanted[j]));
      if (!(weight > 0) || (i != j && !areNear(wanted[i], wanted[j]))) continue;
      const double size = std::sqrt(wanted[i] * wanted[j]);
      const double residual = aligned.stiffness(i, j) / size - (i == j);
      found.pairs.push_back({i, j, 0.5 * (aligned.stiffness(i, i) + aligned.stiffness(j, j))});
      found.scale.push_back(std::sqrt(weight) / size);
      residuals.push_back(std::sqrt(weight) * residual);
      if (i == j) mismatch.squares += weight * residual * residual;
      if (i == j) mismatch.weight += weight;
    }
  mismatch.residual =
      Eigen::Map<Eigen::VectorXd>(residuals.data(), static_cast<Eigen::Index>(residuals.size()));
  return found;
}

}  // namespace

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

ModalTarget::ModalTarget(const TriangleMesh& original, const TriangleMesh& mesh,
                         const ModalTargetOptions& options, Job& job)
    : original_(original),
      options_(options),
      topology_(buildTopology(mesh)),
      shell_(
          mesh, topology_,
          {.poisson = options.material.poisson, .tolerance = toleranceOf(options), .pinned = options.pinned},
          job),
      rootMass_(rootMasses(original)) {
  bind(mesh);
  if (options.isLarge)
    prepareLarge(mesh, job);
  else
    prepare(mesh, job);
}

void ModalTarget::prepareLarge(const TriangleMesh& mesh, Job& job) {
  for (size_t k : thicknesses()) last_[k] = startCoarsely(mesh, k, job);
  const std::unique_ptr<OriginalShell> shell = originalShell(job);
  for (size_t k : thicknesses()) findReference(mesh, shell.get(), k, job);
}

// The original's shell is made ready while the mesh is solved; nobody who waits for it is waited for there.
void ModalTarget::prepare(const TriangleMesh& mesh, Job& job) {
  solvedAt_ = mesh.positions;
  std::unique_ptr<OriginalShell> shell;
  std::once_flag isReady;
  const auto original = [&] {
    std::call_once(isReady, [&] { shell = originalShell(job); });
    return shell.get();
  };
  const bool isSmall = original_.vertexCount() <= kSideBySide;
  const std::vector<size_t> wanted = thicknesses();
  parallelFor(1 + wanted.size(), 1, [&](size_t item, size_t) {
    if (item == 0) return void(original());
    const size_t k = wanted[item - 1];
    last_[k] = shell_.solve(mesh, {thicknessOf(k), modesAt(k) + kMargin}, job);
    if (isSmall) findReference(mesh, original(), k, job);
  });
  if (!isSmall)
    for (size_t k : wanted) findReference(mesh, original(), k, job);
}

std::vector<size_t> ModalTarget::thicknesses() const {
  if (options_.isLarge) return {0, 2};
  return {kMiddle, 0, 2};
}

int ModalTarget::modesAt(size_t k) const {
  if (options_.isLarge) return std::min(options_.modeCount, kLargeModes);
  return k == kMiddle ? options_.modeCount : std::min(options_.modeCount, static_cast<int>(kFirst));
}

double ModalTarget::thicknessOf(size_t k) const {
  return kThickness[k] * options_.material.thickness;
}

// By way of a copy with fewer vertices.
ModeBasis ModalTarget::startCoarsely(const TriangleMesh& mesh, size_t thickness, Job& job) const {
  const VibrationRequest request{thicknessOf(thickness), modesAt(thickness) + kMargin};
  const ModeBasis start = coarseVibration(
      mesh, {request, options_.material.poisson, options_.pinned, options_.coarseVertices}, job);
  return withoutRotations(shell_.follow(mesh, start, request, job), mesh);
}

struct ModalTarget::OriginalShell {
  Topology topology;
  VibratingShell shell;

  OriginalShell(const TriangleMesh& mesh, const VibrationOptions& options, Job& job)
      : topology(buildTopology(mesh)), shell(mesh, topology, options, job) {}
};

// None of a mesh too large to be refined.
std::unique_ptr<ModalTarget::OriginalShell> ModalTarget::originalShell(Job& job) const {
  if (original_.vertexCount() > kRefinedVertices) return nullptr;
  const VibrationOptions options{options_.material.poisson, toleranceOf(options_), kReferenceSteps,
                                 options_.pinnedOriginal};
  return std::make_unique<OriginalShell>(original_, options, job);
}

// The modes of the simplified mesh are a start for those of the original.
void ModalTarget::findReference(const TriangleMesh& mesh, const OriginalShell* original, size_t k, Job& job) {
  ModeBasis& reference = reference_[k];
  reference = original
                  ? original->shell.follow(original_, {last_[k].lambda, carriedToOriginal(mesh, last_[k])},
                                           {thicknessOf(k), modesAt(k)}, job)
                  : vibrateCoarsely(original_, {thicknessOf(k), modesAt(k)}, options_, job);
  const Eigen::Index count = std::min<Eigen::Index>(reference.lambda.size(), modesAt(k));
  reference.lambda.conservativeResize(count);
  reference.phi = massNormalised(reference.phi.topLeftCorner(rootMass_.size(), count), rootMass_);
}

Eigen::MatrixXd ModalTarget::carriedToOriginal(const TriangleMesh& mesh, const ModeBasis& found) const {
  return transfer(found.phi.topRows(3 * static_cast<Eigen::Index>(mesh.vertexCount())), mesh, binding_);
}

// The mesh's modes, turned within neighbourhoods of frequencies so that they are as close to the original's
// as they can be. Modes of nearly the same frequency come in any mixture: compared one by one they would be
// pushed about for nothing.
ModalTarget::Aligned ModalTarget::align(const ModeBasis& found, const Eigen::MatrixXd& carried,
                                        size_t k) const {
  const Eigen::VectorXd& wanted = reference_[k].lambda;
  Eigen::MatrixXd turn = product(carried.transpose(), reference_[k].phi);  // found x wanted
  const std::vector<int> partner = assign(turn.transpose().cwiseAbs2());
  Aligned aligned;
  aligned.weight = Eigen::VectorXd::Zero(wanted.size());
  for (Eigen::Index i = 0; i < wanted.size(); ++i) {
    const int p = partner[static_cast<size_t>(i)];
    for (Eigen::Index j = 0; j < found.lambda.size(); ++j)
      if (p < 0 || !areNear(found.lambda[j], found.lambda[p])) turn(j, i) = 0;
    aligned.weight[i] = kWeight[k] * (i < kFirst ? 1 : kLaterWeight) *
                        std::clamp((turn.col(i).squaredNorm() - kNoMac) / (kMac - kNoMac), 0.0, 1.0);
  }
  // The closest orthonormal columns (polar factor).
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(turn, Eigen::ComputeThinU | Eigen::ComputeThinV);
  aligned.turn = svd.matrixU() * svd.matrixV().transpose();
  aligned.stiffness = aligned.turn.transpose() * found.lambda.asDiagonal() * aligned.turn;
  return aligned;
}

// The modes of `mesh`, from what the last call found; that is them already where it is the constructor's
// mesh.
void ModalTarget::vibrate(const TriangleMesh& mesh, size_t thickness, Job& job) {
  ModeBasis& found = last_[thickness];
  const bool isWhole = found.phi.rows() == shell_.unknownCount();
  if (isWhole && mesh.positions == solvedAt_) return;
  const VibrationRequest request{thicknessOf(thickness), modesAt(thickness) + kMargin};
  found =
      found.lambda.size() > 0 ? shell_.follow(mesh, found, request, job) : shell_.solve(mesh, request, job);
}

Mismatch ModalTarget::compare(const TriangleMesh& mesh, size_t thickness, Job& job) {
  vibrate(mesh, thickness, job);
  ModeBasis& found = last_[thickness];
  const Aligned aligned = align(found, massNormalised(carriedToOriginal(mesh, found), rootMass_), thickness);
  Mismatch mismatch;
  const double coupling = options_.isLarge ? 0 : kCoupling[thickness];
  const auto [pairs, scale] = residualsOf(aligned, reference_[thickness].lambda, coupling, mismatch);
  const ThinShell shell{mesh, topology_, thicknessOf(thickness), options_.material.poisson};
  mismatch.slope =
      shellSensitivity(shell, product(found.phi, aligned.turn), pairs, job) *
      Eigen::Map<const Eigen::VectorXd>(scale.data(), static_cast<Eigen::Index>(scale.size())).asDiagonal();
  found = withoutRotations(std::move(found), mesh);
  return mismatch;
}

}  // namespace limber
