#include "simulate/constraints/bending_constraints.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "simulate/constraints/bending_rest.h"
#include "simulate/constraints/hinge.h"
#include "simulate/constraints/triangle_rest.h"

namespace limber {

namespace {

// The inertia of an edge rotation, as a fraction of the mass of its two triangles times their height squared.
// Between 0.01 and 0.25 the frequencies of plates of 8 x 8 cells change by at most 0.6 %; with less,
// rotations vibrate faster than vertices, which requires more substeps.
constexpr double kRotationInertia = 0.05;

// The rotations for empty lanes are two cache lines apart, see Particles.
constexpr size_t kIdleRotationStride = 16;

bool isRigid(const Particles& particles, uint32_t a, uint32_t b, uint32_t c) {
  return particles.inverseMass[a] == 0 && particles.inverseMass[b] == 0 && particles.inverseMass[c] == 0;
}

// Whether a triangle resists bending at float precision: without stiffness the compliance is infinite.
bool isFiniteInFloat(const std::array<double, 6>& compliance, double substep) {
  return std::ranges::all_of(compliance, [&](double entry) {
    return std::isfinite(static_cast<float>(entry / (substep * substep)));
  });
}

// The inverse inertia of every edge rotation, in 1/(kg m2). It is 0 on borders and where more than two
// triangles meet: such rotations stay 0.
std::vector<double> rotationWeights(const TriangleMesh& mesh, const Topology& topology, double arealDensity) {
  std::vector<double> weights;
  for (const auto& edge : topology.edges) {
    double area = 0;
    for (const uint32_t t : topology.trianglesAt(edge)) area += triangleRest(mesh, t).area();
    const double height = area / length(mesh.positions[edge.a] - mesh.positions[edge.b]);
    const double inertia = kRotationInertia * arealDensity * area * height * height;
    weights.push_back(edge.useCount == 2 && std::isnormal(inertia) ? 1 / inertia : 0);
  }
  return weights;
}

}  // namespace

BendingConstraints::BendingConstraints(const TriangleMesh& mesh, const Topology& topology,
                                       Particles& particles, const ConstraintOptions& options)
    : rotations_(topology.edges.size() + kIdleRotationStride * (options.blocks.groupCount() + 1)),
      exactPsi_(topology.edges.size(), 0.0) {
  rotationWeight_ = rotationWeights(mesh, topology, options.sheet.surfaceDensity);
  const auto flaps = flapsOf(mesh, topology);
  // A stencil has six vertices. Rotations need no entries of their own, because triangles that share a
  // rotation share an edge.
  std::vector<uint32_t> stencils;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const Triangle& corner = mesh.triangles[t];
    if (isRigid(particles, corner[0], corner[1], corner[2])) continue;
    const auto compliance = bendingCompliance(mesh, t, options.sheet);
    if (!isFiniteInFloat(compliance, options.substep)) continue;
    Rest rest{};
    rest.corner = corner;
    for (uint32_t e = 0; e < 3; ++e) {
      rest.flap[e] = flaps[3 * size_t{t} + e];
      rest.edge[e] = topology.edgeOpposite(Corner(t, e));
      setHinge(rest, e, mesh, particles);
    }
    stencils.insert(stencils.end(), corner.begin(), corner.end());
    stencils.insert(stencils.end(), rest.flap.begin(), rest.flap.end());
    compliance_.push_back(compliance);
    rest.stiffness =
        bendingStiffness(compliance_.back(), {rest.share[0] > 0, rest.share[1] > 0, rest.share[2] > 0});
    rest_.push_back(rest);
  }
  colouring_ = colour({stencils, 6}, options.blocks, options.order);
  batches_.resize(colouring_.batches.size());
  forEachLane(colouring_, [&](size_t i, const Lane& lane) {
    setTriangle(batches_[i], lane, particles, options.substep);
  });
}

