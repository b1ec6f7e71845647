// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "numerics/scalar/interval.h"
#include "optim/problem/automatic_curve.h"
#include "optim/search/optimise.h"
#include "tests/optim/small_problems.h"

/// Small problems with known answers, and words for stating more.
namespace camlaw::optim::search_tests {

using namespace small_problems;

inline Variable variable(const std::string& name, double lower, double upper, double start = 0) {
  return {.name = name, .lower = lower, .upper = upper, .start = start};
}

inline Variable integer(const std::string& name, double lower, double upper, double start = 0) {
  return {.name = name, .lower = lower, .upper = upper, .start = start, .integer = true};
}

template <class F>
inline Function convex(std::vector<std::size_t> inputs, F f) {
  return function<Interval>(std::move(inputs), f, Shape::Convex);
}

template <class F>
inline Function linear(std::vector<std::size_t> inputs, F f) {
  return function<Interval>(std::move(inputs), f, Shape::Linear);
}

/// The sum of the inputs, each times its weight.
inline Function sum_of(std::vector<std::size_t> inputs, std::vector<double> weights) {
  return linear(std::move(inputs), [weights](const auto& u) {
    auto total = weights[0] * u[0];
    for (std::size_t i = 1; i < weights.size(); ++i) total = total + weights[i] * u[i];
    return total;
  });
}

inline Constraint at_most(const std::string& name, Function f, double bound) {
  return {.response = {name, "mm", std::move(f)}, .upper = bound};
}
inline Constraint at_least(const std::string& name, Function f, double bound) {
  return {.response = {name, "mm", std::move(f)}, .lower = bound};
}
inline Constraint equal(const std::string& name, Function f, double bound) {
  return {.response = {name, "mm", std::move(f)}, .lower = bound, .upper = bound};
}

/// Least (x - 1)^2 + 2 (y + 1/2)^2 + x y in [-3, 3]^2. From 2 (x - 1) + y = 0 and
/// 4 (y + 1/2) + x = 0: x = 10/7, y = -6/7, (18 + 25 - 120) / 98 = -11/14.
inline Problem bowl() {
  Problem problem;
  problem.variables = {variable("x", -3, 3), variable("y", -3, 3)};
  problem.objectives = {least(convex({0, 1}, [](const auto& u) {
    return square(u[0] - 1.0) + 2.0 * square(u[1] + 0.5) + u[0] * u[1];
  }))};
  return problem;
}

inline Function sum() {
  return linear({0, 1}, [](const auto& u) { return u[0] + u[1]; });
}

/// (x^2 - 1)^2 + x / 5 + y^2: two valleys, the deeper one by x = -1.
inline Problem two_valleys() {
  Problem problem;
  problem.variables = {variable("x", -2, 2, 0.9), variable("y", -2, 2, 0.5)};
  problem.objectives = {least(function<Interval>({0, 1}, [](const auto& u) {
    return square(square(u[0]) - 1.0) + 0.2 * u[0] + square(u[1]);
  }))};
  return problem;
}

/// A stationary point of (x^2 - 1)^2 + x / 5: a root of 4 x^3 - 4 x + 1/5 by Newton's method.
inline double valley(double x) {
  for (int i = 0; i < 50; ++i) x -= (4 * x * x * x - 4 * x + 0.2) / (12 * x * x - 4);
  return x;
}

/// A function that does something before each evaluation: waits, counts, throws.
class Observed final : public Kernel {
 public:
  Observed(Function f, std::function<void(std::span<const double>)> before)
      : f_(std::move(f)), before_(std::move(before)) {}
  double value(std::span<const double> u) const override {
    before_(u);
    return f_.value(design_of(u));
  }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    before_(u);
    return f_.gradient(design_of(u), g);
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    before_(u);
    return f_.hessian(design_of(u), g, h);
  }

 private:
  /// A design with these values of the function's inputs.
  std::vector<double> design_of(std::span<const double> u) const {
    const std::vector<std::size_t>& inputs = f_.inputs();
    std::vector<double> x(1 + *std::max_element(inputs.begin(), inputs.end()));
    for (std::size_t k = 0; k < inputs.size(); ++k) x[inputs[k]] = u[k];
    return x;
  }

  Function f_;
  std::function<void(std::span<const double>)> before_;
};

inline Function observed(Function f, std::function<void(std::span<const double>)> before) {
  std::vector<std::size_t> inputs = f.inputs();
  return Function(std::move(inputs), std::make_shared<Observed>(std::move(f), std::move(before)));
}

/// Rosenbrock's valley from its usual start: many iterations for every method.
inline Function rosenbrock() {
  return function<Interval>({0, 1}, [](const auto& u) {
    return 100.0 * square(u[1] - square(u[0])) + square(1.0 - u[0]);
  });
}

inline Problem valley_of(Function f) {
  Problem problem;
  problem.variables = {variable("x", -5, 5, -1.2), variable("y", -5, 5, 1)};
  problem.objectives = {least(std::move(f))};
  return problem;
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Every number of an answer.
inline Point numbers(const Optimum& optimum) {
  const Assessment& a = optimum.found.assessment;
  Point all = optimum.found.x;
  all.insert(all.end(), {a.objective.value, a.kkt_residual, a.condition});
  for (const LimitReport& limit : a.limits) {
    all.insert(all.end(), {limit.value, limit.margin, limit.tolerance, limit.multiplier,
                           limit.worst_angle.value_or(0)});
  }
  for (const VariableReport& v : a.variables) all.insert(all.end(), {v.value, v.multiplier});
  return all;
}

inline bool same_bits(const Point& a, const Point& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

}  // namespace camlaw::optim::search_tests
