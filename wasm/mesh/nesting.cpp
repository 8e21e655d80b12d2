#include "mesh/nesting.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace limber {

namespace {

constexpr double kNoVolume = 1e-12;  // of the cube of the diagonal

struct Shell {
  bool isClosed = true;
  double volume = 0;        // positive if wound outwards
  uint32_t vertex = kNone;  // the lowest of the component
  Bounds box;
};

// Whether the triangles of an edge traverse it as often in one direction as in the other.
bool isWoundAlike(const TriangleMesh& mesh, const Topology& topology, const Topology::Edge& edge) {
  int balance = 0;
  for (uint32_t t : topology.trianglesAt(edge))
    for (int c = 0; c < 3; ++c)
      if (mesh.triangles[t][c] == edge.a) balance += mesh.triangles[t][(c + 1) % 3] == edge.b ? 1 : -1;
  return balance == 0;
}

std::vector<Shell> measureShells(const TriangleMesh& mesh, const Topology& topology) {
  std::vector<Shell> shells(topology.componentCount);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    Shell& shell = shells[topology.componentOfVertex[v]];
    const Vec3& p = mesh.positions[v];
    if (shell.vertex == kNone) {
      shell.vertex = v;
      shell.box = {p, p};
    }
    shell.box.include(p);
  }
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    Shell& shell = shells[topology.componentOfVertex[mesh.triangles[t][0]]];
    const Vec3 &a = mesh.corner(t, 0), &b = mesh.corner(t, 1), &c = mesh.corner(t, 2);
    shell.volume += dot(a - shell.box.low, cross(b - shell.box.low, c - shell.box.low)) / 6;
  }
  for (const Topology::Edge& edge : topology.edges)
    if (edge.useCount != 2 || !isWoundAlike(mesh, topology, edge))
      shells[topology.componentOfVertex[edge.a]].isClosed = false;
  for (Shell& shell : shells)
    if (!(std::abs(shell.volume) > kNoVolume * std::pow(shell.box.diagonal(), 3))) shell.isClosed = false;
  return shells;
}

// Twice the signed area of the triangle (from, to, p) projected along z. Computed with the lower vertex
// first, so that the side of p is consistent to the last bit for both triangles of an edge.
double areaBeside(const TriangleMesh& mesh, uint32_t from, uint32_t to, const Vec3& p) {
  if (from > to) return -areaBeside(mesh, to, from, p);
  const Vec3 a = mesh.positions[from] - p, b = mesh.positions[to] - p;
  return a.x * b.y - a.y * b.x;
}

// 1 if the ray from p along z exits through the triangle, -1 if it enters, 0 if it misses.
int crossingAbove(const TriangleMesh& mesh, uint32_t t, const Vec3& p) {
  double area[3], total = 0, height = 0;
  int leftCount = 0;
  for (int c = 0; c < 3; ++c) {
    const uint32_t from = mesh.triangles[t][(c + 1) % 3], to = mesh.triangles[t][(c + 2) % 3];
    area[c] = areaBeside(mesh, from, to, p);
    leftCount += area[c] > 0 || (area[c] == 0 && from < to);
    total += area[c];
    height += area[c] * mesh.corner(t, c).z;
  }
  if (leftCount % 3 != 0 || total == 0 || height / total <= p.z) return 0;
  return leftCount == 3 ? 1 : -1;
}

// A crossing of `outer` by the ray from the first vertex of `inner`; the sum of the signs is the winding
// number.
struct Crossing {
  uint32_t inner, outer;
  int sign;
};

std::vector<Crossing> crossingsAboveShells(const TriangleMesh& mesh, const Topology& topology,
                                           const std::vector<Shell>& shells) {
  std::vector<uint32_t> byX;  // closed components, sorted by x of their first vertex
  for (uint32_t s = 0; s < shells.size(); ++s)
    if (shells[s].isClosed) byX.push_back(s);
  const auto xOf = [&](uint32_t s) { return mesh.positions[shells[s].vertex].x; };
  std::stable_sort(byX.begin(), byX.end(), [&](uint32_t a, uint32_t b) { return xOf(a) < xOf(b); });
  std::vector<Crossing> crossings;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const uint32_t outer = topology.componentOfVertex[mesh.triangles[t][0]];
    if (!shells[outer].isClosed) continue;
    const auto [low, high] = std::minmax({mesh.corner(t, 0).x, mesh.corner(t, 1).x, mesh.corner(t, 2).x});
    auto s = std::lower_bound(byX.begin(), byX.end(), low, [&](uint32_t a, double x) { return xOf(a) < x; });
    for (; s != byX.end() && xOf(*s) <= high; ++s) {
      if (*s == outer) continue;
      const int sign = crossingAbove(mesh, t, mesh.positions[shells[*s].vertex]);
      if (sign != 0) crossings.push_back({*s, outer, sign});
    }
  }
  return crossings;
}

bool liesWithin(const Bounds& inner, const Bounds& outer) {
  for (int axis = 0; axis < 3; ++axis)
    if (inner.low[axis] < outer.low[axis] || inner.high[axis] > outer.high[axis]) return false;
  return true;
}

// Per component the closed components that contain it.
std::vector<std::vector<uint32_t>> findContainers(std::vector<Crossing> crossings,
                                                  const std::vector<Shell>& shells) {
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
    return std::tie(a.inner, a.outer) < std::tie(b.inner, b.outer);
  });
  std::vector<std::vector<uint32_t>> containers(shells.size());
  for (size_t begin = 0, end; begin < crossings.size(); begin = end) {
    const auto [inner, outer, first] = crossings[begin];
    int winding = 0;
    for (end = begin;
         end < crossings.size() && crossings[end].inner == inner && crossings[end].outer == outer;)
      winding += crossings[end++].sign;
    if (winding != 0 && liesWithin(shells[inner].box, shells[outer].box)) containers[inner].push_back(outer);
  }
  return containers;
}

}  // namespace

uint32_t countSolidComponents(const TriangleMesh& mesh, const Topology& topology) {
  return static_cast<uint32_t>(std::ranges::count(measureShells(mesh, topology), true, &Shell::isClosed));
}

std::vector<uint32_t> solidHosts(const TriangleMesh& mesh, const Topology& topology) {
  const std::vector<Shell> shells = measureShells(mesh, topology);
  const auto containers = findContainers(crossingsAboveShells(mesh, topology, shells), shells);
  std::vector<uint32_t> fromOutside, hosts(shells.size(), kNone);
  for (uint32_t s = 0; s < shells.size(); ++s)
    if (shells[s].isClosed) fromOutside.push_back(s);
  std::stable_sort(fromOutside.begin(), fromOutside.end(),
                   [&](uint32_t a, uint32_t b) { return containers[a].size() < containers[b].size(); });
  for (uint32_t s : fromOutside) {
    hosts[s] = s;
    const auto closest =
        std::max_element(containers[s].begin(), containers[s].end(),
                         [&](uint32_t a, uint32_t b) { return containers[a].size() < containers[b].size(); });
    if (closest == containers[s].end()) continue;
    const bool isWoundAgainst = (shells[s].volume < 0) != (shells[*closest].volume < 0);
    if (hosts[*closest] == *closest && isWoundAgainst) hosts[s] = *closest;
  }
  return hosts;
}

}  // namespace limber
