// SPDX-License-Identifier: MIT
#include "fitting/constants/explanation.h"

#include <algorithm>
#include <tuple>

#include "fitting/constants/agreement.h"
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
                                     std::vector<double> x, double limit) {
  constexpr int kAllDigits = 17;
  ConstantsFit result{model.law_at(x), {}, {}, 0, false, true};
  const Agreement free(model, agreeing);
  Agreement search = free;
  const auto determined = free.determined(x);
  const auto& unknowns = model.unknowns();
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    FoundNumber number{unknowns[i].name, unknowns[i].unit, unknowns[i].of_law};
    number.identifiable = determined[i];
    result.identifiable = result.identifiable && determined[i];
    const auto [low, high] = search.range(i, x);
    const SimpleNumber simple = simplest_of(unknowns[i], low, high);
    Agreement held = search;
    held.hold(i, simple.value);
    if (const auto near = held.near(x)) {
      x = *near;
      search = held;
      result.cost += simple.digits;
    } else {  // the interval has a gap there
      search.hold(i, x[i]);
      result.cost += kAllDigits;
    }
    if (result.cost > limit) return {};
    std::tie(number.low, number.high) = i == 0 ? std::pair(low, high) : free.range(i, x);
    number.value = x[i];
    result.numbers.push_back(std::move(number));
  }
  check(model, x, result);
  if (result.cost > limit) return {};
  return result;
}

}  // namespace camlaw::problems
