#include "fit/target/mismatch.h"

namespace limber {

Mismatch join(const std::vector<Mismatch>& parts) {
  Mismatch all;
  Eigen::Index count = 0;
  for (const Mismatch& part : parts) count += part.residual.size();
  all.residual.resize(count);
  all.jacobian.resize(parts[0].jacobian.rows(), count);
  count = 0;
  for (const Mismatch& part : parts) {
    all.residual.segment(count, part.residual.size()) = part.residual;
    all.jacobian.middleCols(count, part.residual.size()) = part.jacobian;
    count += part.residual.size();
    all.squares += part.squares;
    all.weight += part.weight;
  }
  return all;
}

}  // namespace limber
