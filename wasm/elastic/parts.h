#pragma once

#include <cstdint>
#include <vector>

#include "elastic/modes.h"
#include "mesh/topology.h"

namespace limber {

// What vibrates as one: a connected component, or, for the solid model, an outer surface together with its
// cavities. It is in its own frame: translated and scaled so that the bounding box starts at 0 and its
// diagonal is 1.
struct Part {
  TriangleMesh mesh;
  ElasticModel model = ElasticModel::Shell;  // never Auto
  std::vector<uint32_t> vertexOfBody;        // per vertex: its id in the body
  std::vector<uint32_t> componentOfVertex;   // per vertex: its component of the body
  std::vector<uint32_t> components;          // of the body, the host first
  std::vector<uint32_t> pinned;              // vertices of this part, ascending
  double diagonal = 0;                       // length of the frame's unit, in units of the body
};

// The parts of a body, ordered by their hosts. Throws std::invalid_argument if the solid model is requested
// for a part without an inside, or if a pinned vertex does not exist.
std::vector<Part> partsOf(const TriangleMesh& body, const Topology& topology, const ModesOptions& options);

}  // namespace limber
