#pragma once

#include "simulate/float4.h"

namespace limber {

// The bend of a hinge, tan(half the fold from rest) times the share of the fold, and its gradient, which lies
// along the normals of the two triangles. By the position of the flap it is `flap` flapNormal, of the apex
// `apex` normal, of the start of the edge flapStart flapNormal + start normal, and of its end flapEnd
// flapNormal + end normal.
struct Hinge {
  Vec3x4 flapNormal;
  Float4 bend, cosine;
  Float4 flap, flapStart, flapEnd;
  Float4 apex, start, end;
};

// Relative to the apex.
struct HingeVertices {
  Vec3x4 toStart, toEnd, toFlap;
};
// The fold at rest, and the share of the fold that counts (see BendingConstraints::Batch).
struct RestFold {
  Float4 cosine, sine, share;
};

// `normal` is the unit normal of the triangle. Divisions are kept finite for triangles without area.
inline Hinge hingeOf(const HingeVertices& at, const Vec3x4& normal, Float4 inverseDoubleArea,
                     const RestFold& rest) {
  const Float4 one = splat(1), tiny = splat(1e-30f);
  const Vec3x4 edge = at.toEnd - at.toStart, across = at.toFlap - at.toStart;
  const Vec3x4 flapNormal = cross(at.toFlap - at.toEnd, edge);
  const Float4 squaredEdge = dot(edge, edge), edgeLength = squareRoot(squaredEdge);
  const Float4 inverseFlapArea = one / squareRoot(dot(flapNormal, flapNormal) + tiny);
  Hinge hinge;
  hinge.flapNormal = flapNormal * inverseFlapArea;
  hinge.cosine = dot(normal, hinge.flapNormal);
  const Float4 sine = dot(across, normal) * edgeLength * inverseFlapArea;
  // delta is the fold from rest. Up to 90 degrees the bend is tan(delta / 2) = sin / (1 + cos); beyond that
  // it is 2 - tan((180 - delta) / 2), which continues it smoothly without the pole at 180 degrees. The
  // derivative of both by delta is 1 / (1 + |cos|).
  const Float4 sineFromRest = sine * rest.cosine - hinge.cosine * rest.sine;
  const Float4 cosineFromRest = hinge.cosine * rest.cosine + sine * rest.sine;
  const Float4 growth = rest.share / (one + larger(cosineFromRest, -cosineFromRest));
  const Float4 tangent = sineFromRest * growth, zero{};
  const Float4 twice = sineFromRest < zero ? -splat(2) * rest.share : splat(2) * rest.share;
  hinge.bend = cosineFromRest < zero ? twice - tangent : tangent;
  const Float4 scale = growth * edgeLength;
  const Float4 inverseSquare = one / (squaredEdge + tiny);
  const Float4 flapFoot = dot(across, edge) * inverseSquare,
               apexFoot = -dot(at.toStart, edge) * inverseSquare;
  hinge.flap = scale * inverseFlapArea;
  hinge.flapEnd = -flapFoot * hinge.flap;
  hinge.flapStart = -hinge.flap - hinge.flapEnd;
  hinge.apex = scale * inverseDoubleArea;
  hinge.end = -apexFoot * hinge.apex;
  hinge.start = -hinge.apex - hinge.end;
  return hinge;
}

}  // namespace limber
