// Products of dense blocks, ours and Eigen's in turn, as JSON on stdout: [{rows, depth, cols, ours, eigen}]
// with GFlop/s. For tests/bench/dense.mjs, which compiles it to WebAssembly and natively. Sizes: the large
// ones of updates of fronts, the narrow ones of solves with two dozen right-hand sides, one with a single
// one.

#include "linear/dense/dense_product.h"

#include <Eigen/Dense>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

namespace {

constexpr int kRounds = 7;
constexpr double kFlopsARound = 1e8;

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

template <class Action>
double seconds(int repeats, const Action& action) {
  const double start = now();
  for (int i = 0; i < repeats; ++i) action();
  return (now() - start) / repeats;
}

struct Speeds {
  double ours, eigen;  // GFlop/s
};

template <class A, class B, class C>
Speeds measure(const A& a, const B& b, C& c) {
  const double flops = 2.0 * static_cast<double>(a.rows() * a.cols() * b.cols());
  const int repeats = std::max(1, static_cast<int>(kFlopsARound / flops));
  double ours = HUGE_VAL, eigen = HUGE_VAL;
  for (int round = 0; round < kRounds; ++round) {
    ours = std::min(ours, seconds(repeats, [&] { limber::subtractProduct(a, b, c); }));
    eigen = std::min(eigen, seconds(repeats, [&] { c.noalias() -= a * b; }));
  }
  return {1e-9 * flops / ours, 1e-9 * flops / eigen};
}

}  // namespace

int main() {
  constexpr Eigen::Index sizes[][3] = {{256, 256, 256}, {1000, 200, 96}, {200, 32, 200}, {120, 120, 24},
                                       {30, 10, 30},    {12, 6, 24},     {200, 60, 1}};
  const char* separator = "[";
  for (const auto& [rows, depth, cols] : sizes) {
    const Eigen::MatrixXd a = Eigen::MatrixXd::Random(rows, depth), b = Eigen::MatrixXd::Random(depth, cols);
    Eigen::MatrixXd c = Eigen::MatrixXd::Zero(rows, cols);
    Eigen::VectorXd vector = Eigen::VectorXd::Zero(rows);
    const Speeds found = cols == 1 ? measure(a, Eigen::VectorXd(b.col(0)), vector) : measure(a, b, c);
    std::printf("%s{\"rows\": %d, \"depth\": %d, \"cols\": %d, \"ours\": %.3f, \"eigen\": %.3f}", separator,
                static_cast<int>(rows), static_cast<int>(depth), static_cast<int>(cols), found.ours,
                found.eigen);
    separator = ", ";
  }
  std::printf("]\n");
}
