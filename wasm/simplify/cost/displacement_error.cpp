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

// Adds `weight` times u^T v, made symmetric.
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

void addDisplacement(double* sums, double* form, const LinearField* u, const WeightedMetric& triangle) {
  Fields fields;
  for (int i = 0; i < 12; ++i) fields[i] = u[i / 4][i % 4];
  const Fields inMetric = product(triangle.metric, fields);
  addProduct(form, fields, inMetric, triangle.area);
  for (int i = 0; i < 12; ++i) {
    sums[i] += triangle.area * fields[i];
    sums[12 + i] += triangle.area * inMetric[i];
  }
}

void takeMeanOff(double* form, const double* sums, const WeightedMetric& all) {
  Fields mean;
  for (int i = 0; i < 12; ++i) mean[i] = sums[i] / all.area;
  Fields rest = product(all.metric, mean);
  for (int i = 0; i < 12; ++i) rest[i] -= 2 * sums[12 + i];
  addProduct(form, mean, rest, 1);
}

}  // namespace limber
