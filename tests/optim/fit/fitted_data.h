// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "optim/fit/residuals.h"

/// Data and residuals for the tests of fits.
namespace camlaw::optim {

/// Standard normal numbers, the same on every platform, unlike the standard library's.
class Normal {
 public:
  explicit Normal(unsigned seed) : generator_(seed) {}
  double uniform() { return std::ldexp(static_cast<double>(generator_()) + 0.5, -32); }
  double operator()() {
    const double radius = std::sqrt(-2 * std::log(uniform()));
    return radius * std::cos(2 * std::numbers::pi * uniform());
  }

 private:
  std::mt19937 generator_;
};

/// 0, 1, ..., n - 1 times step.
inline std::vector<double> even(std::size_t n, double step = 1) {
  std::vector<double> x;
  for (std::size_t i = 0; i < n; ++i) x.push_back(step * static_cast<double>(i));
  return x;
}

/// Model minus data: model(p, x) at each of x.
template <class Model>
auto against(std::vector<double> x, std::vector<double> y, Model model) {
  const std::size_t n = x.size();
  return AutomaticResiduals(
      n, [x = std::move(x), y = std::move(y), model](const auto& p, const auto& r) {
        for (std::size_t i = 0; i < x.size(); ++i) r[i] = model(p, x[i]) - y[i];
        return true;
      });
}

/// p0 + p1 x
inline constexpr auto kLine = [](const auto& p, double x) { return p[0] + p[1] * x; };

}  // namespace camlaw::optim
