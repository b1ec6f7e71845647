// SPDX-License-Identifier: MIT
#include "problems/published/cam_shape/kernels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "numerics/scalar/interval.h"

/// By hand: derivatives by dual numbers would take most of the time that 20000 rows need.
namespace camlaw::problems::cam_shape_parts {
namespace {

using optim::Bounds;
using optim::Function;
using optim::Kernel;
using optim::packed;

/// The distinct variables among some radii, increasing.
template <std::size_t N>
std::vector<std::size_t> variables_of(const std::array<Radius, N>& radii) {
  std::vector<std::size_t> result;
  for (const Radius& radius : radii) {
    if (radius.variable >= 0) result.push_back(static_cast<std::size_t>(radius.variable));
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// Where a function of N neighbouring radii finds them: among its inputs, or given.
template <std::size_t N>
class Neighbours {
 public:
  static constexpr std::size_t kGiven = static_cast<std::size_t>(-1);

  explicit Neighbours(const std::array<Radius, N>& radii) {
    const std::vector<std::size_t> variables = variables_of(radii);
    for (std::size_t i = 0; i < N; ++i) {
      given_[i] = radii[i].given;
      if (radii[i].variable < 0) continue;
      const auto variable = static_cast<std::size_t>(radii[i].variable);
      const auto at = std::lower_bound(variables.begin(), variables.end(), variable);
      input_[i] = static_cast<std::size_t>(at - variables.begin());
    }
    inputs_ = variables.size();
  }

  std::array<double, N> radii(std::span<const double> u) const {
    std::array<double, N> result = given_;
    for (std::size_t i = 0; i < N; ++i) {
      if (input_[i] != kGiven) result[i] = u[input_[i]];
    }
    return result;
  }

  /// From derivatives by the radii to those by the inputs; two radii may be one input.
  void put_first(const std::array<double, N>& by_radius, std::span<double> g) const {
    std::fill_n(g.begin(), inputs_, 0.0);
    for (std::size_t i = 0; i < N; ++i) {
      if (input_[i] != kGiven) g[input_[i]] += by_radius[i];
    }
  }
  void put_second(const std::array<std::array<double, N>, N>& by_radii, std::span<double> h) const {
    std::fill_n(h.begin(), optim::packed_size(inputs_), 0.0);
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t j = 0; j < N; ++j) {
        if (input_[i] == kGiven || input_[j] == kGiven || input_[j] > input_[i]) continue;
        h[packed(input_[i], input_[j])] += by_radii[i][j];
      }
    }
  }

 private:
  std::array<double, N> given_{};
  std::array<std::size_t, N> input_ = filled();
  std::size_t inputs_ = 0;

  static constexpr std::array<std::size_t, N> filled() {
    std::array<std::size_t, N> result{};
    result.fill(kGiven);
    return result;
  }
};

class Convexity final : public Kernel {
 public:
  Convexity(const std::array<Radius, 3>& radii, double angle)
      : neighbours_(radii),
        chord_(4 * std::sin(angle / 2) * std::sin(angle / 2)),
        square_(angle * angle) {}

  double value(std::span<const double> u) const override {
    const auto [a, b, c] = neighbours_.radii(u);
    return formula(a, b, c);
  }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    const auto [a, b, c] = neighbours_.radii(u);
    const double by_a = ((c - b) + c - chord_ * c) / square_;
    const double by_c = ((a - b) + a - chord_ * a) / square_;
    neighbours_.put_first({by_a, -(a + c) / square_, by_c}, g);
    return formula(a, b, c);
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    const double by_ac = (2 - chord_) / square_, by_b = -1 / square_;
    neighbours_.put_second({{{0, by_b, by_ac}, {by_b, 0, by_b}, {by_ac, by_b, 0}}}, h);
    return gradient(u, g);
  }
  Bounds enclose(std::span<const double> u) const override {
    const auto [a, b, c] = neighbours_.radii(u);
    const Interval exact = formula(Interval(a), Interval(b), Interval(c));
    return {exact.lower(), exact.upper()};
  }
  bool is_enclosed() const override { return true; }

 private:
  template <class T>
  T formula(const T& a, const T& b, const T& c) const {
    return (a * (c - b) - c * (b - a) - chord_ * (a * c)) / square_;
  }

  Neighbours<3> neighbours_;
  double chord_;  ///< 2 - 2 cos(angle)
  double square_;
};

class Slope final : public Kernel {
 public:
  Slope(const std::array<Radius, 2>& radii, double angle) : neighbours_(radii), angle_(angle) {}

  double value(std::span<const double> u) const override {
    const auto [a, b] = neighbours_.radii(u);
    return (b - a) / angle_;
  }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    neighbours_.put_first({-1 / angle_, 1 / angle_}, g);
    return value(u);
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    neighbours_.put_second({}, h);
    return gradient(u, g);
  }
  Bounds enclose(std::span<const double> u) const override {
    const auto [a, b] = neighbours_.radii(u);
    const Interval exact = (Interval(b) - a) / angle_;
    return {exact.lower(), exact.upper()};
  }
  bool is_enclosed() const override { return true; }

 private:
  Neighbours<2> neighbours_;
  double angle_;
};

class Sum final : public Kernel {
 public:
  explicit Sum(double factor) : factor_(factor) {}

  double value(std::span<const double> u) const override {
    return factor_ * std::accumulate(u.begin(), u.end(), 0.0);
  }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    std::fill_n(g.begin(), u.size(), factor_);
    return value(u);
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    std::fill_n(h.begin(), optim::packed_size(u.size()), 0.0);
    return gradient(u, g);
  }
  Bounds enclose(std::span<const double> u) const override {
    const Interval exact = factor_ * std::accumulate(u.begin(), u.end(), Interval(0.0));
    return {exact.lower(), exact.upper()};
  }
  bool is_enclosed() const override { return true; }

 private:
  double factor_;
};

}  // namespace

Function convexity(Radius a, Radius b, Radius c, double angle) {
  const std::array<Radius, 3> radii{a, b, c};
  return {variables_of(radii), std::make_shared<Convexity>(radii, angle)};
}

Function slope(Radius a, Radius b, double angle) {
  const std::array<Radius, 2> radii{a, b};
  return {variables_of(radii), std::make_shared<Slope>(radii, angle), optim::Shape::Linear};
}

Function sum(std::size_t count, double factor) {
  std::vector<std::size_t> all(count);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return {std::move(all), std::make_shared<Sum>(factor), optim::Shape::Linear};
}

}  // namespace camlaw::problems::cam_shape_parts
