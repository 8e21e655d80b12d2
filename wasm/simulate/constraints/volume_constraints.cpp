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
  for (size_t i = 0; i < 4 * batches.size(); ++i)
    for (int c = 0; c < 3; ++c)
      batches[i / 4].corner[c][i % 4] = i < triangles.size() ? triangles[i][c] : idle;
  return batches;
}

double volumeOf(const std::vector<Triangle>& triangles, const std::vector<Vec3>& place) {
  double six = 0;
  for (const Triangle& t : triangles) six += dot(place[t[0]], cross(place[t[1]], place[t[2]]));
  return six / 6;
}

}  // namespace

VolumeConstraints::VolumeConstraints(const TriangleMesh& mesh, const Topology& topology, const Blocks& blocks,
                                     double bulkModulus)
    : parts_(blocks.groupCount()),
      base_(mesh.positions.size() + 1),
      place_(base_.size()),
      gradient_(base_.size()) {
  const auto closed = closedComponents(mesh, topology);
  const auto component = componentOfTriangle(mesh, topology);
  std::vector<Body> bodies(topology.componentCount);
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    if (closed[component[t]]) bodies[component[t]].triangles.push_back(mesh.triangles[t]);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    bodies[topology.componentOfVertex[v]].vertices.push_back(v);
  for (Body& body : bodies) {
    body.restVolume = volumeOf(body.triangles, mesh.positions);
    body.compliance = std::abs(body.restVolume) / bulkModulus;
    if (!(body.compliance > 0)) continue;
    bodies_.push_back(std::move(body));
    addParts(count() - 1, blocks);
  }
}

void VolumeConstraints::addParts(uint32_t number, const Blocks& blocks) {
  Body& body = bodies_[number];
  std::map<uint32_t, std::vector<Triangle>> triangles;  // by group
  std::map<uint32_t, std::vector<uint32_t>> vertices;   // by block
  for (const Triangle& t : body.triangles) triangles[blocks.groupOf(t)].push_back(t);
  for (const uint32_t v : body.vertices) vertices[blocks.blockOf[v]].push_back(v);
  for (const auto& [block, own] : vertices) triangles[block];
  const auto idle = static_cast<uint32_t>(base_.size() - 1);
  for (const auto& [group, own] : triangles) {
    body.parts.push_back({group, static_cast<uint32_t>(parts_[group].size())});
    parts_[group].push_back({number, std::move(vertices[group]), batchesOf(own, idle)});
  }
}

void VolumeConstraints::rebase(const Particles& particles, size_t block) {
  for (const Part& part : parts_[block])
    for (const uint32_t v : part.vertices)
      base_[v] = toFloat4(particles.positions[v] - particles.positions[bodies_[part.body].vertices.front()]);
}

// The gradient of a closed surface is the sum of the area normals around a vertex.
void VolumeConstraints::measure(const Particles& particles, size_t group) {
  for (Part& part : parts_[group]) {
    for (const uint32_t v : part.vertices) {
      place_[v] = base_[v] + particles.motion[v].u + particles.motion[v].q;
      gradient_[v] = Float4{};
    }
    part.six = 0;
    for (const VolumeBatch& batch : part.batches) {
      const Vec3x4 a = gatherPlaces(place_.data(), batch.corner[0]);
      const Vec3x4 b = gatherPlaces(place_.data(), batch.corner[1]);
      const Vec3x4 c = gatherPlaces(place_.data(), batch.corner[2]);
      const Vec3x4 normal = cross(b - a, c - a);
      const Float4 volume = dot(a, normal);
      // Floats would add up to too little of what changes in a substep.
      part.six += (double{volume[0]} + double{volume[1]}) + (double{volume[2]} + double{volume[3]});
      Float4 normals[4];
      fromLanes(normal, normals);
      for (int k = 0; k < 4; ++k)
        for (int corner = 0; corner < 3; ++corner) gradient_[batch.corner[corner][k]] += normals[k];
    }
  }
}

void VolumeConstraints::weigh(const Particles& particles, size_t block) {
  for (Part& part : parts_[block]) {
    part.weight = 0;
    for (const uint32_t v : part.vertices) {
      const Float4 squared = gradient_[v] * gradient_[v];
      part.weight += particles.inverseMass[v] * double{squared[0] + squared[1] + squared[2]};
    }
  }
}

double VolumeConstraints::lambdaOf(const Body& body, double substep) const {
  double six = 0, weight = 0;
  for (const auto& [group, number] : body.parts) {
    six += parts_[group][number].six;
    weight += parts_[group][number].weight;
  }
  return (body.restVolume - six / 6) / (weight / 36 + body.compliance / (substep * substep));
}

void VolumeConstraints::apply(Particles& particles, size_t block, double substep) const {
  for (const Part& part : parts_[block]) {
    const double lambda = lambdaOf(bodies_[part.body], substep);
    for (const uint32_t v : part.vertices)
      particles.motion[v].q +=
          gradient_[v] * splat(static_cast<float>(lambda * particles.inverseMass[v] / 6));
  }
}

double VolumeConstraints::energy(const std::vector<Vec3>& positions) const {
  double sum = 0;
  for (const Body& body : bodies_) {
    const double change = volumeOf(body.triangles, positions) - body.restVolume;
    sum += 0.5 * change * change / body.compliance;
  }
  return sum;
}

}  // namespace limber
