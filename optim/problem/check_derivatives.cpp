// SPDX-License-Identifier: MIT
#include "optim/problem/check_derivatives.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "optim/problem/starts.h"

namespace camlaw::optim {
namespace {

constexpr double kStep = 1e-2;  // of a variable's typical change: the first, largest step
/// Of a curve's size: what differences over the smallest step, kStep / 2^7, cannot tell from
/// nothing to kDerivativeTolerance, where values are rounded to some units of their last place.
constexpr double kNoiseOfCurve = 1e-5;

/// A derivative by Ridders' extrapolation of central differences of f(t) at t = 0.
template <class F>
double ridders(F f, double step) {
  // Steps down to 1/128 of the first; shorter ones lose digits to rounding.
  constexpr int kRows = 8;
  constexpr double kShrink = 2;  // halving a step is exact
  std::array<std::array<double, kRows>, kRows> table{};
  double best = 0, least = kInfinity;
  for (int i = 0; i < kRows; ++i, step /= kShrink) {
    auto& row = table[static_cast<std::size_t>(i)];
    row[0] = (f(step) - f(-step)) / (2 * step);
    double factor = kShrink * kShrink;
    for (int k = 1; k <= i; ++k, factor *= kShrink * kShrink) {
      const auto& above = table[static_cast<std::size_t>(i - 1)];
      const auto c = static_cast<std::size_t>(k);
      row[c] = (factor * row[c - 1] - above[c - 1]) / (factor - 1);
      const double error = std::max(std::abs(row[c] - row[c - 1]), std::abs(row[c] - above[c - 1]));
      if (error < least) least = error, best = row[c];
    }
  }
  return best;
}

class Checker {
 public:
  Checker(const Problem& problem, Design x)
      : problem_(problem), scales_(variable_scales(problem)), x_(x.begin(), x.end()) {
    for (std::size_t i = 0; i < x_.size(); ++i) {
      const Variable& v = problem.variables[i];
      step_.push_back(kStep * scales_[i]);
      const double room = std::min(step_[i], (v.upper - v.lower) / 4);
      if (v.lower < v.upper) x_[i] = std::clamp(x_[i], v.lower + room, v.upper - room);
      if (room > 0) step_[i] = room;
    }
  }

  DerivativeCheck run() {
    for (const Objective& o : problem_.objectives) check(o.response);
    for (const Constraint& c : problem_.constraints) check(c.response);
    result_.agrees = result_.worst.error <= kDerivativeTolerance;
    return std::move(result_);
  }

 private:
  void check(const Response& response) {
    if (!response.is_curve()) {
      check(response.name, {}, response.function(), 0);
      check_shape(response.name, response.function());
      return;
    }
    constexpr std::size_t kMost = 12;  // stretches looked at
    const auto breaks = response.curve().trace(x_)->breaks();
    const std::size_t stride = std::max<std::size_t>(1, breaks.size() / kMost);
    std::vector<double> angles;
    for (std::size_t k = 0; k + 1 < breaks.size(); k += stride) {
      for (const double share : {0.23, 0.71}) {
        angles.push_back(std::lerp(breaks[k], breaks[k + 1], share));
      }
    }
    // Where the curve crosses zero, rounding is still that of its terms.
    double size = 0;
    for (const double angle : angles) {
      const double value = response.curve().at({angle}).value(x_);
      if (std::isfinite(value)) size = std::max(size, std::abs(value));
    }
    for (const double angle : angles) {
      check(response.name, angle, response.curve().at({angle}), size);
    }
    const double middle = std::lerp(breaks.front(), breaks.back(), 0.37);
    check_shape(response.name, response.curve().at({middle}));
  }

  /// Gradient of f where one variable is moved by t.
  std::vector<double> gradient_at(const Function& f, std::size_t variable, double t) const {
    std::vector<double> moved = x_, g(f.inputs().size());
    moved[variable] += t;
    f.gradient(moved, g);
    return g;
  }

  /// `size`: of the curve that f is one place of.
  void check(const std::string& name, std::optional<double> angle, const Function& f, double size) {
    const auto& inputs = f.inputs();
    std::vector<double> g(inputs.size()), h(packed_size(inputs.size()));
    const double value = f.hessian(x_, g, h);
    // Less than this of the value differences cannot tell from nothing.
    constexpr double kNoiseOfNumber = 1e-6;
    double first = std::max(kNoiseOfNumber * std::abs(value), kNoiseOfCurve * size), second = first;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      first = std::max(first, std::abs(g[i]) * scales_[inputs[i]]);
      for (std::size_t j = 0; j <= i; ++j) {
        second =
            std::max(second, std::abs(h[packed(i, j)]) * scales_[inputs[i]] * scales_[inputs[j]]);
      }
    }
    // Derivatives of one order that vanish are compared on the other's measure.
    first = second = first > 0 || second > 0 ? std::max(first, second) : 1;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const std::size_t variable = inputs[i];
      const double by_value = ridders(
          [&](double t) {
            std::vector<double> moved = x_;
            moved[variable] += t;
            return f.value(moved);
          },
          step_[variable]);
      compare({name, angle, problem_.variables[variable].name, "", g[i], by_value},
              scales_[variable] / first);
      for (std::size_t j = 0; j <= i; ++j) {
        const double difference =
            ridders([&](double t) { return gradient_at(f, variable, t)[j]; }, step_[variable]);
        compare({name, angle, problem_.variables[variable].name, problem_.variables[inputs[j]].name,
                 h[packed(i, j)], difference},
                scales_[variable] * scales_[inputs[j]] / second);
      }
    }
  }

  void compare(DerivativeEntry entry, double factor) {
    ++result_.entries;
    entry.error = std::abs(entry.exact - entry.difference) * factor;
    if (std::isnan(entry.error)) entry.error = kInfinity;
    if (entry.error >= result_.worst.error) result_.worst = std::move(entry);
  }

  /// Values on a segment between two designs, for a shape. It is said of designs that have a value:
  /// one between two such must have one too.
  void check_shape(const std::string& name, const Function& f) {
    constexpr int kPairs = 64;  // a shape that fails for one pair in twenty escapes once in 27
    if (f.shape() == Shape::General) return;
    const auto points = starts(problem_, 2 * kPairs, 7);
    for (std::size_t k = 0; k + 1 < points.size(); k += 2) {
      std::vector<double> middle = points[k];
      for (std::size_t i = 0; i < middle.size(); ++i) {
        middle[i] = std::midpoint(points[k][i], points[k + 1][i]);
      }
      const double a = f.value(points[k]), b = f.value(points[k + 1]), m = f.value(middle);
      if (std::isnan(a) || std::isnan(b)) continue;
      constexpr double kRounding = 1e-9;  // what a formula's rounding leaves of a difference
      const double room = kRounding * std::max({std::abs(a), std::abs(b), std::abs(m)});
      const bool below = m <= std::midpoint(a, b) + room, above = m >= std::midpoint(a, b) - room;
      const bool under = m <= std::max(a, b) + room, over = m >= std::min(a, b) - room;
      const Shape shape = f.shape();
      const bool holds = (!is_convex(shape) || below) && (!is_concave(shape) || above) &&
                         (!convex_below(shape) || under) && (!convex_above(shape) || over);
      if (holds) continue;
      result_.shapes.push_back(
          fmt::format("{} is not of the shape that it is declared to have", name));
      return;
    }
  }

  const Problem& problem_;
  std::vector<double> scales_, x_, step_;
  DerivativeCheck result_;
};

}  // namespace

DerivativeCheck check_derivatives(const Problem& problem, Design x) {
  return Checker(problem, x).run();
}

}  // namespace camlaw::optim
