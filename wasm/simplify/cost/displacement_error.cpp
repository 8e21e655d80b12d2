#include "simplify/cost/displacement_error.h"

namespace limber {
namespace {

// The entries of a form in a symmetric matrix of size 4.
constexpr uint8_t kEntries[kFormSize][2] = {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2},
                                            {2, 2}, {0, 3}, {1, 3}, {2, 3}, {3, 3}};

// Three fields, [4 * c + i]: coefficient i of coordinate c.
using Fields = std::array<double, 12>;

Fields product(const Metric& m, const Fields& u) {
  Fields all;
  for (int i = 0; i < 4; ++i) {
    const double x = u[i], y = u[4 + i], z = u[8 + i];
    all[i] = m[0] * x + m[1] * y + m[2] * z;
    all[4 + i] = m[1] * x + m[3] * y + m[4] * z;
    all[8 + i] = m[2] * x + m[4] * y + m[5] * z;
  }
  return all;
}

// Adds `weight` times u^T v, symmetrised.
void addProduct(double* form, const Fields& u, const Fields& v, double weight) {
  for (uint32_t entry = 0; entry < kFormSize; ++entry) {
    const auto [i, j] = kEntries[entry];
    for (int c = 0; c < 12; c += 4) form[entry] += 0.5 * weight * (u[c + i] * v[c + j] + u[c + j] * v[c + i]);
  }
}

}  // namespace

Metric metricAlong(const Vec3& normal, double within) {
  const Vec3 n = normal * (1 - within);
  return {n.x * normal.x + within, n.x * normal.y, n.x * normal.z,
          n.y * normal.y + within, n.y * normal.z, n.z * normal.z + within};
}

void addSquare(double* form, const LinearField& field, double weight) {
  for (uint32_t entry = 0; entry < kFormSize; ++entry)
    form[entry] += weight * (field[kEntries[entry][0]] * field[kEntries[entry][1]]);
}

void addDisplacements(double* sums, double* form, std::span<const LinearField> u,
                      const WeightedMetric& triangle) {
  for (const double value : triangle.metric) *sums++ += triangle.area * value;
  for (size_t k = 0; k < u.size(); k += 3) {
    Fields fields;
    for (int i = 0; i < 12; ++i) fields[i] = u[k + i / 4][i % 4];
    const Fields inMetric = product(triangle.metric, fields);
    addProduct(form, fields, inMetric, triangle.area);
    for (const Fields& list : {fields, inMetric})
      for (const double value : list) *sums++ += triangle.area * value;
  }
}

void takeMeansOff(double* form, const std::array<const double*, 2>& sums, uint32_t count, double area) {
  auto [p, q] = sums;
  const auto next = [&] { return *p++ + *q++; };
  Metric metric;
  for (double& value : metric) value = next();
  for (uint32_t k = 0; k < count; ++k) {
    Fields mean;
    for (double& value : mean) value = next() / area;
    Fields rest = product(metric, mean);
    for (double& value : rest) value -= 2 * next();
    addProduct(form, mean, rest, 1);
  }
}

}  // namespace limber
