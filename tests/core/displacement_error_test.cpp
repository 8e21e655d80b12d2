#include "simplify/cost/displacement_error.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace limber {
namespace {

struct Part {
  std::array<LinearField, 3> u;
  WeightedMetric metric;
};

std::vector<Part> randomParts(int count) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> any(-1, 1);
  std::vector<Part> parts(count);
  for (Part& part : parts) {
    for (LinearField& field : part.u)
      for (double& value : field) value = any(generator);
    const Vec3 normal = normalized({any(generator), any(generator), any(generator)});
    part.metric = {metricAlong(normal, 0.2), 1.5 + any(generator)};
  }
  return parts;
}

double valueOf(const LinearField& field, const Vec3& p) {
  return field[0] * p.x + field[1] * p.y + field[2] * p.z + field[3];
}

Vec3 valueOf(const Part& part, const Vec3& p) {
  return {valueOf(part.u[0], p), valueOf(part.u[1], p), valueOf(part.u[2], p)};
}

double squareIn(const Metric& m, const Vec3& d) {
  return m[0] * d.x * d.x + m[3] * d.y * d.y + m[5] * d.z * d.z +
         2 * (m[1] * d.x * d.y + m[2] * d.x * d.z + m[4] * d.y * d.z);
}

double valueOfForm(const double* f, const Vec3& p) {
  return squareIn({f[0], f[1], f[2], f[3], f[4], f[5]}, p) + 2 * (f[6] * p.x + f[7] * p.y + f[8] * p.z) +
         f[9];
}

// The form from the sums over the triangles, added up in two sets.
std::array<double, kFormSize> formOf(const std::vector<Part>& parts) {
  std::array<double, kFormSize> form{};
  std::array<double, displacementSums(1)> first{}, second{};
  double area = 0;
  for (size_t i = 0; i < parts.size(); ++i) {
    addDisplacements((i < 2 ? first : second).data(), form.data(), parts[i].u, parts[i].metric);
    area += parts[i].metric.area;
  }
  takeMeansOff(form.data(), {first.data(), second.data()}, 1, area);
  return form;
}

TEST(DisplacementError, isTheSumOverTheTrianglesThatItStandsFor) {
  const auto parts = randomParts(5);
  const auto form = formOf(parts);
  for (const Vec3& p : {Vec3{0, 0, 0}, Vec3{0.3, -1.2, 0.5}, Vec3{2, 1, -3}}) {
    Vec3 mean;
    double area = 0, error = 0;
    for (const Part& part : parts) {
      mean += part.metric.area * valueOf(part, p);
      area += part.metric.area;
    }
    for (const Part& part : parts)
      error += part.metric.area * squareIn(part.metric.metric, valueOf(part, p) - mean / area);
    EXPECT_NEAR(valueOfForm(form.data(), p), error, 1e-12 * error);
  }
}

TEST(DisplacementError, ofTrianglesThatAgreeIsZero) {
  auto parts = randomParts(4);
  for (Part& part : parts) part.u = parts[0].u;
  const auto form = formOf(parts);
  EXPECT_NEAR(valueOfForm(form.data(), {1, 2, -1}), 0, 1e-12);
}

TEST(DisplacementError, countsInFullAlongTheNormalAndAShareOfItWithinTheSurface) {
  const Metric metric = metricAlong({0, 0, 1}, 0.25);
  EXPECT_DOUBLE_EQ(squareIn(metric, {0, 0, 2}), 4);
  EXPECT_DOUBLE_EQ(squareIn(metric, {0, 2, 0}), 1);
  EXPECT_DOUBLE_EQ(squareIn(metric, {2, 0, 0}), 1);
}

}  // namespace
}  // namespace limber
