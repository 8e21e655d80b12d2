#pragma once

#include <cstdint>
#include <vector>

#include "elastic/modes.h"
#include "mesh/topology.h"

namespace limber {

// What vibrates on its own: a connected component, or, for the solid model, an outer shell with its cavities.
// Moved and scaled so that its box starts at 0 and its diagonal is 1.
struct Part {
  TriangleMesh mesh;
  Model model = Model::Shell;               // never Auto
  std::vector<uint32_t> vertexOfBody;       // per vertex
  std::vector<uint32_t> componentOfVertex;  // the body's, per vertex
  std::vector<uint32_t> components;         // the body's, the host first
  std::vector<uint32_t> pinned;             // vertices of this part, ascending
  double diagonal = 0;                      // in units of the body
};

// The parts of a body in the order of their hosts. Auto takes the solid model for closed parts and the shell
// for others. Throws std::invalid_argument where the solid model is asked for a part without an inside, or a
// pinned vertex does not exist.
std::vector<Part> partsOf(const TriangleMesh& body, const Topology& topology, const ModesOptions& options);

}  // namespace limber
