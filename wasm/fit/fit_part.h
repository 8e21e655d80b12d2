#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fit/fit_constraints.h"
#include "fit/result_mirror.h"
#include "fit/surface/feature_segments.h"
#include "fit/surface/flat_regions.h"
#include "mesh/component_frame.h"
#include "mesh/pinned_vertices.h"
#include "mesh/triangle_mesh.h"
#include "simplify/history.h"

namespace limber {

// A component of the original and the corresponding component of the result, each with ids of its own, in the
// frame where the diagonal of the original's component is 1.
struct FitPart {
  TriangleMesh original, result;
  std::vector<uint32_t> wholeVertex;    // per vertex of `result`: its id in the whole result
  std::vector<uint32_t> wholeTriangle;  // per triangle of `result`: its index in the whole result
  std::vector<uint8_t> locked;          // per vertex of `result`: 1 if it stays in place, else 0
  // Of both meshes; empty if the pins leave a rigid motion free.
  PinnedVertices pinnedOriginal, pinnedResult;
  EdgeList originalFeatureEdges, featureEdges;  // seams that stay in place, of `original` and of `result`
  EdgeList fixedEdges;                          // edges of `result` that are not flipped
  FlatRegions flatRegions;                      // of `result`; initially none
  UnitFrame frame;
  bool isLarge = false;              // whether `result` has more than FitConstraints::largeVertices
  std::optional<MeshMirror> mirror;  // of `result`, if it is its own mirror image
  bool hasImage = false;             // whether another component is its mirror image, which is skipped

  // Locks a vertex of `result` together with its mirror image.
  void lock(uint32_t v) {
    locked[v] = 1;
    if (mirror) locked[mirror->partners[v]] = 1;
  }

  // The mirror image of each vertex of `result`; empty without symmetry.
  std::span<const uint32_t> partners() const {
    return mirror ? std::span<const uint32_t>(mirror->partners) : std::span<const uint32_t>();
  }
};

// The components that are fitted, in the order of their ids. Components with very few faces, components that
// are too large, and the second of two components that are mirror images of each other are skipped.
struct FitParts {
  std::vector<FitPart> parts;
  uint32_t tooLarge = 0;  // components that are skipped because of FitConstraints::mostOriginal
};

// `mirror`: null if the result is not its own mirror image.
FitParts findFitParts(const TriangleMesh& original, const MeshAt& result, const FitConstraints& constraints,
                      const ResultMirror* mirror);

}  // namespace limber
