#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "elastic/part_modes.h"

namespace limber {

// The modes of all parts of a body as one set, in SI units, named and sorted. Throws std::invalid_argument if
// the material makes a frequency infinite.
ModeSet collectModes(const TriangleMesh& body, const std::vector<Part>& parts,
                     const std::vector<PartModes>& modes, const ModesOptions& options);

// The lowest modes of a set, at most `count`, as columns over the whole body: lambda[k] = omega^2 in
// (rad/s)^2 and phi(3 v + c, k), scaled as in the set and 0 outside of the mode's component. The square root
// of lambda is omega to the last bit. `componentOfVertex`: of the body that the set belongs to.
ModeBasis lowestModes(const ModeSet& set, std::span<const uint32_t> componentOfVertex, size_t count);

}  // namespace limber
