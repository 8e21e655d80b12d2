#include "fit/tune/modes/mode_matching.h"

namespace limber {
namespace {

constexpr double kClearMac = 0.5;  // two modes cannot both share more with a third

}  // namespace

std::vector<Eigen::Index> matchModes(const Eigen::MatrixXd& overlap) {
  std::vector<Eigen::Index> partner(static_cast<size_t>(overlap.cols()), -1);
  std::vector<uint8_t> isTaken(static_cast<size_t>(overlap.rows()), 0);
  for (Eigen::Index i = 0; i < overlap.cols(); ++i) {
    Eigen::Index j = 0;
    const double mac = overlap.col(i).cwiseAbs2().maxCoeff(&j);
    if (mac <= kClearMac || isTaken[static_cast<size_t>(j)]) continue;
    partner[static_cast<size_t>(i)] = j;
    isTaken[static_cast<size_t>(j)] = 1;
  }
  Eigen::Index next = 0;
  for (Eigen::Index& j : partner) {
    if (j >= 0) continue;
    while (isTaken[static_cast<size_t>(next)]) ++next;
    j = next++;
  }
  return partner;
}

}  // namespace limber
