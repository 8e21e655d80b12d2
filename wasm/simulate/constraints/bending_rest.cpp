#include "simulate/constraints/bending_rest.h"

#include <cmath>

#include "simulate/constraints/triangle_rest.h"

namespace limber {

Fold foldOf(const Vec3& apex, const Vec3& start, const Vec3& end, const Vec3& flap) {
  const Vec3 edge = end - start;
  const Vec3 normal = normalized(cross(edge, apex - start)), other = normalized(cross(flap - end, edge));
  return {dot(normal, other), dot(cross(other, normal), normalized(edge))};
}

std::vector<uint32_t> flapsOf(const TriangleMesh& mesh, const Topology& topology) {
  std::vector<uint32_t> flaps(3 * size_t{mesh.triangleCount()}, kNone);
  for (const auto& edge : topology.edges) {
    const auto users = topology.trianglesAt(edge);
    if (users.size() < 2) continue;
    for (size_t use = 0; use < users.size(); ++use) {
      const Triangle &own = mesh.triangles[users[use]],
                     &next = mesh.triangles[users[(use + 1) % users.size()]];
      const auto apex = [&](const Triangle& t) {
        for (uint32_t c = 0; c < 3; ++c)
          if (t[c] != edge.a && t[c] != edge.b) return c;
        return 0u;
      };
      flaps[3 * size_t{users[use]} + apex(own)] = next[apex(next)];
    }
  }
  return flaps;
}

// Let m_e be the unit vector across edge e and E_e the edge. E_f . m_e m_e^T E_g is 0 unless e differs from f
// and g, so s_e = -(l_e / 4 A) E_f . kappa E_g. This gives P^-1 of kappa = P s without inverting a matrix.
std::array<double, 6> bendingCompliance(const TriangleMesh& mesh, uint32_t t, const Sheet& sheet) {
  const TriangleRest rest = triangleRest(mesh, t);
  const double edge[3][2] = {{rest.x2 - rest.x1, rest.y2}, {-rest.x2, -rest.y2}, {rest.x1, 0}};
  double inverse[3][3];  // rows of P^-1, on (kappa_xx, kappa_yy, 2 kappa_xy)
  for (int e = 0; e < 3; ++e) {
    const double *f = edge[(e + 1) % 3], *g = edge[(e + 2) % 3];
    const double scale = -std::hypot(edge[e][0], edge[e][1]) / (4 * rest.area());
    inverse[e][0] = scale * f[0] * g[0];
    inverse[e][1] = scale * f[1] * g[1];
    inverse[e][2] = scale * 0.5 * (f[0] * g[1] + f[1] * g[0]);
  }
  const double nu = sheet.bendingPoisson, softness = 1 / (rest.area() * sheet.bending * (1 - nu * nu));
  // In float the compliance of a needle is singular and its stiffness unbounded, so this fraction is added to
  // the diagonal.
  constexpr double kLoading = 1e-4;
  std::array<double, 6> compliance;
  int at = 0;
  for (int e = 0; e < 3; ++e)
    for (int f = e; f < 3; ++f) {
      const double *a = inverse[e], *b = inverse[f];
      compliance[at++] = (e == f ? 1 + kLoading : 1) * softness *
                         (a[0] * (b[0] - nu * b[1]) + a[1] * (b[1] - nu * b[0]) + 2 * (1 + nu) * a[2] * b[2]);
    }
  return compliance;
}

std::array<double, 6> bendingStiffness(const std::array<double, 6>& compliance,
                                       const std::array<bool, 3>& inner) {
  const auto entry = [&](int e, int f) {
    if (!inner[e] || !inner[f]) return e == f ? 1.0 : 0.0;
    const int index[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
    return compliance[index[e][f]];
  };
  const auto cofactor = [&](int e, int f) {
    const int a = (e + 1) % 3, b = (e + 2) % 3, c = (f + 1) % 3, d = (f + 2) % 3;
    return entry(a, c) * entry(b, d) - entry(a, d) * entry(b, c);
  };
  const double determinant =
      entry(0, 0) * cofactor(0, 0) + entry(0, 1) * cofactor(0, 1) + entry(0, 2) * cofactor(0, 2);
  std::array<double, 6> stiffness;
  int at = 0;
  for (int e = 0; e < 3; ++e)
    for (int f = e; f < 3; ++f) stiffness[at++] = inner[e] && inner[f] ? cofactor(e, f) / determinant : 0.0;
  return stiffness;
}

}  // namespace limber
