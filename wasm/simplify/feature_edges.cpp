#include "simplify/feature_edges.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/manifold.h"

namespace limber {
namespace {

// The rules by which an edge with two triangles, s and t, is a feature edge.
class FeatureRules {
 public:
  FeatureRules(const TriangleMesh& mesh, const SimplifyConstraints& constraints)
      : mesh_(mesh),
        constraints_(constraints),
        creaseCosine_(std::cos(constraints.creaseAngle * std::numbers::pi / 180)) {}

  // Whether no rule can apply.
  bool empty() const {
    return constraints_.groups.empty() && constraints_.wedges.empty() && constraints_.creaseAngle == 0 &&
           constraints_.pinnedSets.empty() && constraints_.mirror.empty();
  }
  FeatureKind kindOf(const Topology::Edge& edge, uint32_t s, uint32_t t) const {
    if (isBetweenGroups(s, t) || isCrease(s, t) || isOutline(edge, s, t) || isInMirror(edge))
      return FeatureKind::Outline;
    return isSeam(edge, s, t) ? FeatureKind::Seam : FeatureKind::None;
  }

 private:
  bool isBetweenGroups(uint32_t s, uint32_t t) const {
    return !constraints_.groups.empty() && constraints_.groups[s] != constraints_.groups[t];
  }
  bool isSeam(const Topology::Edge& edge, uint32_t s, uint32_t t) const {
    return !constraints_.wedges.empty() &&
           (wedge(s, edge.a) != wedge(t, edge.a) || wedge(s, edge.b) != wedge(t, edge.b));
  }
  uint32_t wedge(uint32_t t, uint32_t v) const {
    return constraints_.wedges[cornerAt(mesh_, t, v).flatIndex()];
  }
  bool isCrease(uint32_t s, uint32_t t) const {
    if (constraints_.creaseAngle == 0) return false;
    const Vec3 a = areaNormal(mesh_, s), b = areaNormal(mesh_, t);
    // A triangle without area has no normal.
    if (squaredLength(a) == 0 || squaredLength(b) == 0) return false;
    return dot(normalized(a), normalized(b)) < creaseCosine_;
  }
  // Whether both ends are in a pinned set that does not contain a vertex opposite to the edge.
  bool isOutline(const Topology::Edge& edge, uint32_t s, uint32_t t) const {
    const auto& sets = constraints_.pinnedSets;
    if (sets.empty()) return false;
    const auto third = [&](uint32_t triangle) {
      const auto& [p, q, r] = mesh_.triangles[triangle];
      return p ^ q ^ r ^ edge.a ^ edge.b;
    };
    return (sets[edge.a] & sets[edge.b] & ~(sets[third(s)] & sets[third(t)])) != 0;
  }

  bool isInMirror(const Topology::Edge& edge) const {
    return !constraints_.mirror.empty() && constraints_.mirror[edge.a] == edge.a &&
           constraints_.mirror[edge.b] == edge.b;
  }

  const TriangleMesh& mesh_;
  const SimplifyConstraints& constraints_;
  double creaseCosine_;
};

// The properties from which the role of a vertex follows.
struct FeatureCounts {
  uint32_t borders = 0, features = 0;  // numbers of edges; borders are not counted as features
  bool outlinesPinnedSet = false;      // a feature edge leads to a vertex that is not in all sets of this one
  bool leavesSet = false;              // any edge does
};

std::vector<FeatureCounts> countFeatures(const Topology& topology, const SimplifyConstraints& constraints,
                                         const FeatureEdges& found) {
  std::vector<FeatureCounts> around(topology.vertexStart.size() - 1);
  for (size_t e = 0; e < topology.edges.size(); ++e) {
    const Topology::Edge& edge = topology.edges[e];
    const bool border = edge.useCount == 1;
    const bool feature = found.isFeature(e);
    if (!border && !feature && constraints.pinnedSets.empty()) continue;
    for (const auto& [v, other] : {std::pair(edge.a, edge.b), std::pair(edge.b, edge.a)}) {
      around[v].borders += border;
      around[v].features += feature;
      if (constraints.pinnedSets.empty()) continue;
      const uint32_t own = constraints.pinnedSets[v], others = constraints.pinnedSets[other];
      const bool leaves = (own & ~others) != 0;
      around[v].leavesSet |= leaves;
      around[v].outlinesPinnedSet |= leaves && (border || feature);
    }
  }
  return around;
}

VertexRole roleOf(VertexKind kind, const FeatureCounts& around, bool borderFixed) {
  VertexRole role;
  role.onBorder = around.borders > 0;
  role.onFeature = role.onBorder || around.features > 0;
  const bool between = around.borders + around.features == 2 && (around.borders == 0 || around.features == 0);
  if (kind != VertexKind::Interior && kind != VertexKind::Border)
    role.freedom = Freedom::Locked;
  else if (role.onFeature)
    role.freedom = between && !around.outlinesPinnedSet ? Freedom::Feature : Freedom::Fixed;
  else if (around.leavesSet)
    role.freedom = Freedom::Fixed;
  if (borderFixed && role.onBorder) role.freedom = std::max(role.freedom, Freedom::Fixed);
  return role;
}

}  // namespace

FeatureEdges findFeatureEdges(const TriangleMesh& mesh, const Topology& topology,
                              const SimplifyConstraints& constraints) {
  FeatureEdges found;
  found.kinds.assign(topology.edges.size(), FeatureKind::None);
  const FeatureRules rules(mesh, constraints);
  for (size_t e = 0; e < topology.edges.size() && !rules.empty(); ++e) {
    const Topology::Edge& edge = topology.edges[e];
    if (edge.useCount != 2) continue;
    const auto triangles = topology.trianglesAt(edge);
    found.kinds[e] = rules.kindOf(edge, triangles[0], triangles[1]);
  }
  const auto around = countFeatures(topology, constraints, found);
  const auto kinds = classifyVertices(mesh, topology);
  found.roles.reserve(mesh.vertexCount());
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    VertexRole role = roleOf(kinds[v], around[v], constraints.borders == Borders::Fixed);
    const bool isFixed = (!constraints.locked.empty() && constraints.locked[v]) ||
                         (!constraints.mirror.empty() && constraints.mirror[v] == v && !role.onFeature);
    if (isFixed) role.freedom = std::max(role.freedom, Freedom::Fixed);
    found.roles.push_back(role);
  }
  for (size_t e = 0; e < topology.edges.size(); ++e)
    if (topology.clashes[e])
      for (const uint32_t v : {topology.edges[e].a, topology.edges[e].b})
        found.roles[v].freedom = Freedom::Locked;
  return found;
}

}  // namespace limber
