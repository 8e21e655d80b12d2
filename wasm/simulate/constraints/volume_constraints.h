#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/topology.h"
#include "simulate/blocks.h"
#include "simulate/particles.h"

namespace limber {

// The corners of four triangles; the idle vertex in empty lanes, which are the last ones. All threads share
// that vertex: it may be read, but not written.
struct VolumeBatch {
  uint32_t corner[3][4];
  int used = 0;  // lanes with a triangle
};

// Keeps the volume of closed components: one constraint per component, C = V - V_0, of compliance V_0 / bulk
// modulus, as if the inside were filled with the material (without its resistance to shear). A pass has four
// phases, each of which must have ended for all groups before the next begins: `measure` for all blocks,
// `measure` for all borders, `weigh` for all blocks, and `apply` for all blocks.
class VolumeConstraints {
 public:
  // Leaves out components that have an edge without exactly two triangles of opposite directions.
  VolumeConstraints(const TriangleMesh& mesh, const Topology& topology, const Blocks& blocks,
                    double bulkModulus);

  uint32_t count() const { return static_cast<uint32_t>(components_.size()); }
  // Copies the positions at the start of a step.
  void rebase(const Particles& particles, size_t block);
  // Sums the volume under the triangles of a group and adds to the gradients of their vertices; a block first
  // sets those of its own vertices to 0.
  void measure(const Particles& particles, size_t group);
  // Sums w |gradient|^2 over the vertices of a block.
  void weigh(const Particles& particles, size_t block);
  // Moves the vertices of a block along the gradient.
  void apply(Particles& particles, size_t block, double substep) const;
  // Joules.
  double energy(const std::vector<Vec3>& positions) const;

 private:
  // The part of a component in a group.
  struct Portion {
    uint32_t component;
    std::vector<uint32_t> vertices;  // empty for a border
    std::vector<VolumeBatch> batches;
    double sixfoldVolume = 0;  // 6 V between the triangles and the first vertex of the component
    double weight = 0;         // sum over the vertices of w |gradient|^2
  };
  struct Component {
    std::vector<Triangle> triangles;
    std::vector<uint32_t> vertices;
    double restVolume, compliance;
    std::vector<std::array<uint32_t, 2>> portions;  // group and index in portions_[group]; ascending
  };
  void addPortions(uint32_t component, const Blocks& blocks);
  double lambdaOf(const Component& component, double substep) const;

  std::vector<Component> components_;
  std::vector<std::vector<Portion>> portions_;  // by group
  // Per vertex, and for the idle one: relative to the first vertex of the component, at the start of the step
  // and now.
  std::vector<Float4> base_, current_;
  std::vector<Float4> gradient_;  // six times the gradient of the volume
};

}  // namespace limber
