#include "simplify/symmetry/mirror_splits.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "mesh/edge_flip.h"
#include "mesh/topology.h"

namespace limber {
namespace {

// Flips edges of quads until each triangle has an image.
class Matching {
 public:
  Matching(const TriangleMesh& mesh, std::span<const uint32_t> partners, const MirrorPlane& plane,
           const Charts& charts)
      : mesh_(mesh),
        partners_(partners),
        plane_(plane),
        charts_(charts),
        topology_(buildIncidence(mesh)),
        isAsymmetric_(asymmetricTriangles(mesh, partners)),
        isDone_(mesh.triangleCount(), 0),
        flipped_(mesh),
        corners_(3 * size_t{mesh.triangleCount()}) {
    std::iota(corners_.begin(), corners_.end(), 0u);
  }

  std::vector<uint32_t> run() {
    for (const Topology::Edge& edge : topology_.edges) match(edge);
    if (trianglesWithoutImage(flipped_, partners_) > 0) return {};
    return std::move(corners_);
  }

 private:
  void match(const Topology::Edge& edge);
  std::optional<EdgeQuad> imageOf(const EdgeQuad& quad) const;
  bool isOpen(const EdgeQuad& quad) const {
    return isAsymmetric_[quad.first] && isAsymmetric_[quad.second] && !isDone_[quad.first] &&
           !isDone_[quad.second];
  }
  bool canFlip(const EdgeQuad& quad) const;
  bool isSeam(const EdgeQuad& quad) const;
  double heightOf(const EdgeQuad& quad) const;

  const TriangleMesh& mesh_;
  std::span<const uint32_t> partners_;
  MirrorPlane plane_;
  Charts charts_;
  Topology topology_;
  std::vector<uint8_t> isAsymmetric_, isDone_;  // per triangle
  TriangleMesh flipped_;
  std::vector<uint32_t> corners_;
};

// Each pair of quads is visited at both diagonals; the first visit decides.
void Matching::match(const Topology::Edge& edge) {
  const std::optional<EdgeQuad> quad = quadAt(mesh_, topology_, edge);
  if (!quad || !isOpen(*quad)) return;
  const std::optional<EdgeQuad> image = imageOf(*quad);
  if (!image || !isOpen(*image)) return;
  const bool isImageLower = heightOf(*image) < heightOf(*quad);
  const EdgeQuad& lower = isImageLower ? *image : *quad;
  const EdgeQuad& upper = isImageLower ? *quad : *image;
  if (!canFlip(lower) && !canFlip(upper)) return;
  flipEdge(canFlip(lower) ? lower : upper, flipped_, corners_);
  for (const uint32_t t : {quad->first, quad->second, image->first, image->second}) isDone_[t] = 1;
}

// The quad of the images of the vertices, if it is split along the other diagonal and is not the same quad.
std::optional<EdgeQuad> Matching::imageOf(const EdgeQuad& quad) const {
  const Topology::Edge* edge = edgeBetween(topology_, partners_[quad.left], partners_[quad.right]);
  if (!edge) return std::nullopt;
  const std::optional<EdgeQuad> image = quadAt(mesh_, topology_, *edge);
  if (!image || image->first == quad.first || image->first == quad.second) return std::nullopt;
  const auto tips = std::minmax(image->left, image->right);
  if (tips != std::minmax(partners_[quad.start], partners_[quad.end])) return std::nullopt;
  return image;
}

bool Matching::canFlip(const EdgeQuad& quad) const {
  return !isSeam(quad) && !edgeBetween(topology_, quad.left, quad.right);
}

bool Matching::isSeam(const EdgeQuad& quad) const {
  const auto differ = [&](uint32_t c, uint32_t d) {
    return charts_.wedges[Corner(quad.first, (quad.firstTip + c) % 3).flatIndex()] !=
           charts_.wedges[Corner(quad.second, (quad.secondTip + d) % 3).flatIndex()];
  };
  if (!charts_.groups.empty() && charts_.groups[quad.first] != charts_.groups[quad.second]) return true;
  return !charts_.wedges.empty() && (differ(1, 2) || differ(2, 1));
}

double Matching::heightOf(const EdgeQuad& quad) const {
  double sum = 0;
  for (const uint32_t v : {quad.left, quad.start, quad.end, quad.right})
    sum += plane_.height(mesh_.positions[v]);
  return sum;
}

}  // namespace

std::vector<uint32_t> matchSplits(const TriangleMesh& mesh, std::span<const uint32_t> partners,
                                  const MirrorPlane& plane, const Charts& charts) {
  return Matching(mesh, partners, plane, charts).run();
}

}  // namespace limber
