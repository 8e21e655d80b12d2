#include "simplify/deviation_limit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/sampling.h"
#include "query/closest_point.h"

namespace limber {
namespace {

// As a fraction of the limit: the distance allowed at samples, so that the surface between them stays within
// the limit.
constexpr double kMargin = 0.85;
// A coarse input gets more samples per triangle, up to about this many in all ...
constexpr double kSamples = 10000;
constexpr int kFinest = 8;  // ... with its edges cut into at most this many parts
// To sample a changed triangle, its edges are cut into parts of about this length, in multiples of the limit,
// but at least kFewestCuts and at most kMaxCuts parts.
constexpr double kCutLength = 2;
constexpr double kFewestCuts = 3, kMaxCuts = 20;
// A triangle within this fraction of the limit is near enough to a sample; the search for a nearer one ends.
constexpr double kNearEnough = 0.25;

}  // namespace

DeviationLimit::DeviationLimit(const TriangleMesh& input, const CollapseMesh& mesh, double limit)
    : mesh_(mesh),
      squaredLimit_(kMargin * kMargin * limit * limit),
      nearest_(input),
      first_(input.triangleCount(), kNone) {
  for (uint32_t v = 0; v < input.vertexCount(); ++v) {
    samples_.push_back(mesh.position(v));
    inputOf_.push_back(mesh.star(v).empty() ? kNone : mesh.star(v)[0].triangle());
  }
  const int cuts =
      std::min<int>(kFinest, std::ceil(std::sqrt(kSamples / std::max(1u, input.triangleCount()))));
  for (uint32_t t = 0; t < input.triangleCount(); ++t) addSamples(t, cuts);
  next_.assign(samples_.size(), kNone);
  for (uint32_t sample = 0; sample < samples_.size(); ++sample)
    if (inputOf_[sample] != kNone) attach(sample, inputOf_[sample]);
}

void DeviationLimit::addSamples(uint32_t t, int cuts) {
  const auto add = [&](const Vec3& p) {
    samples_.push_back(p);
    inputOf_.push_back(t);
  };
  const auto& [vertices, edges] = mesh_.face(t);
  const std::array<Vec3, 3> corners{mesh_.position(vertices[0]), mesh_.position(vertices[1]),
                                    mesh_.position(vertices[2])};
  forEachPartCentre(corners, cuts, add);
  for (int c = 0; c < 3; ++c) {
    const auto [a, b] = mesh_.edge(edges[c]);
    const bool isFirst = vertices[nextIndex(c)] == a || mesh_.trianglesOnEdge(edges[c]) != 2;
    if (!isFirst) continue;
    const Vec3 &from = corners[nextIndex(c)], &to = corners[previousIndex(c)];
    for (int i = 0; i < cuts; ++i) add(from + (to - from) * ((i + 0.5) / cuts));
  }
}

void DeviationLimit::attach(uint32_t sample, uint32_t triangle) {
  next_[sample] = first_[triangle];
  first_[triangle] = sample;
}

void DeviationLimit::collectChanged(const Collapse& step) {
  changed_.clear();
  emptied_.clear();
  for (const uint32_t v : {step.kept, step.removed})
    for (const Corner corner : mesh_.star(v)) {
      const uint32_t t = corner.triangle();
      const CollapseMesh::Face& face = mesh_.face(t);
      const int next = nextIndex(corner.index()), previous = previousIndex(corner.index());
      const bool vanishes = face.edges[next] == step.edge || face.edges[previous] == step.edge;
      if (!vanishes || v == step.kept) emptied_.push_back(t);
      if (!vanishes)
        changed_.push_back({t, mesh_.position(face.vertices[next]), mesh_.position(face.vertices[previous])});
    }
}

// Finds a changed triangle near the sample to assign it to; false if all are too far away.
bool DeviationLimit::reassignSample(uint32_t sample, const Vec3& target) {
  double least = squaredLimit_;
  uint32_t triangle = kNone;
  for (const Changed& changed : changed_) {
    const Vec3 point = closestPosition(samples_[sample], target, changed.q, changed.r);
    const double square = squaredLength(samples_[sample] - point);
    if (square > least || (square == least && triangle != kNone)) continue;
    least = square;
    triangle = changed.triangle;
    if (square <= kNearEnough * kNearEnough * squaredLimit_) break;
  }
  moving_.push_back(sample);
  to_.push_back(triangle);
  return triangle != kNone;
}

bool DeviationLimit::isNearInput(const Vec3& p, uint32_t guess) const {
  const auto [x, y, z] = mesh_.inFile(p);
  return nearest_.isWithin({x, y, z}, squaredLimit_, guess);
}

void DeviationLimit::follow(const Collapse& step) {
  startReassigning(step);
  if (changed_.empty()) return;
  for (const uint32_t triangle : emptied_)
    for (uint32_t sample = first_[triangle]; sample != kNone; sample = next_[sample])
      if (!reassignSample(sample, step.target)) to_.back() = changed_.front().triangle;
}

void DeviationLimit::startReassigning(const Collapse& step) {
  collectChanged(step);
  moving_.clear();
  to_.clear();
}

bool DeviationLimit::allows(const Collapse& step) {
  startReassigning(step);
  const uint32_t guess = emptied_[0];
  if (!isNearInput(step.target, guess)) return false;
  for (const uint32_t triangle : emptied_)
    for (uint32_t sample = first_[triangle]; sample != kNone; sample = next_[sample])
      if (!reassignSample(sample, step.target)) return false;
  return std::ranges::all_of(changed_,
                             [&](const Changed& changed) { return isNearInput(changed, step.target); });
}

bool DeviationLimit::isNearInput(const Changed& changed, const Vec3& target) const {
  const auto& [triangle, q, r] = changed;
  const double longest =
      std::max({squaredLength(q - target), squaredLength(r - target), squaredLength(r - q)});
  const double parts = std::ceil(std::sqrt(longest / squaredLimit_) / kCutLength);
  const int cuts = static_cast<int>(std::clamp(parts, kFewestCuts, kMaxCuts));
  bool near = true;
  const auto ask = [&, triangle = triangle](const Vec3& p) { near = near && isNearInput(p, triangle); };
  for (int i = 1; i < cuts; ++i) ask(target + (q - target) * (1.0 * i / cuts));
  forEachPartCentre({target, q, r}, cuts, ask);
  return near;
}

void DeviationLimit::collapse() {
  for (const uint32_t triangle : emptied_) first_[triangle] = kNone;
  for (size_t i = 0; i < moving_.size(); ++i) attach(moving_[i], to_[i]);
}

}  // namespace limber
