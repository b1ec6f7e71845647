// SPDX-License-Identifier: MIT
#pragma once

#include "optim/problem/check_derivatives.h"
#include "optim/search/optimise.h"
#include "problems/statement/bind.h"
#include "tests/machines/mechanism_fixture.h"
#include "tests/paths.h"

/// What the published systems' tests have in common.
namespace camlaw::testing {}

namespace camlaw::problems::testing {

using namespace camlaw::testing;  // what tests of other rooms use too

/// Every parameter of the machine that is not an integer.
inline std::vector<std::string> all_parameters(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (const auto& parameter : mechanism.parameters) names.push_back(parameter.name);
  return names;
}

/// Exact derivatives of every curve at some places, and enclosures that hold around them and close
/// on the value.
inline void check_curves(const Mechanism& mechanism, const TestDesign& design,
                         const std::vector<double>& places) {
  for (const auto& listed : mechanism.responses) {
    if (!listed.curve) continue;
    const auto response = response_of(mechanism, listed.name, design.binding);
    const auto trace = response.curve().trace(design.x);
    for (const double place : places) {
      INFO(listed.name << " at " << place);
      check_derivatives(response.curve().at({place}), design.x);
      const double h = 1e-4 * trace->breaks().back();
      const auto at = trace->at({place});
      const double size = std::abs(at[0]) + std::abs(at[1]) * trace->breaks().back();
      const auto value = [&](double by) { return trace->at({place + by})[0]; };
      CHECK(at[0] == Approx(response.curve().at({place}).value(design.x)).epsilon(1e-12));
      CHECK(at[1] * h ==
            Approx(slope([&](double t) { return value(t * h); }, 1)).margin(1e-9 * size));
      const auto bounds = trace->enclose(place - h, place + h);
      for (const double by : {-h, -0.3 * h, 0.0, 0.9 * h}) {
        CHECK((bounds.lower <= value(by) && value(by) <= bounds.upper));
      }
      CHECK(bounds.upper - bounds.lower <= 1e-2 * size);
    }
  }
}

inline void check_numbers(const Mechanism& mechanism, const TestDesign& design) {
  for (const auto& listed : mechanism.responses) {
    if (!listed.number) continue;
    INFO(listed.name);
    const auto function = response_of(mechanism, listed.name, design.binding).function();
    check_derivatives(function, design.x);
    const auto bounds = function.enclose(design.x);
    const double value = function.value(design.x);
    CHECK((bounds.lower <= value && value <= bounds.upper));
    CHECK(bounds.upper - bounds.lower <= 1e-11 * std::abs(value));
  }
}

inline BoundProblem shipped(const std::string& file) {
  return BoundProblem(read_problem_file(testing::source("problems/") + file));
}

/// Where a rising f is 0 between two numbers, by halving; an end where it is 0 beyond that one.
template <class F>
double root(const F& f, double low, double high) {
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (f(middle) < 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// Least f(t) over a grid on [low, high], refined by golden section around the best.
template <class F>
double grid_minimum(const F& f, double low, double high, int steps, double* where = nullptr) {
  double best = low;
  for (int i = 1; i <= steps; ++i) {
    const double t = low + (high - low) * i / steps;
    if (f(t) < f(best)) best = t;
  }
  const double ratio = 0.6180339887498949, step = (high - low) / steps;
  double a = std::max(low, best - step), b = std::min(high, best + step);
  while (b - a > 1e-9 * (high - low)) {
    const double c = b - ratio * (b - a), d = a + ratio * (b - a);
    (f(c) < f(d) ? b : a) = f(c) < f(d) ? d : c;
  }
  const double t = (a + b) / 2;
  if (where != nullptr) *where = f(t) < f(best) ? t : best;
  return std::min(f(t), f(best));
}

}  // namespace camlaw::problems::testing
