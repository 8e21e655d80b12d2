#pragma once

#include <cstdint>

namespace limber {

// Sizes, in vertices, above which shells are solved and fitted differently. Each number is defined only here.

// A shell part with more vertices is solved on a decimated copy, unless an exact solve is requested: the time
// of an exact solve grows faster than that of a copy with refinement.
inline constexpr uint32_t kExactVertices = 8000;

// The size of that copy: its modes are accurate enough as the start of a few steps of inverse iteration on
// the part itself.
inline constexpr uint32_t kCoarseVertices = 8000;

// A part with more vertices is not refined, and not fitted: its factor would take over a gigabyte.
inline constexpr uint32_t kRefinedVertices = 120000;

// The size of the copy of such a part. It is larger, because nothing refines its modes.
inline constexpr uint32_t kUnrefinedCopyVertices = 40000;

// If modes only guide, shells with more vertices are solved on a copy of this size without refinement: ranks
// of strain correlate by .96 and more with those of the part itself, and frequencies are off by at most 0.6 %
// (docs/modes.md).
inline constexpr uint32_t kGuidingCopyVertices = 1000;

// A result with more vertices is fitted as a large one (fit/modal_fit.h): at fewer thicknesses and in fewer
// rounds, because its frequencies are off by only tenths of a percent and time matters.
inline constexpr uint32_t kLargeResultVertices = 20000;

// A part with at most this many vertices keeps few threads busy; such parts are therefore solved in parallel.
inline constexpr uint32_t kSmallPartVertices = 4000;

}  // namespace limber
