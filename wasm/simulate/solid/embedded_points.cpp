#include "simulate/solid/embedded_points.h"

#include <algorithm>

namespace limber {

Vec3 EmbeddedPoint::position(const Particles& particles) const {
  Vec3 sum;
  for (size_t i = 0; i < nodes.size(); ++i) sum += particles.positions[nodes[i]] * weights[i];
  return sum;
}

Vec3 EmbeddedPoint::motion(const Particles& particles) const {
  Vec3 sum;
  for (size_t i = 0; i < nodes.size(); ++i) {
    const Float4 q = particles.motion[nodes[i]].q;
    sum += Vec3{double{q[0]}, double{q[1]}, double{q[2]}} * weights[i];
  }
  return sum;
}

EmbeddedPoint embeddedVertex(const LatticeBody& body, uint32_t v) {
  const EmbeddedVertex& vertex = body.vertices[v];
  const auto& nodes = body.cells[vertex.cell];
  return {{nodes.begin(), nodes.end()}, {vertex.weights.begin(), vertex.weights.end()}};
}

EmbeddedPoint embeddedPoint(const LatticeBody& body, const Triangle& triangle,
                            const double (&barycentric)[3]) {
  EmbeddedPoint point;
  for (int c = 0; c < 3; ++c) {
    const EmbeddedPoint corner = embeddedVertex(body, triangle[c]);
    for (size_t i = 0; i < corner.nodes.size(); ++i) {
      const auto known = std::ranges::find(point.nodes, corner.nodes[i]);
      const auto at = static_cast<size_t>(known - point.nodes.begin());
      if (known == point.nodes.end()) {
        point.nodes.push_back(corner.nodes[i]);
        point.weights.push_back(0);
      }
      point.weights[at] += corner.weights[i] * barycentric[c];
    }
  }
  return point;
}

void EmbeddedPins::add(const Particles& particles, EmbeddedPoint point) {
  Pin pin = {std::move(point), {}};
  double sum = 0;
  for (size_t i = 0; i < pin.point.nodes.size(); ++i)
    sum += particles.inverseMass[pin.point.nodes[i]] * pin.point.weights[i] * pin.point.weights[i];
  for (size_t i = 0; i < pin.point.nodes.size(); ++i) {
    const double weight = pin.point.weights[i];
    pin.shares.push_back({static_cast<float>(weight),
                          static_cast<float>(particles.inverseMass[pin.point.nodes[i]] * weight / sum)});
  }
  pins_.push_back(std::move(pin));
}

void EmbeddedPins::rebase(size_t i, const Particles& particles, const PointConstraints::Path& path,
                          int substeps) {
  pins_[i].gap = toFloat4(position(i, particles) - path.from);
  pins_[i].targetMove = toFloat4((path.to - path.from) / substeps);
}

void EmbeddedPins::projectPin(const Pin& pin, Particles& particles, Float4 done) {
  Float4 gap = pin.gap - done * pin.targetMove;
  for (size_t i = 0; i < pin.shares.size(); ++i) {
    const Motion& motion = particles.motion[pin.point.nodes[i]];
    gap += splat(pin.shares[i].first) * (motion.u + motion.q);
  }
  for (size_t i = 0; i < pin.shares.size(); ++i)
    particles.motion[pin.point.nodes[i]].q -= splat(pin.shares[i].second) * gap;
}

void EmbeddedPins::project(Particles& particles, int substep) const {
  const Float4 done = splat(static_cast<float>(substep + 1));
  for (size_t i = 0; i < pins_.size(); ++i)
    projectPin(pins_[substep % 2 ? pins_.size() - 1 - i : i], particles, done);
}

}  // namespace limber
