// SPDX-License-Identifier: MIT
#include "numerics/formula/formula_ranges.h"

#include <algorithm>
#include <array>
#include <optional>

#include "numerics/formula/operations.h"
#include "numerics/formula/steps.h"

namespace camlaw {
namespace {

/// Of a function of one number the slope at it, from what it is there; none of one that has a kink
/// or an edge.
std::optional<Interval> smooth_slope(Operation operation, const Interval& x,
                                     const Interval& value) {
  const Interval one(1.0);
  switch (operation) {
    case Operation::Sin:
      return cos(x);
    case Operation::Cos:
      return -sin(x);
    case Operation::Tan:
      return one + value * value;
    case Operation::Asin:
      return quotient(one, sqrt((one - x) * (one + x)));
    case Operation::Atan:
      return quotient(one, one + x * x);
    case Operation::Log:
      return quotient(one, x);
    case Operation::Exp:
      return value;
    default:
      return {};
  }
}

}  // namespace

FormulaRanges::FormulaRanges(const Formula& formula) : inputs_(formula.inputs()) {
  const std::vector<Step>& steps = formula.steps();
  std::vector<std::vector<std::uint32_t>> behind(steps.size());
  constants_.resize(steps.size());
  for (std::uint32_t i = 0; i < steps.size(); ++i) {
    const Step& step = steps[i];
    const std::array from{step.a, step.b, step.c};
    std::vector<std::uint32_t>& inputs = behind[i];
    if (step.operation == Operation::Input) inputs.push_back(step.a);
    for (std::size_t k = 0; k < operands(step.operation); ++k) {
      inputs.insert(inputs.end(), behind[from[k]].begin(), behind[from[k]].end());
    }
    std::sort(inputs.begin(), inputs.end());
    inputs.erase(std::unique(inputs.begin(), inputs.end()), inputs.end());
    if (!inputs.empty()) {
      const auto begin = static_cast<std::uint32_t>(reached_.size());
      reached_.insert(reached_.end(), inputs.begin(), inputs.end());
      varying_.push_back({step.operation, i, step.a, step.b, step.c, begin,
                          static_cast<std::uint32_t>(reached_.size())});
    } else {
      constants_[i] = step.operation == Operation::Constant
                          ? Interval(step.lower, step.upper)
                          : operate<Interval>(step.operation, constants_[step.a],
                                              constants_[step.b], constants_[step.c]);
    }
  }
}

void FormulaRanges::add_slopes(const Varying& step, const Interval* values,
                               std::vector<Interval>& slopes) const {
  const Interval &a = values[step.a], &b = values[step.b], &own = values[step.result];
  const auto each = [&](const auto& by) {
    for (std::uint32_t k = step.begin; k < step.end; ++k) {
      const std::uint32_t input = reached_[k];
      slope(slopes, step.result, input) = by(slope(slopes, step.a, input), input);
    }
  };
  const auto of_b = [&](std::uint32_t input) -> const Interval& {
    return slope(slopes, step.b, input);
  };
  switch (step.operation) {
    case Operation::Input:
      slope(slopes, step.result, step.a) = Interval(1.0);
      return;
    case Operation::Add:
      return each([&](const Interval& by_a, std::uint32_t i) { return by_a + of_b(i); });
    case Operation::Subtract:
      return each([&](const Interval& by_a, std::uint32_t i) { return by_a - of_b(i); });
    case Operation::Multiply:
      return each([&](const Interval& by_a, std::uint32_t i) { return a * of_b(i) + by_a * b; });
    case Operation::Divide:
      return each(
          [&](const Interval& by_a, std::uint32_t i) { return quotient(by_a - of_b(i) * own, b); });
    case Operation::Negate:
      return each([&](const Interval& by_a, std::uint32_t) { return -by_a; });
    case Operation::Sqrt: {
      const Interval twice = own + own;
      return each([&](const Interval& by_a, std::uint32_t) { return quotient(by_a, twice); });
    }
    default:
      break;
  }
  if (const auto rate = smooth_slope(step.operation, a, own)) {
    return each([&](const Interval& by_a, std::uint32_t) { return by_a * *rate; });
  }
  // What has kinks and edges says itself what is known of its slopes.
  const std::size_t used = operands(step.operation);
  each([&](const Interval& by_a, std::uint32_t i) {
    using Slopes = Series<Interval, 2>;
    const Slopes none;
    return operate<Slopes>(
               step.operation, Slopes::variable(a, by_a),
               used > 1 ? Slopes::variable(b, of_b(i)) : none,
               used > 2 ? Slopes::variable(values[step.c], slope(slopes, step.c, i)) : none)
        .c[1];
  });
}

Interval FormulaRanges::operator()(std::span<const Interval> box,
                                   std::span<Interval> slopes) const {
  thread_local std::vector<Interval> values, all;
  values = constants_;
  all.assign(constants_.size() * inputs_, Interval(0.0));
  for (const Varying& step : varying_) {
    values[step.result] =
        step.operation == Operation::Input
            ? box[step.a]
            : operate<Interval>(step.operation, values[step.a], values[step.b], values[step.c]);
    add_slopes(step, values.data(), all);
  }
  const auto own = all.end() - static_cast<std::ptrdiff_t>(inputs_);
  std::copy_n(own, std::min(slopes.size(), inputs_), slopes.begin());
  return values.back();
}

}  // namespace camlaw
