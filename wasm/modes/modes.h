#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "mesh/triangle_mesh.h"

namespace limber {

enum class Model : int32_t { Laplacian = 0, Shell = 1 };

// SI units; `thickness` is a length in the mesh's own units (the caller knows what it is a percentage of).
struct ModesOptions {
  Model model = Model::Shell;
  int modeCount = 12;    // elastic modes per component
  double thickness = 0;  // > 0
  double young = 0;      // Pa, > 0
  double poisson = 0;    // in (-1, 0.5)
  double density = 0;    // kg/m3, > 0
  double unit = 1;       // metres per unit of the mesh, > 0
};

// One elastic mode of one component.
struct Mode {
  double omega = 0;     // rad/s
  double residual = 0;  // |K phi - lambda M phi| / (lambda |M phi|)
  uint32_t component = 0;
  uint32_t layer = 0;  // it is the component's (layer + 1)-th elastic mode
  int32_t axis = -1;   // laplacian: the principal axis it moves along, 0 shortest .. 2 longest; otherwise -1
};

struct ComponentModes {
  uint32_t faces = 0;
  uint32_t zeroModesExpected = 0;  // 6 for a shell, 3 for a Laplacian
  uint32_t zeroModesFound =
      0;                   // measured: negative pivots of K - s M, s halfway to the first elastic eigenvalue
  uint32_t modeCount = 0;  // elastic modes it has, <= ModesOptions::modeCount (a tiny part has fewer)
};

// Modes of every component, stored in layers: layer k holds, at each vertex, the shape of the (k + 1)-th
// elastic mode of the vertex's own component, so that nothing is stored twice. A component with fewer modes
// is 0 in the rest. A shape's largest displacement is 1; signs are fixed by making the first component of
// that size positive.
struct ModeSet {
  std::vector<Mode> modes;  // ascending by omega (ties by component, then layer)
  std::vector<ComponentModes> components;
  uint32_t layerCount = 0;
  std::vector<float> shapes;    // shapes[(layer * vertexCount + v) * 3 + c]
  uint64_t factorNonzeros = 0;  // of L, the largest component's
};

// Undamped free modes, (K - omega^2 M) phi = 0 (paper Eqs. 1-4), lumped masses.
// Shell: CST membrane and Morley bending of the given thickness (NUMERICS of docs/modes.md). Laplacian: k = 1
// per edge and direction, lumped areas as masses, nominal frequencies; each scalar mode is listed three
// times, once per principal axis, shortest axis first. Throws Cancelled; std::runtime_error with a sentence
// where the solver fails, saying how many modes could be trusted.
ModeSet computeModes(const TriangleMesh& mesh, const ModesOptions& options, Job& job);

}  // namespace limber
