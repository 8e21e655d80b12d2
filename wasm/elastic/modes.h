#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/job.h"
#include "elastic/material.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// How the stiffness of a part is discretised. Auto: solid for closed parts, shell for others.
enum class ElasticModel : int32_t { Laplacian = 0, Shell = 1, Solid = 2, Auto = 3 };
// The kind of motion of a mode; see elastic/mode_character.h.
enum class ModeName : int32_t { Bend = 0, Twist = 1, Stretch = 2, Breathe = 3, Local = 4 };

struct ModesOptions {
  ElasticModel model = ElasticModel::Shell;
  int modeCount = 12;  // elastic modes per component, >= 1
  ElasticMaterial material;
  int direction = -1;  // laplacian: 0 x, 1 y, 2 z; -1: each mode along all principal axes in turn
  std::vector<uint32_t> pinned = {};  // ids of the pinned vertices, in any order
  // If modes are only needed for guidance: for findModes the number of bodies in the file (it counts the
  // parts of this body itself), otherwise the number of all parts. Solid parts are then solved on coarser
  // lattices, see latticeCells. 0: modes whose frequencies matter, on the finer lattice that these need.
  uint32_t guidedParts = 0;
};

// One elastic mode of one component.
struct Mode {
  double omega = 0;     // rad/s
  double residual = 0;  // |K phi - lambda M phi| / (lambda |M phi|)
  uint32_t component = 0;
  uint32_t ordinal = 0;  // this is the component's (ordinal + 1)-th elastic mode
  int32_t axis = -1;  // laplacian: the principal axis it moves along, 0 shortest .. 2 longest; otherwise -1
  ModeName name = ModeName::Bend;
};

struct ComponentModes {
  uint32_t faces = 0;
  ElasticModel model = ElasticModel::Shell;  // never Auto
  uint32_t host = 0;  // the component whose modes it shares: its own id, except for a cavity of a solid
  // The number of rigid motions that the pins leave free: 6 for a free part, 3 for a Laplacian (1 with a
  // direction), 0 for a cavity, whose host has them.
  uint32_t zeroModesExpected = 0;
  uint32_t zeroModesFound = 0;  // counted by the solver (EigenSolution::nullity)
  uint32_t modeCount = 0;       // its elastic modes, at most ModesOptions::modeCount (a tiny part has fewer)
  uint32_t coarseVertices = 0;  // vertices of the copy that was solved instead; 0: the part itself was solved
  // Why it has no modes, as a sentence; only with ModesOptions::guidedParts, without which the solve throws.
  std::string failure = {};
};

// The modes of all components. The shapes with one ordinal share one array: at each vertex it has the shape
// of the (ordinal + 1)-th elastic mode of that vertex's component, so nothing is stored twice. If a component
// has fewer modes, its entries are 0. A cavity has the modes of its host. The largest displacement of a shape
// is 1; its largest component at that vertex is positive.
struct ModeSet {
  std::vector<Mode> modes;  // ascending by omega (ties by component, then ordinal)
  std::vector<ComponentModes> components;
  uint32_t modesPerComponent = 0;  // ordinals: the most modes that a component has
  std::vector<float> shapes;       // shapes[(ordinal * vertexCount + v) * 3 + c]
  uint64_t factorNonzeros = 0;     // of L, for the largest part
};

// The undamped modes of every part, (K - omega^2 M) phi = 0 (paper, Eqs. 1 to 4), with lumped masses.
// Shell: CST membrane and Morley bending of the given thickness (docs/modes.md). Solid: a lattice of
// hexahedra that fills the inside. Laplacian: k = 1 per edge and direction, lumped areas as masses, nominal
// frequencies; each scalar mode is listed three times, once per principal axis, shortest axis first, or once
// along the given direction. Throws Cancelled; std::invalid_argument with a sentence for options out of
// range; std::runtime_error with a sentence if the solver fails or memory is short.
ModeSet computeModes(const TriangleMesh& mesh, const ModesOptions& options, Job& job);

// Throws std::invalid_argument with one sentence.
void checkModesOptions(const TriangleMesh& mesh, const ModesOptions& options);

}  // namespace limber
