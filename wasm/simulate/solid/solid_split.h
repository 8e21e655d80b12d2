#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/component_frame.h"
#include "simulate/simulation_options.h"

namespace limber {

// A body divided into its open components, which are sheets, and its closed ones, which are solids.
struct SolidSplit {
  explicit SolidSplit(const TriangleMesh& mesh);

  // Divides the pins and records to which part each of the body's pins belongs.
  void splitPins(const Pins& pins);
  // The same point in the sheets or in the solids, whichever has its triangle.
  SurfacePoint local(const SurfacePoint& point) const;
  // The values that belong to these indices, in their order.
  static std::vector<Vec3> chosen(std::span<const Vec3> values, std::span<const uint32_t> indices);

  TriangleMesh sheets, solids;  // in units of the body; vertices in the order of the body
  double sheetArea = 0;
  std::vector<uint32_t> sheetVertices, solidVertices;  // their ids in the body
  std::vector<uint32_t> componentOfVertex;             // of the body, see Topology
  std::vector<uint8_t> isSolidVertex, isSolidTriangle;
  std::vector<uint32_t> localVertex, localTriangle;  // per vertex and triangle: the index in sheets or solids
  Pins sheetPins, solidPins;
  std::vector<uint32_t> sheetPinIndices, solidPinIndices;  // per pin: its index among those of the body
  uint32_t edgeCount;                                      // of the body
  double diagonal;                                         // of the body, in its units
};

}  // namespace limber
