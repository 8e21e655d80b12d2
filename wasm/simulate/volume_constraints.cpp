#include "simulate/volume_constraints.h"

#include <cmath>

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

double volumeOf(const std::vector<Triangle>& triangles, const std::vector<Vec3>& place) {
  double six = 0;
  for (const Triangle& t : triangles) six += dot(place[t[0]], cross(place[t[1]], place[t[2]]));
  return six / 6;
}

}  // namespace

VolumeConstraints::VolumeConstraints(const TriangleMesh& mesh, const Topology& topology, double bulkModulus,
                                     double substep)
    : gradient_(mesh.vertexCount()), place_(mesh.positions), substep_(substep) {
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
    if (body.compliance > 0) bodies_.push_back(std::move(body));
  }
}

// In double: against the whole volume, what a substep changes is lost in float.
void VolumeConstraints::project(Particles& particles) {
  for (const Body& body : bodies_) {
    for (const uint32_t v : body.vertices) {
      const Float4 moved = particles.motion[v].u + particles.motion[v].q;
      place_[v] = particles.positions[v] + Vec3{double{moved[0]}, double{moved[1]}, double{moved[2]}};
      gradient_[v] = {};
    }
    double six = 0;
    for (const Triangle& t : body.triangles) {
      const Vec3 &a = place_[t[0]], &b = place_[t[1]], &c = place_[t[2]];
      const Vec3 normal = cross(b, c);
      six += dot(a, normal);
      gradient_[t[0]] += normal;
      gradient_[t[1]] += cross(c, a);
      gradient_[t[2]] += cross(a, b);
    }
    double weight = 0;
    for (const uint32_t v : body.vertices)
      weight += particles.inverseMass[v] * squaredLength(gradient_[v]) / 36;
    const double lambda = (body.restVolume - six / 6) / (weight + body.compliance / (substep_ * substep_));
    for (const uint32_t v : body.vertices)
      particles.motion[v].q += toFloat4(gradient_[v] * (lambda * particles.inverseMass[v] / 6));
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
