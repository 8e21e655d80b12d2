#pragma once

// Meshes that are their own mirror image across x = 0, and a way to check that.

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

#include "shapes.h"
#include "surfaces.h"

namespace limber::mirrored {

// A mesh, its image across x = 0, and the image of each vertex. Vertices with x = 0 are shared.
struct Doubled {
  TriangleMesh mesh;
  std::vector<uint32_t> mirror;
};
inline Doubled doubled(const TriangleMesh& half) {
  Doubled whole{half, {}};
  for (uint32_t v = 0; v < half.vertexCount(); ++v) {
    const Vec3& p = half.positions[v];
    whole.mirror.push_back(p.x == 0 ? v : whole.mesh.vertexCount());
    if (p.x != 0) whole.mesh.positions.push_back({-p.x, p.y, p.z});
  }
  for (const auto& [a, b, c] : half.triangles)
    whole.mesh.triangles.push_back({whole.mirror[a], whole.mirror[c], whole.mirror[b]});
  whole.mirror.resize(whole.mesh.vertexCount());
  for (uint32_t v = 0; v < half.vertexCount(); ++v) whole.mirror[whole.mirror[v]] = v;
  return whole;
}

// A rough sheet, its left side on the plane.
inline Doubled sheet() {
  TriangleMesh half = shapes::jittered(shapes::grid(12, 10), 0.02, 6);
  for (int j = 0; j <= 10; ++j) half.positions[13 * j].x = 0;
  return doubled(surfaces::inFloats(half));
}

// Half of a box, open where it lies on the plane: whole, it is closed.
inline Doubled box() {
  TriangleMesh half = surfaces::inFloats(shapes::jittered(shapes::box(5, 4, 6, 0.25), 0.01, 3));
  std::erase_if(half.triangles, [&](const Triangle& t) {
    return std::ranges::all_of(t, [&](uint32_t v) { return half.positions[v].x < 0.1; });
  });
  for (Vec3& p : half.positions)
    if (p.x < 0.1) p.x = 0;
  TriangleMesh used;
  std::vector<uint32_t> number(half.vertexCount(), kNone);
  for (Triangle t : half.triangles) {
    for (uint32_t& v : t) {
      if (number[v] == kNone) {
        number[v] = used.vertexCount();
        used.positions.push_back(half.positions[v]);
      }
      v = number[v];
    }
    used.triangles.push_back(t);
  }
  return doubled(used);
}

// A rough ball, flattened to `height` along y.
inline Doubled ball(int levels, double height) {
  const TriangleMesh smooth = shapes::sphere(levels);
  Doubled whole{smooth, {}};
  for (uint32_t v = 0; v < smooth.vertexCount(); ++v) {
    const Vec3& p = smooth.positions[v];
    const auto isImage = [&](const Vec3& q) { return length(Vec3{-p.x, p.y, p.z} - q) < 1e-9; };
    const auto found = std::ranges::find_if(smooth.positions, isImage);
    whole.mirror.push_back(static_cast<uint32_t>(found - smooth.positions.begin()));
  }
  for (uint32_t v = 0; v < smooth.vertexCount(); ++v) {
    const uint32_t first = std::min(v, whole.mirror[v]);
    const Vec3 p = smooth.positions[first] * (1 + 0.005 * (first * 7919 % 31));
    const double x = whole.mirror[v] == v ? 0 : v == first ? p.x : -p.x;
    whole.mesh.positions[v] = {x, height * p.y, p.z};
  }
  whole.mesh = surfaces::inFloats(whole.mesh);
  return whole;
}

using Corner3 = std::tuple<double, double, double>;
using Face = std::array<Corner3, 3>;

// The triangles by their positions, the lowest corner first; `side` = -1 gives those of the image.
inline std::vector<Face> facesOf(const TriangleMesh& mesh, double side) {
  std::vector<Face> faces;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    Face face;
    for (int c = 0; c < 3; ++c) {
      const Vec3& p = mesh.corner(t, side < 0 ? 2 - c : c);
      face[c] = {side * p.x + 0.0, p.y, p.z};
    }
    std::ranges::rotate(face, std::ranges::min_element(face));
    faces.push_back(face);
  }
  std::ranges::sort(faces);
  return faces;
}

}  // namespace limber::mirrored
