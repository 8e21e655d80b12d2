#pragma once

#include "simulate/float4.h"

namespace limber {

// The bend of a hinge (a measure of its fold relative to rest, times the share of the fold) and its gradient,
// which lies along the normals of the two triangles. The gradient with respect to the flap is `flap`
// flapNormal, to the apex `apex` normal, to the start of the edge flapStart flapNormal + start normal, and to
// its end flapEnd flapNormal + end normal.
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

// A measure of a fold delta, and its derivative with respect to delta.
struct FoldMeasure {
  Float4 value, growth;
};

// tan(delta / 2) = sin / (1 + cos) up to 90 degrees; beyond that 2 - tan((180 - delta) / 2), which continues
// it smoothly without the pole at 180 degrees. The derivative of both is 1 / (1 + |cos|).
inline FoldMeasure foldTangent(Float4 sine, Float4 cosine) {
  const Float4 growth = splat(1) / (splat(1) + larger(cosine, -cosine));
  const Float4 tangent = sine * growth, zero{};
  const Float4 twice = sine < zero ? splat(-2) : splat(2);
  return {cosine < zero ? twice - tangent : tangent, growth};
}

// delta itself, in (-pi, pi), from t = tan of a quarter of it or of its supplement, which is at most 0.42:
// the series of the arc tangent to t^13, within 4e-7 of delta.
inline FoldMeasure foldAngle(Float4 sine, Float4 cosine) {
  const Float4 one = splat(1), zero{};
  const Float4 half = sine / (one + larger(cosine, -cosine));
  const Float4 t = half / (one + squareRoot(one + half * half)), square = t * t;
  Float4 series = splat(1.0f / 13);
  for (const float denominator : {11.0f, 9.0f, 7.0f, 5.0f, 3.0f, 1.0f})
    series = splat(1 / denominator) - square * series;
  const Float4 acute = splat(4) * t * series, straight = splat(3.14159265f);
  return {cosine < zero ? (sine < zero ? -straight : straight) - acute : acute, one};
}

// `normal` is the unit normal of the triangle. Divisions are kept finite for triangles without area.
template <FoldMeasure (*measure)(Float4 sine, Float4 cosine)>
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
  const Float4 sineFromRest = sine * rest.cosine - hinge.cosine * rest.sine;
  const Float4 cosineFromRest = hinge.cosine * rest.cosine + sine * rest.sine;
  const FoldMeasure fold = measure(sineFromRest, cosineFromRest);
  hinge.bend = fold.value * rest.share;
  const Float4 scale = fold.growth * rest.share * edgeLength;
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

// The squared lengths of the gradient at the start and at the end of the edge.
inline Float4 squaredAtStart(const Hinge& h) {
  return h.flapStart * h.flapStart + h.start * (h.start + splat(2) * h.flapStart * h.cosine);
}
inline Float4 squaredAtEnd(const Hinge& h) {
  return h.flapEnd * h.flapEnd + h.end * (h.end + splat(2) * h.flapEnd * h.cosine);
}

}  // namespace limber
