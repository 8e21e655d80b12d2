// The loop that a textbook has for substep XPBD with distance constraints, timed natively on the paper's bar,
// as JSON on stdout: the peer of tests/bench/simulate.mjs. Compiled with -O3 -march=native; -ffast-math is
// told by the macro.
//
//   plain_springs [--cells 8] [--substeps 2000] [--seconds 3] [--colour]
//
// The bar has cells x cells x 3 cells cells; edges come in the order in which the faces name them, or, with
// --colour, in colours whose edges share no vertex.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <utility>
#include <vector>

namespace {

#ifndef REAL
#define REAL float
#endif
using Real = REAL;

struct Point {
  Real x, y, z;
};

struct Edge {
  int a, b;
  Real rest;
};

struct Body {
  std::vector<Point> position, before, velocity;
  std::vector<Real> inverseMass;
  std::vector<Edge> edges;
  Real compliance;
};

using Faces = std::vector<std::array<int, 3>>;

Body bar(int cells, Faces& faces) {
  Body body;
  const int size[3] = {cells, cells, 3 * cells};
  std::map<std::array<int, 3>, int> index;
  const auto at = [&](std::array<int, 3> p) {
    const auto [entry, added] = index.try_emplace(p, static_cast<int>(body.position.size()));
    if (added) body.position.push_back({Real(p[0]) / cells, Real(p[1]) / cells, Real(p[2]) / cells});
    return entry->second;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side)
      for (int j = 0; j < size[(axis + 2) % 3]; ++j)
        for (int i = 0; i < size[(axis + 1) % 3]; ++i) {
          std::array<std::array<int, 3>, 4> corner{};
          const int offset[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
          for (int k = 0; k < 4; ++k) {
            corner[k][axis] = side ? size[axis] : 0;
            corner[k][(axis + 1) % 3] = i + offset[k][0];
            corner[k][(axis + 2) % 3] = j + offset[k][1];
          }
          faces.push_back({at(corner[0]), at(corner[1]), at(corner[2])});
          faces.push_back({at(corner[0]), at(corner[2]), at(corner[3])});
        }
  return body;
}

// Every edge once, where the first face names it.
void addEdges(Body& body, const Faces& faces) {
  std::map<std::pair<int, int>, bool> seen;
  for (const auto& face : faces)
    for (int e = 0; e < 3; ++e) {
      const int a = face[e], b = face[(e + 1) % 3];
      if (!seen.try_emplace(std::minmax(a, b), true).second) continue;
      const Point &p = body.position[a], &q = body.position[b];
      const Real x = p.x - q.x, y = p.y - q.y, z = p.z - q.z;
      body.edges.push_back({a, b, std::sqrt(x * x + y * y + z * z)});
    }
}

// First fit; a stable sort keeps the faces' order within a colour.
void sortByColour(Body& body) {
  std::vector<std::vector<bool>> used(body.position.size());
  std::vector<std::pair<size_t, Edge>> coloured;
  for (const Edge& edge : body.edges) {
    size_t colour = 0;
    const auto taken = [&](int v) { return colour < used[v].size() && used[v][colour]; };
    while (taken(edge.a) || taken(edge.b)) ++colour;
    for (const int v : {edge.a, edge.b}) {
      if (used[v].size() <= colour) used[v].resize(colour + 1);
      used[v][colour] = true;
    }
    coloured.push_back({colour, edge});
  }
  std::stable_sort(coloured.begin(), coloured.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (size_t i = 0; i < coloured.size(); ++i) body.edges[i] = coloured[i].second;
}

void project(Body& body, Real dt) {
  const Real softness = body.compliance / (dt * dt);
  for (const Edge& edge : body.edges) {
    Point &p = body.position[edge.a], &q = body.position[edge.b];
    const Real x = p.x - q.x, y = p.y - q.y, z = p.z - q.z;
    const Real length = std::sqrt(x * x + y * y + z * z);
    const Real wa = body.inverseMass[edge.a], wb = body.inverseMass[edge.b];
    const Real scale = (edge.rest - length) / ((wa + wb + softness) * length);
    p = {p.x + wa * scale * x, p.y + wa * scale * y, p.z + wa * scale * z};
    q = {q.x - wb * scale * x, q.y - wb * scale * y, q.z - wb * scale * z};
  }
}

void substep(Body& body, Real dt) {
  const size_t count = body.position.size();
  for (size_t v = 0; v < count; ++v) {
    Point &x = body.position[v], &u = body.velocity[v];
    body.before[v] = x;
    if (body.inverseMass[v] == 0) continue;
    u.y -= Real(9.81) * dt;
    x = {x.x + u.x * dt, x.y + u.y * dt, x.z + u.z * dt};
  }
  project(body, dt);
  for (size_t v = 0; v < count; ++v) {
    const Point &x = body.position[v], &old = body.before[v];
    body.velocity[v] = {(x.x - old.x) / dt, (x.y - old.y) / dt, (x.z - old.z) / dt};
  }
}

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

int main(int count, char** values) {
  int cells = 8, substeps = 2000;
  double seconds = 3;
  bool colour = false;
  for (int i = 1; i < count; ++i) {
    if (!std::strcmp(values[i], "--colour")) colour = true;
    if (i + 1 == count) continue;
    if (!std::strcmp(values[i], "--cells")) cells = std::atoi(values[i + 1]);
    if (!std::strcmp(values[i], "--substeps")) substeps = std::atoi(values[i + 1]);
    if (!std::strcmp(values[i], "--seconds")) seconds = std::atof(values[i + 1]);
  }
  Faces faces;
  Body body = bar(cells, faces);
  addEdges(body, faces);
  if (colour) sortByColour(body);
  const size_t vertices = body.position.size();
  body.before = body.position;
  body.velocity.assign(vertices, Point{0, 0, 0});
  body.inverseMass.assign(vertices, Real(vertices) / 280);  // 280 kg of rubber, 2 cm thick
  for (size_t v = 0; v < vertices; ++v)
    if (body.position[v].z < Real(0.1)) body.inverseMass[v] = 0;
  body.compliance = Real(1 / (1e6 * 0.02));
  double least = 1e30;
  for (const double end = now() + seconds; now() < end;) {
    const double start = now();
    for (int i = 0; i < substeps; ++i) substep(body, Real(1 / 60.0 / substeps));
    least = std::min(least, now() - start);
  }
  std::printf("{\"edges\": %zu, \"secondsPerStep\": %.9f, \"edgesPerSecond\": %.0f, \"height\": %g}\n",
              body.edges.size(), least, static_cast<double>(body.edges.size()) * substeps / least,
              static_cast<double>(body.position[0].y));
}
