#include "fit/target/modal_target.h"

#include <algorithm>
#include <mutex>
#include <optional>
#include <utility>

#include "base/parallel.h"
#include "linear/dense/dense_product.h"
#include "modes/coarse_vibration.h"
#include "transfer/shape_transfer.h"

namespace limber {

namespace {

namespace constants = tuning::target;

constexpr size_t kMiddle = 1;  // index of the middle thickness

double toleranceOf(const ModalTargetOptions& options) {
  return options.isLarge ? constants::kLargeTolerance : constants::kTolerance;
}

// The rotations of edges have no mass, and inverse iteration starts without them.
ModeBasis withoutEdgeRotations(ModeBasis modes, const TriangleMesh& mesh) {
  modes.phi.conservativeResize(3 * static_cast<Eigen::Index>(mesh.vertexCount()), Eigen::NoChange);
  return modes;
}

}  // namespace

ModalTarget::ModalTarget(const TriangleMesh& original, const TriangleMesh& result,
                         const ModalTargetOptions& options, Job& job)
    : original_(original),
      options_(options),
      topology_(buildTopology(result)),
      shell_(result, topology_,
             {.poisson = options.material.poisson,
              .tolerance = toleranceOf(options),
              .pinned = options.pinnedResult},
             job),
      rootMass_(rootMasses(original)) {
  bind(result);
  if (options.isLarge)
    prepareLarge(result, job);
  else
    prepare(result, job);
}

void ModalTarget::bind(const TriangleMesh& result) {
  binding_ = closestPoints(original_, result, binding_);
}

void ModalTarget::prepareLarge(const TriangleMesh& result, Job& job) {
  for (size_t k : thicknesses()) last_[k] = startCoarsely(result, k, job);
  const OriginalModes original(original_, originalOptions(), job);
  for (size_t k : thicknesses()) findReference(result, original, k, job);
}

// The original's shell is prepared while the result's modes are solved. A thread that needs it earlier waits
// for it; the preparation never waits for such a thread, so there is no deadlock.
void ModalTarget::prepare(const TriangleMesh& result, Job& job) {
  solvedAt_ = result.positions;
  std::optional<OriginalModes> modes;
  std::once_flag isReady;
  const auto original = [&]() -> const OriginalModes& {
    std::call_once(isReady, [&] { modes.emplace(original_, originalOptions(), job); });
    return *modes;
  };
  const bool isSmall = original_.vertexCount() <= constants::kParallelVertices;
  const std::vector<size_t> wanted = thicknesses();
  parallelFor(1 + wanted.size(), 1, [&](size_t item, size_t) {
    if (item == 0) return void(original());
    const size_t k = wanted[item - 1];
    last_[k] = shell_.solve(result, resultRequest(k), job);
    if (isSmall) findReference(result, original(), k, job);
  });
  if (!isSmall)
    for (size_t k : wanted) findReference(result, original(), k, job);
}

std::vector<size_t> ModalTarget::thicknesses() const {
  if (options_.isLarge) return {0, 2};
  return {kMiddle, 0, 2};
}

bool ModalTarget::empty() const {
  return std::ranges::any_of(thicknesses(), [&](size_t k) {
    return reference_[k].lambda.size() == 0 || last_[k].lambda.size() == 0;
  });
}

int ModalTarget::modesAt(size_t thickness) const {
  if (options_.isLarge) return std::min(options_.modeCount, constants::kLargeModes);
  return thickness == kMiddle ? options_.modeCount : std::min(options_.modeCount, constants::kFirst);
}

double ModalTarget::thicknessOf(size_t thickness) const {
  return constants::kThickness[thickness] * options_.material.thickness;
}

VibrationRequest ModalTarget::resultRequest(size_t thickness) const {
  return {thicknessOf(thickness), modesAt(thickness) + constants::kMargin};
}

VibrationRequest ModalTarget::originalRequest(size_t thickness) const {
  return {thicknessOf(thickness), modesAt(thickness)};
}

VibrationOptions ModalTarget::originalOptions() const {
  return {options_.material.poisson, toleranceOf(options_), constants::kOriginalSteps,
          options_.pinnedOriginal};
}

// Solves on a decimated copy.
ModeBasis ModalTarget::startCoarsely(const TriangleMesh& result, size_t thickness, Job& job) const {
  const VibrationRequest request = resultRequest(thickness);
  const ModeBasis start = coarseVibration(
      result, {request, options_.material.poisson, options_.pinnedResult, options_.coarseVertices}, job);
  return withoutEdgeRotations(shell_.follow(result, start, request, job), result);
}

// Refines the modes of the result on the original.
void ModalTarget::findReference(const TriangleMesh& result, const OriginalModes& original, size_t thickness,
                                Job& job) {
  const ModeBasis& start = last_[thickness];
  ModeBasis& reference = reference_[thickness];
  reference = original.canRefine() ? original.refine({start.lambda, carriedToOriginal(result, start)},
                                                     originalRequest(thickness), job)
                                   : original.findCoarsely(originalRequest(thickness), job);
  const Eigen::Index count = std::min<Eigen::Index>(reference.lambda.size(), modesAt(thickness));
  reference.lambda.conservativeResize(count);
  reference.phi = massNormalised(reference.phi.topLeftCorner(rootMass_.size(), count), rootMass_);
}

// Shapes of the result at the vertices of the original.
Eigen::MatrixXd ModalTarget::carriedToOriginal(const TriangleMesh& result, const ModeBasis& modes) const {
  return transfer(modes.phi.topRows(3 * static_cast<Eigen::Index>(result.vertexCount())), result, binding_);
}

// Updates last_ for the positions of the result. It is up to date if these are the constructor's and the edge
// rotations have not been dropped.
void ModalTarget::vibrate(const TriangleMesh& result, size_t thickness, Job& job) {
  ModeBasis& modes = last_[thickness];
  const bool isWhole = modes.phi.rows() == shell_.unknownCount();
  if (isWhole && result.positions == solvedAt_) return;
  const VibrationRequest request = resultRequest(thickness);
  modes = modes.lambda.size() > 0 ? shell_.follow(result, modes, request, job)
                                  : shell_.solve(result, request, job);
}

Mismatch ModalTarget::compare(const TriangleMesh& result, size_t thickness, Job& job) {
  vibrate(result, thickness, job);
  ModeBasis& modes = last_[thickness];
  const ModeBasis& reference = reference_[thickness];
  const Eigen::MatrixXd carried = massNormalised(carriedToOriginal(result, modes), rootMass_);
  const AlignedModes aligned = alignModes(modes.lambda, product(carried.transpose(), reference.phi),
                                          reference.lambda, constants::kWeight[thickness]);
  Mismatch mismatch;
  const double coupling = options_.isLarge ? 0 : constants::kCoupling[thickness];
  const auto [pairs, scale] = findResiduals(aligned, reference.lambda, coupling, mismatch);
  const ThinShell shell{result, topology_, thicknessOf(thickness), options_.material.poisson};
  mismatch.jacobian =
      shellSensitivity(shell, product(modes.phi, aligned.rotation), pairs, job) *
      Eigen::Map<const Eigen::VectorXd>(scale.data(), static_cast<Eigen::Index>(scale.size())).asDiagonal();
  modes = withoutEdgeRotations(std::move(modes), result);
  return mismatch;
}

}  // namespace limber
