#include "fit/fit_part.h"

#include <utility>

#include "elastic/pins.h"
#include "fit/fit_edges.h"
#include "mesh/topology.h"

namespace limber {

namespace {

constexpr size_t kFewestFaces = 12;  // of the result of a component that is fitted

// Per vertex of the result: 1 if a marked vertex of the original was merged into it.
std::vector<uint8_t> carriedMarks(const MeshAt& result, std::span<const uint8_t> marks) {
  std::vector<uint8_t> carried(result.mesh.vertexCount(), 0);
  for (uint32_t v = 0; v < marks.size(); ++v)
    if (marks[v] && result.vertexOfInput[v] != kNone) carried[result.vertexOfInput[v]] = 1;
  return carried;
}

// Per component its edges, by its own vertex ids.
std::vector<EdgeList> splitEdges(const EdgeList& edges, const MeshParts& parts,
                                 const std::vector<uint32_t>& componentOfVertex) {
  std::vector<EdgeList> lists(parts.parts.size());
  for (const auto& [a, b] : edges)
    lists[componentOfVertex[a]].push_back({parts.localVertex[a], parts.localVertex[b]});
  return lists;
}

// The pinned vertices of a part, given marks of the whole mesh. None if they leave it a rigid motion, or no
// vertex to move.
PinnedVertices pinnedIn(const MeshParts::Part& part, const std::vector<uint8_t>& isPinned) {
  std::vector<uint32_t> pinned;
  for (uint32_t v = 0; v < part.vertices.size(); ++v)
    if (isPinned[part.vertices[v]]) pinned.push_back(v);
  const bool isFixed = rigidMotionsLeft(part.mesh, pinned) == 0 && pinned.size() < part.vertices.size();
  return isFixed ? PinnedVertices(std::move(pinned)) : PinnedVertices();
}

class PartFinder {
 public:
  PartFinder(const TriangleMesh& original, const MeshAt& result, const FitConstraints& constraints,
             const ResultMirror* mirror);

  FitParts find();

 private:
  void markVertices(const TriangleMesh& original, const MeshAt& result);
  uint32_t imageOf(uint32_t component) const;
  FitPart take(uint32_t component);
  void takeMeshes(uint32_t component, FitPart& part);
  MeshMirror mirrorOf(const FitPart& part) const;

  const FitConstraints& constraints_;
  const ResultMirror* mirror_;
  Topology topology_;                                                       // of the original
  std::vector<uint32_t> componentOfResult_;                                 // per vertex of the result
  std::vector<uint8_t> isPinned_;                                           // per vertex of the original
  std::vector<uint8_t> isResultPinned_, locked_;                            // per vertex of the result
  MeshParts originals_, results_;                                           // by component
  std::vector<EdgeList> originalFeatureEdges_, featureEdges_, fixedEdges_;  // by component
};

PartFinder::PartFinder(const TriangleMesh& original, const MeshAt& result, const FitConstraints& constraints,
                       const ResultMirror* mirror)
    : constraints_(constraints), mirror_(mirror), topology_(buildTopology(original)) {
  for (const uint32_t v : result.inputOfVertex) componentOfResult_.push_back(topology_.componentOfVertex[v]);
  markVertices(original, result);
  originals_ = splitMesh(original, topology_.componentOfVertex, topology_.componentCount);
  results_ = splitMesh(result.mesh, componentOfResult_, topology_.componentCount);
  const FitEdges edges = findFitEdges({original, topology_, result, mirror}, constraints);
  originalFeatureEdges_ = splitEdges(edges.original, originals_, topology_.componentOfVertex);
  featureEdges_ = splitEdges(edges.result, results_, componentOfResult_);
  fixedEdges_ = splitEdges(edges.fixed, results_, componentOfResult_);
}

// A pinned vertex is locked too, and so is the mirror image of a locked vertex.
void PartFinder::markVertices(const TriangleMesh& original, const MeshAt& result) {
  isPinned_ = constraints_.pinned.mask(original.vertexCount());
  isResultPinned_ = carriedMarks(result, isPinned_);
  locked_ = carriedMarks(result, constraints_.locked);
  for (uint32_t v = 0; v < locked_.size(); ++v) locked_[v] |= isResultPinned_[v];
  if (!mirror_) return;
  for (uint32_t v = 0; v < locked_.size(); ++v)
    if (locked_[v]) locked_[mirror_->partners[v]] = 1;
}

FitParts PartFinder::find() {
  FitParts found;
  for (uint32_t component = 0; component < topology_.componentCount; ++component) {
    const MeshParts::Part& result = results_.parts[component];
    if (result.triangles.size() < kFewestFaces || imageOf(component) < component) continue;
    const bool isLarge = result.vertices.size() > constraints_.largeVertices;
    if (isLarge && originals_.parts[component].vertices.size() > constraints_.mostOriginal) {
      ++found.tooLarge;
      continue;
    }
    found.parts.push_back(take(component));
    found.parts.back().isLarge = isLarge;
  }
  return found;
}

// The component that is the mirror image of this one, which may be itself.
uint32_t PartFinder::imageOf(uint32_t component) const {
  return mirror_ ? componentOfResult_[mirror_->partners[results_.parts[component].vertices[0]]] : component;
}

FitPart PartFinder::take(uint32_t component) {
  FitPart part;
  part.hasImage = imageOf(component) != component;
  part.frame = unitFrame(originals_.parts[component].mesh);
  moveToFrame(originals_.parts[component].mesh, part.frame);
  moveToFrame(results_.parts[component].mesh, part.frame);
  part.originalFeatureEdges = std::move(originalFeatureEdges_[component]);
  part.featureEdges = std::move(featureEdges_[component]);
  part.fixedEdges = std::move(fixedEdges_[component]);
  for (const uint32_t v : results_.parts[component].vertices) part.locked.push_back(locked_[v]);
  takeMeshes(component, part);
  return part;
}

// Pins are checked on the meshes after the result has been made symmetric.
void PartFinder::takeMeshes(uint32_t component, FitPart& part) {
  MeshParts::Part &original = originals_.parts[component], &result = results_.parts[component];
  part.wholeVertex = result.vertices;
  part.wholeTriangle = std::move(result.triangles);
  if (mirror_ && !part.hasImage) {
    part.mirror = mirrorOf(part);
    part.mirror->symmetrise(result.mesh);
  }
  part.pinnedOriginal = pinnedIn(original, isPinned_);
  part.pinnedResult = pinnedIn(result, isResultPinned_);
  if (part.pinnedResult.empty() || part.pinnedOriginal.empty()) part.pinnedResult = part.pinnedOriginal = {};
  part.original = std::move(original.mesh);
  part.result = std::move(result.mesh);
}

// The mirror of the whole result in the ids and the frame of a part.
MeshMirror PartFinder::mirrorOf(const FitPart& part) const {
  const auto& [normal, offset] = mirror_->plane;
  MeshMirror mirror{{}, {normal, (offset - dot(normal, part.frame.origin)) / part.frame.diagonal}};
  for (const uint32_t v : part.wholeVertex)
    mirror.partners.push_back(results_.localVertex[mirror_->partners[v]]);
  return mirror;
}

}  // namespace

FitParts findFitParts(const TriangleMesh& original, const MeshAt& result, const FitConstraints& constraints,
                      const ResultMirror* mirror) {
  return PartFinder(original, result, constraints, mirror).find();
}

}  // namespace limber
