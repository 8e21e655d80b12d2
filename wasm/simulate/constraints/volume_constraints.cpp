#include "simulate/constraints/volume_constraints.h"

#include <cmath>
#include <map>
#include <utility>

#include "simulate/gather.h"

namespace limber {

namespace {

std::vector<bool> closedComponents(const TriangleMesh& mesh, const Topology& topology) {
  std::vector<bool> closed(topology.componentCount, true);
  const auto runs = [&](uint32_t t, uint32_t from, uint32_t to) {
    for (int c = 0; c < 3; ++c)
      if (mesh.triangles[t][c] == from && mesh.triangles[t][(c + 1) % 3] == to) return true;
    return false;
  };
  for (const auto& edge : topology.edges) {
    const auto users = topology.trianglesAt(edge);
    if (users.size() != 2 || runs(users[0], edge.a, edge.b) == runs(users[1], edge.a, edge.b))
      closed[topology.componentOfVertex[edge.a]] = false;
  }
  return closed;
}

std::vector<VolumeBatch> batchesOf(const std::vector<Triangle>& triangles, uint32_t idle) {
  std::vector<VolumeBatch> batches((triangles.size() + 3) / 4);
  for (size_t i = 0; i < 4 * batches.size(); ++i) {
    for (int c = 0; c < 3; ++c)
      batches[i / 4].corner[c][i % 4] = i < triangles.size() ? triangles[i][c] : idle;
    batches[i / 4].used += i < triangles.size();
  }
  return batches;
}

double volumeOf(const std::vector<Triangle>& triangles, const std::vector<Vec3>& positions) {
  double six = 0;
  for (const Triangle& t : triangles) six += dot(positions[t[0]], cross(positions[t[1]], positions[t[2]]));
  return six / 6;
}

}  // namespace

VolumeConstraints::VolumeConstraints(const TriangleMesh& mesh, const Topology& topology, const Blocks& blocks,
                                     double bulkModulus)
    : portions_(blocks.groupCount()),
      base_(mesh.positions.size() + 1),
      current_(base_.size()),
      gradient_(base_.size()) {
  const auto closed = closedComponents(mesh, topology);
  const auto componentOf = componentOfTriangle(mesh, topology);
  std::vector<Component> components(topology.componentCount);
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    if (closed[componentOf[t]]) components[componentOf[t]].triangles.push_back(mesh.triangles[t]);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    components[topology.componentOfVertex[v]].vertices.push_back(v);
  for (Component& component : components) {
    component.restVolume = volumeOf(component.triangles, mesh.positions);
    component.compliance = std::abs(component.restVolume) / bulkModulus;
    if (!(component.compliance > 0)) continue;
    components_.push_back(std::move(component));
    addPortions(count() - 1, blocks);
  }
}

void VolumeConstraints::addPortions(uint32_t number, const Blocks& blocks) {
  Component& component = components_[number];
  std::map<uint32_t, std::vector<Triangle>> triangles;  // by group
  std::map<uint32_t, std::vector<uint32_t>> vertices;   // by block
  for (const Triangle& t : component.triangles) triangles[blocks.groupOf(t)].push_back(t);
  for (const uint32_t v : component.vertices) vertices[blocks.blockOf[v]].push_back(v);
  for (const auto& [block, own] : vertices) triangles[block];
  const auto idle = static_cast<uint32_t>(base_.size() - 1);
  for (const auto& [group, own] : triangles) {
    component.portions.push_back({group, static_cast<uint32_t>(portions_[group].size())});
    portions_[group].push_back({number, std::move(vertices[group]), batchesOf(own, idle)});
  }
}

void VolumeConstraints::rebase(const Particles& particles, size_t block) {
  for (const Portion& portion : portions_[block])
    for (const uint32_t v : portion.vertices)
      base_[v] = toFloat4(particles.positions[v] -
                          particles.positions[components_[portion.component].vertices.front()]);
}

// The gradient of the volume at a vertex is a sixth of the sum of the doubled area normals around it.
void VolumeConstraints::measure(const Particles& particles, size_t group) {
  for (Portion& portion : portions_[group]) {
    for (const uint32_t v : portion.vertices) {
      current_[v] = base_[v] + particles.motion[v].u + particles.motion[v].q;
      gradient_[v] = Float4{};
    }
    portion.sixfoldVolume = 0;
    for (const VolumeBatch& batch : portion.batches) {
      const Vec3x4 a = gatherLanes(current_.data(), batch.corner[0]);
      const Vec3x4 b = gatherLanes(current_.data(), batch.corner[1]);
      const Vec3x4 c = gatherLanes(current_.data(), batch.corner[2]);
      const Vec3x4 normal = cross(b - a, c - a);
      const Float4 volume = dot(a, normal);
      // A sum of floats would lose the small changes of a substep.
      portion.sixfoldVolume +=
          (double{volume[0]} + double{volume[1]}) + (double{volume[2]} + double{volume[3]});
      Float4 normals[4];
      fromLanes(normal, normals);
      for (int k = 0; k < batch.used; ++k)
        for (int corner = 0; corner < 3; ++corner) gradient_[batch.corner[corner][k]] += normals[k];
    }
  }
}

void VolumeConstraints::weigh(const Particles& particles, size_t block) {
  for (Portion& portion : portions_[block]) {
    portion.weight = 0;
    for (const uint32_t v : portion.vertices) {
      const Float4 squared = gradient_[v] * gradient_[v];
      portion.weight += particles.inverseMass[v] * double{squared[0] + squared[1] + squared[2]};
    }
  }
}

double VolumeConstraints::lambdaOf(const Component& component, double substep) const {
  double six = 0, weight = 0;
  for (const auto& [group, number] : component.portions) {
    six += portions_[group][number].sixfoldVolume;
    weight += portions_[group][number].weight;
  }
  return (component.restVolume - six / 6) / (weight / 36 + component.compliance / (substep * substep));
}

void VolumeConstraints::apply(Particles& particles, size_t block, double substep) const {
  for (const Portion& portion : portions_[block]) {
    const double lambda = lambdaOf(components_[portion.component], substep);
    for (const uint32_t v : portion.vertices)
      particles.motion[v].q +=
          gradient_[v] * splat(static_cast<float>(lambda * particles.inverseMass[v] / 6));
  }
}

double VolumeConstraints::energy(const std::vector<Vec3>& positions) const {
  double sum = 0;
  for (const Component& component : components_) {
    const double change = volumeOf(component.triangles, positions) - component.restVolume;
    sum += 0.5 * change * change / component.compliance;
  }
  return sum;
}

}  // namespace limber
