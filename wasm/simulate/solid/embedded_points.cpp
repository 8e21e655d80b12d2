#include "simulate/solid/embedded_points.h"

#include <algorithm>
#include <map>
#include <utility>

namespace limber {

namespace {

// The weight of the displacement of the heaviest node relative to the gap of a pin: small enough that pins do
// not yield, and large enough that the equations can be solved if a node hardly belongs to any pin.
constexpr double kSoftness = 1e-6;

}  // namespace

Vec3 LatticePoint::position(const Particles& particles) const {
  Vec3 sum;
  for (size_t i = 0; i < nodes.size(); ++i) sum += particles.positions[nodes[i]] * weights[i];
  return sum;
}

Vec3 LatticePoint::motion(const Particles& particles) const {
  Vec3 sum;
  for (size_t i = 0; i < nodes.size(); ++i) sum += toVec3(particles.motion[nodes[i]].q) * weights[i];
  return sum;
}

LatticePoint embeddedVertex(const LatticeBody& body, uint32_t v) {
  const EmbeddedVertex& vertex = body.vertices[v];
  const auto& nodes = body.cells[vertex.cell];
  return {{nodes.begin(), nodes.end()}, {vertex.weights.begin(), vertex.weights.end()}};
}

LatticePoint embeddedPoint(const LatticeBody& body, const Triangle& triangle,
                           const double (&barycentric)[3]) {
  LatticePoint point;
  for (int c = 0; c < 3; ++c) {
    const LatticePoint corner = embeddedVertex(body, triangle[c]);
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

void EmbeddedPins::set(const Particles& particles, std::vector<LatticePoint> points) {
  pins_.clear();
  nodes_.clear();
  std::map<uint32_t, uint32_t> rowOf;
  for (LatticePoint& point : points) {
    Pin pin = {std::move(point), {}, {}, {}};
    for (const uint32_t node : pin.point.nodes) {
      const auto [entry, isNew] = rowOf.try_emplace(node, static_cast<uint32_t>(nodes_.size()));
      if (isNew) nodes_.push_back(node);
      pin.rows.push_back(entry->second);
    }
    pins_.push_back(std::move(pin));
  }
  if (pins_.empty()) return;
  std::vector<Eigen::Triplet<double>> entries;
  for (const Pin& pin : pins_)
    for (size_t i = 0; i < pin.rows.size(); ++i)
      for (size_t j = 0; j < pin.rows.size(); ++j)
        entries.push_back({static_cast<int>(pin.rows[i]), static_cast<int>(pin.rows[j]),
                           pin.point.weights[i] * pin.point.weights[j]});
  double heaviest = 0;
  for (const uint32_t node : nodes_) heaviest = std::max(heaviest, 1 / particles.inverseMass[node]);
  for (size_t i = 0; i < nodes_.size(); ++i)
    entries.push_back({static_cast<int>(i), static_cast<int>(i),
                       kSoftness / (heaviest * particles.inverseMass[nodes_[i]])});
  const auto size = static_cast<Eigen::Index>(nodes_.size());
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  factor_ = std::make_unique<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>>(matrix);
  way_.resize(size, 3);
}

void EmbeddedPins::rebase(size_t i, const Particles& particles, const PointConstraints::Path& path,
                          int substeps) {
  pins_[i].gap = position(i, particles) - path.from;
  pins_[i].targetMove = (path.to - path.from) / substeps;
}

void EmbeddedPins::project(Particles& particles, int substep) {
  if (pins_.empty()) return;
  way_.setZero();
  for (const Pin& pin : pins_) {
    Vec3 gap = pin.gap - pin.targetMove * double(substep + 1);
    for (size_t i = 0; i < pin.rows.size(); ++i) {
      const Motion& motion = particles.motion[pin.point.nodes[i]];
      gap += toVec3(motion.u + motion.q) * pin.point.weights[i];
    }
    for (size_t i = 0; i < pin.rows.size(); ++i)
      for (int c = 0; c < 3; ++c) way_(pin.rows[i], c) -= pin.point.weights[i] * gap[c];
  }
  way_ = factor_->solve(way_).eval();
  for (size_t i = 0; i < nodes_.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    particles.motion[nodes_[i]].q += toFloat4({way_(row, 0), way_(row, 1), way_(row, 2)});
  }
}

}  // namespace limber
