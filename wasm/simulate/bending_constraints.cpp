#include "simulate/bending_constraints.h"

#include <cmath>

#include "simulate/bending_rest.h"
#include "simulate/gather.h"
#include "simulate/triangle_rest.h"

namespace limber {

namespace {

// The share of the triangles' mass times their height squared that a turn has as its inertia. From 0.01 to
// 0.25 the frequencies of plates of 8 cells a side stay within 0.6 %; less makes turns faster than the
// vertices, which costs substeps.
constexpr double kTurnInertia = 0.25;

// Folds beyond about 150 degrees from rest count as 150 degrees: tan(theta / 2) grows without bound.
constexpr float kLeastCosine = 0.14f;  // of 1 + cos

// Six vertices and, by the edges' vertices, three turns: two triangles that share a turn share vertices too.
std::vector<uint32_t> stencils(const TriangleMesh& mesh, const std::vector<uint32_t>& flaps) {
  std::vector<uint32_t> vertices;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    vertices.insert(vertices.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
    vertices.insert(vertices.end(), flaps.begin() + 3 * size_t{t}, flaps.begin() + 3 * size_t{t} + 3);
  }
  return vertices;
}

// 1/(kg m2) of every edge's turn; 0 on borders and where more than two triangles meet, whose turn stays 0.
std::vector<double> turnWeights(const TriangleMesh& mesh, const Topology& topology, double arealDensity) {
  std::vector<double> weights;
  for (const auto& edge : topology.edges) {
    double area = 0;
    for (const uint32_t t : topology.trianglesAt(edge)) area += triangleRest(mesh, t).area();
    const double height = area / length(mesh.positions[edge.a] - mesh.positions[edge.b]);
    const double inertia = kTurnInertia * arealDensity * area * height * height;
    weights.push_back(edge.useCount == 2 && std::isnormal(inertia) ? 1 / inertia : 0);
  }
  return weights;
}

}  // namespace

BendingConstraints::BendingConstraints(const TriangleMesh& mesh, const Topology& topology,
                                       const Particles& particles, const Sheet& sheet, double density,
                                       double substep, uint32_t order)
    : triangles_(mesh.triangles),
      turns_(topology.edges.size() + 1, Turn{0, 0}),
      exactPsi_(topology.edges.size(), 0.0),
      turnWeight_(turnWeights(mesh, topology, density * sheet.thickness)),
      count_(mesh.triangleCount()) {
  const auto flaps = flapsOf(mesh, topology);
  for (uint32_t t = 0; t < count_; ++t) {
    Rest rest{};
    std::array<bool, 3> inner;
    for (uint32_t e = 0; e < 3; ++e) {
      const uint32_t start = mesh.triangles[t][(e + 1) % 3], end = mesh.triangles[t][(e + 2) % 3];
      rest.flap[e] = flaps[3 * size_t{t} + e];
      rest.edge[e] = topology.edgeOfCorner[3 * size_t{t} + e];
      rest.side[e] = start < end ? 1 : -1;
      inner[e] = rest.flap[e] != kNone;
      if (!inner[e]) continue;
      const Fold fold = foldOf(mesh.corner(t, static_cast<int>(e)), mesh.positions[start],
                               mesh.positions[end], mesh.positions[rest.flap[e]]);
      const double size = std::hypot(fold.cosine, fold.sine);  // 0 where a triangle has no plane
      rest.cosine[e] = size > 0 ? fold.cosine / size : 1;
      rest.sine[e] = size > 0 ? fold.sine / size : 0;
    }
    compliance_.push_back(bendingCompliance(mesh, t, sheet));
    rest.stiffness = bendingStiffness(compliance_.back(), inner);
    rest_.push_back(rest);
  }
  colouring_ = colour(stencils(mesh, flaps), 6, particles.count(), order);
  batches_.resize(colouring_.batches.size());
  for (size_t i = 0; i < batches_.size(); ++i)
    for (int k = 0; k < 4; ++k) setTriangle(batches_[i], k, colouring_.batches[i][k], particles, substep);
}

void BendingConstraints::setTriangle(Batch& batch, int k, uint32_t t, const Particles& particles,
                                     double substep) {
  static const Vec3 outside[3] = {{1, 1, 0}, {-1, 1, 0}, {1, -1, 0}};  // flaps of an empty lane's triangle
  const bool empty = t == kNone;
  setLane(batch.base1, k, {1, 0, 0});
  setLane(batch.base2, k, {0, 1, 0});
  std::array<bool, 3> inner{};
  for (uint32_t e = 0; e < 3; ++e) {
    inner[e] = !empty && rest_[t].flap[e] != kNone;
    const uint32_t vertex = empty ? particles.idle() : triangles_[t][e];
    const uint32_t flap = inner[e] ? rest_[t].flap[e] : particles.idle();
    batch.corner[e][k] = vertex;
    batch.flap[e][k] = flap;
    batch.edge[e][k] = inner[e] ? rest_[t].edge[e] : static_cast<uint32_t>(edgeCount());
    batch.weight[e][k] = static_cast<float>(particles.inverseMass[vertex]);
    batch.flapWeight[e][k] = static_cast<float>(particles.inverseMass[flap]);
    batch.turnWeight[e][k] = inner[e] ? static_cast<float>(turnWeight_[rest_[t].edge[e]]) : 0.0f;
    batch.side[e][k] = empty ? 1 : static_cast<float>(rest_[t].side[e]);
    batch.restCosine[e][k] = inner[e] ? static_cast<float>(rest_[t].cosine[e]) : 0.0f;
    batch.restSine[e][k] = inner[e] ? static_cast<float>(rest_[t].sine[e]) : 0.0f;
    setLane(batch.baseFlap[e], k, outside[e]);
  }
  for (int e = 0; e < 3; ++e) {  // 0 and 1, 2 and 0, 1 and 2
    const int f = (e + 1) % 3;
    const bool shared = inner[e] && inner[f] && rest_[t].flap[e] == rest_[t].flap[f];
    batch.sharedFlap[e][k] = shared ? batch.flapWeight[e][k] : 0.0f;
  }
  Float4* const entries[6] = {&batch.compliance.xx, &batch.compliance.xy, &batch.compliance.xz,
                              &batch.compliance.yy, &batch.compliance.yz, &batch.compliance.zz};
  int at = 0;
  for (int e = 0; e < 3; ++e)
    for (int f = e; f < 3; ++f, ++at)
      (*entries[at])[k] = inner[e] && inner[f] ? static_cast<float>(compliance_[t][at] / (substep * substep))
                                               : static_cast<float>(e == f);
}

void BendingConstraints::rebase(const Particles& particles, size_t begin, size_t end) {
  for (size_t i = begin; i < end; ++i)
    for (int k = 0; k < 4; ++k) {
      Batch& batch = batches_[i];
      if (batch.corner[0][k] == particles.idle()) continue;
      const auto at = [&](uint32_t v) {
        return particles.positions[v] - particles.positions[batch.corner[0][k]];
      };
      setLane(batch.base1, k, at(batch.corner[1][k]));
      setLane(batch.base2, k, at(batch.corner[2][k]));
      for (int e = 0; e < 3; ++e) {
        // Across a border any point outside the triangle does: nothing follows from it.
        const Vec3 start = at(batch.corner[(e + 1) % 3][k]), end = at(batch.corner[(e + 2) % 3][k]);
        const bool border = batch.flap[e][k] == particles.idle();
        setLane(batch.baseFlap[e], k, border ? start + end - at(batch.corner[e][k]) : at(batch.flap[e][k]));
      }
    }
}

void BendingConstraints::advanceTurns(size_t begin, size_t end, const Advance& what, float damping) {
  for (size_t e = begin; e < end; ++e) {
    Turn& turn = turns_[e];
    if (what.moves) {
      exactPsi_[e] += double{turn.rate};
      turn.psi = static_cast<float>(exactPsi_[e]);
    }
    if (what.accelerates) turn.rate -= damping * turn.rate;
  }
}

namespace {

// tan(half the fold from rest) and its gradient over the four vertices of a hinge.
struct Hinge {
  Float4 turn;
  Vec3x4 apex, start, end, flap;
};

// As seen from the apex.
struct HingeVertices {
  Vec3x4 toStart, toEnd, toFlap;
};
struct RestFold {
  Float4 cosine, sine;
};

Hinge hingeOf(const HingeVertices& at, const Vec3x4& unitNormal, Float4 inverseNormal, const RestFold& rest) {
  const Vec3x4 edge = at.toEnd - at.toStart, across = at.toFlap - at.toStart;
  const Vec3x4 normal = cross(at.toFlap - at.toEnd, edge);
  const Float4 one = splat(1), squaredEdge = dot(edge, edge), edgeLength = squareRoot(squaredEdge);
  const Float4 inverseOther = one / squareRoot(dot(normal, normal) + splat(1e-30f));
  const Vec3x4 unitOther = normal * inverseOther;
  const Float4 cosine = dot(unitNormal, unitOther);
  const Float4 sine = dot(across, unitNormal) * edgeLength * inverseOther;
  const Float4 growth = one / larger(one + cosine * rest.cosine + sine * rest.sine, splat(kLeastCosine));
  // 1 inside, 0 on a border.
  const Float4 inner = rest.cosine * rest.cosine + rest.sine * rest.sine;
  Hinge hinge;
  hinge.turn = (sine * rest.cosine - cosine * rest.sine) * growth;
  const Float4 scale = growth * inner * edgeLength;
  hinge.flap = unitOther * (scale * inverseOther);
  hinge.apex = unitNormal * (scale * inverseNormal);
  const Float4 inverseSquare = one / (squaredEdge + splat(1e-30f));
  const Float4 flapFoot = dot(across, edge) * inverseSquare,
               apexFoot = -dot(at.toStart, edge) * inverseSquare;
  hinge.end = hinge.flap * -flapFoot - hinge.apex * apexFoot;
  hinge.start = hinge.flap * (flapFoot - one) + hinge.apex * (apexFoot - one);
  return hinge;
}

}  // namespace

// The three hinges of a triangle, for four triangles at once.
struct BendingConstraints::Hinges {
  Hinge hinge[3];

