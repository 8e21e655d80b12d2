#include "simplify/creases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace limber {
namespace {

constexpr int kBins = 180;  // of a degree each
constexpr double kEvenSpread = 0.75;
constexpr double kSplitAngle = 60;

// Lengths of edges by dihedral angle.
using Histogram = std::array<double, kBins>;

int binOf(const TriangleMesh& mesh, const Topology& topology, const Topology::Edge& edge) {
  const auto triangles = topology.trianglesAt(edge);
  const Vec3 s = normalized(areaNormal(mesh, triangles[0])), t = normalized(areaNormal(mesh, triangles[1]));
  const double angle = std::acos(std::clamp(dot(s, t), -1.0, 1.0)) * 180 / std::numbers::pi;
  return std::min(static_cast<int>(angle), kBins - 1);
}

// The first bin of the upper class; kBins if the histogram does not fall into two.
int firstCreaseBin(const Histogram& lengths) {
  double total = 0, sum = 0, squares = 0;
  for (int bin = 0; bin < kBins; ++bin) {
    total += lengths[bin];
    sum += lengths[bin] * bin;
    squares += lengths[bin] * bin * bin;
  }
  if (!(total > 0)) return kBins;
  const double variance = squares - sum * sum / total;
  double largest = 0, meanAbove = 0, below = 0, sumBelow = 0;
  int best = kBins;
  for (int bin = 1; bin < kBins; ++bin) {
    below += lengths[bin - 1];
    sumBelow += lengths[bin - 1] * (bin - 1);
    const double above = total - below;
    if (!(below > 0 && above > 1e-12 * total)) continue;
    const double difference = (sum - sumBelow) / above - sumBelow / below;
    const double between = below * above / total * difference * difference;
    if (!(between > largest)) continue;
    largest = between;
    meanAbove = (sum - sumBelow) / above;
    best = bin;
  }
  return largest > kEvenSpread * variance && meanAbove > kSplitAngle ? best : kBins;
}

}  // namespace

std::vector<uint8_t> findCreases(const TriangleMesh& mesh, const Topology& topology) {
  Histogram lengths{};
  std::vector<uint8_t> bins(topology.edges.size(), 0);
  for (size_t e = 0; e < topology.edges.size(); ++e) {
    const Topology::Edge& edge = topology.edges[e];
    if (edge.useCount != 2) continue;
    const int bin = binOf(mesh, topology, edge);
    bins[e] = static_cast<uint8_t>(bin);
    lengths[bin] += length(mesh.positions[edge.b] - mesh.positions[edge.a]);
  }
  const int first = firstCreaseBin(lengths);
  if (first == kBins) return {};
  for (uint8_t& bin : bins) bin = bin >= first;
  return bins;
}

}  // namespace limber
