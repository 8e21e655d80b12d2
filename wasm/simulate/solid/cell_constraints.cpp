#include "simulate/solid/cell_constraints.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>

#include "mesh/eigen_vec3.h"

namespace limber {

namespace {

// The Hessian of mu / 2 |F|^2 is mu on all of F; together with that of det F it is 2 mu on shear at rest.
constexpr double kHessianBound = 2;
// Axes of a cell that is flatter than this along one of them are shorter than 1, which weakens its hourglass
// stiffness instead of dividing by 0.
constexpr float kFlattest = 0.05f;

// The amplitudes of corner vectors, in place.
void toAmplitudes(Vec3x4 (&a)[8]) {
  for (const int bit : {1, 2, 4})
    for (int k = 0; k < 8; ++k) {
      if (k & bit) continue;
      const Vec3x4 low = a[k], high = a[k + bit];
      a[k] = low + high;
      a[k + bit] = high - low;
    }
}

// The corner vectors sum_m s_mk y_m of multipliers of the amplitudes, in place.
void toCorners(Vec3x4 (&y)[8]) {
  for (const int bit : {1, 2, 4})
    for (int k = 0; k < 8; ++k) {
      if (k & bit) continue;
      const Vec3x4 even = y[k], odd = y[k + bit];
      y[k] = even - odd;
      y[k + bit] = even + odd;
    }
}

inline void add(Vec3x4& sum, const Vec3x4& term, Float4 factor) {
  sum = sum + term * factor;
}

struct GradientColumns {
  Vec3x4 x, y, z;
};

inline GradientColumns operator*(const GradientColumns& a, Float4 s) {
  return {a.x * s, a.y * s, a.z * s};
}
inline GradientColumns operator-(const GradientColumns& a, const GradientColumns& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Float4 dot(const GradientColumns& a, const GradientColumns& b) {
  return dot(a.x, b.x) + dot(a.y, b.y) + dot(a.z, b.z);
}
// A times the symmetric matrix xx, yy, zz, yz, zx, xy.
inline GradientColumns operator*(const GradientColumns& a, const Float4 (&m)[6]) {
  return {a.x * m[0] + a.y * m[5] + a.z * m[4], a.x * m[5] + a.y * m[1] + a.z * m[3],
          a.x * m[4] + a.y * m[3] + a.z * m[2]};
}

// The mean deformation gradient from amplitudes.
inline GradientColumns gradientOf(const Vec3x4 (&a)[8], const Float4 (&moments)[6],
                                  const Float4 (&scale)[3]) {
  const auto& [x, y, z, yz, zx, xy] = moments;
  return {(a[1] + a[5] * z + a[3] * y + a[7] * yz) * scale[0],
          (a[2] + a[6] * z + a[3] * x + a[7] * zx) * scale[1],
          (a[4] + a[6] * y + a[5] * x + a[7] * xy) * scale[2]};
}

// Adds the multipliers of amplitudes that correspond to those of the gradient's columns.
inline void addGradientMultipliers(const GradientColumns& multipliers, const Float4 (&moments)[6],
                                   const Float4 (&scale)[3], Vec3x4 (&y)[8]) {
  const auto& [mx, my, mz, myz, mzx, mxy] = moments;
  const Vec3x4 a = multipliers.x * scale[0], b = multipliers.y * scale[1], c = multipliers.z * scale[2];
  y[1] = y[1] + a;
  y[2] = y[2] + b;
  y[4] = y[4] + c;
  y[3] = y[3] + a * my + b * mx;
  y[5] = y[5] + a * mz + c * mx;
  y[6] = y[6] + b * mz + c * my;
  y[7] = y[7] + a * myz + b * mzx + c * mxy;
}

inline GradientColumns cofactors(const GradientColumns& f) {
  return {cross(f.y, f.z), cross(f.z, f.x), cross(f.x, f.y)};
}

// The Gram-Schmidt basis of the columns of F, and the terms of its derivative.
struct Axes {
  Vec3x4 e[3];
  Float4 inverseX, inverseY;  // 1 / |f_x|, 1 / |f_y across e_0|
  Float4 leaning;             // f_y . e_0
};
inline Axes axesOf(const GradientColumns& f) {
  const Float4 one = splat(1), least = splat(kFlattest);
  Axes axes;
  axes.inverseX = one / larger(squareRoot(dot(f.x, f.x)), least);
  axes.e[0] = f.x * axes.inverseX;
  axes.leaning = dot(f.y, axes.e[0]);
  const Vec3x4 across = f.y - axes.e[0] * axes.leaning;
  axes.inverseY = one / larger(squareRoot(dot(across, across)), least);
  axes.e[1] = across * axes.inverseY;
  axes.e[2] = cross(axes.e[0], axes.e[1]);
  return axes;
}

// The multipliers of F's columns that balance a torque on the axes: minus the derivative of the energy whose
// derivative with respect to the rotation of the axes is `torque`.
inline GradientColumns takeUp(const Vec3x4& torque, const Axes& axes) {
  const Float4 t0 = dot(torque, axes.e[0]), t1 = dot(torque, axes.e[1]), t2 = dot(torque, axes.e[2]);
  const Float4 lean = t0 * axes.leaning * axes.inverseX * axes.inverseY;
  return {axes.e[2] * (t1 * axes.inverseX + lean) - axes.e[1] * (t2 * axes.inverseX),
          axes.e[2] * (-t0 * axes.inverseY), Vec3x4{}};
}

// Row i of the packed symmetric matrix times the vector.
inline void multiplySymmetric(const Float4* packed, const Float4 (&v)[12], Float4 (&product)[12]) {
  for (int i = 0; i < 12; ++i) {
    Float4 sum{};
    for (int j = 0; j < i; ++j, ++packed) {
      sum += *packed * v[j];
      product[j] += *packed * v[i];
    }
    product[i] = sum + *packed++ * v[i];
  }
}

using Matrix12 = Eigen::Matrix<double, 12, 12>;

// sum_k w_k grad_k grad_k^T: the change of F for a unit multiplier.
Eigen::Matrix3d meanMobility(const CellRest& rest, const std::array<double, 8>& weights) {
  const auto gradients = meanGradients(rest.size, rest.moments);
  Eigen::Matrix3d mobility = Eigen::Matrix3d::Zero();
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector3d g = eigen(gradients[k]);
    mobility += weights[k] * g * g.transpose();
  }
  return mobility;
}

// (W + H^-1)^-1 for the stiffness H of the hourglass amplitudes times the substep squared and their mobility
// W: the multipliers of one implicit step, per amplitude.
Matrix12 hourglassResponse(const Matrix12& stiffness, const std::array<double, 8>& weights) {
  Matrix12 mobility = Matrix12::Zero();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      double sum = 0;
      for (int k = 0; k < 8; ++k)
        sum += weights[k] * amplitudeSign(kHourglassMasks[i], k) * amplitudeSign(kHourglassMasks[j], k);
      for (int axis = 0; axis < 3; ++axis) mobility(3 * i + axis, 3 * j + axis) = sum;
    }
  const Matrix12 response = (Matrix12::Identity() + stiffness * mobility).partialPivLu().solve(stiffness);
  return 0.5 * (response + response.transpose());
}

Vec3 amplitudeOf(int mask, const std::array<Vec3, 8>& corners) {
  Vec3 sum;
  for (int k = 0; k < 8; ++k) sum += corners[k] * double(amplitudeSign(mask, k));
  return sum;
}

double cellEnergy(const CellRest& rest, const std::array<Vec3, 8>& corners, double mu, double lambda) {
  const auto gradients = meanGradients(rest.size, rest.moments);
  Vec3 f[3];
  for (int k = 0; k < 8; ++k)
    for (int axis = 0; axis < 3; ++axis) f[axis] += corners[k] * gradients[k][axis];
  const double squared = squaredLength(f[0]) + squaredLength(f[1]) + squaredLength(f[2]);
  const double offset = mu / lambda, over = dot(f[0], cross(f[1], f[2])) - 1;
  const double mean = 0.5 * mu * (squared - 3) + 0.5 * lambda * over * (over - 2 * offset);
  Vec3 axes[3];
  axes[0] = f[0] / std::max(length(f[0]), double{kFlattest});
  axes[1] = f[1] - axes[0] * dot(f[1], axes[0]);
  axes[1] = axes[1] / std::max(length(axes[1]), double{kFlattest});
  axes[2] = cross(axes[0], axes[1]);
  Eigen::Matrix<double, 12, 1> local;
  for (int i = 0; i < 4; ++i)
    for (int axis = 0; axis < 3; ++axis)
      local[3 * i + axis] = dot(amplitudeOf(kHourglassMasks[i], corners), axes[axis]);
  return rest.volume * mean + 0.5 * local.dot(rest.hourglass * local);
}

}  // namespace

