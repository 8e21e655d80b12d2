#pragma once

#include <array>
#include <vector>

#include "elastic/modes.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// What a shape does, as shares of its kinetic energy over the surface (area as mass).
struct ModeCharacter {
  // By cross-sections across the longest principal axis, each fitted with its own rigid motion:
  double stretch = 0;  // sections move along the axis
  double bend = 0;     // sections move across it or lean
  double twist = 0;    // sections turn about it
  // (sum m u . n)^2 / (sum m  sum m |u|^2): 1 where a closed surface moves evenly outwards; 0 for an open
  // one.
  double breathe = 0;
  // (sum m |u|)^2 / (sum m  sum m |u|^2): the share of the surface that takes part, 1 where all moves
  // alike.
  double participation = 0;
};

// Measures shapes of one body against its principal axes. Built once for a mesh that must outlive it.
class ModeObserver {
 public:
  explicit ModeObserver(const TriangleMesh& mesh);
  ModeCharacter observe(const std::vector<Vec3>& shape) const;

 private:
  const TriangleMesh& mesh_;
  Vec3 axis_;
  std::vector<double> mass_;
  std::vector<Vec3> normal_;  // per vertex, area-weighted, unit; empty for an open surface
  std::vector<std::vector<uint32_t>> sections_;
};

// local: little of the surface takes part (participation below 0.2), and not because a tapered beam moves
// most at its tip (one motion of rigid sections explaining 95 % of the energy); breathe: the closed surface
// moves outwards as a whole; otherwise the largest of stretch, twist and bend. What no motion of rigid
// sections explains (a tube's oval, a plate's ripples) is bending of the wall, so it is a bend.
ModeName nameOf(const ModeCharacter& character);

}  // namespace limber
