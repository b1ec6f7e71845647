// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "benchmarks/speed/hand_formulas.h"
#include "benchmarks/timing.h"
#include "machines/model/recorded_response.h"
#include "machines/registry.h"
#include "numerics/formula/expression.h"
#include "optim/problem/automatic.h"

/// One evaluation of a machine's recorded formula, of its derivatives and of its enclosures.
namespace camlaw::benchmarks {
namespace {

using problems::Mechanism, problems::MechanismResponse;

/// A response's record in the inputs that a formula written by hand has, all of which vary, at
/// numbers of them.
struct Case {
  problems::Recorded record;
  std::vector<double> at;
};

Case case_of(const HandFormula& hand) {
  const Mechanism& mechanism = problems::find_mechanism(hand.machine);
  const MechanismResponse& response =
      *std::find_if(mechanism.responses.begin(), mechanism.responses.end(),
                    [&](const MechanismResponse& one) { return one.name == hand.response; });
  const std::vector<std::string> others = problems::other_names(response);
  Case result{
      {Formula::record(hand.inputs.size(),
                       [&](std::span<const Expression> u) {
                         const auto given = [&](const std::string& name, double otherwise) {
                           const auto found =
                               std::find(hand.inputs.begin(), hand.inputs.end(), name);
                           return found == hand.inputs.end()
                                      ? Expression(otherwise)
                                      : u[static_cast<std::size_t>(found - hand.inputs.begin())];
                         };
                         std::vector<Expression> parameters, place;
                         for (const auto& p : mechanism.parameters) {
                           parameters.push_back(given(p.name, p.default_value));
                         }
                         for (const std::string& name : others) place.push_back(given(name, 0));
                         return response.write(parameters, place);
                       }),
       hand.inputs.size(),
       {}},
      {}};
  for (const std::string& name : hand.inputs) {
    constexpr double kPlace = 0.3, kFriction = 0.1, kLength = 30;
    const auto p = std::find_if(mechanism.parameters.begin(), mechanism.parameters.end(),
                                [&](const auto& one) { return one.name == name; });
    double value = p == mechanism.parameters.end() ? kPlace : p->default_value;
    if (value == 0) value = name == "guide_friction" ? kFriction : kLength;
    result.at.push_back(value);
  }
  return result;
}

/// Of some calls that follow one another, nanoseconds of one.
template <class Work>
double nanoseconds(const Work& work) {
  constexpr int kPasses = 500;
  return 1e9 * processor_seconds(work, kPasses) / kPasses;
}

struct Times {
  std::vector<double> hand, value, gradient, forward, hessian, twice_forward, enclosure, range,
      range_forward;
};

void print_row(const HandFormula& hand) {
  const Case one = case_of(hand);
  const auto kernel = problems::recorded_kernel(one.record);
  const std::size_t n = one.at.size();
  std::vector<double> u = one.at, g(n), h(optim::packed_size(n));
  std::vector<optim::Bounds> box;
  for (const double x : u) box.push_back({x * (1 - 1e-3), x * (1 + 1e-3)});
  const double by_hand = hand.value(u), recorded = kernel->value(u);
  if (!(std::abs(by_hand - recorded) <= 1e-12 * std::abs(by_hand))) {
    throw std::runtime_error(fmt::format("{} {}: by hand {}, recorded {}", hand.machine,
                                         hand.response, by_hand, recorded));
  }
  const optim::AutomaticKernel<problems::Recorded, Interval, Series<Interval, 2>> ahead(one.record);
  Times times;
  double sum = 0;  // so that nothing is left out
  const Formula& formula = one.record.formula;
  for (int i = 0; i < 41; ++i) {
    u[0] = one.at[0] * (1 + 1e-6 * i);
    times.hand.push_back(nanoseconds([&] {
      u[0] += 1e-12;
      sum += hand.value(u);
    }));
    times.value.push_back(nanoseconds([&] { sum += kernel->value(u); }));
    times.gradient.push_back(nanoseconds([&] { sum += kernel->gradient(u, g); }));
    times.forward.push_back(nanoseconds(
        [&] { sum += optim::automatic_gradient(formula, std::span<const double>(u), g); }));
    times.hessian.push_back(nanoseconds([&] { sum += kernel->hessian(u, g, h); }));
    times.twice_forward.push_back(nanoseconds(
        [&] { sum += optim::automatic_hessian(formula, std::span<const double>(u), g, h); }));
    times.enclosure.push_back(nanoseconds([&] { sum += kernel->enclose(u).lower; }));
    times.range.push_back(nanoseconds([&] { sum += kernel->range(box).value.lower; }));
    times.range_forward.push_back(nanoseconds([&] { sum += ahead.range(box).value.lower; }));
  }
  const auto ratio = [&](const std::vector<double>& of) {
    std::vector<double> all;
    for (std::size_t i = 0; i < of.size(); ++i) all.push_back(of[i] / times.hand[i]);
    return median(all);
  };
  fmt::print(
      "| {}: {} | {} | {} | {:.1f} | {:.1f} | {:.1f} ({:.1f}) | {:.1f} ({:.1f}) | {:.1f} | "
      "{:.0f} ({:.0f}) |{}\n",
      hand.machine, hand.response, n, formula.steps().size(), median(times.hand),
      ratio(times.value), ratio(times.gradient), ratio(times.forward), ratio(times.hessian),
      ratio(times.twice_forward), ratio(times.enclosure), ratio(times.range),
      ratio(times.range_forward), std::isfinite(sum) ? "" : " not finite");
}

}  // namespace

void print_formula_table() {
  fmt::print(
      "one evaluation of a recorded formula, in the time of the formula written by hand in plain "
      "numbers (in brackets by passes forward alone)\n\n"
      "| formula | inputs | steps | by hand, ns | value | gradient | Hessian | enclosure | range "
      "and slopes over a box |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  for (const HandFormula& hand : hand_formulas()) print_row(hand);
  fmt::print("\n");
}

}  // namespace camlaw::benchmarks
