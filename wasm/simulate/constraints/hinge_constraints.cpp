#include "simulate/constraints/hinge_constraints.h"

#include <cmath>
#include <utility>

#include "simulate/constraints/bending_rest.h"
#include "simulate/constraints/hinge.h"

namespace limber {

namespace {

std::vector<uint32_t> stencilsOf(const std::vector<RestHinge>& hinges) {
  std::vector<uint32_t> vertices;
  vertices.reserve(4 * hinges.size());
  for (const RestHinge& h : hinges) vertices.insert(vertices.end(), {h.apex, h.start, h.end, h.flap});
  return vertices;
}

Fold foldAt(const RestHinge& hinge, const std::vector<Vec3>& positions) {
  return foldOf(positions[hinge.apex], positions[hinge.start], positions[hinge.end], positions[hinge.flap]);
}

}  // namespace

HingeConstraints::HingeConstraints(std::vector<RestHinge> hinges, const TriangleMesh& mesh,
                                   Particles& particles, const ConstraintOptions& options)
    : hinges_(std::move(hinges)),
      rest_(hinges_.size()),
      colouring_(colour({stencilsOf(hinges_), 4}, options.blocks, options.order)) {
  for (size_t i = 0; i < hinges_.size(); ++i) {
    const Fold fold = foldAt(hinges_[i], mesh.positions);
    const double size = std::hypot(fold.cosine, fold.sine);
    if (size > 0) rest_[i] = {fold.cosine / size, fold.sine / size};
  }
  batches_.resize(colouring_.batches.size());
  forEachLane(colouring_,
              [&](size_t i, const Lane& lane) { setHinge(batches_[i], lane, particles, options.substep); });
}

void HingeConstraints::setHinge(Batch& batch, const Lane& lane, Particles& particles, double substep) {
  const int k = lane.lane;
  const uint32_t idle = particles.idle(lane.group);
  const bool isEmpty = lane.constraint == kNone;
  const RestHinge hinge = isEmpty ? RestHinge{idle, idle, idle, idle, 0} : hinges_[lane.constraint];
  const RestAngle rest = isEmpty ? RestAngle{} : rest_[lane.constraint];
  // Any two triangles with area can be used for an empty lane.
  setLane(batch.baseStart, k, {1, 0, 0});
  setLane(batch.baseEnd, k, {0, 1, 0});
  setLane(batch.baseFlap, k, {1, 1, 0});
  batch.restCosine[k] = static_cast<float>(rest.cosine);
  batch.restSine[k] = static_cast<float>(rest.sine);
  batch.inert[k] = static_cast<float>(hinge.stiffness * substep * substep);
  const auto set = [&](MotionLanes& vertices, Float4& weight, uint32_t v) {
    vertices[k] = &particles.motion[v];
    weight[k] = static_cast<float>(particles.inverseMass[v]);
  };
  set(batch.apex, batch.apexWeight, hinge.apex);
  set(batch.start, batch.startWeight, hinge.start);
  set(batch.end, batch.endWeight, hinge.end);
  set(batch.flap, batch.flapWeight, hinge.flap);
}

void HingeConstraints::rebase(const Particles& particles, size_t begin, size_t end) {
  forEachConstraint(colouring_, begin, end, [&](size_t i, int k, uint32_t index) {
    const RestHinge& hinge = hinges_[index];
    const Vec3 apex = particles.positions[hinge.apex];
    setLane(batches_[i].baseStart, k, particles.positions[hinge.start] - apex);
    setLane(batches_[i].baseEnd, k, particles.positions[hinge.end] - apex);
    setLane(batches_[i].baseFlap, k, particles.positions[hinge.flap] - apex);
  });
}

void HingeConstraints::project(size_t begin, size_t end) const {
  const Float4 one = splat(1);
  for (const Batch *batch = batches_.data() + begin, *last = batches_.data() + end; batch < last; ++batch) {
    const Batch& b = *batch;
    const Vec3x4 origin = gatherMotion(b.apex);
    const HingeVertices at = {b.baseStart + (gatherMotion(b.start) - origin),
                              b.baseEnd + (gatherMotion(b.end) - origin),
                              b.baseFlap + (gatherMotion(b.flap) - origin)};
    const Vec3x4 doubleArea = cross(at.toStart, at.toEnd);
    const Float4 inverse = one / squareRoot(dot(doubleArea, doubleArea) + splat(1e-30f));
    const Vec3x4 normal = doubleArea * inverse;
    const Hinge hinge = hingeOf<foldAngle>(at, normal, inverse, {b.restCosine, b.restSine, one});
    const Float4 weight = b.apexWeight * hinge.apex * hinge.apex + b.startWeight * squaredAtStart(hinge) +
                          b.endWeight * squaredAtEnd(hinge) + b.flapWeight * hinge.flap * hinge.flap;
    // -C / (weight + 1 / inert), in a form that stays finite for a stiffness of 0.
    const Float4 lambda = -hinge.bend * b.inert / (weight * b.inert + one);
    const Float4 atStart = lambda * b.startWeight, atEnd = lambda * b.endWeight;
    scatterCorrection(b.apex, normal * (lambda * b.apexWeight * hinge.apex));
    scatterCorrection(b.start,
                      normal * (atStart * hinge.start) + hinge.flapNormal * (atStart * hinge.flapStart));
    scatterCorrection(b.end, normal * (atEnd * hinge.end) + hinge.flapNormal * (atEnd * hinge.flapEnd));
    scatterCorrection(b.flap, hinge.flapNormal * (lambda * b.flapWeight * hinge.flap));
  }
}

double HingeConstraints::energy(const std::vector<Vec3>& positions) const {
  double sum = 0;
  for (size_t i = 0; i < hinges_.size(); ++i) {
    const Fold fold = foldAt(hinges_[i], positions);
    const RestAngle& rest = rest_[i];
    const double angle = std::atan2(fold.sine * rest.cosine - fold.cosine * rest.sine,
                                    fold.cosine * rest.cosine + fold.sine * rest.sine);
    sum += 0.5 * hinges_[i].stiffness * angle * angle;
  }
  return sum;
}

}  // namespace limber
