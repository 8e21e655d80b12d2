#include "simulate/constraints/edge_constraints.h"

#include <algorithm>
#include <utility>

namespace limber {

namespace {

std::vector<uint32_t> endsOf(const std::vector<Spring>& springs) {
  std::vector<uint32_t> vertices;
  vertices.reserve(2 * springs.size());
  for (const Spring& spring : springs) vertices.insert(vertices.end(), {spring.a, spring.b});
  return vertices;
}

double areaAround(const TriangleMesh& mesh, const Topology& topology, const Topology::Edge& edge) {
  double area = 0;
  for (const uint32_t t : topology.trianglesAt(edge)) area += triangleArea(mesh, t);
  return area;
}

}  // namespace

std::vector<Spring> paperSprings(const TriangleMesh& mesh, const Topology& topology, const Sheet& sheet) {
  std::vector<Spring> springs;
  for (const auto& edge : topology.edges) {
    const double rest = length(mesh.positions[edge.a] - mesh.positions[edge.b]);
    const double stiffness = sheet.stretching * areaAround(mesh, topology, edge) / (rest * rest);
    springs.push_back({edge.a, edge.b, rest, rest > 0 ? stiffness : 0});
  }
  return springs;
}

EdgeConstraints::EdgeConstraints(std::vector<Spring> springs, Particles& particles,
                                 const ConstraintOptions& options)
    : springs_(std::move(springs)), colouring_(colour({endsOf(springs_), 2}, options.blocks, options.order)) {
  // The heavier end comes second, so that the ratio of the weights is at most 1.
  for (Spring& spring : springs_)
    if (particles.inverseMass[spring.a] < particles.inverseMass[spring.b]) std::swap(spring.a, spring.b);
  batches_.resize(colouring_.batches.size());
  forEachLane(colouring_,
              [&](size_t i, const Lane& lane) { setSpring(batches_[i], lane, particles, options.substep); });
}

void EdgeConstraints::setSpring(Batch& batch, const Lane& lane, Particles& particles, double substep) {
  const int k = lane.lane;
  const uint32_t idle = particles.idle(lane.group);
  const Spring spring = lane.constraint == kNone ? Spring{idle, idle, 1, 0} : springs_[lane.constraint];
  const double wa = particles.inverseMass[spring.a], wb = particles.inverseMass[spring.b];
  // share = w_a / (w_a + w_b + 1 / (stiffness substep^2)), in a form that stays finite for a stiffness of 0.
  const double inert = spring.stiffness * substep * substep;
  batch.a[k] = &particles.motion[spring.a];
  batch.b[k] = &particles.motion[spring.b];
  batch.base[k] = Float4{1, 0, 0, 0};
  const double share = wa * inert / ((wa + wb) * inert + 1);
  batch.share[k] = static_cast<float>(share);
  batch.restShare[k] = static_cast<float>(spring.rest * share);
  batch.ratio[k] = wa > 0 ? static_cast<float>(wb / wa) : 0;
}

void EdgeConstraints::rebase(const Particles& particles, size_t begin, size_t end) {
  forEachConstraint(colouring_, begin, end, [&](size_t i, int k, uint32_t e) {
    const Spring& spring = springs_[e];
    batches_[i].base[k] = toFloat4(particles.positions[spring.a] - particles.positions[spring.b]);
  });
}

void EdgeConstraints::project(size_t begin, size_t end) const {
  for (const Batch *batch = batches_.data() + begin, *last = batches_.data() + end; batch < last; ++batch) {
    Motion *const a0 = batch->a[0], *const a1 = batch->a[1], *const a2 = batch->a[2], *const a3 = batch->a[3];
    Motion *const b0 = batch->b[0], *const b1 = batch->b[1], *const b2 = batch->b[2], *const b3 = batch->b[3];
    const Float4 d0 = batch->base[0] + ((a0->u - b0->u) + (a0->q - b0->q));
    const Float4 d1 = batch->base[1] + ((a1->u - b1->u) + (a1->q - b1->q));
    const Float4 d2 = batch->base[2] + ((a2->u - b2->u) + (a2->q - b2->q));
    const Float4 d3 = batch->base[3] + ((a3->u - b3->u) + (a3->q - b3->q));
    const Float4 squared = laneSums(d0 * d0, d1 * d1, d2 * d2, d3 * d3);
    // 1e-30 is far below the square of any length: it only prevents a division by 0.
    const Float4 moveA = batch->restShare / squareRoot(squared + splat(1e-30f)) - batch->share;
    const Float4 m0 = d0 * splatLane<0>(moveA), m1 = d1 * splatLane<1>(moveA);
    const Float4 m2 = d2 * splatLane<2>(moveA), m3 = d3 * splatLane<3>(moveA);
    a0->q += m0;
    b0->q -= m0 * splatLane<0>(batch->ratio);
    a1->q += m1;
    b1->q -= m1 * splatLane<1>(batch->ratio);
    a2->q += m2;
    b2->q -= m2 * splatLane<2>(batch->ratio);
    a3->q += m3;
    b3->q -= m3 * splatLane<3>(batch->ratio);
  }
}

double EdgeConstraints::energy(const std::vector<Vec3>& positions) const {
  double sum = 0;
  for (const Spring& spring : springs_) {
    const double stretch = length(positions[spring.a] - positions[spring.b]) - spring.rest;
    sum += 0.5 * spring.stiffness * stretch * stretch;
  }
  return sum;
}

}  // namespace limber
