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

// A collapse: the triangles on `edge` vanish, `kept` goes to `target` and takes over the others of `removed`.
struct Collapse {
  uint32_t edge, kept, removed;
  Vec3 target;  // in the mesh's own frame, see CollapseMesh::origin
};

// A mesh whose edges can be collapsed in constant time, in flat arrays. Triangles, edges and vertices keep
// their indices for life; edges are those of the Topology of the input, sorted by their vertices.
// Positions are relative to `origin`, the middle of the bounding box rounded to float32.
// What a collapse asks of a vertex or an edge lies in one place of memory: on large meshes reading from many
// places is what takes the time.
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
  // How many triangles an edge has: 0 once it is gone, 1 on a border, 2 inside, 3 for more than two.
  int trianglesOnEdge(uint32_t e) const { return edges_[e].triangles; }
  const Face& face(uint32_t t) const { return faces_[t]; }
  const Vec3& position(uint32_t v) const { return vertices_[v].position; }
  const VertexRole& role(uint32_t v) const { return vertices_[v].role; }
  // The planes of the triangles and lines around a vertex and around all those that it has taken over.
  const Quadric& quadric(uint32_t v) const { return vertices_[v].quadric; }
  // A mark that a vertex carries for the collapse loop, false at first; `collapse` leaves it alone.
  bool isMarked(uint32_t v) const { return vertices_[v].isMarked; }
  void setMarked(uint32_t v, bool marked) { vertices_[v].isMarked = marked; }
  // Whether an edge is a border or another line.
  bool isFeature(uint32_t e) const { return edges_[e].triangles == 1 || edges_[e].isFeature != 0; }
  // The end of an edge that the wishes or a line keep in place while the other end is removed; kNone where
  // both ends are alike.
  uint32_t fixedEnd(uint32_t e) const {
    const auto [a, b] = edges_[e].ends;
    const Freedom atA = role(a).freedom, atB = role(b).freedom;
    return atA == atB ? kNone : atA > atB ? a : b;
  }
  // The sector of a corner (see findSectors), where wedges or attributes are among the
  // constraints.
  uint32_t sector(Corner corner) const { return sectorOfCorner_[corner.flatIndex()]; }
  uint32_t sectorCount() const { return static_cast<uint32_t>(heirOfSector_.size()); }
  // The corners at a vertex, in no special order.
  std::span<const Corner> star(uint32_t v) const {
    const Star& star = vertices_[v].star;
    return {pool_.data() + star.begin, star.count};
  }

  // What a collapse does to the triangles around its ends.
  struct Change {
    uint32_t edge = kNone, kept = kNone;  // of the collapse
    std::vector<Corner> corners;          // [0, count): those that stay, at the kept vertex before the others
    size_t ofKept = 0, count = 0;
    std::array<Corner, 3> vanishing{};  // those at the kept vertex that do not stay
    uint32_t commonNeighbours = 0;      // how many vertices are neighbours of both ends
  };
  // Uses marks of its own in the vertices. Valid until the next call, of which one for the same edge before
  // any collapse costs nothing.
  const Change& changeOf(const Collapse& step);

  // Calls visit(edge, other vertex) once for each edge of a vertex that is not locked.
  template <class Visit>
  void forEachEdge(uint32_t v, const Visit& visit) const {
    const bool open = role(v).onBorder;
    for (const Corner corner : star(v)) {
      const Face& face = faces_[corner.triangle()];
      const int next = nextIndex(corner.index()), previous = nextIndex(next);
      visit(face.edges[previous], face.vertices[next]);
      // Every other edge leaves v in one of its two triangles; the last of an open fan only arrives.
      if (open && trianglesOnEdge(face.edges[next]) == 1) visit(face.edges[next], face.vertices[previous]);
    }
  }

  // The float32 coordinates of a point in the file, and the point that has them.
  std::array<float, 3> inFile(const Vec3& p) const {
    const Vec3 q = p + origin_;
    return {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)};
  }
  Vec3 stored(const Vec3& p) const {
    const auto [x, y, z] = inFile(p);
    return Vec3{x, y, z} - origin_;
  }
  Vec3 fromFile(const Vec3& p) const { return p - origin_; }
  // Where to store a point that was computed: its coordinates in the file are rounded to steps of 1e-9 of the
  // diagonal first, so that rounding noise around 0 becomes 0.
  template <class Real>
  Point<Real> rounded(const Point<Real>& p) const {
    const auto round = [&](Real x, double origin) {
      return asFloat(((x + origin) + rounder_) - rounder_) - origin;
    };
    return {round(p.x, origin_.x), round(p.y, origin_.y), round(p.z, origin_.z)};
  }

  // The collapse of an edge to `target`: of the two ends the fixed one stays, else the one nearer to the
  // target, else the lower one.
  Collapse collapseOf(uint32_t edge, const Vec3& target) const;

  // Carries out a legal collapse, whose kept vertex must be its `fixedEnd` if there is one, and returns the
  // up to two further edges that are gone (else kNone): they have become one with edges of `kept`.
  std::array<uint32_t, 2> collapse(const Collapse& step);

 private:
  struct Star {
    uint32_t begin = 1, count = 0;
  };
  struct Edge {
    Ends ends;
    uint32_t heir;      // of an edge that is gone: the edge it has become; else kNone
    uint8_t triangles;  // see trianglesOnEdge
    uint8_t isFeature;  // whether it is a line inside the surface
  };
  struct alignas(128) Vertex {
    Quadric quadric{};
    Vec3 position;
    Star star;
    uint32_t seen = 0;  // the last mark of `changeOf`
    VertexRole role;
    bool isMarked = false;
  };

  void collectVertices(const TriangleMesh& mesh, const Topology& topology, const FeatureEdges& features);
  void collectQuadrics();
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
  double rounder_ = 0;  // adding and subtracting it rounds to the steps of `rounded`
  uint32_t livingTriangles_ = 0;
  std::vector<Vertex> vertices_;
  std::vector<Face> faces_;
  std::vector<Edge> edges_;
  std::vector<Corner> pool_;  // the stars' places, each behind its capacity
  uint32_t mark_ = 0;         // the last that was set in a vertex
  std::vector<uint32_t> sectorOfCorner_, heirOfSector_;
  Change change_;  // the last one asked for
};

}  // namespace limber
