#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/topology.h"
#include "simulate/blocks.h"
#include "simulate/particles.h"

namespace limber {

// The corners of four triangles; the idle vertex in empty lanes.
struct VolumeBatch {
  uint32_t corner[3][4];
};

// Keeps what closed components hold: one constraint per component, C = V - V_0, of compliance V_0 / bulk
// modulus, as if the inside were filled with the material (without its resistance to shear). A pass has four
// steps, each to be ended for all groups before the next: `measure` for all blocks, `measure` for all
// borders, `weigh` and `apply` for all blocks.
class VolumeConstraints {
 public:
  // Components with an edge that does not have two triangles, run in opposite directions, are left out.
  VolumeConstraints(const TriangleMesh& mesh, const Topology& topology, const Blocks& blocks,
                    double bulkModulus);

  uint32_t count() const { return static_cast<uint32_t>(bodies_.size()); }
  // Takes over the positions at the start of a step.
  void rebase(const Particles& particles, size_t block);
  // Adds what the group's triangles hold, and to the gradient; a block starts these for its vertices.
  void measure(const Particles& particles, size_t group);
  void weigh(const Particles& particles, size_t block);
  void apply(Particles& particles, size_t block, double substep) const;
  // Joules.
  double energy(const std::vector<Vec3>& positions) const;

 private:
  // What a group has of a body.
  struct Part {
    uint32_t body;
    std::vector<uint32_t> vertices;  // none of a border
    std::vector<VolumeBatch> batches;
    double six = 0;     // times the volume under the triangles, seen from the body's origin
    double weight = 0;  // sum over the vertices of w |gradient|^2
  };
  struct Body {
    std::vector<Triangle> triangles;
    std::vector<uint32_t> vertices;
    double restVolume, compliance;
    std::vector<std::array<uint32_t, 2>> parts;  // group, and number in it; in order
  };
  void addParts(uint32_t body, const Blocks& blocks);
  double lambdaOf(const Body& body, double substep) const;

  std::vector<Body> bodies_;
  std::vector<std::vector<Part>> parts_;  // by group
  // By vertex, and the idle one: from the body's first vertex, at the start of the step and now.
  std::vector<Float4> base_, place_;
  std::vector<Float4> gradient_;  // six times that of the volume
};

}  // namespace limber
