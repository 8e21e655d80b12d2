#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/job.h"
#include "elastic/material.h"
#include "elastic/shell_sensitivity.h"
#include "elastic/shell_vibration.h"
#include "modes/vertex_limits.h"
#include "query/closest_point.h"
#include "transfer/shape_transfer.h"

namespace limber {

// Residuals of the reduced stiffness matrix against diag(lambda_original), relative, each with the weight of
// its pair in it.
struct Mismatch {
  Eigen::VectorXd residual;  // clipped, times the root of the weight
  Eigen::MatrixXd
      slope;  // 3 x vertexCount rows, a column for each residual: its derivatives by the coordinates
  double squares = 0, weight = 0;  // of the eigenvalues' residuals as they are, weighted

  double meanSquare() const { return weight > 0 ? squares / weight : 0; }
};

struct ModalTargetOptions {
  ElasticMaterial material;  // of the middle thickness
  int modeCount = 20;
  std::span<const uint32_t> pinnedOriginal = {}, pinned = {};  // vertices of the original and of the mesh
  // For large meshes: half and twice the thickness, without what couples modes; eigenvalues to a tenth of the
  // tolerance (there is less to mend); the mesh's first modes by way of a copy with so many vertices.
  bool isLarge = false;
  uint32_t coarseVertices = kCoarseVertices;
};

// The vibration that a mesh shall have: modes of its original at several thicknesses. Both in the frame where
// the original's diagonal is 1. To be used within a WholePhase.
class ModalTarget {
 public:
  static constexpr size_t kThicknesses = 3;

  // Keeps a reference to `original`. `mesh`: what will be compared, but for the places of its vertices.
  ModalTarget(const TriangleMesh& original, const TriangleMesh& mesh, const ModalTargetOptions& options,
              Job& job);

  // Binds the original's vertices to the mesh, for `compare`.
  void bind(const TriangleMesh& mesh) { binding_ = closestPoints(original_, mesh, binding_); }

  // Indices of the thicknesses to compare at, and whether that is best done side by side.
  std::vector<size_t> thicknesses() const;
  bool areSideBySide() const { return !options_.isLarge; }

  // How far `mesh` is off at one of the thicknesses; a mode counts as far as its MAC is above 0.2, fully from
  // 0.6. Starts from what the last call found. Calls for different thicknesses may run side by side.
  Mismatch compare(const TriangleMesh& mesh, size_t thickness, Job& job);

  // What the last calls have found for each thickness, and to go on from such again.
  using Found = std::array<ModeBasis, kThicknesses>;
  const Found& found() const { return last_; }
  void startFrom(const Found& found) { last_ = found; }

  // There is nothing to aim at.
  bool empty() const { return reference_[thicknesses()[0]].lambda.size() == 0; }

  // psi = phi * turn, mass-normalised, and psi^T K psi; weights by the original's mode.
  struct Aligned {
    Eigen::MatrixXd turn, stiffness;
    Eigen::VectorXd weight;
  };

 private:
  struct OriginalShell;  // ready to follow its modes at any thickness

  static constexpr size_t kMiddle = 1;
  // How many are fitted: fewer at half and at twice the thickness than at the middle one.
  int modesAt(size_t k) const;
  double thicknessOf(size_t k) const;
  void prepare(const TriangleMesh& mesh, Job& job);
  void prepareLarge(const TriangleMesh& mesh, Job& job);
  ModeBasis startCoarsely(const TriangleMesh& mesh, size_t thickness, Job& job) const;
  std::unique_ptr<OriginalShell> originalShell(Job& job) const;
  void findReference(const TriangleMesh& mesh, const OriginalShell* original, size_t thickness, Job& job);
  void vibrate(const TriangleMesh& mesh, size_t thickness, Job& job);
  // Shapes of the mesh at the original's vertices.
  Eigen::MatrixXd carriedToOriginal(const TriangleMesh& mesh, const ModeBasis& found) const;
  Aligned align(const ModeBasis& found, const Eigen::MatrixXd& carried, size_t k) const;

  const TriangleMesh& original_;
  ModalTargetOptions options_;
  Topology topology_;  // of the mesh
  VibratingShell shell_;
  Found reference_;             // shapes mass-normalised over the original's vertices
  Found last_;                  // of the mesh that was compared last
  std::vector<Vec3> solvedAt_;  // the vertices of the mesh that the constructor has solved, or empty
  std::vector<ClosestPoint> binding_;
  Eigen::VectorXd rootMass_;
};

// Several as one.
Mismatch join(const std::vector<Mismatch>& parts);

}  // namespace limber
