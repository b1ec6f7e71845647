// SPDX-License-Identifier: MIT
#include "numerics/formula/steps.h"

#include <algorithm>
#include <bit>

namespace camlaw {

std::uint32_t Recorder::write(const Step& step) {
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  const Key key{step.operation,   step.a,           step.b,          step.c,
                bits(step.value), bits(step.lower), bits(step.upper)};
  const auto [at, is_new] = known_.try_emplace(key, static_cast<std::uint32_t>(steps_.size()));
  if (is_new) steps_.push_back(step);
  return at->second;
}

std::size_t operands(Operation operation) {
  switch (operation) {
    case Operation::Input:
    case Operation::Constant:
    case Operation::Pi:
      return 0;
    case Operation::Add:
    case Operation::Subtract:
    case Operation::Multiply:
    case Operation::Divide:
    case Operation::Power:
    case Operation::Greater:
    case Operation::Lesser:
    case Operation::Along:
    case Operation::WherePositive:
    case Operation::UnlessZero:
    case Operation::Unknown:
      return 2;
    case Operation::BySide:
    case Operation::Root:
      return 3;
    default:
      return 1;
  }
}

std::vector<bool> needed_for(const std::vector<std::uint32_t>& values,
                             const std::vector<Step>& steps) {
  std::vector<bool> needed(*std::max_element(values.begin(), values.end()) + std::size_t{1});
  for (const std::uint32_t value : values) needed[value] = true;
  for (std::size_t i = needed.size(); i-- > 0;) {
    if (!needed[i]) continue;
    const std::uint32_t from[] = {steps[i].a, steps[i].b, steps[i].c};
    for (std::size_t k = 0; k < operands(steps[i].operation); ++k) needed[from[k]] = true;
  }
  return needed;
}

std::vector<bool> reached_from(std::size_t first, const std::vector<Step>& steps) {
  std::vector<bool> reached(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Step& step = steps[i];
    const std::uint32_t from[] = {step.a, step.b, step.c};
    reached[i] = step.operation == Operation::Input && step.a >= first;
    for (std::size_t k = 0; k < operands(step.operation); ++k) {
      reached[i] = reached[i] || reached[from[k]];
    }
  }
  return reached;
}

}  // namespace camlaw
