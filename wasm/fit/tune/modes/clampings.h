#pragma once

#include <cstdint>
#include <vector>

#include "fit/tune/modes/tune_parts.h"
#include "fit/tune/tune_options.h"

namespace limber {

// How a body is clamped while modes are compared. The lower and the other end are those of the longest side
// of the bounding box of the original.
enum class ClampKind : uint8_t { Free, LowerEnd, UserPins, OtherEnd };

// The pinned vertices of one part in one clamping, of both bodies, by ids of the part; empty if it is free.
struct PartPins {
  size_t pair;  // index of the part
  std::vector<uint32_t> original, result;
};

// The parts that take part in a clamping: all of them if free, otherwise those whose pins leave no rigid
// motion on either body.
struct Clamping {
  ClampKind kind = ClampKind::Free;
  std::vector<PartPins> parts;
};

// Free first, then the clampings in which at least one part takes part. Ends are a tenth of the longest side;
// their pins are carried over to the coarse mesh by transfer/carry_pins.h.
std::vector<Clamping> findClampings(const TriangleMesh& original, const std::deque<PartPair>& pairs,
                                    const TuneOptions& options);

}  // namespace limber
