#include "simulate/constraints/membrane_constraints.h"

#include "simulate/constraints/triangle_rest.h"

namespace limber {

MembraneConstraints::MembraneConstraints(const TriangleMesh& mesh, StiffnessFactors factors,
                                         Particles& particles, const ConstraintOptions& options)
    : triangles_(mesh.triangles), sheet_(options.sheet), count_(mesh.triangleCount()) {
  colouring_ = colour({flattened(triangles_), 3}, options.blocks, options.order);
  for (uint32_t t = 0; t < count_; ++t) {
    const TriangleRest rest = triangleRest(mesh, t);
    rest_.push_back(
        {rest.area(), 1 / rest.x1, -rest.x2 / (rest.x1 * rest.y2), 1 / rest.y2, factorOf(factors, t)});
  }
  batches_.resize(colouring_.batches.size());
  forEachLane(colouring_, [&](size_t i, const Lane& lane) {
    setTriangle(batches_[i], lane, particles, options.substep);
  });
}

void MembraneConstraints::setTriangle(Batch& batch, const Lane& lane, Particles& particles, double substep) {
  const int k = lane.lane;
  const uint32_t t = lane.constraint;
  const bool empty = t == kNone;
  const Rest rest = empty ? Rest{1, 1, 0, 1, 1} : rest_[t];
  batch.xx[k] = static_cast<float>(rest.xx);
  batch.xy[k] = static_cast<float>(rest.xy);
  batch.yy[k] = static_cast<float>(rest.yy);
  setLane(batch.base1, k, {1, 0, 0});
  setLane(batch.base2, k, {0, 1, 0});
  const double gradients[3][2] = {{-rest.xx, -rest.xy - rest.yy}, {rest.xx, rest.xy}, {0, rest.yy}};
  double mass[3] = {0, 0, 0};
  for (int c = 0; c < 3; ++c) {
    const uint32_t v = empty ? particles.idle(lane.group) : triangles_[t][c];
    batch.corner[c][k] = &particles.motion[v];
    const double w = particles.inverseMass[v];
    batch.weight[c][k] = static_cast<float>(w);
    mass[0] += w * gradients[c][0] * gradients[c][0];
    mass[1] += w * gradients[c][0] * gradients[c][1];
    mass[2] += w * gradients[c][1] * gradients[c][1];
  }
  batch.mass11[k] = static_cast<float>(mass[0]);
  batch.mass12[k] = static_cast<float>(mass[1]);
  batch.mass22[k] = static_cast<float>(mass[2]);
  const double stiffness = rest.factor * rest.area * sheet_.stretching * substep * substep;
  batch.compliance[k] = empty ? 1 : static_cast<float>(1 / stiffness);
}

void MembraneConstraints::rebase(const Particles& particles, size_t begin, size_t end) {
  forEachConstraint(colouring_, begin, end, [&](size_t i, int k, uint32_t t) {
    const auto at = [&](int c) { return particles.positions[triangles_[t][c]]; };
    setLane(batches_[i].base1, k, at(1) - at(0));
    setLane(batches_[i].base2, k, at(2) - at(0));
  });
}

void MembraneConstraints::project(size_t begin, size_t end) const {
  const Float4 one = splat(1), half = splat(0.5f);
  const Float4 coupling = splat(static_cast<float>(sheet_.poisson));
  const Float4 shearing = splat(static_cast<float>(2 * (1 + sheet_.poisson)));
  for (const Batch *batch = batches_.data() + begin, *last = batches_.data() + end; batch < last; ++batch) {
    const Batch& b = *batch;
    const Vec3x4 origin = gatherMotion(b.corner[0]);
    const Vec3x4 edge1 = b.base1 + (gatherMotion(b.corner[1]) - origin);
    const Vec3x4 edge2 = b.base2 + (gatherMotion(b.corner[2]) - origin);
    // Columns of the deformation gradient F.
    const Vec3x4 f1 = edge1 * b.xx, f2 = edge1 * b.xy + edge2 * b.yy;
    const Float4 f11 = dot(f1, f1), f22 = dot(f2, f2), f12 = dot(f1, f2);
    const Symmetric3x4 system = {
        b.mass11 * f11 + b.compliance,
        b.mass12 * f12 - b.compliance * coupling,
        b.mass11 * f12 + b.mass12 * f11,
        b.mass22 * f22 + b.compliance,
        b.mass12 * f22 + b.mass22 * f12,
        b.mass11 * f22 + splat(2) * b.mass12 * f12 + b.mass22 * f11 + b.compliance * shearing};
    const Vec3x4 lambda = solve(system, {half * (one - f11), half * (one - f22), -f12});
    const Vec3x4 stress1 = f1 * lambda.x + f2 * lambda.z, stress2 = f2 * lambda.y + f1 * lambda.z;
    const Vec3x4 force1 = stress1 * b.xx + stress2 * b.xy, force2 = stress2 * b.yy;
    scatterCorrection(b.corner[1], force1 * b.weight[1]);
    scatterCorrection(b.corner[2], force2 * b.weight[2]);
    scatterCorrection(b.corner[0], (force1 + force2) * -b.weight[0]);
  }
}

double MembraneConstraints::energy(const std::vector<Vec3>& positions) const {
  const double nu = sheet_.poisson, factor = 0.5 * sheet_.stretching / (1 - nu * nu);
  double sum = 0;
  for (uint32_t t = 0; t < count_; ++t) {
    const Vec3& origin = positions[triangles_[t][0]];
    const Vec3 edge1 = positions[triangles_[t][1]] - origin, edge2 = positions[triangles_[t][2]] - origin;
    const Rest& rest = rest_[t];
    const Vec3 f1 = edge1 * rest.xx, f2 = edge1 * rest.xy + edge2 * rest.yy;
    const double xx = 0.5 * (dot(f1, f1) - 1), yy = 0.5 * (dot(f2, f2) - 1), xy = 0.5 * dot(f1, f2);
    sum += rest.factor * factor * rest.area * (xx * xx + yy * yy + 2 * nu * xx * yy + 2 * (1 - nu) * xy * xy);
  }
  return sum;
}

}  // namespace limber
