#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/real_pair.h"
#include "mesh/corner.h"
#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"
#include "simplify/feature_edges.h"
#include "simplify/quadric.h"

namespace limber {

// A collapse: the triangles on `edge` vanish, `kept` moves to `target` and gets the other triangles of
// `removed`.
struct Collapse {
  uint32_t edge, kept, removed;
  Vec3 target;  // in the mesh's own frame, see CollapseMesh::origin
};

// A mesh in flat arrays whose edges can be collapsed in time proportional to the triangles around them.
// Triangles, edges and vertices keep their indices; edges are those of the Topology of the input, sorted by
// their vertices. Positions are relative to `origin`, the middle of the bounding box rounded to float32. The
// data that a collapse reads of a vertex or an edge are contiguous in memory, because on large meshes
// scattered reads dominate the time.
class CollapseMesh {
 public:
  struct Ends {
    uint32_t a, b;
  };
  struct Face {
    Triangle vertices;
    Triangle edges;  // edges[c] is opposite to vertices[c]
  };

  explicit CollapseMesh(const TriangleMesh& mesh, const SimplifyConstraints& constraints = {});

  uint32_t edgeCount() const { return static_cast<uint32_t>(edges_.size()); }
  uint32_t vertexCount() const { return static_cast<uint32_t>(vertices_.size()); }
  uint32_t triangleCount() const { return livingTriangles_; }
  double diagonal() const { return diagonal_; }

  const Ends& edge(uint32_t e) const { return edges_[e].ends; }
  // The number of triangles of an edge: 0 once it has been removed, 1 on a border, 2 inside, 3 for more than
  // two.
  int trianglesOnEdge(uint32_t e) const { return edges_[e].triangles; }
  const Face& face(uint32_t t) const { return faces_[t]; }
  const Vec3& position(uint32_t v) const { return vertices_[v].position; }
  const VertexRole& role(uint32_t v) const { return vertices_[v].role; }
  // The planes of the triangles and feature edges around a vertex and around all vertices that have been
  // merged into it.
  const Quadric& quadric(uint32_t v) const { return vertices_[v].quadric; }
  // A mark for the use of the collapse loop, initially false; `collapse` does not change it.
  bool isMarked(uint32_t v) const { return vertices_[v].isMarked; }
  void setMarked(uint32_t v, bool marked) { vertices_[v].isMarked = marked; }
  // Whether an edge is a feature edge, borders included.
  bool isFeature(uint32_t e) const {
    return edges_[e].triangles == 1 || edges_[e].feature != FeatureKind::None;
  }
  // The end of an edge that constraints fix in place while the other end is removed; kNone if both ends are
  // equally free.
  uint32_t fixedEnd(uint32_t e) const {
    const auto [a, b] = edges_[e].ends;
    const Freedom atA = role(a).freedom, atB = role(b).freedom;
    return atA == atB ? kNone : atA > atB ? a : b;
  }
  // The sector of a corner (see findSectors). Only for constraints with wedges or attributes.
  uint32_t sector(Corner corner) const { return sectorOfCorner_[corner.flatIndex()]; }
  uint32_t sectorCount() const { return static_cast<uint32_t>(heirOfSector_.size()); }
  // The corners at a vertex, in no particular order.
  std::span<const Corner> star(uint32_t v) const {
    const Star& star = vertices_[v].star;
    return {pool_.data() + star.begin, star.count};
  }

  // How a collapse changes the triangles around its ends.
  struct Change {
    uint32_t edge = kNone, kept = kNone;  // of the collapse
    std::vector<Corner> corners;  // [0, count): corners that remain, first the ofKept ones at the kept vertex
    size_t ofKept = 0, count = 0;
    std::array<Corner, 3> vanishing{};  // corners at the kept vertex that vanish
    uint32_t commonNeighbours = 0;      // number of vertices that are neighbours of both ends
  };
  // The reference is valid until the next call. A call for the same collapse as the last one, with no other
  // collapse in between, costs nothing.
  const Change& changeOf(const Collapse& step);

