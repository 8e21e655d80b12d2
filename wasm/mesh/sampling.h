#pragma once

#include <array>

#include "base/vec3.h"

namespace limber {

// Cuts a triangle into cuts^2 equal parts by cuts parallel to its edges, `cuts` >= 1, and calls visit(u, v)
// for the centre of each: the point at p + (q - p) u / cuts + (r - p) v / cuts of triangle pqr. The parts
// come in rows of increasing u; within a row, upright and inverted parts alternate.
template <class Visit>
void forEachPart(int cuts, const Visit& visit) {
  for (int i = 0; i < cuts; ++i)
    for (int j = 0; i + j < cuts; ++j) {
      visit(i + 1.0 / 3, j + 1.0 / 3);
      if (i + j + 1 < cuts) visit(i + 2.0 / 3, j + 2.0 / 3);
    }
}

// Calls visit(position) for the centres of the cuts^2 equal parts of a triangle, in the same order.
template <class Visit>
void forEachPartCentre(const std::array<Vec3, 3>& triangle, int cuts, const Visit& visit) {
  const auto& [p, q, r] = triangle;
  const Vec3 alongQ = (q - p) / cuts, alongR = (r - p) / cuts;
  forEachPart(cuts, [&](double u, double v) { visit(p + alongQ * u + alongR * v); });
}

}  // namespace limber
