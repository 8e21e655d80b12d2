#pragma once

#include <cstdint>
#include <vector>

#include "mesh/topology.h"
#include "simulate/particles.h"

namespace limber {

// The corners of four triangles; the idle vertex in empty lanes.
struct VolumeBatch {
  uint32_t corner[3][4];
};

// Keeps what closed components hold: one constraint per component, C = V - V_0, of compliance V_0 / bulk
// modulus, as if the inside were filled with the material (without its resistance to shear).
class VolumeConstraints {
 public:
  // Components with an edge that does not have two triangles, run in opposite directions, are left out.
  VolumeConstraints(const TriangleMesh& mesh, const Topology& topology, double bulkModulus, double substep);

  uint32_t count() const { return static_cast<uint32_t>(bodies_.size()); }
  // Takes over the positions at the start of a step.
  void rebase(const Particles& particles);
  void project(Particles& particles);
  // Joules.
  double energy(const std::vector<Vec3>& positions) const;

 private:
  struct Body {
    std::vector<Triangle> triangles;
    std::vector<uint32_t> vertices;
    double restVolume, compliance;
    std::vector<VolumeBatch> batches;
  };
  double measure(const Body& body);

  std::vector<Body> bodies_;
  // By vertex, and the idle one: from the body's first vertex, at the start of the step and now.
  std::vector<Float4> base_, place_;
  std::vector<Float4> gradient_;  // six times that of the volume
  double substep_;
};

}  // namespace limber
