// SPDX-License-Identifier: MIT
#include "tests/machines/formula_dimension.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <stdexcept>

namespace camlaw {
namespace {

/// None: it measures anything.
using Measured = std::optional<Dimension>;

[[noreturn]] void refuse_pair(const char* what, const Dimension& a, const Dimension& b) {
  throw std::invalid_argument(fmt::format("the formula {} {} and {}, which are of different kinds",
                                          what, to_string(a), to_string(b)));
}

Measured alike(const char* what, const Measured& a, const Measured& b) {
  if (a && b && !(*a == *b)) refuse_pair(what, *a, *b);
  return a ? a : b;
}

Measured plain(const char* function, const Measured& x) {
  if (!x || x->is_plain()) return Dimension{};
  throw std::invalid_argument(
      fmt::format("the formula takes the {} of {}", function, to_string(*x)));
}

bool measures_anything(double constant) { return constant == 0 || !std::isfinite(constant); }

Measured measured(const std::vector<Step>& steps, const Step& step, const Measured& a,
                  const Measured& b, const Measured& c) {
  switch (step.operation) {
    case Operation::Constant:
      return measures_anything(step.value) ? Measured() : Dimension{};
    case Operation::Add:
      return alike("adds", a, b);
    case Operation::Subtract:
      return alike("subtracts", a, b);
    case Operation::Multiply:
      return a && b ? Measured(*a * *b) : Measured();
    case Operation::Divide:
      return a && b ? Measured(*a / *b) : Measured();
    case Operation::Negate:
    case Operation::Absolute:
      return a;
    case Operation::Sqrt:
      return a ? Measured(power(*a, 0.5)) : a;
    case Operation::Power:
      return a ? Measured(power(*a, steps[step.b].value)) : a;
    case Operation::Greater:
    case Operation::Lesser:
      return alike("compares", a, b);
    case Operation::Unknown:
      return alike("looks for a root between", a, b);
    case Operation::Root:
      return a;
    case Operation::BySide:
      return alike("chooses between", b, c);
    case Operation::Along:
    case Operation::WherePositive:
    case Operation::UnlessZero:
      return b;
    case Operation::Sin:
    case Operation::Cos:
    case Operation::Tan:
      return plain("sine, cosine or tangent", a);
    case Operation::Asin:
    case Operation::Atan:
      return plain("arcsine or arctangent", a);
    case Operation::Log:
      return plain("logarithm", a);
    case Operation::Exp:
      return plain("exponential", a);
    case Operation::Pi:
    case Operation::Input:
      break;
  }
  return Dimension{};
}

}  // namespace

Dimension dimension_of(const Formula& formula, std::span<const Dimension> inputs) {
  const auto& steps = formula.steps();
  std::vector<Measured> all;
  for (const Step& step : steps) {
    const auto of = [&](std::uint32_t from) { return from < all.size() ? all[from] : Measured(); };
    all.push_back(step.operation == Operation::Input
                      ? Measured(inputs[step.a])
                      : measured(steps, step, of(step.a), of(step.b), of(step.c)));
  }
  return all.back().value_or(Dimension{});
}

}  // namespace camlaw
