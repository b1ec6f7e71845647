// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "kinematics/program/program.h"
#include "machines/model/law_binding.h"
#include "machines/model/mechanism.h"

/// Designs of a mechanism for tests: some of its parameters and some of its law's vary.
namespace camlaw::testing {}

namespace camlaw::problems::testing {

using namespace camlaw::testing;  // what tests of other rooms use too

struct TestDesign {
  Binding binding;
  std::vector<double> x;  ///< the design as it stands
};

/// Every element of the named parameters of the law.
inline std::vector<LawVariable> law_variables(const Member& law,
                                              const std::vector<std::string>& names) {
  std::vector<LawVariable> result;
  for (const std::string& name : names) {
    const std::size_t parameter = law.family->parameter(name);
    for (std::size_t i = 0; i < law.arguments.list(parameter).size(); ++i) {
      result.push_back({parameter, i});
    }
  }
  return result;
}

/// A rise by a law, a dwell, a return and a dwell: the rise's parameters are "rise_" and the law's.
inline Member with_dwells(const std::string& law) {
  return motion_program({{.name = "rise", .angle = 110, .to = 1, .law = find_law(law)},
                         {.name = "high", .angle = 60, .to = 1, .rests = true},
                         {.name = "return", .angle = 80, .to = 0, .law = find_law("cycloidal")},
                         {.name = "low", .angle = 110, .to = 0, .rests = true}},
                        Matched::Velocity);
}

/// Variables in an order of their own: those of the law first, the machine's from last to first. A
/// cam's follower has an elastic end, which no default states.
inline TestDesign design_of(const Mechanism& mechanism, const Member& member,
                            const std::vector<std::string>& of_law,
                            const std::vector<std::string>& of_machine) {
  constexpr double kStiffness = 2;
  TestDesign design;
  std::vector<LawVariable> variables = law_variables(member, of_law);
  for (LawVariable& v : variables) {
    v.variable = design.x.size();
    design.x.push_back(member.arguments.list(v.parameter)[v.element]);
  }
  Binding& binding = design.binding;
  for (const auto& p : mechanism.parameters) {
    binding.constants.push_back(p.name == "train_stiffness" ? kStiffness : p.default_value);
  }
  for (const auto& name : of_machine) binding.parameters.push_back(mechanism.parameter(name));
  std::sort(binding.parameters.begin(), binding.parameters.end());
  design.x.resize(design.x.size() + binding.parameters.size());
  for (std::size_t k = 0; k < binding.parameters.size(); ++k) {
    binding.variables.push_back(design.x.size() - 1 - k);
    design.x[binding.variables[k]] = binding.constants[binding.parameters[k]];
  }
  binding.law = std::make_shared<const LawBinding>(member, variables);
  return design;
}

inline TestDesign design_of(const Mechanism& mechanism, const std::string& law,
                            const std::vector<std::string>& of_law,
                            const std::vector<std::string>& of_machine) {
  return design_of(mechanism, find_law(law), of_law, of_machine);
}

inline optim::Response response_of(const Mechanism& mechanism, const std::string& name,
                                   const Binding& binding) {
  return make_response(mechanism, find_response(mechanism, name), binding);
}

/// The derivative at 0 of f by central differences with Richardson: error of fourth order.
template <class F>
double slope(const F& f, double h) {
  return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h);
}

/// Gradient and Hessian against differences of value and gradient. `step` is relative. Values agree
/// to `same`, and gradients by a pass back and forward to ten times that.
inline void check_derivatives(const optim::Function& f, const std::vector<double>& x,
                              double step = 1e-3, double tolerance = 1e-7, double same = 1e-13) {
  constexpr std::array<double, 4> kSteps{-2, -1, 1, 2};
  const std::size_t n = f.inputs().size();
  std::vector<double> g(n), g2(n), h(optim::packed_size(n));
  const double value = f.value(x);
  REQUIRE(std::isfinite(value));
  CHECK(f.gradient(x, g) == Approx(value).epsilon(same).margin(same));
  CHECK(f.hessian(x, g2, h) == Approx(value).epsilon(same).margin(same));
  const auto moved = [&](std::size_t i, double by) {
    std::vector<double> y = x;
    y[f.inputs()[i]] += by;
    return y;
  };
  for (std::size_t i = 0; i < n; ++i) {
    const double by = step * std::max(0.1, std::abs(x[f.inputs()[i]]));
    INFO("by variable " << f.inputs()[i]);
    const double first = slope([&](double t) { return f.value(moved(i, t)); }, by);
    const double size = std::abs(value) + std::abs(first);
    CHECK(g[i] == Approx(first).epsilon(tolerance).margin(tolerance * size));
    CHECK(g2[i] == Approx(g[i]).epsilon(10 * same).margin(10 * same * size));
    std::array<std::vector<double>, 4> gradients;  // at -2, -1, 1 and 2 steps
    for (std::size_t at = 0; at < 4; ++at) {
      gradients[at].resize(n);
      f.gradient(moved(i, kSteps[at] * by), gradients[at]);
    }
    for (std::size_t k = 0; k < n; ++k) {
      const double second =
          (8 * (gradients[2][k] - gradients[1][k]) - (gradients[3][k] - gradients[0][k])) /
          (12 * by);
      INFO("and variable " << f.inputs()[k]);
      const double bent = std::abs(second) + std::abs(g[k]) + size;
      CHECK(h[optim::packed(std::max(i, k), std::min(i, k))] ==
            Approx(second).epsilon(tolerance).margin(tolerance * bent));
    }
  }
}

}  // namespace camlaw::problems::testing
