#include "elastic/mode_character.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "elastic/displacement.h"
#include "mesh/eigen_vec3.h"
#include "mesh/principal_axes.h"
#include "mesh/topology.h"
#include "mesh/vertex_areas.h"

namespace limber {

namespace {

constexpr size_t kSections = 16;           // at most
constexpr size_t kVerticesOfSection = 16;  // on average, at least: small meshes get fewer sections
constexpr double kLocal = 0.2;             // participation below which a mode is local
constexpr double kBreathe = 0.5;           // share of the energy above which a mode breathes
constexpr double kWhole =
    0.95;  // energy share of one rigid motion that identifies a beam, however light its tip
constexpr double kExplained = 0.5;  // energy share below which rigid sections do not explain the motion

bool isClosed(const Topology& topology) {
  return std::all_of(topology.edges.begin(), topology.edges.end(),
                     [](const Topology::Edge& edge) { return edge.useCount == 2; });
}

// The mass of a section and the moments of its motion about its centre.
struct SectionMoments {
  double mass = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero(), velocity = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  Eigen::Vector3d spin = Eigen::Vector3d::Zero();  // sum m r x (u - velocity)
};

// Adds the energy of the best-fitting rigid motion of a section.
void addSection(const SectionMoments& section, const Eigen::Vector3d& axis, ModeCharacter& sums) {
  const double along = section.velocity.dot(axis);
  sums.stretch += section.mass * along * along;
  sums.bend += section.mass * (section.velocity.squaredNorm() - along * along);
  const Eigen::Vector3d rotation = section.inertia.completeOrthogonalDecomposition().solve(section.spin);
  const double all = rotation.dot(section.inertia * rotation);
  const double about = rotation.dot(axis);
  const double twist = std::min(all, about * about * axis.dot(section.inertia * axis));
  sums.twist += twist;
  sums.bend += all - twist;
}

}  // namespace

ModeObserver::ModeObserver(const TriangleMesh& mesh) : mesh_(mesh), mass_(lumpedAreas(mesh)) {
  axis_ = longestAxis(mesh);
  if (isClosed(buildIncidence(mesh))) normal_ = vertexNormals(mesh);
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Vec3& p : mesh.positions) {
    low = std::min(low, dot(p, axis_));
    high = std::max(high, dot(p, axis_));
  }
  const size_t count = std::clamp<size_t>(mesh.positions.size() / kVerticesOfSection, 1, kSections);
  sections_.resize(count);
  const double width = std::max(high - low, 1e-30);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const double position = (dot(mesh.positions[v], axis_) - low) / width * static_cast<double>(count);
    const double last = static_cast<double>(count - 1);
    // NaN if coordinates overflow.
    sections_[position > 0 ? static_cast<size_t>(std::min(position, last)) : 0].push_back(v);
  }
}

ModeCharacter ModeObserver::observe(const Eigen::Ref<const Eigen::VectorXd>& shape) const {
  ModeCharacter sums;
  double mass = 0, energy = 0, amplitude = 0, outward = 0;
  for (size_t v = 0; v < mass_.size(); ++v) {
    const Vec3 displacement = displacementAt(shape, v);
    const double square = squaredLength(displacement);
    mass += mass_[v];
    energy += mass_[v] * square;
    amplitude += mass_[v] * std::sqrt(square);
    if (!normal_.empty()) outward += mass_[v] * dot(displacement, normal_[v]);
  }
  if (!(energy > 0)) return sums;
  for (const auto& vertices : sections_) {
    SectionMoments section;
    for (uint32_t v : vertices) {
      section.mass += mass_[v];
      section.centre += mass_[v] * eigen(mesh_.positions[v]);
      section.velocity += mass_[v] * eigen(displacementAt(shape, v));
    }
    if (!(section.mass > 0)) continue;
    section.centre /= section.mass;
    section.velocity /= section.mass;
    for (uint32_t v : vertices) {
      const Eigen::Vector3d r = eigen(mesh_.positions[v]) - section.centre;
      section.inertia += mass_[v] * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
      section.spin += mass_[v] * r.cross(eigen(displacementAt(shape, v)) - section.velocity);
    }
    addSection(section, eigen(axis_), sums);
  }
  sums.stretch /= energy;
  sums.bend /= energy;
  sums.twist /= energy;
  sums.breathe = outward * outward / (mass * energy);
  sums.participation = amplitude * amplitude / (mass * energy);
  return sums;
}

ModeName nameOf(const ModeCharacter& character) {
  const double most = std::max({character.stretch, character.twist, character.bend});
  if (character.participation < kLocal && most < kWhole) return ModeName::Local;
  if (character.breathe > kBreathe) return ModeName::Breathe;
  if (character.stretch + character.twist + character.bend < kExplained) return ModeName::Bend;
  if (most == character.bend) return ModeName::Bend;
  return most == character.twist ? ModeName::Twist : ModeName::Stretch;
}

}  // namespace limber