CellConstraints::CellConstraints(const LatticeBody& body, Particles& particles, const Options& options)
    : cells_(body.cells), rest_(body.rest), substep_(options.substep) {
  const double nu = options.poisson;
  mu_ = options.young / (2 * (1 + nu));
  lambda_ = options.young * nu / ((1 + nu) * (1 - 2 * nu)) + mu_;
  colouring_ = colour({flattened(cells_), 8}, options.blocks, options.order);
  batches_.resize(colouring_.batches.size());
  forEachLane(colouring_, [&](size_t i, const Lane& lane) { setCell(batches_[i], lane, body, particles); });
}

void CellConstraints::setCell(Batch& batch, const Lane& lane, const LatticeBody& body, Particles& particles) {
  const int lanes = lane.lane;
  const bool isEmpty = lane.constraint == kNone;
  for (int k = 0; k < 8; ++k) {
    const uint32_t node = isEmpty ? particles.idle(lane.group) : body.cells[lane.constraint][k];
    batch.corner[k][lanes] = &particles.motion[node];
    batch.weight[k][lanes] = static_cast<float>(particles.inverseMass[node]);
  }
  if (isEmpty) return;
  const CellRest& rest = rest_[lane.constraint];
  const auto& nodes = body.cells[lane.constraint];
  std::array<double, 8> weights;
  for (int k = 0; k < 8; ++k) weights[k] = particles.inverseMass[nodes[k]];
  for (int i = 0; i < 6; ++i) batch.moments[i][lanes] = static_cast<float>(rest.moments[i]);
  for (int axis = 0; axis < 3; ++axis)
    batch.scale[axis][lanes] = static_cast<float>(1 / (4 * rest.size[axis]));

  const Eigen::Matrix3d mobility = meanMobility(rest, weights);
  const double fastest = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(mobility).eigenvalues()[2];
  const double share = 1 / (1 / (mu_ * rest.volume * substep_ * substep_) + kHessianBound * fastest);
  batch.share[lanes] = static_cast<float>(share);
  constexpr int kRow[6] = {0, 1, 2, 1, 2, 0}, kColumn[6] = {0, 1, 2, 2, 0, 1};
  for (int i = 0; i < 6; ++i)
    batch.mobility[i][lanes] = static_cast<float>(share * mobility(kRow[i], kColumn[i]));
  const Matrix12 response = hourglassResponse(rest.hourglass * (substep_ * substep_), weights);
  for (int i = 0, entry = 0; i < 12; ++i)
    for (int j = 0; j <= i; ++j, ++entry) batch.response[entry][lanes] = static_cast<float>(response(i, j));
}

