#pragma once

#include <Eigen/Core>
#include <vector>

#include "elastic/modes.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// The kinds of motion in a mode shape, as shares of its kinetic energy over the surface, with area as mass m.
// Each in [0, 1].
struct ModeCharacter {
  // From cross-sections perpendicular to the longest axis (see longestAxis), each fitted with its own rigid
  // motion:
  double stretch = 0;  // sections move along the axis
  double bend = 0;     // sections move across the axis or lean
  double twist = 0;    // sections rotate about the axis
  // (sum m u . n)^2 / (sum m sum m |u|^2): 1 if a closed surface moves outwards uniformly; 0 for an open
  // surface.
  double breathe = 0;
  // (sum m |u|)^2 / (sum m sum m |u|^2): the share of the surface that takes part, 1 if all of it moves
  // equally far.
  double participation = 0;
};

// Measures mode shapes of one body with respect to its longest axis. The mesh must outlive the object.
class ModeObserver {
 public:
  explicit ModeObserver(const TriangleMesh& mesh);
  // `shape`: displacements shape[3 v + c], at any scale.
  ModeCharacter observe(const Eigen::Ref<const Eigen::VectorXd>& shape) const;

 private:
  const TriangleMesh& mesh_;
  Vec3 axis_;
  std::vector<double> mass_;
  std::vector<Vec3> normal_;  // per vertex, area-weighted, unit; empty for an open surface
  std::vector<std::vector<uint32_t>> sections_;
};

// Local: little of the surface takes part (participation below 0.2), unless one motion of rigid sections
// explains 95 % of the energy (a tapered beam moves most at its tip). Breathe: a closed surface moves
// outwards as a whole (breathe above 0.5). Otherwise the largest of stretch, twist and bend. Motion that
// rigid sections do not explain (the ovalling of a tube, the ripples of a plate) is bending of the wall and
// counts as bend.
ModeName nameOf(const ModeCharacter& character);

}  // namespace limber