void BendingConstraints::setHinge(Rest& rest, uint32_t e, const TriangleMesh& mesh,
                                  const Particles& particles) {
  const Triangle& corner = rest.corner;
  const uint32_t start = corner[(e + 1) % 3], end = corner[(e + 2) % 3], flap = rest.flap[e];
  rest.side[e] = start < end ? 1 : -1;
  rest.cosine[e] = 1;
  if (flap == kNone) return;
  const bool besideRigid = isRigid(particles, start, end, flap);
  rest.share[e] = besideRigid ? 2 : 1;
  if (besideRigid) rotationWeight_[rest.edge[e]] = 0;
  const auto& x = mesh.positions;
  const Fold fold = foldOf(x[corner[e]], x[start], x[end], x[flap]);
  const double size = std::hypot(fold.cosine, fold.sine);
  if (!(size > 0)) return;  // a triangle without a plane
  rest.cosine[e] = fold.cosine / size;
  rest.sine[e] = fold.sine / size;
}

// For an empty lane: a triangle whose three edges are borders.
const BendingConstraints::Rest& BendingConstraints::restOf(const Lane& lane) const {
  static const Rest border = {.corner = {},
                              .flap = {kNone, kNone, kNone},
                              .edge = {},
                              .cosine = {1, 1, 1},
                              .sine = {},
                              .side = {1, 1, 1},
                              .share = {},
                              .stiffness = {}};
  return lane.constraint == kNone ? border : rest_[lane.constraint];
}

void BendingConstraints::setTriangle(Batch& batch, const Lane& lane, Particles& particles, double substep) {
  const int k = lane.lane;
  const Rest& rest = restOf(lane);
  setLane(batch.base1, k, {1, 0, 0});
  setLane(batch.base2, k, {0, 1, 0});
  for (uint32_t e = 0; e < 3; ++e) setEdge(batch, lane, e, particles);
  for (int e = 0; e < 3; ++e) {
    const int f = (e + 1) % 3;
    const bool shared = rest.share[e] > 0 && rest.share[f] > 0 && rest.flap[e] == rest.flap[f];
    batch.sharedFlap[e][k] = shared ? batch.flapWeight[e][k] : 0.0f;
  }
  setCompliance(batch, lane, substep);
}

void BendingConstraints::setEdge(Batch& batch, const Lane& lane, uint32_t e, Particles& particles) {
  static const Vec3 outside[3] = {
      {1, 1, 0}, {-1, 1, 0}, {1, -1, 0}};  // flaps of the triangle of an empty lane
  const int k = lane.lane;
  const Rest& rest = restOf(lane);
  const bool isInner = rest.share[e] > 0;
  const uint32_t idle = particles.idle(lane.group);
  const uint32_t vertex = lane.constraint == kNone ? idle : rest.corner[e];
  const uint32_t flap = isInner ? rest.flap[e] : idle;
  EdgeRotation* const idleRotation = &rotations_[edgeCount() + kIdleRotationStride * (lane.group + 1)];
  batch.corner[e][k] = &particles.motion[vertex];
  batch.flap[e][k] = &particles.motion[flap];
  batch.edge[e][k] = isInner ? &rotations_[rest.edge[e]] : idleRotation;
  batch.weight[e][k] = static_cast<float>(particles.inverseMass[vertex]);
  batch.flapWeight[e][k] = static_cast<float>(particles.inverseMass[flap]);
  batch.rotationWeight[e][k] = isInner ? static_cast<float>(rotationWeight_[rest.edge[e]]) : 0.0f;
  batch.side[e][k] = static_cast<float>(rest.side[e]);
  batch.restCosine[e][k] = static_cast<float>(rest.cosine[e]);
  batch.restSine[e][k] = static_cast<float>(rest.sine[e]);
  batch.share[e][k] = static_cast<float>(rest.share[e]);
  setLane(batch.baseFlap[e], k, outside[e]);
}

void BendingConstraints::setCompliance(Batch& batch, const Lane& lane, double substep) const {
  const Rest& rest = restOf(lane);
  Float4* const entries[6] = {&batch.compliance.xx, &batch.compliance.xy, &batch.compliance.xz,
                              &batch.compliance.yy, &batch.compliance.yz, &batch.compliance.zz};
  int at = 0;
  for (int e = 0; e < 3; ++e)
    for (int f = e; f < 3; ++f, ++at) {
      const bool isInner = rest.share[e] > 0 && rest.share[f] > 0;
      (*entries[at])[lane.lane] =
          isInner ? static_cast<float>(compliance_[lane.constraint][at] / (substep * substep))
                  : static_cast<float>(e == f);
    }
}

