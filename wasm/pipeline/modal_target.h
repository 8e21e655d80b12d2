#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "base/job.h"
#include "measure/closest_point.h"
#include "pipeline/shell_vibration.h"

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

// The vibration that a mesh shall have: modes of its original at several thicknesses. Both in the frame where
// the original's diagonal is 1.
class ModalTarget {
 public:
  // Keeps a reference to `original`. `material`: the middle thickness.
  ModalTarget(const TriangleMesh& original, const ShellMaterial& material, int modeCount, Job& job);

  // How far `mesh` is off; a mode counts as far as its MAC is above 0.2, fully from 0.6. Starts from what the
  // last call with the same triangles found.
  Mismatch compare(const TriangleMesh& mesh, const Topology& topology, Job& job);

  // Lets the next call search from scratch, which proves that no mode is missing.
  void forget() { last_ = {}; }

  // Binds the original's vertices to the mesh, for `compare`.
  void bind(const TriangleMesh& mesh);

  bool empty() const { return reference_[1].lambda.size() == 0; }

  // psi = phi * turn, mass-normalised, and psi^T K psi; weights by the original's mode.
  struct Aligned {
    Eigen::MatrixXd turn, stiffness;
    Eigen::VectorXd weight;
  };

 private:
  static constexpr size_t kCount = 3;
  Aligned align(const ShellVibration& found, const Eigen::MatrixXd& carried, size_t k) const;

  const TriangleMesh& original_;
  ShellMaterial material_;
  int modeCount_;
  std::array<ShellVibration, kCount> reference_;  // shapes mass-normalised over the original's vertices
  std::array<ShellVibration, kCount> last_;       // of the mesh that was compared last
  std::vector<SurfacePoint> binding_;
  Eigen::VectorXd rootMass_;
};

}  // namespace limber
