// SPDX-License-Identifier: MIT
#include "numerics/formula/steps.h"

#include <algorithm>
#include <bit>
#include <initializer_list>

namespace camlaw {

namespace {

/// Numbers count by their bits: so NaN is like itself, and -0 is not 0.
std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

bool same(const Step& x, const Step& y) {
  return x.operation == y.operation && x.a == y.a && x.b == y.b && x.c == y.c &&
         bits(x.value) == bits(y.value) && bits(x.lower) == bits(y.lower) &&
         bits(x.upper) == bits(y.upper);
}

std::size_t hash(const Step& step) {
  std::uint64_t result = static_cast<std::uint64_t>(step.operation);
  for (const std::uint64_t more :
       {std::uint64_t{step.a}, std::uint64_t{step.b}, std::uint64_t{step.c}, bits(step.value),
        bits(step.lower), bits(step.upper)}) {
    constexpr std::uint64_t kOdd = 0x9E3779B97F4A7C15;  // 2^64 over the golden ratio
    result = (result ^ more) * kOdd;
    result ^= result >> 32;
  }
  return result;
}

}  // namespace

std::uint32_t Recorder::write(const Step& step) {
  if (2 * steps_.size() >= table_.size()) enlarge();
  std::uint32_t& known = table_[place_of(step)];
  if (known == 0) {
    steps_.push_back(step);
    known = static_cast<std::uint32_t>(steps_.size());
  }
  return known - 1;
}

std::size_t Recorder::place_of(const Step& step) const {
  const std::size_t last = table_.size() - 1;
  std::size_t place = hash(step) & last;
  while (table_[place] != 0 && !same(steps_[table_[place] - 1], step)) place = (place + 1) & last;
  return place;
}

void Recorder::enlarge() {
  constexpr std::size_t kFirst = 256;  // most formulas have fewer than 128 steps
  table_.assign(std::max(kFirst, 2 * table_.size()), 0);
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    table_[place_of(steps_[i])] = static_cast<std::uint32_t>(i + 1);
  }
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
