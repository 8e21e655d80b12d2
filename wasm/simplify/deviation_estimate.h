#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "simplify/collapse_mesh.h"

namespace limber {

// Estimates how far each collapse moves the surface from the input, in time that does not depend on the
// number of previous collapses. For exact distances see DeviationLimit and measureSurfaceDistance.
//
// Each vertex keeps up to kWitnesses vertices of the input that have become part of it, those with the
// largest bounds on their distance from the surface. A collapse moves the surface around its ends by at most
// m, the distance of the end from the triangles that replace those around it. So a witness with bound b has
// the bound min(b + m, its distance from these triangles) afterwards: sliding over a flat side adds nothing,
// and many small steps along a thin part add up. The estimate of a collapse is the largest of these bounds
// and of the distance of the target from the triangles before.
class DeviationEstimate {
 public:
  // Keeps a reference to the mesh.
  explicit DeviationEstimate(const CollapseMesh& mesh);

  // The estimate for a collapse of the current mesh; a length in units of the mesh, >= 0. O(triangles around
  // its ends).
  double of(const Collapse& step);
  // Must be called before the mesh carries out a collapse. Returns its estimate.
  double collapse(const Collapse& step);

 private:
  static constexpr size_t kWitnesses = 3;

  struct Witness {
    std::array<float, 3> position;
    float bound;  // negative: no witness
  };
  using Witnesses = std::array<Witness, kWitnesses>;

  void gather(uint32_t end);
  void take(const Witness& witness);
  double distanceFromChanged(const Vec3& p, double enough) const;
  double distanceFromStars(const Collapse& step, double enough) const;

  const CollapseMesh& mesh_;
  std::vector<Witnesses> witnesses_;  // per vertex
  std::vector<uint8_t> isMoved_;      // per vertex: whether it has left its position in the input
  // Of the last collapse that was estimated.
  Collapse last_{kNone, kNone, kNone, {}};
  double estimate_ = 0;
  Witnesses kept_{};
  std::vector<std::array<Vec3, 2>> changed_;  // the unmoved corners of every remaining triangle
};

}  // namespace limber
