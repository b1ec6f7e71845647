// SPDX-License-Identifier: MIT
#include "numerics/formula/deciders.h"

#include <algorithm>
#include <optional>

#include "numerics/formula/expression.h"
#include "numerics/formula/steps.h"

namespace camlaw {
namespace {

using Numbers = std::span<const Expression>;

/// Writes a step again, of the numbers that the steps before it have become.
Expression written_again(Step step, Numbers inputs, Numbers before) {
  if (step.operation == Operation::Input) return inputs[step.a];
  const std::size_t count = operands(step.operation);
  if (count > 0) step.a = before[step.a].step();
  if (count > 1) step.b = before[step.b].step();
  if (count > 2) step.c = before[step.c].step();
  return Expression::of(step);
}

/// What a step decides by: the sign of a number that an earlier step gives, or of one less another.
struct Decision {
  std::uint32_t number;
  std::optional<std::uint32_t> less = {};
};
using Decisions = std::vector<Decision>;

Decisions decisions(const Step& step) {
  switch (step.operation) {
    case Operation::Absolute:
    case Operation::BySide:
    case Operation::WherePositive:
    case Operation::UnlessZero:
      return {{step.a}};
    case Operation::Along:
      return {{step.a}, {step.b}};
    case Operation::Greater:
    case Operation::Lesser:
      return {{step.a, step.b}};
    default:
      return {};
  }
}

/// The first number of a step that may jump where that one changes its sign.
Decisions jumps(const Step& step) {
  if (step.operation != Operation::BySide && step.operation != Operation::Along) return {};
  return {{step.a}};
}

Formula decider_of(const Decision& decision, const Formula& formula) {
  const std::vector<Step>& steps = formula.steps();
  std::vector<std::uint32_t> values{decision.number};
  if (decision.less) values.push_back(*decision.less);
  const std::vector<bool> needed = needed_for(values, steps);
  return Formula::record(formula.inputs(), [&](Numbers inputs) {
    std::vector<Expression> results(needed.size(), Expression(0.0));
    for (std::size_t k = 0; k < needed.size(); ++k) {
      if (needed[k]) results[k] = written_again(steps[k], inputs, results);
    }
    const Expression& number = results[decision.number];
    return decision.less ? number - results[*decision.less] : number;
  });
}

std::vector<Formula> deciders_by(const Formula& formula, Decisions (*decisions)(const Step&)) {
  const std::vector<Step>& steps = formula.steps();
  const auto searches = [](const Step& step) { return step.operation == Operation::Root; };
  if (std::ranges::any_of(steps, searches)) return {};
  std::vector<Formula> result;
  for (const Step& step : steps) {
    for (const Decision& decision : decisions(step)) {
      Formula decider = decider_of(decision, formula);
      const auto is_same = [&](const Formula& known) { return known.steps() == decider.steps(); };
      if (std::ranges::none_of(result, is_same)) result.push_back(std::move(decider));
    }
  }
  return result;
}

}  // namespace

std::vector<Formula> deciders(const Formula& formula) { return deciders_by(formula, decisions); }

std::vector<Formula> jump_deciders(const Formula& formula) { return deciders_by(formula, jumps); }

std::vector<Formula> moving(std::vector<Formula> formulas, std::size_t first) {
  std::erase_if(formulas, [&](const Formula& formula) {
    return std::ranges::none_of(formula.uses(), [&](std::size_t input) { return input >= first; });
  });
  return formulas;
}

}  // namespace camlaw
