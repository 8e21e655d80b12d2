#include "fit/result_mirror.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace limber {
namespace {

[[noreturn]] void refuse() {
  throw std::invalid_argument("Only a result that is its own mirror image can be fitted as one.");
}

std::vector<uint32_t> partnersIn(const MeshAt& result, std::span<const uint32_t> partners) {
  std::vector<uint32_t> own;
  for (const uint32_t input : result.inputOfVertex) own.push_back(result.vertexOfInput[partners[input]]);
  for (uint32_t v = 0; v < own.size(); ++v)
    if (own[v] >= own.size() || own[own[v]] != v) refuse();
  return own;
}

Triangle sorted(Triangle t) {
  std::ranges::sort(t);
  return t;
}

std::vector<uint32_t> triangleImages(const TriangleMesh& mesh, const std::vector<uint32_t>& partners) {
  std::vector<std::pair<Triangle, uint32_t>> known;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) known.emplace_back(sorted(mesh.triangles[t]), t);
  std::ranges::sort(known);
  std::vector<uint32_t> images;
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::pair<Triangle, uint32_t> image(sorted({partners[a], partners[b], partners[c]}), 0);
    const auto found = std::ranges::lower_bound(known, image);
    if (found == known.end() || found->first != image.first) refuse();
    images.push_back(found->second);
  }
  return images;
}

Vec3 reflected(const Vec3& displacement, const Vec3& normal) {
  return displacement - normal * (2 * dot(normal, displacement));
}

}  // namespace

ResultMirror mirrorOfResult(const TriangleMesh& original, const MeshAt& result,
                            std::span<const uint32_t> partners) {
  if (partners.size() != original.vertexCount()) refuse();
  ResultMirror mirror{partnersIn(result, partners), {}, fitMirrorPlane(original.positions, partners)};
  mirror.triangleImages = triangleImages(result.mesh, mirror.partners);
  return mirror;
}

void MeshMirror::symmetrise(TriangleMesh& mesh) const {
  for (uint32_t v = 0; v < partners.size(); ++v) {
    const uint32_t other = partners[v];
    if (other < v) continue;
    Vec3 &here = mesh.positions[v], &there = mesh.positions[other];
    here = other == v ? plane.onto(here) : (here + plane.image(there)) / 2;
    if (other != v) there = plane.image(here);
  }
}

void MeshMirror::symmetrise(Eigen::Ref<Eigen::MatrixXd> displacements) const {
  for (Eigen::Index column = 0; column < displacements.cols(); ++column) {
    auto moves = displacements.col(column);
    const auto at = [&](uint32_t v) { return moves.segment<3>(3 * static_cast<Eigen::Index>(v)); };
    for (uint32_t v = 0; v < partners.size(); ++v) {
      const uint32_t other = partners[v];
      if (other < v) continue;
      const Vec3 here{at(v)[0], at(v)[1], at(v)[2]}, there{at(other)[0], at(other)[1], at(other)[2]};
      const Vec3 mean = (here + reflected(there, plane.normal)) / 2, image = reflected(mean, plane.normal);
      at(v) << mean.x, mean.y, mean.z;
      if (other != v) at(other) << image.x, image.y, image.z;
    }
  }
}

}  // namespace limber