void BendingConstraints::rebase(const Particles& particles, size_t begin, size_t end) {
  forEachConstraint(colouring_, begin, end, [&](size_t i, int k, uint32_t t) {
    Batch& batch = batches_[i];
    const Triangle& corner = rest_[t].corner;
    const auto at = [&](uint32_t v) { return particles.positions[v] - particles.positions[corner[0]]; };
    setLane(batch.base1, k, at(corner[1]));
    setLane(batch.base2, k, at(corner[2]));
    for (int e = 0; e < 3; ++e) {
      // Across a border any point outside the triangle can be used: it has no effect.
      const Vec3 from = at(corner[(e + 1) % 3]), to = at(corner[(e + 2) % 3]);
      const uint32_t flap = rest_[t].flap[e];
      setLane(batch.baseFlap[e], k, flap == kNone ? from + to - at(corner[e]) : at(flap));
    }
  });
}

void BendingConstraints::advanceRotations(size_t begin, size_t end, const Advance& what, float damping) {
  for (size_t e = begin; e < end; ++e) {
    EdgeRotation& rotation = rotations_[e];
    if (what.moves) {
      exactPsi_[e] += double{rotation.rate};
      rotation.psi = static_cast<float>(exactPsi_[e]);
    }
    if (what.accelerates) rotation.rate -= damping * rotation.rate;
  }
}

// The three hinges of a triangle, for four triangles at once. Corner c is the apex of hinge c, the end of the
// edge of hinge c + 1, and the start of the edge of hinge c + 2.
struct BendingConstraints::Hinges {
  Vec3x4 normal;
  Hinge hinge[3];
};

inline BendingConstraints::Hinges BendingConstraints::hingesOf(const Batch& b) {
  const Vec3x4 origin = gatherMotion(b.corner[0]);
  const Vec3x4 corner1 = b.base1 + (gatherMotion(b.corner[1]) - origin);
  const Vec3x4 corner2 = b.base2 + (gatherMotion(b.corner[2]) - origin);
  const Vec3x4 flap0 = b.baseFlap[0] + (gatherMotion(b.flap[0]) - origin);
  const Vec3x4 flap1 = b.baseFlap[1] + (gatherMotion(b.flap[1]) - origin);
  const Vec3x4 flap2 = b.baseFlap[2] + (gatherMotion(b.flap[2]) - origin);
  const Vec3x4 normal = cross(corner1, corner2), zero = {};
  const Float4 inverse = splat(1) / squareRoot(dot(normal, normal) + splat(1e-30f));
  Hinges hinges;
  hinges.normal = normal * inverse;
  hinges.hinge[0] = hingeOf<foldTangent>({corner1, corner2, flap0}, hinges.normal, inverse,
                                         {b.restCosine[0], b.restSine[0], b.share[0]});
  hinges.hinge[1] = hingeOf<foldTangent>({corner2 - corner1, zero - corner1, flap1 - corner1}, hinges.normal,
                                         inverse, {b.restCosine[1], b.restSine[1], b.share[1]});
  hinges.hinge[2] = hingeOf<foldTangent>({zero - corner2, corner1 - corner2, flap2 - corner2}, hinges.normal,
                                         inverse, {b.restCosine[2], b.restSine[2], b.share[2]});
  return hinges;
}

// J W J^T + compliance / substep^2 (Macklin et al. 2016, Eq. 18), for the three values s_e of a triangle.
inline Symmetric3x4 BendingConstraints::systemOf(const Batch& b, const Hinges& hinges) {
  const Hinge* hinge = hinges.hinge;
  const auto own = [&](int e) {
    const Hinge& h = hinge[e];
    return b.weight[e] * h.apex * h.apex + b.weight[(e + 1) % 3] * squaredAtStart(h) +
           b.weight[(e + 2) % 3] * squaredAtEnd(h) + b.flapWeight[e] * h.flap * h.flap + b.rotationWeight[e];
  };
  const auto mixed = [&](int e) {
    const int f = (e + 1) % 3, g = (e + 2) % 3;
    const Hinge &h = hinge[e], &next = hinge[f];
    const Float4 flaps = dot(h.flapNormal, next.flapNormal);
    const Float4 nextStart = next.flapStart * next.cosine + next.start;
    return b.weight[e] * h.apex * (next.flapEnd * next.cosine + next.end) +
           b.weight[f] * next.apex * (h.flapStart * h.cosine + h.start) +
           b.weight[g] * (h.flapEnd * (next.flapStart * flaps + h.cosine * next.start) + h.end * nextStart) +
           b.sharedFlap[e] * h.flap * next.flap * flaps;
  };
  return {b.compliance.xx + own(0), b.compliance.xy + mixed(0), b.compliance.xz + mixed(2),
          b.compliance.yy + own(1), b.compliance.yz + mixed(1), b.compliance.zz + own(2)};
}

