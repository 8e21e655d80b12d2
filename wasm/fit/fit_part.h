#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fit/flat_regions.h"
#include "fit/result_mirror.h"
#include "fit/surface_fit.h"
#include "mesh/triangle_mesh.h"
#include "modes/vertex_limits.h"
#include "simplify/history.h"
#include "transfer/chart_sides.h"

namespace limber {

// A component of the original and what has become of it, in the frame where the original's diagonal is 1.
struct FitPart {
  TriangleMesh original, simplified;
  std::vector<uint32_t> vertexOfResult;          // per vertex of `simplified`
  std::vector<uint32_t> triangleOfResult;        // per triangle of it
  std::vector<uint8_t> locked;                   // per vertex of it
  std::vector<uint32_t> pinnedOriginal, pinned;  // vertices of both
  EdgeList originalFeatures, lines;              // seams that stay in place, of both meshes
  FlatRegions flats;                             // of `simplified`
  EdgeList fixedEdges;                           // seams of `simplified`, and what they are images of
  Vec3 origin;
  double diagonal = 1;
  bool isLarge = false;              // more vertices in `simplified` than largeVertices
  std::optional<MeshMirror> mirror;  // of `simplified`, where it is its own image
  bool hasImage = false;             // another part is its image, which is left out

  std::span<const uint32_t> partners() const {
    return mirror ? std::span<const uint32_t>(mirror->partners) : std::span<const uint32_t>();
  }
};

struct FitPartOptions {
  Charts charts = {};                                 // of the original
  bool holdsSeams = true;                             // all of them, else those between groups alone
  std::span<const uint8_t> locked = {}, pinned = {};  // per vertex of the original
  const ResultMirror* mirror = nullptr;               // where the result is its own image
  uint32_t fewestFaces = 12;                          // results of fewer are left out
  uint32_t largeVertices = kLargeResultVertices;      // results of more are large ...
  uint32_t mostOriginal = kRefinedVertices;  // ... and left out where the original has more than this
};

// The components of the original, each with its result; of two that are images of each other the first.
struct FitParts {
  std::vector<FitPart> parts;
  uint32_t tooLarge = 0;  // left out because they are large
};
FitParts fitParts(const TriangleMesh& original, const MeshAt& simplified, const FitPartOptions& options);

}  // namespace limber
