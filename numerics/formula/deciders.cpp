// SPDX-License-Identifier: MIT
#include "numerics/formula/deciders.h"

#include <algorithm>

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

using Decisions = std::vector<std::function<Expression(Numbers)>>;

/// What a step decides by.
Decisions decisions(const Step& step) {
  const auto one = [](std::uint32_t number) {
    return [number](Numbers results) { return results[number]; };
  };
  switch (step.operation) {
    case Operation::Absolute:
    case Operation::BySide:
    case Operation::WherePositive:
    case Operation::UnlessZero:
      return {one(step.a)};
    case Operation::Along:
      return {one(step.a), one(step.b)};
    case Operation::Greater:
    case Operation::Lesser:
      return {[step](Numbers results) { return results[step.a] - results[step.b]; }};
    default:
      return {};
  }
}

/// The first number of a step that may jump where that one changes its sign.
Decisions jumps(const Step& step) {
  if (step.operation != Operation::BySide && step.operation != Operation::Along) return {};
  return {[number = step.a](Numbers results) { return results[number]; }};
}

std::vector<Formula> deciders_by(const Formula& formula, Decisions (*decisions)(const Step&)) {
  const std::vector<Step>& steps = formula.steps();
  const auto searches = [](const Step& step) { return step.operation == Operation::Root; };
  if (std::ranges::any_of(steps, searches)) return {};
  std::vector<Formula> result;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    for (const auto& decision : decisions(steps[i])) {
      Formula decider = Formula::record(formula.inputs(), [&](Numbers inputs) {
        std::vector<Expression> results;
        for (std::size_t k = 0; k < i; ++k) {
          results.push_back(written_again(steps[k], inputs, results));
        }
        return decision(results);
      });
      const auto is_same = [&](const Formula& known) { return known.steps() == decider.steps(); };
      if (std::ranges::none_of(result, is_same)) result.push_back(std::move(decider));
    }
  }
  return result;
}

}  // namespace

std::vector<Formula> deciders(const Formula& formula) { return deciders_by(formula, decisions); }

std::vector<Formula> jump_deciders(const Formula& formula) { return deciders_by(formula, jumps); }

}  // namespace camlaw