inline void BendingConstraints::apply(const Batch& b, const Hinges& hinges, const Float4 (&lambda)[3]) {
  for (int c = 0; c < 3; ++c) {
    const int e = (c + 1) % 3, f = (c + 2) % 3;
    const Hinge &ended = hinges.hinge[e], &started = hinges.hinge[f];
    const Float4 along = lambda[c] * hinges.hinge[c].apex + lambda[e] * ended.end + lambda[f] * started.start;
    const Vec3x4 force = ended.flapNormal * (lambda[e] * ended.flapEnd) +
                         started.flapNormal * (lambda[f] * started.flapStart) + hinges.normal * along;
    scatterCorrection(b.corner[c], force * b.weight[c]);
  }
  for (int e = 0; e < 3; ++e) {
    const Hinge& hinge = hinges.hinge[e];
    scatterCorrection(b.flap[e], hinge.flapNormal * (lambda[e] * hinge.flap * b.flapWeight[e]));
  }
}

void BendingConstraints::project(size_t begin, size_t end) const {
  for (const Batch *batch = batches_.data() + begin, *last = batches_.data() + end; batch < last; ++batch) {
    const Batch& b = *batch;
    const Hinges hinges = hingesOf(b);
    Float4 residual[3];  // -s_e
    for (int e = 0; e < 3; ++e) {
      EdgeRotation* const(&at)[4] = b.edge[e];
      const Float4 psi = {at[0]->psi + at[0]->rate, at[1]->psi + at[1]->rate, at[2]->psi + at[2]->rate,
                          at[3]->psi + at[3]->rate};
      residual[e] = -(hinges.hinge[e].bend + b.side[e] * psi);
    }
    const Vec3x4 solution = solve(systemOf(b, hinges), {residual[0], residual[1], residual[2]});
    const Float4 lambda[3] = {solution.x, solution.y, solution.z};
    apply(b, hinges, lambda);
    for (int e = 0; e < 3; ++e) {
      const Float4 change = lambda[e] * b.rotationWeight[e] * b.side[e];
      for (int k = 0; k < 4; ++k) b.edge[e][k]->rate += change[k];
    }
  }
}

double BendingConstraints::energy(const std::vector<Vec3>& positions) const {
  double sum = 0;
  for (uint32_t t = 0; t < count(); ++t) {
    const Rest& rest = rest_[t];
    double s[3] = {0, 0, 0};
    for (uint32_t e = 0; e < 3; ++e) {
      if (rest.share[e] == 0) continue;
      const Triangle& corner = rest.corner;
      const Fold fold = foldOf(positions[corner[e]], positions[corner[(e + 1) % 3]],
                               positions[corner[(e + 2) % 3]], positions[rest.flap[e]]);
      const double sine = fold.sine * rest.cosine[e] - fold.cosine * rest.sine[e];
      const double cosine = fold.cosine * rest.cosine[e] + fold.sine * rest.sine[e];
      const double tangent = sine / (1 + std::abs(cosine));
      s[e] = rest.share[e] * (cosine < 0 ? std::copysign(2, sine) - tangent : tangent) +
             rest.side[e] * exactPsi_[rest.edge[e]];
    }
    const auto& k = rest.stiffness;
    sum += 0.5 * (k[0] * s[0] * s[0] + k[3] * s[1] * s[1] + k[5] * s[2] * s[2]) + k[1] * s[0] * s[1] +
           k[2] * s[0] * s[2] + k[4] * s[1] * s[2];
  }
  return sum;
}

bool BendingConstraints::isFinite() const {
  for (const double psi : exactPsi_)
    if (!std::isfinite(psi)) return false;
  return true;
}

}  // namespace limber
