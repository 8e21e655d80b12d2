#pragma once

// The topology that every simplification keeps.

#include <gtest/gtest.h>

#include "mesh/repair/inspect.h"

namespace limber {

inline void expectSameTopology(const TriangleMesh& a, const TriangleMesh& b) {
  const Inspection before = inspect(a), after = inspect(b);
  ASSERT_EQ(after.components, before.components);
  ASSERT_EQ(after.boundaryLoops, before.boundaryLoops);
  ASSERT_EQ(after.genus, before.genus);
  ASSERT_EQ(after.eulerCharacteristic, before.eulerCharacteristic);
  ASSERT_EQ(after.nonManifoldEdges, before.nonManifoldEdges);
  ASSERT_EQ(after.nonManifoldVertices, before.nonManifoldVertices);
}

}  // namespace limber
