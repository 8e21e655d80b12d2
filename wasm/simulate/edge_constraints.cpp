#include "simulate/edge_constraints.h"

#include <algorithm>

namespace limber {

namespace {

std::vector<uint32_t> edgeVertices(const Topology& topology) {
  std::vector<uint32_t> vertices;
  vertices.reserve(2 * topology.edges.size());
  for (const auto& edge : topology.edges) vertices.insert(vertices.end(), {edge.a, edge.b});
  return vertices;
}

double areaAround(const TriangleMesh& mesh, const Topology& topology, const Topology::Edge& edge) {
  double area = 0;
  for (const uint32_t t : topology.trianglesAt(edge)) area += triangleArea(mesh, t);
  return area;
}

}  // namespace

EdgeConstraints::EdgeConstraints(const TriangleMesh& mesh, const Topology& topology,
                                 const Particles& particles, const ConstraintOptions& options)
    : colouring_(colour(edgeVertices(topology), 2, particles.count(), options.order)),
      count_(static_cast<uint32_t>(topology.edges.size())) {
  batches_.resize(colouring_.batches.size());
  stiffness_.assign(4 * batches_.size(), 0.0);
  rest_.assign(4 * batches_.size(), 1.0);
  const double stretching = options.sheet.stretching(), squaredSubstep = options.substep * options.substep;
  for (size_t i = 0; i < batches_.size(); ++i)
    for (int k = 0; k < 4; ++k) {
      Batch& batch = batches_[i];
      const uint32_t e = colouring_.batches[i][k];
      batch.a[k] = batch.b[k] = particles.idle();
      batch.base[k] = Float4{1, 0, 0, 0};
      batch.rest[k] = 1;
      batch.shareA[k] = batch.shareB[k] = 0;
      if (e == kNone) continue;
      const auto& edge = topology.edges[e];
      const double rest = length(mesh.positions[edge.a] - mesh.positions[edge.b]);
      const double stiffness = rest > 0 ? stretching * areaAround(mesh, topology, edge) / (rest * rest) : 0;
      const double wa = particles.inverseMass[edge.a], wb = particles.inverseMass[edge.b];
      // w / (w_a + w_b + 1 / (stiffness substep^2)), which stays finite where the stiffness is 0.
      const double inert = stiffness * squaredSubstep, divisor = (wa + wb) * inert + 1;
      batch.a[k] = edge.a;
      batch.b[k] = edge.b;
      batch.rest[k] = static_cast<float>(rest);
      batch.shareA[k] = static_cast<float>(wa * inert / divisor);
      batch.shareB[k] = static_cast<float>(wb * inert / divisor);
      stiffness_[4 * i + k] = stiffness;
      rest_[4 * i + k] = rest;
    }
}

void EdgeConstraints::rebase(const Particles& particles, size_t begin, size_t end) {
  for (size_t i = begin; i < end; ++i) {
    Batch& batch = batches_[i];
    for (int k = 0; k < 4; ++k) {
      if (batch.a[k] == particles.idle()) continue;
      batch.base[k] = toFloat4(particles.positions[batch.a[k]] - particles.positions[batch.b[k]]);
    }
  }
}

void EdgeConstraints::project(Particles& particles, size_t begin, size_t end) const {
  Motion* const motion = particles.motion.data();
  const auto lane = [&](const Batch& batch, int k) {
    const Motion &a = motion[batch.a[k]], &b = motion[batch.b[k]];
    return batch.base[k] + ((a.u - b.u) + (a.q - b.q));
  };
  for (const Batch *batch = batches_.data() + begin, *last = batches_.data() + end; batch < last; ++batch) {
    const Float4 d0 = lane(*batch, 0), d1 = lane(*batch, 1), d2 = lane(*batch, 2), d3 = lane(*batch, 3);
    const Float4 squared = laneSums(d0 * d0, d1 * d1, d2 * d2, d3 * d3);
    // Far below any length: it only keeps 0 out of the division.
    const Float4 stretch = batch->rest / squareRoot(squared + splat(1e-30f)) - splat(1);
    const Float4 moveA = stretch * batch->shareA, moveB = stretch * batch->shareB;
    motion[batch->a[0]].q += d0 * splatLane<0>(moveA);
    motion[batch->b[0]].q -= d0 * splatLane<0>(moveB);
    motion[batch->a[1]].q += d1 * splatLane<1>(moveA);
    motion[batch->b[1]].q -= d1 * splatLane<1>(moveB);
    motion[batch->a[2]].q += d2 * splatLane<2>(moveA);
    motion[batch->b[2]].q -= d2 * splatLane<2>(moveB);
    motion[batch->a[3]].q += d3 * splatLane<3>(moveA);
    motion[batch->b[3]].q -= d3 * splatLane<3>(moveB);
  }
}

double EdgeConstraints::energy(const std::vector<Vec3>& positions) const {
  double sum = 0;
  for (size_t i = 0; i < batches_.size(); ++i)
    for (int k = 0; k < 4; ++k) {
      const size_t at = 4 * i + k;
      if (stiffness_[at] == 0) continue;
      const double stretch = length(positions[batches_[i].a[k]] - positions[batches_[i].b[k]]) - rest_[at];
      sum += 0.5 * stiffness_[at] * stretch * stretch;
    }
  return sum;
}

}  // namespace limber
