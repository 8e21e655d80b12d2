#pragma once

// Simplified meshes as targets of transfers.

#include "simplify/history.h"
#include "simplify/simplify.h"

namespace limber {

inline MeshAt reduced(const TriangleMesh& mesh, uint32_t faces) {
  Job job;
  return meshAt(mesh, simplify(mesh, {}, {.method = Method::Qem}, job), faces);
}

}  // namespace limber
