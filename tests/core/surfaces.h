#pragma once

// Surfaces of every topology that simplification has to keep, and a slow replay of a history to check it.

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "mesh/repair/weld.h"
#include "shapes.h"
#include "simplify/history.h"

namespace limber::surfaces {

// Positions rounded to float32, as they are in every mesh that has been welded.
inline TriangleMesh inFloats(TriangleMesh mesh) {
  for (Vec3& p : mesh.positions)
    p = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
  return mesh;
}

using Voxel = std::array<int, 3>;

// The surface of a set of unit cubes, two triangles a side, welded. Where cubes meet only in an edge or a
// corner, it is non-manifold.
inline TriangleMesh voxelSurface(const std::set<Voxel>& voxels) {
  std::vector<float> positions;
  std::vector<uint32_t> indices;
  for (const Voxel& voxel : voxels)
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side) {
        Voxel neighbour = voxel;
        neighbour[axis] += side ? 1 : -1;
        if (voxels.count(neighbour)) continue;
        const auto first = static_cast<uint32_t>(positions.size() / 3);
        for (const auto& [u, v] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
          Voxel corner = voxel;
          corner[axis] += side;
          corner[(axis + 1) % 3] += side ? u : v;
          corner[(axis + 2) % 3] += side ? v : u;
          for (int c : corner) positions.push_back(static_cast<float>(c));
        }
        for (uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) indices.push_back(first + i);
      }
  Job job;
  return weld(positions, indices, {}, job).mesh;
}

// A slab of 8 x 5 x 2 cubes with two holes through it: genus 2.
inline TriangleMesh doubleTorus() {
  std::set<Voxel> voxels;
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 5; ++y)
      for (int z = 0; z < 2; ++z)
        if (y != 2 || (x != 2 && x != 5)) voxels.insert({x, y, z});
  return voxelSurface(voxels);
}

// A flat ring around the z axis: two boundary loops.
inline TriangleMesh annulus(int around, int across) {
  TriangleMesh mesh;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j <= across; ++j) {
      const double angle = 2 * std::numbers::pi * i / around, radius = 1 + 1.0 * j / across;
      mesh.positions.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    }
  const auto at = [&](int i, int j) { return static_cast<uint32_t>((i % around) * (across + 1) + j); };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
    }
  return mesh;
}

// Three sheets of n x n cells that share their left side.
inline TriangleMesh threeSheets(int n) {
  TriangleMesh mesh;
  std::map<std::array<int, 3>, uint32_t> index;
  const auto at = [&](int sheet, int i, int j) {
    const auto [entry, added] = index.try_emplace({i == 0 ? 0 : sheet, i, j}, mesh.vertexCount());
    const double angle = 2 * std::numbers::pi * sheet / 3;
    if (added) mesh.positions.push_back({i * std::cos(angle) / n, i * std::sin(angle) / n, 1.0 * j / n});
    return entry->second;
  };
  for (int sheet = 0; sheet < 3; ++sheet)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        mesh.triangles.push_back({at(sheet, i, j), at(sheet, i + 1, j), at(sheet, i + 1, j + 1)});
        mesh.triangles.push_back({at(sheet, i, j), at(sheet, i + 1, j + 1), at(sheet, i, j + 1)});
      }
  return mesh;
}

