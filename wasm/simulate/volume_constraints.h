#pragma once

#include <cstdint>
#include <vector>

#include "mesh/topology.h"
#include "simulate/particles.h"

namespace limber {

// Keeps what closed components hold: one constraint per component, C = V - V_0, of compliance V_0 / bulk
// modulus, as if the inside were filled with the material (without its resistance to shear).
class VolumeConstraints {
 public:
  // Components with an edge that does not have two triangles, run in opposite directions, are left out.
  VolumeConstraints(const TriangleMesh& mesh, const Topology& topology, double bulkModulus, double substep);

  uint32_t count() const { return static_cast<uint32_t>(bodies_.size()); }
  void project(Particles& particles);
  // Joules.
  double energy(const std::vector<Vec3>& positions) const;

 private:
  struct Body {
    std::vector<Triangle> triangles;
    std::vector<uint32_t> vertices;
    double restVolume, compliance;
  };
  std::vector<Body> bodies_;
  std::vector<Vec3> gradient_, place_;  // by vertex; in use during a call
  double substep_;
};

}  // namespace limber
