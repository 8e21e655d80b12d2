#include "fit/tune/steps/factor_range.h"

#include <algorithm>
#include <cmath>

namespace limber {
namespace {

// The bending stiffness of a sheet of triangles with edges of length h is proportional to h to this power.
double powerOfLength(BendElement element) {
  switch (element) {
    case BendElement::CrossSprings:
      return 4;
    case BendElement::HingeByLength:
      return 1;
    default:
      return 0;
  }
}

}  // namespace

FactorRange bendRange(BendElement element, double lengthRatio) {
  const double predicted = -powerOfLength(element) * std::log(lengthRatio);
  const FactorRange range;
  return {range.least + std::min(predicted, 0.0), range.most + std::max(predicted, 0.0)};
}

}  // namespace limber