// A Moebius strip of `cells` cells; its two sides meet with clashing windings.
inline TriangleMesh moebiusStrip(int cells) {
  TriangleMesh mesh;
  for (int i = 0; i < cells; ++i)
    for (int j = -1; j <= 1; ++j) {
      const double angle = 2 * std::numbers::pi * i / cells, radius = 1 + 0.3 * j * std::cos(angle / 2);
      mesh.positions.push_back(
          {radius * std::cos(angle), radius * std::sin(angle), 0.3 * j * std::sin(angle / 2)});
    }
  const auto at = [&](int i, int j) { return static_cast<uint32_t>(i == cells ? 2 - j : 3 * i + j); };
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < 2; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

// Random cubes with jittered corners: many components, handles, non-manifold edges and vertices.
inline TriangleMesh randomVoxels(uint32_t seed) {
  std::mt19937 random(seed);
  std::set<Voxel> voxels;
  for (int x = 0; x < 5; ++x)
    for (int y = 0; y < 5; ++y)
      for (int z = 0; z < 5; ++z)
        if (random() % 5 < 2) voxels.insert({x, y, z});
  return inFloats(shapes::jittered(voxelSurface(voxels), 0.1, seed));
}

struct Named {
  std::string name;
  TriangleMesh mesh;
};

inline std::vector<Named> everyTopology() {
  const auto rough = [](const TriangleMesh& mesh, double size) {
    return inFloats(shapes::jittered(mesh, size, 7));
  };
  std::vector<Named> all{
      {"sphere", inFloats(shapes::sphere(2))},
      {"rough sphere", rough(shapes::sphere(3), 0.02)},
      {"torus", inFloats(shapes::torus(12, 8))},
      {"rough torus", rough(shapes::torus(16, 9), 0.03)},
      {"double torus", doubleTorus()},
      {"rough double torus", rough(doubleTorus(), 0.15)},
      {"sheet", inFloats(shapes::grid(9, 7))},
      {"rough sheet", rough(shapes::grid(9, 7), 0.02)},
      {"annulus", inFloats(annulus(14, 3))},
      {"rough annulus", rough(annulus(14, 3), 0.03)},
      {"three sheets", inFloats(threeSheets(5))},
      {"rough three sheets", rough(threeSheets(5), 0.02)},
      {"Moebius strip", rough(moebiusStrip(20), 0.01)},
      {"several", rough(shapes::together(shapes::together(shapes::sphere(1), shapes::torus(9, 6)),
                                         shapes::together(shapes::grid(4, 4), annulus(9, 2))),
                        0.01)},
  };
  for (uint32_t seed = 1; seed <= 6; ++seed)
    all.push_back({"random voxels, seed " + std::to_string(seed), randomVoxels(seed)});
  return all;
}

// Replays a history one collapse at a time, in the simplest way: every step visits every triangle.
class Replay {
 public:
  Replay(const TriangleMesh& input, const History& history) : history_(history), positions_(input.positions) {
    for (const Triangle& triangle : input.triangles) triangles_.push_back(triangle);
  }

  // Carries out collapse i.
  void step(uint32_t i) {
    const uint32_t kept = history_.kept[i], removed = history_.removed[i];
    positions_[kept] = {history_.positions[3 * i], history_.positions[3 * i + 1],
                        history_.positions[3 * i + 2]};
    for (Triangle& triangle : triangles_) std::ranges::replace(triangle, removed, kept);
    std::erase_if(triangles_, [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  }

  // Both are in terms of the vertices of the input.
  const std::vector<Triangle>& triangles() const { return triangles_; }
  const std::vector<Vec3>& positions() const { return positions_; }

 private:
  const History& history_;
  std::vector<Vec3> positions_;
  std::vector<Triangle> triangles_;
};

// A sphere with bumps: curved everywhere, without symmetry.
inline TriangleMesh bumpySphere() {
  TriangleMesh mesh = shapes::sphere(3);
  for (Vec3& p : mesh.positions)
    p *= 1 + 0.15 * std::sin(3 * p.x + 0.4) * std::cos(4 * p.y) + 0.1 * std::sin(5 * p.z + p.x);
  for (Vec3& p : mesh.positions)
    p = {static_cast<float>(1.3 * p.x), static_cast<float>(p.y), static_cast<float>(0.8 * p.z)};
  return mesh;
}

// Sheets of 1 x 0.5 that share one edge of 1.
inline TriangleMesh sheetsAroundAnEdge(int sheets, int cells) {
  TriangleMesh mesh;
  for (int i = 0; i < sheets; ++i) {
    const double angle = 0.3 + 2.2 * i;
    TriangleMesh sheet = shapes::grid(2 * cells, cells, 1, 0.5);
    for (Vec3& p : sheet.positions) p = {p.x, p.y * std::cos(angle), p.y * std::sin(angle)};
    const uint32_t shared = i > 0 ? 2 * cells + 1 : 0, first = mesh.vertexCount() - shared;
    mesh.positions.insert(mesh.positions.end(), sheet.positions.begin() + shared, sheet.positions.end());
    for (Triangle t : sheet.triangles) {
      for (uint32_t& v : t)
        if (v >= shared) v += first;
      mesh.triangles.push_back(t);
    }
  }
  return mesh;
}

}  // namespace limber::surfaces
