#pragma once

#include "simulate/float4.h"

namespace limber {

// Tan(half the fold from rest), and its gradient over the four vertices of a hinge, which lies along the
// normals of its two triangles: over the flap it is `flap` times flapNormal, over the start of the edge
// flapStart times flapNormal plus start times the triangle's own normal, and so on.
struct Hinge {
  Vec3x4 flapNormal;
  Float4 turn, cosine;
  Float4 flap, flapStart, flapEnd;
  Float4 apex, start, end;
};

// As seen from the apex.
struct HingeVertices {
  Vec3x4 toStart, toEnd, toFlap;
};
struct RestFold {
  Float4 cosine, sine, share;
};

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
  // How far it is from rest, delta. Up to 90 degrees tan(delta / 2) = sin / (1 + cos); from there on 2 -
  // tan((180 - delta) / 2), as smooth, and without a pole. Both grow by 1 / (1 + |cos|).
  const Float4 sineFromRest = sine * rest.cosine - hinge.cosine * rest.sine;
  const Float4 cosineFromRest = hinge.cosine * rest.cosine + sine * rest.sine;
  const Float4 growth = rest.share / (one + larger(cosineFromRest, -cosineFromRest));
  const Float4 tangent = sineFromRest * growth, zero{};
  const Float4 twice = sineFromRest < zero ? -splat(2) * rest.share : splat(2) * rest.share;
  hinge.turn = cosineFromRest < zero ? twice - tangent : tangent;
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