void CellConstraints::rebase(const Particles& particles, size_t begin, size_t end) {
  forEachConstraint(colouring_, begin, end, [&](size_t i, int lane, uint32_t cell) {
    std::array<Vec3, 8> corners;  // relative to the first, because floats far from the origin lose digits
    for (int k = 0; k < 8; ++k)
      corners[k] = particles.positions[cells_[cell][k]] - particles.positions[cells_[cell][0]];
    for (int mask = 1; mask < 8; ++mask) setLane(batches_[i].base[mask], lane, amplitudeOf(mask, corners));
  });
}

void CellConstraints::projectBatch(const Batch& b) const {
  const Float4 offset = splat(static_cast<float>(mu_ / lambda_)), one = splat(1);
  Vec3x4 a[8], moved[8] = {};
  for (int k = 0; k < 8; ++k) a[k] = gatherMotion(b.corner[k]);
  toAmplitudes(a);
  for (int mask = 1; mask < 8; ++mask) a[mask] = a[mask] + b.base[mask];

  // The mean strain: `pressing` is the hydrostatic multiplier over that of the deviatoric constraint.
  const GradientColumns f = gradientOf(a, b.moments, b.scale), g = cofactors(f);
  const Float4 volume = dot(f.x, g.x);
  const GradientColumns mobile = g * b.mobility;
  const Float4 pressing = ((one - volume) + offset + dot(f, mobile)) / (offset + dot(g, mobile));
  addGradientMultipliers((g * pressing - f) * b.share, b.moments, b.scale, moved);
  toCorners(moved);
  Vec3x4 change[8];
  for (int k = 0; k < 8; ++k) change[k] = moved[k] = moved[k] * b.weight[k];
  toAmplitudes(change);

  // The remaining hourglass amplitudes, in the axes of the cell.
  const Axes axes = axesOf(f);
  Vec3x4 amplitude[4], multipliers[8] = {}, torque{};
  Float4 local[12], response[12];
  for (int i = 0; i < 4; ++i) {
    amplitude[i] = a[kHourglassMasks[i]] + change[kHourglassMasks[i]];
    for (int axis = 0; axis < 3; ++axis) local[3 * i + axis] = -dot(amplitude[i], axes.e[axis]);
  }
  multiplySymmetric(b.response, local, response);
  for (int i = 0; i < 4; ++i) {
    Vec3x4& multiplier = multipliers[kHourglassMasks[i]];
    for (int axis = 0; axis < 3; ++axis) add(multiplier, axes.e[axis], response[3 * i + axis]);
    torque = torque + cross(amplitude[i], multiplier);
  }
  addGradientMultipliers(takeUp(torque, axes), b.moments, b.scale, multipliers);
  toCorners(multipliers);
  for (int k = 0; k < 8; ++k) scatterCorrection(b.corner[k], moved[k] + multipliers[k] * b.weight[k]);
}

void CellConstraints::project(size_t begin, size_t end) const {
  for (size_t i = begin; i < end; ++i) projectBatch(batches_[i]);
}

double CellConstraints::energy(const std::vector<Vec3>& positions) const {
  double sum = 0;
  for (size_t cell = 0; cell < cells_.size(); ++cell) {
    std::array<Vec3, 8> corners;
    for (int k = 0; k < 8; ++k) corners[k] = positions[cells_[cell][k]];
    sum += cellEnergy(rest_[cell], corners, mu_, lambda_);
  }
  return sum;
}

}  // namespace limber
