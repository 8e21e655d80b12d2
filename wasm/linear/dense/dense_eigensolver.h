#pragma once

#include "linear/mode_basis.h"
#include "linear/sparse_pencil.h"

namespace limber {

// All eigenpairs of a small pencil, zero eigenvalues included. Massless unknowns are condensed out and
// recovered in phi; those without couplings, such as pinned ones, are 0. O(n^3) time and O(n^2) memory in the
// other unknowns.
ModeBasis solveDensely(const SparsePencil& pencil);

}  // namespace limber
