// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "benchmarks/timing.h"
#include "kinematics/program/program.h"
#include "machines/model/law_binding.h"
#include "machines/registry.h"

/// Means over the cycle, with their gradients by many variables.
namespace camlaw::benchmarks {
namespace {

using problems::Binding, problems::LawBinding, problems::LawVariable, problems::Mechanism;

/// A rise by a spline of so many coefficients, a dwell, a return and a dwell.
Member free_rise(int coefficients) {
  constexpr int kDegree = 4;
  Member law = find_law("b-spline");
  std::vector<double> knots, values;
  const int spans = coefficients - kDegree;
  for (int i = 1; i < spans; ++i) knots.push_back(static_cast<double>(i) / spans);
  for (int i = 0; i < coefficients; ++i) {
    const double x = std::clamp((i - 2.0) / (coefficients - 5), 0.0, 1.0);
    values.push_back(x * x * x * (10 + x * (-15 + 6 * x)));
  }
  law.arguments.values()[law.family->parameter("degree")] = {kDegree};
  law.arguments.values()[law.family->parameter("knots")] = knots;
  law.arguments.values()[law.family->parameter("coefficients")] = values;
  return motion_program({{.name = "rise", .angle = 110, .to = 1, .law = law},
                         {.name = "high", .angle = 60, .to = 1, .rests = true},
                         {.name = "return", .angle = 80, .to = 0, .law = find_law("cycloidal")},
                         {.name = "low", .angle = 110, .to = 0, .rests = true}},
                        Matched::Velocity);
}

struct Case {
  std::string law;
  Member member;
  std::vector<LawVariable> variables;
};

/// The times of the value and of its gradient, us.
void print_row(const Case& one, const std::string& name) {
  const Mechanism& mechanism = problems::find_mechanism("disc-cam-roller");
  Binding binding;
  for (const auto& p : mechanism.parameters) binding.constants.push_back(p.default_value);
  for (const char* of_machine : {"base_radius", "roller_radius", "spring_rate"}) {
    binding.parameters.push_back(mechanism.parameter(of_machine));
  }
  std::ranges::sort(binding.parameters);
  std::vector<double> x;
  for (const std::size_t parameter : binding.parameters) {
    binding.variables.push_back(x.size());
    x.push_back(binding.constants[parameter]);
  }
  std::vector<LawVariable> variables = one.variables;
  for (LawVariable& v : variables) {
    v.variable = x.size();
    x.push_back(one.member.arguments.list(v.parameter)[v.element]);
  }
  binding.law = std::make_shared<const LawBinding>(one.member, variables);
  const auto response =
      std::ranges::find(mechanism.responses, name, [](const auto& r) { return r.name; });
  const optim::Function f = response->number(binding, optim::Shape::General);
  std::vector<double> g(f.inputs().size());
  double sum = f.gradient(x, g);
  std::vector<double> value, gradient;
  for (int i = 0; i < 11; ++i) {
    constexpr int kPasses = 5;
    value.push_back(1e6 * processor_seconds([&] {
                      for (int k = 0; k < kPasses; ++k) sum += f.value(x);
                    }) /
                    kPasses);
    gradient.push_back(1e6 * processor_seconds([&] {
                         for (int k = 0; k < kPasses; ++k) sum += f.gradient(x, g);
                       }) /
                       kPasses);
  }
  fmt::print("| {} | {} | {} | {:.0f} | {:.0f} | {:.1f} |\n", name, one.law, x.size(),
             median(value), median(gradient), median(gradient) / median(value));
}

}  // namespace

void print_mean_table() {
  std::vector<Case> cases;
  for (const int coefficients : {7, 14, 42}) {
    Case one{fmt::format("spline of {} coefficients", coefficients), free_rise(coefficients), {}};
    const std::size_t parameter = one.member.family->parameter("rise_coefficients");
    for (std::size_t i = 3; i + 3 < std::size_t(coefficients); ++i) {
      one.variables.push_back({parameter, i, 0});
    }
    cases.push_back(one);
  }
  fmt::print(
      "means over the cycle\n\n| mean | law | variables | value, us | gradient, us | gradient "
      "over value |\n|---|---|--:|--:|--:|--:|\n");
  for (const char* name : {"torque_rms", "equivalent_load", "life"}) {
    for (const Case& one : cases) print_row(one, name);
  }
  fmt::print("\n");
}

}  // namespace camlaw::benchmarks
