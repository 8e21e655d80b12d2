#pragma once

// Small meshes that the tests share. All are wound outwards and, unless said, closed.

#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <random>
#include <utility>

#include "mesh/triangle_mesh.h"

namespace limber::shapes {

// A flat grid in the xy plane, cellsX * cellsY cells of two triangles each, normals along +z. Open.
inline TriangleMesh grid(int cellsX, int cellsY, double width = 1, double height = 1) {
  TriangleMesh mesh;
  for (int j = 0; j <= cellsY; ++j)
    for (int i = 0; i <= cellsX; ++i) mesh.positions.push_back({width * i / cellsX, height * j / cellsY, 0});
  const auto at = [&](int i, int j) { return static_cast<uint32_t>(j * (cellsX + 1) + i); };
  for (int j = 0; j < cellsY; ++j)
    for (int i = 0; i < cellsX; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

// The surface of a box of cells[0] x cells[1] x cells[2] cells of the given edge length; the paper's bar is
// 8, 8, 24, 1/8.
inline TriangleMesh box(int cellsX, int cellsY, int cellsZ, double cell) {
  TriangleMesh mesh;
  const int cells[3] = {cellsX, cellsY, cellsZ};
  std::map<std::array<int, 3>, uint32_t> index;
  const auto at = [&](std::array<int, 3> p) {
    const auto [entry, added] = index.try_emplace(p, mesh.vertexCount());
    if (added) mesh.positions.push_back({p[0] * cell, p[1] * cell, p[2] * cell});
    return entry->second;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (int j = 0; j < cells[v]; ++j)
        for (int i = 0; i < cells[u]; ++i) {
          std::array<std::array<int, 3>, 4> q{};
          const int offsets[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
          for (int k = 0; k < 4; ++k) {
            q[k][axis] = side ? cells[axis] : 0;
            q[k][u] = i + offsets[k][0];
            q[k][v] = j + offsets[k][1];
          }
          if (!side) std::swap(q[1], q[3]);
          mesh.triangles.push_back({at(q[0]), at(q[1]), at(q[2])});
          mesh.triangles.push_back({at(q[0]), at(q[2]), at(q[3])});
        }
    }
  return mesh;
}

// An icosahedron subdivided `levels` times, 20 * 4^levels triangles on a sphere around the origin.
inline TriangleMesh sphere(int levels, double radius = 1) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  TriangleMesh mesh;
  mesh.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                    {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
    const auto middle = [&](uint32_t a, uint32_t b) {
      const auto [entry, added] = middles.try_emplace(std::minmax(a, b), mesh.vertexCount());
      if (added) mesh.positions.push_back((mesh.positions[a] + mesh.positions[b]) * 0.5);
      return entry->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    mesh.triangles = finer;
  }
  for (auto& p : mesh.positions) p = normalized(p) * radius;
  return mesh;
}

// A torus around the z axis, genus 1.
inline TriangleMesh torus(int around, int across, double majorRadius = 1, double minorRadius = 0.35) {
  TriangleMesh mesh;
  const double circle = 2 * std::numbers::pi;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double u = circle * i / around, v = circle * j / across,
                   r = majorRadius + minorRadius * std::cos(v);
      mesh.positions.push_back({r * std::cos(u), r * std::sin(u), minorRadius * std::sin(v)});
    }
  const auto at = [&](int i, int j) { return static_cast<uint32_t>((i % around) * across + j % across); };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

// Two meshes as one, without shared vertices.
inline TriangleMesh together(TriangleMesh a, const TriangleMesh& b) {
  const uint32_t offset = a.vertexCount();
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const auto& t : b.triangles) a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  return a;
}

// Moves every vertex by up to `size` along each axis, reproducibly.
inline TriangleMesh jittered(TriangleMesh mesh, double size, uint32_t seed) {
  std::mt19937 random(seed);
  const auto offset = [&] { return size * (2.0 * random() / 4294967295.0 - 1); };
  for (auto& p : mesh.positions) p += Vec3{offset(), offset(), offset()};
  return mesh;
}

}  // namespace limber::shapes