  // How edge e's turn changes with corner c, which is apex of edge c, end of edge c + 1, start of edge c + 2.
  const Vec3x4& gradient(int e, int c) const {
    return c == e ? hinge[e].apex : c == (e + 1) % 3 ? hinge[e].end : hinge[e].start;
  }
};

BendingConstraints::Hinges BendingConstraints::hingesOf(const Batch& b, const Motion* motion) {
  const Vec3x4 origin = gatherMotion(motion, b.corner[0]);
  const Vec3x4 corner1 = b.base1 + (gatherMotion(motion, b.corner[1]) - origin);
  const Vec3x4 corner2 = b.base2 + (gatherMotion(motion, b.corner[2]) - origin);
  const Vec3x4 normal = cross(corner1, corner2);
  const Float4 inverseNormal = splat(1) / squareRoot(dot(normal, normal) + splat(1e-30f));
  const Vec3x4 unitNormal = normal * inverseNormal;
  const Vec3x4 corners[3] = {Vec3x4{}, corner1, corner2};
  Hinges hinges;
  for (int e = 0; e < 3; ++e) {
    const Vec3x4& apex = corners[e];
    const Vec3x4 flap = b.baseFlap[e] + (gatherMotion(motion, b.flap[e]) - origin);
    hinges.hinge[e] = hingeOf({corners[(e + 1) % 3] - apex, corners[(e + 2) % 3] - apex, flap - apex},
                              unitNormal, inverseNormal, {b.restCosine[e], b.restSine[e]});
  }
  return hinges;
}

// J W J^T + compliance.
Symmetric3x4 BendingConstraints::systemOf(const Batch& b, const Hinges& hinges) {
  const auto coupling = [&](int e, int f) {
    return b.weight[0] * dot(hinges.gradient(e, 0), hinges.gradient(f, 0)) +
           b.weight[1] * dot(hinges.gradient(e, 1), hinges.gradient(f, 1)) +
           b.weight[2] * dot(hinges.gradient(e, 2), hinges.gradient(f, 2));
  };
  const auto own = [&](int e) {
    const Vec3x4& flap = hinges.hinge[e].flap;
    return coupling(e, e) + b.flapWeight[e] * dot(flap, flap) + b.turnWeight[e];
  };
  const auto mixed = [&](int e) {
    const int f = (e + 1) % 3;
    return coupling(e, f) + b.sharedFlap[e] * dot(hinges.hinge[e].flap, hinges.hinge[f].flap);
  };
  return {b.compliance.xx + own(0), b.compliance.xy + mixed(0), b.compliance.xz + mixed(2),
          b.compliance.yy + own(1), b.compliance.yz + mixed(1), b.compliance.zz + own(2)};
}

void BendingConstraints::project(Particles& particles, size_t begin, size_t end) {
  Motion* const motion = particles.motion.data();
  Turn* const turns = turns_.data();
  for (const Batch *batch = batches_.data() + begin, *last = batches_.data() + end; batch < last; ++batch) {
    const Batch& b = *batch;
    const Hinges hinges = hingesOf(b, motion);
    Float4 turn[3];
    for (int e = 0; e < 3; ++e) {
      Float4 psi;
      for (int k = 0; k < 4; ++k) psi[k] = turns[b.edge[e][k]].psi + turns[b.edge[e][k]].rate;
      turn[e] = -(hinges.hinge[e].turn + b.side[e] * psi);
    }
    const Vec3x4 solution = solve(systemOf(b, hinges), {turn[0], turn[1], turn[2]});
    const Float4 lambda[3] = {solution.x, solution.y, solution.z};
    for (int c = 0; c < 3; ++c) {
      const Vec3x4 pull = hinges.gradient(0, c) * lambda[0] + hinges.gradient(1, c) * lambda[1] +
                          hinges.gradient(2, c) * lambda[2];
      scatterCorrection(motion, b.corner[c], pull * b.weight[c]);
    }
    for (int e = 0; e < 3; ++e) {
      scatterCorrection(motion, b.flap[e], hinges.hinge[e].flap * (lambda[e] * b.flapWeight[e]));
      const Float4 turned = lambda[e] * b.turnWeight[e] * b.side[e];
      for (int k = 0; k < 4; ++k) turns[b.edge[e][k]].rate += turned[k];
    }
  }
}

double BendingConstraints::energy(const std::vector<Vec3>& positions) const {
  double sum = 0;
  for (uint32_t t = 0; t < count_; ++t) {
    const Rest& rest = rest_[t];
    double s[3] = {0, 0, 0};
    for (uint32_t e = 0; e < 3; ++e) {
      if (rest.flap[e] == kNone) continue;
      const Triangle& corner = triangles_[t];
      const Fold fold = foldOf(positions[corner[e]], positions[corner[(e + 1) % 3]],
                               positions[corner[(e + 2) % 3]], positions[rest.flap[e]]);
      const double sine = fold.sine * rest.cosine[e] - fold.cosine * rest.sine[e];
      const double cosine = fold.cosine * rest.cosine[e] + fold.sine * rest.sine[e];
      s[e] = sine / std::fmax(1 + cosine, kLeastCosine) + rest.side[e] * exactPsi_[rest.edge[e]];
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
