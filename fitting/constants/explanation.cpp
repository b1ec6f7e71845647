// SPDX-License-Identifier: MIT
#include "fitting/constants/explanation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fitting/motions/simplest.h"

namespace camlaw::problems {
namespace {

/// A number of digits, and the value that takes them.
SimpleNumber simplest_of(const Unknown& unknown, double low, double high) {
  if (low <= unknown.default_value && unknown.default_value <= high)
    return {unknown.default_value, 0};
  SimpleNumber simple = simplest_between(low, high);
  ++simple.digits;  // for its being there
  return simple;
}

/// The simplest value of an unknown that leaves the others values to agree with, which the search
/// then holds, and these values. None where only the solution's own does.
std::optional<std::vector<double>> hold_simplest(const Unknown& unknown, std::size_t i,
                                                 const AgreeingValues& solution, Agreement& search,
                                                 double& digits) {
  constexpr int kTries = 4;           // there may be gaps between low and high
  constexpr double kRounding = 1e-9;  // that searches for the ends leave
  const double room = kRounding * std::max(std::abs(solution.low[i]), std::abs(solution.high[i]));
  double low = std::max(unknown.lower, solution.low[i] - room);
  double high = std::min(unknown.upper, solution.high[i] + room);
  for (int k = 0; k < kTries; ++k) {
    const SimpleNumber simple = simplest_of(unknown, low, high);
    Agreement held = search;
    held.hold(i, simple.value);
    if (auto near = held.near(solution, i)) {
      search = held;
      digits = simple.digits;
      return near;
    }
    low = std::midpoint(low, solution.x[i]);
    high = std::midpoint(high, solution.x[i]);
  }
  return {};
}

/// The constants at the numbers found; those that do not agree cost what they take to write.
void check(const PrintedModel& model, const std::vector<double>& x, ConstantsFit& fit) {
  fit.law = model.law_at(x);
  fit.consistent = true;
  for (std::size_t c = 0; c < model.constants().size(); ++c) {
    const PrintedConstant& printed = model.constants()[c];
    const bool agrees = model.agrees(c, x);
    fit.constants.push_back({printed, model.value(c, x), agrees});
    fit.consistent = fit.consistent && agrees;
    if (!agrees) fit.cost += cost_of(printed);
  }
}

}  // namespace

double cost_of(const PrintedConstant& constant) { return constant.digits + 1; }

double cost_of(const std::vector<PrintedConstant>& constants) {
  double sum = 0;
  for (const PrintedConstant& constant : constants) sum += cost_of(constant);
  return sum;
}

std::optional<ConstantsFit> shortest(const PrintedModel& model,
                                     const std::vector<std::size_t>& agreeing,
                                     const AgreeingValues& solution,
                                     std::span<const AgreeingValues> all, double limit) {
  constexpr int kAllDigits = 17;  // digits that tell any double
  std::vector<double> x = solution.x;
  ConstantsFit result{model.law_at(x), {}, {}, 0, false, true};
  Agreement search(model, agreeing);
  const auto determined = search.determined(x);
  const auto& unknowns = model.unknowns();
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    FoundNumber number{unknowns[i].name, unknowns[i].unit, unknowns[i].of_law};
    number.low = solution.low[i];
    number.high = solution.high[i];
    number.identifiable =
        determined[i] && std::all_of(all.begin(), all.end(), [&](const AgreeingValues& other) {
          return other.low[i] <= number.high && other.high[i] >= number.low;
        });
    result.identifiable = result.identifiable && number.identifiable;
    double digits = kAllDigits;
    const AgreeingValues left = i == 0 ? solution : search.within(x);
    if (const auto near = hold_simplest(unknowns[i], i, left, search, digits)) {
      x = *near;
    } else {
      search.hold(i, x[i]);
    }
    result.cost += digits;
    if (result.cost > limit) return {};
    number.value = x[i];
    number.low = std::min(number.low, x[i]);
    number.high = std::max(number.high, x[i]);
    result.numbers.push_back(std::move(number));
  }
  for (std::size_t i = 0; i < unknowns.size(); ++i) result.numbers[i].value = x[i];
  check(model, x, result);
  if (result.cost > limit) return {};
  return result;
}

ConstantsFit with_ranges(const PrintedModel& model, ConstantsFit fit) {
  std::vector<double> x = model.defaults();
  for (std::size_t i = 0; i < fit.numbers.size(); ++i) x[i] = fit.numbers[i].value;
  std::vector<std::size_t> agreeing;
  for (std::size_t c = 0; c < fit.constants.size(); ++c) {
    if (fit.constants[c].agrees) agreeing.push_back(c);
  }
  const Agreement search(model, agreeing);
  const AgreeingValues solution = search.within(x);
  const std::vector<bool> determined = search.determined(x);
  fit.numbers.clear();
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Unknown& u = model.unknowns()[i];
    fit.numbers.push_back(
        {u.name, u.unit, u.of_law, x[i], solution.low[i], solution.high[i], determined[i]});
    fit.identifiable = fit.identifiable && determined[i];
  }
  return fit;
}

ConstantsFit as_it_is(const PrintedModel& model) {
  ConstantsFit result{model.law_at(model.defaults()), {}, {}, 0, false, true};
  check(model, model.defaults(), result);
  return result;
}

}  // namespace camlaw::problems