  // Calls visit(edge, other vertex) once for each edge of a vertex that is not locked.
  template <class Visit>
  void forEachEdge(uint32_t v, const Visit& visit) const {
    const bool open = role(v).onBorder;
    for (const Corner corner : star(v)) {
      const Face& face = faces_[corner.triangle()];
      const int next = nextIndex(corner.index()), previous = nextIndex(next);
      visit(face.edges[previous], face.vertices[next]);
      // Each of the other edges leaves v in one of its two triangles; the last edge of an open fan only
      // arrives at v.
      if (open && trianglesOnEdge(face.edges[next]) == 1) visit(face.edges[next], face.vertices[previous]);
    }
  }

  // The float32 coordinates in the file for a point of this frame.
  std::array<float, 3> inFile(const Vec3& p) const {
    const Vec3 q = p + origin_;
    return {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)};
  }
  // The point of this frame that the file can store nearest to p.
  Vec3 stored(const Vec3& p) const {
    const auto [x, y, z] = inFile(p);
    return Vec3{x, y, z} - origin_;
  }
  Vec3 fromFile(const Vec3& p) const { return p - origin_; }
  // As `stored`, for a computed point: its coordinates in the file are first rounded to multiples of about
  // 1e-9 of the diagonal, so that rounding noise around 0 becomes 0.
  template <class Real>
  Point<Real> rounded(const Point<Real>& p) const {
    const auto round = [&](Real x, double origin) {
      return asFloat(((x + origin) + rounder_) - rounder_) - origin;
    };
    return {round(p.x, origin_.x), round(p.y, origin_.y), round(p.z, origin_.z)};
  }

  // The collapse of an edge to `target`. The kept end is the fixed one, otherwise the one nearer to the
  // target, or the lower one on a tie.
  Collapse collapseOf(uint32_t edge, const Vec3& target) const;

  // Carries out a legal collapse, whose kept vertex must be its `fixedEnd` if there is one. Returns the up to
  // two further edges (otherwise kNone) that are removed because they coincide with edges of `kept`.
  std::array<uint32_t, 2> collapse(const Collapse& step);

 private:
  struct Star {
    uint32_t begin = 1, count = 0;
  };
  struct Edge {
    Ends ends;
    uint32_t heir;      // of a removed edge: the edge that it was merged into; else kNone
    uint8_t triangles;  // see trianglesOnEdge
    FeatureKind feature;
  };
  struct alignas(128) Vertex {
    Quadric quadric{};
    Vec3 position;
    Star star;
    uint32_t seen = 0;  // the last mark that `changeOf` set
    VertexRole role;
    bool isMarked = false;
  };

  void collectVertices(const TriangleMesh& mesh, const Topology& topology, const FeatureEdges& features);
  void collectQuadrics(std::span<const float> textureWeights);
  double featureWeight(uint32_t edge, double slide) const;
  bool isOn(const Face& face, uint32_t edge) const;
  void mergeEdges(uint32_t dying, uint32_t heir);
  void removeFromStar(uint32_t v, uint32_t triangle);
  void joinSectors(Corner removed, Corner kept);
  template <class Visit>
  size_t divideStar(uint32_t v, size_t count, std::array<Corner, 3>& vanishing, const Visit& visit);
  void transferCorner(Corner corner, const Collapse& step);
  uint32_t capacityOf(const Star& star) const { return pool_[star.begin - 1].code(); }
  void storeStar(const Collapse& step);

  Vec3 origin_;
  double diagonal_ = 0;
  double rounder_ = 0;  // adding and subtracting it rounds to the multiples of `rounded`
  uint32_t livingTriangles_ = 0;
  std::vector<Vertex> vertices_;
  std::vector<Face> faces_;
  std::vector<Edge> edges_;
  std::vector<Corner> pool_;  // the stars; the entry before each stores its capacity
  uint32_t mark_ = 0;         // the last one set in a vertex
  std::vector<uint32_t> sectorOfCorner_, heirOfSector_;
  Change change_;  // the last requested one
};

}  // namespace limber
