#pragma once

#include <array>
#include <cmath>

namespace limber {

// A number with its derivatives with respect to N variables, for forward-mode differentiation. Exact to
// rounding.
template <int N>
struct Dual {
  double value = 0;
  std::array<double, N> derivative{};  // [i]: with respect to variable i

  Dual() = default;
  Dual(double constant) : value(constant) {}  // NOLINT: constants mix freely with duals
  // Variable `index` itself, with derivative 1.
  static Dual variable(double value, int index) {
    Dual x(value);
    x.derivative[static_cast<size_t>(index)] = 1;
    return x;
  }
  // f(x) by the chain rule, for a function with value `f` and derivative `d` at x.
  Dual chain(double f, double d) const {
    Dual y(f);
    for (size_t i = 0; i < N; ++i) y.derivative[i] = d * derivative[i];
    return y;
  }
  Dual& operator+=(const Dual& b) { return *this = *this + b; }

  friend Dual operator+(Dual a, const Dual& b) {
    a.value += b.value;
    for (size_t i = 0; i < N; ++i) a.derivative[i] += b.derivative[i];
    return a;
  }
  friend Dual operator-(Dual a, const Dual& b) {
    a.value -= b.value;
    for (size_t i = 0; i < N; ++i) a.derivative[i] -= b.derivative[i];
    return a;
  }
  friend Dual operator-(const Dual& a) { return a.chain(-a.value, -1); }
  friend Dual operator*(const Dual& a, const Dual& b) {
    Dual y(a.value * b.value);
    for (size_t i = 0; i < N; ++i) y.derivative[i] = a.derivative[i] * b.value + a.value * b.derivative[i];
    return y;
  }
  friend Dual operator*(Dual a, double b) {
    a.value *= b;
    for (size_t i = 0; i < N; ++i) a.derivative[i] *= b;
    return a;
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    return a * b.chain(1 / b.value, -1 / (b.value * b.value));
  }
};

template <int N>
Dual<N> sqrt(const Dual<N>& x) {
  const double root = std::sqrt(x.value);
  return x.chain(root, 0.5 / root);
}

}  // namespace limber
