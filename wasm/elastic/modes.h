#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// Auto: solid for closed parts, shell for others.
enum class Model : int32_t { Laplacian = 0, Shell = 1, Solid = 2, Auto = 3 };
// What a mode looks like; see modes/mode_character.h.
enum class ModeName : int32_t { Bend = 0, Twist = 1, Stretch = 2, Breathe = 3, Local = 4 };

// SI units; `thickness` is a length in the mesh's own units (the caller knows what it is a percentage of).
struct ModesOptions {
  Model model = Model::Shell;
  int modeCount = 12;    // elastic modes per component
  double thickness = 0;  // > 0
  double young = 0;      // Pa, > 0
  double poisson = 0;    // in (-1, 0.5)
  double density = 0;    // kg/m3, > 0
  double unit = 1;       // metres per unit of the mesh, > 0
  int direction = -1;    // laplacian: 0 x, 1 y, 2 z; -1: every mode along each principal axis in turn
  std::vector<uint32_t> pinned = {};  // vertices that are held in place
};

// One elastic mode of one component.
struct Mode {
  double omega = 0;     // rad/s
  double residual = 0;  // |K phi - lambda M phi| / (lambda |M phi|)
  uint32_t component = 0;
  uint32_t ordinal = 0;  // it is the component's (ordinal + 1)-th elastic mode
  int32_t axis = -1;  // laplacian: the principal axis it moves along, 0 shortest .. 2 longest; otherwise -1
  ModeName name = ModeName::Bend;
};

struct ComponentModes {
  uint32_t faces = 0;
  Model model = Model::Shell;  // never Auto
  uint32_t host = 0;  // the component whose modes it takes part in: itself, but for a cavity of a solid
  // Rigid motions that pins leave: 6 of a free part, 3 for a Laplacian (1 with a direction), 0 for a cavity,
  // whose host has them.
  uint32_t zeroModesExpected = 0;
  uint32_t zeroModesFound =
      0;                   // measured: negative pivots of K - s M, s halfway to the first elastic eigenvalue
  uint32_t modeCount = 0;  // elastic modes it has, <= ModesOptions::modeCount (a tiny part has fewer)
  uint32_t coarseVertices = 0;  // of the copy that was solved in its place; 0: solved as it is
};

// Modes of every component, stored in ordinals: ordinal k holds, at each vertex, the shape of the (k + 1)-th
// elastic mode of the vertex's own component, so that nothing is stored twice. A component with fewer modes
// is 0 in the rest. A cavity has its host's modes. A shape's largest displacement is 1; signs are fixed by
// making the first component of that size positive.
struct ModeSet {
  std::vector<Mode> modes;  // ascending by omega (ties by component, then ordinal)
  std::vector<ComponentModes> components;
  uint32_t modesPerComponent = 0;
  std::vector<float> shapes;    // shapes[(ordinal * vertexCount + v) * 3 + c]
  uint64_t factorNonzeros = 0;  // of L, the largest component's
};

// Undamped modes, (K - omega^2 M) phi = 0 (paper Eqs. 1-4), lumped masses, free but for the pins.
// Shell: CST membrane and Morley bending of the given thickness (docs/modes.md). Solid: a lattice of
// hexahedra through the inside. Laplacian: k = 1 per edge and direction, lumped areas as masses, nominal
// frequencies; each scalar mode is listed three times, once per principal axis, shortest axis first, or once
// along the direction. Throws Cancelled; std::runtime_error with a sentence where the solver fails, saying
// how many modes could be trusted.
ModeSet computeModes(const TriangleMesh& mesh, const ModesOptions& options, Job& job);

}  // namespace limber
