#include "fit/tune/modes/mode_matching.h"

#include <algorithm>

namespace limber {
namespace {

constexpr double kNearlyEqual = 0.01;  // relative difference of eigenvalues
constexpr double kClearMac = 0.5;      // no mode can share more than this with two spans

// The modes of the coarse mesh that correspond to a cluster of the original: ascending, at most as many.
std::vector<Eigen::Index> clearPartners(const Eigen::MatrixXd& overlap, const ModeRange& cluster,
                                        const std::vector<uint8_t>& isTaken) {
  const Eigen::Index count = cluster.last - cluster.first;
  const Eigen::VectorXd shared = overlap.middleCols(cluster.first, count).rowwise().squaredNorm();
  std::vector<Eigen::Index> partners;
  for (Eigen::Index j = 0; j < shared.size(); ++j)
    if (shared[j] > kClearMac && !isTaken[static_cast<size_t>(j)]) partners.push_back(j);
  std::ranges::stable_sort(partners, [&](Eigen::Index a, Eigen::Index b) { return shared[a] > shared[b]; });
  if (static_cast<Eigen::Index>(partners.size()) > count) partners.resize(static_cast<size_t>(count));
  std::ranges::sort(partners);
  return partners;
}

}  // namespace

std::vector<ModeRange> modeClusters(const Eigen::VectorXd& lambda) {
  std::vector<ModeRange> clusters;
  for (Eigen::Index i = 0; i < lambda.size(); ++i) {
    const bool joins = !clusters.empty() && lambda[i] <= (1 + kNearlyEqual) * lambda[clusters.back().first];
    if (joins)
      ++clusters.back().last;
    else
      clusters.push_back({i, i + 1});
  }
  return clusters;
}

std::vector<Eigen::Index> matchModes(const Eigen::MatrixXd& overlap, const std::vector<ModeRange>& clusters) {
  std::vector<Eigen::Index> partner(static_cast<size_t>(overlap.cols()), -1);
  std::vector<uint8_t> isTaken(static_cast<size_t>(overlap.rows()), 0);
  for (const ModeRange& cluster : clusters) {
    auto mode = static_cast<size_t>(cluster.first);
    for (const Eigen::Index j : clearPartners(overlap, cluster, isTaken)) {
      partner[mode++] = j;
      isTaken[static_cast<size_t>(j)] = 1;
    }
  }
  Eigen::Index next = 0;
  for (Eigen::Index& j : partner) {
    if (j >= 0) continue;
    while (isTaken[static_cast<size_t>(next)]) ++next;
    j = next++;
  }
  for (const ModeRange& cluster : clusters)
    std::sort(partner.begin() + cluster.first, partner.begin() + cluster.last);
  return partner;
}

}  // namespace limber
