#include "simplify/symmetry/mirror_images.h"

#include <tuple>

#include "base/parallel.h"
#include "mesh/principal_axes.h"
#include "query/nearest.h"
#include "simplify/symmetry/mirror.h"
#include "simplify/symmetry/mirror_splits.h"

namespace limber {
namespace {

// Of the diagonal; half of the tolerance of Mirror, whose plane differs slightly.
constexpr double kTolerance = 5e-5;
constexpr size_t kVerticesPerRange = 1024;

std::vector<MirrorPlane> candidates(const TriangleMesh& mesh, int axis) {
  // The axes of the vertices, because areas depend on how quads are split.
  const std::vector<double> weights(mesh.vertexCount(), 1);
  const PrincipalAxes principal = principalAxes(mesh.positions, weights);
  std::vector<MirrorPlane> planes;
  const auto add = [&](const Vec3& normal) { planes.push_back({normal, dot(normal, principal.centre)}); };
  const Vec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int k = 0; k < 3; ++k)
    if (axis == k || axis == kAnyAxis) add(axes[k]);
  if (axis == kAnyAxis)
    for (int k = 2; k >= 0; --k) add(principal.axis[static_cast<size_t>(k)]);
  return planes;
}

// Per vertex the vertex at its image, or kNone if there is none or the images are not mutual.
std::vector<uint32_t> partnersAcross(const TriangleMesh& mesh, const NearestVertex& nearest,
                                     const MirrorPlane& plane, Job& job) {
  const double limit = kTolerance * bounds(mesh).diagonal();
  std::vector<uint32_t> found(mesh.vertexCount(), kNone);
  parallelFor(found.size(), kVerticesPerRange, [&](size_t begin, size_t end) {
    job.check();
    auto guess = static_cast<uint32_t>(begin);
    for (size_t v = begin; v < end; ++v) {
      const Vec3 image = plane.image(mesh.positions[v]);
      guess = nearest.find(image, guess);
      if (length(mesh.positions[guess] - image) <= limit) found[v] = guess;
    }
  });
  std::vector<uint32_t> partners = found;
  for (uint32_t v = 0; v < found.size(); ++v)
    if (found[v] != kNone && found[found[v]] != v) partners[v] = kNone;
  return partners;
}

bool liesOnPlane(const std::vector<uint32_t>& partners) {
  for (uint32_t v = 0; v < partners.size(); ++v)
    if (partners[v] != v) return false;
  return true;
}

struct MirrorSearch {
  const TriangleMesh& mesh;
  const Charts& charts;
  const NearestVertex& nearest;
};

MirrorImages imagesAcross(const MirrorSearch& search, const MirrorPlane& plane, Job& job) {
  const auto& [mesh, charts, nearest] = search;
  MirrorImages images;
  std::vector<uint32_t> partners = partnersAcross(mesh, nearest, plane, job);
  for (const uint32_t partner : partners) images.asymmetricVertices += partner == kNone;
  // The plane of a flat mesh does not count as a symmetry plane.
  if (liesOnPlane(partners)) images.asymmetricVertices = mesh.vertexCount();
  if (images.asymmetricVertices > 0) return images;
  images.asymmetricTriangles = trianglesWithoutImage(mesh, partners);
  if (images.asymmetricTriangles > 0) images.corners = matchSplits(mesh, partners, plane, charts);
  if (images.asymmetricTriangles == 0 || !images.corners.empty()) images.partners = std::move(partners);
  return images;
}

}  // namespace

MirrorImages findMirrorImages(const TriangleMesh& mesh, const Charts& charts, int axis, Job& job) {
  job.begin(Phase::Mirror);
  const NearestVertex nearest(mesh);
  const std::vector<MirrorPlane> planes = candidates(mesh, axis);
  MirrorImages best;
  for (size_t i = 0; i < planes.size(); ++i) {
    job.report(static_cast<double>(i) / static_cast<double>(planes.size()));
    MirrorImages images = imagesAcross({mesh, charts, nearest}, planes[i], job);
    const auto rank = [](const MirrorImages& of) {
      return std::tuple(of.partners.empty(), of.asymmetricVertices, of.asymmetricTriangles);
    };
    if (i == 0 || rank(images) < rank(best)) best = std::move(images);
    if (best.asymmetricVertices == 0 && best.asymmetricTriangles == 0) break;
  }
  return best;
}

}  // namespace limber
