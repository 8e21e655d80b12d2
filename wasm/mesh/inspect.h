#pragma once

#include <cstdint>
#include <optional>

#include "mesh/triangle_mesh.h"

namespace limber {

// What a mesh is like, and what is wrong with it. The shared part of a report's "input" and "output"; counts
// of `weld` (welded vertices, degenerate, duplicate and flipped faces) come from there.
struct Inspection {
  uint32_t vertices = 0, faces = 0;
  uint32_t components = 0;
  uint32_t boundaryLoops = 0;    // closed walks along edges with one face
  std::optional<int64_t> genus;  // sum over components; none where the mesh is non-manifold or not orientable
  int64_t eulerCharacteristic = 0;   // V - E + F
  uint32_t nonManifoldEdges = 0;     // with more than two faces
  uint32_t nonManifoldVertices = 0;  // whose faces are not one fan, apart from ends of non-manifold edges
  uint32_t orientationClashes = 0;   // edges with two faces that run the same way
};

Inspection inspect(const TriangleMesh& mesh);

}  // namespace limber
