#include "simulate/solid/velocity_fit.h"

#include <Eigen/SparseCholesky>
#include <array>
#include <stdexcept>

namespace limber {

namespace {

// The weight of a second difference relative to the velocity of a vertex, and that of a first difference, for
// nodes that second differences do not determine.
constexpr double kSmoothness = 1e-3, kFirstDifference = 1e-9;

using Matrix = Eigen::SparseMatrix<double>;

// The normal equations of least squares: each equation adds a row times its transpose.
class NormalEquations {
 public:
  explicit NormalEquations(size_t nodes)
      : right_(Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(nodes), 3)) {}

  void add(std::span<const uint32_t> nodes, std::span<const double> factors, double weight,
           const Vec3& value = {}) {
    for (size_t i = 0; i < nodes.size(); ++i) {
      for (int c = 0; c < 3; ++c)
        right_(static_cast<Eigen::Index>(nodes[i]), c) += weight * factors[i] * value[c];
      for (size_t j = 0; j < nodes.size(); ++j)
        entries_.push_back(
            {static_cast<int>(nodes[i]), static_cast<int>(nodes[j]), weight * factors[i] * factors[j]});
    }
  }

  Eigen::MatrixXd solve() const {
    Matrix matrix(right_.rows(), right_.rows());
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    const Eigen::SimplicialLDLT<Matrix> factor(matrix);
    if (factor.info() != Eigen::Success)
      throw std::runtime_error(
          "The velocities cannot be given to the inside of the body: use the material shell.");
    return factor.solve(right_);
  }

 private:
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::MatrixXd right_;
};

// The neighbours of each node along each axis, [6 * node + 2 * axis + side], or kNone.
std::vector<uint32_t> neighboursOf(const LatticeBody& body) {
  std::vector<uint32_t> neighbours(6 * body.nodes.size(), kNone);
  for (const auto& cell : body.cells)
    for (uint32_t corner = 0; corner < 8; ++corner)
      for (uint32_t axis = 0; axis < 3; ++axis) {
        uint32_t& next = neighbours[6 * size_t{cell[corner]} + 2 * axis + (~corner >> axis & 1)];
        if (next == kNone) next = cell[corner ^ 1u << axis];
      }
  return neighbours;
}

}  // namespace

std::vector<Vec3> fitVelocities(const LatticeBody& body, std::span<const Vec3> velocities) {
  NormalEquations equations(body.nodes.size());
  for (size_t v = 0; v < velocities.size(); ++v)
    equations.add(body.cells[body.vertices[v].cell], body.vertices[v].weights, 1, velocities[v]);
  for (const auto& cell : body.cells)
    for (uint32_t corner = 0; corner < 8; ++corner)
      for (uint32_t axis = 0; axis < 3; ++axis)
        equations.add(std::array{cell[corner], cell[corner ^ 1u << axis]}, std::array{-1.0, 1.0},
                      kFirstDifference);
  const auto neighbours = neighboursOf(body);
  for (uint32_t node = 0; node < body.nodes.size(); ++node)
    for (uint32_t direction = 0; direction < 6; ++direction) {
      const uint32_t next = neighbours[6 * size_t{node} + direction];
      const uint32_t last = next == kNone ? kNone : neighbours[6 * size_t{next} + direction];
      if (last != kNone) equations.add(std::array{node, next, last}, std::array{1.0, -2.0, 1.0}, kSmoothness);
    }
  const Eigen::MatrixXd fitted = equations.solve();
  std::vector<Vec3> result;
  for (Eigen::Index node = 0; node < fitted.rows(); ++node)
    result.push_back({fitted(node, 0), fitted(node, 1), fitted(node, 2)});
  return result;
}

}  // namespace limber
