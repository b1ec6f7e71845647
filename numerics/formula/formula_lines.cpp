// SPDX-License-Identifier: MIT
#include "numerics/formula/formula_lines.h"

#include <fmt/format.h>

#include <map>

#include "numerics/formula/roots.h"
#include "numerics/formula/steps.h"

namespace camlaw {
namespace {

/// How tightly a text holds together: that of a product stands unbracketed in a sum.
enum Binding { kSum = 1, kProduct, kSign, kPower, kWhole };

struct Text {
  std::string text;
  Binding binding;
};

const char* function_name(Operation operation) {
  switch (operation) {
    case Operation::Sqrt:
      return "sqrt";
    case Operation::Sin:
      return "sin";
    case Operation::Cos:
      return "cos";
    case Operation::Tan:
      return "tan";
    case Operation::Asin:
      return "asin";
    case Operation::Atan:
      return "atan";
    case Operation::Log:
      return "log";
    case Operation::Exp:
      return "exp";
    case Operation::Absolute:
      return "abs";
    case Operation::Greater:
      return "max";
    case Operation::Lesser:
      return "min";
    case Operation::BySide:
      return "select";
    case Operation::Along:
      return "along";
    case Operation::WherePositive:
      return "where_positive";
    case Operation::UnlessZero:
      return "unless_zero";
    default:
      return "";
  }
}

class LineWriter {
 public:
  LineWriter(const Formula& formula, const NameOfStep& name_of)
      : steps_(formula.steps()), roots_(formula.roots()), name_of_(name_of), uses_(steps_.size()) {}

  FormulaLines operator()(std::uint32_t value) {
    count_uses(value);
    FormulaLines result;
    for (const std::uint32_t i : order_) {
      if (i == value) continue;
      const bool is_named = uses_[i] > 1 && operands(steps_[i].operation) > 0 && !name(i);
      if (!is_named || roots_.has_inside(i)) continue;  // an unknown has a name in its root alone
      std::string text = written(i).text;
      names_[i] = fmt::format("t{}", names_.size() + 1);
      result.lines.push_back({names_[i], std::move(text)});
    }
    result.lines.push_back({"", written(value).text});
    return result;
  }

 private:
  /// The name of a step that is not looked into.
  std::optional<std::string> name(std::uint32_t i) const {
    if (const auto known = names_.find(i); known != names_.end()) return known->second;
    return name_of_(steps_[i]);
  }

  /// Counts how often each step is used, and puts them in the order in which they are needed. (In
  /// which order they were recorded may depend on the compiler, as that of a call's arguments.)
  void count_uses(std::uint32_t i) {
    if (++uses_[i] > 1 || name_of_(steps_[i])) return;
    const Step& step = steps_[i];
    const std::uint32_t from[] = {step.a, step.b, step.c};
    // A power by multiplication is one step to its reader.
    if (const auto [base, exponent] = power_of(i); exponent > 1) {
      count_uses(base);
    } else {
      for (std::size_t k = 0; k < operands(step.operation); ++k) count_uses(from[k]);
    }
    order_.push_back(i);
  }

  /// x and n where a step is x * x * ... * x, n times; n is 1 elsewhere.
  std::pair<std::uint32_t, int> power_of(std::uint32_t i) const {
    const std::uint32_t base = steps_[i].b;
    int exponent = 1;
    for (std::uint32_t k = i; steps_[k].operation == Operation::Multiply && steps_[k].b == base;
         k = steps_[k].a) {
      ++exponent;
      if (steps_[k].a == base) return {base, exponent};
    }
    return {i, 1};
  }

  std::string inside(std::uint32_t i, Binding least) const {
    const Text text = written_or_named(i);
    return text.binding < least ? "(" + text.text + ")" : text.text;
  }
  Text written_or_named(std::uint32_t i) const {
    if (auto known = name(i)) return {std::move(*known), kWhole};
    return written(i);
  }

  Text pair(const Step& step, const char* sign, Binding left, Binding right, Binding own) const {
    return {fmt::format("{} {} {}", inside(step.a, left), sign, inside(step.b, right)), own};
  }

  Text root(const Step& step) const {
    const Step& unknown = steps_[step.a];
    std::string text =
        fmt::format("root({}, {}, {}, {}", inside(step.a, kWhole), inside(unknown.a, kSum),
                    inside(unknown.b, kSum), inside(step.b, kSum));
    const bool has_level = steps_[step.c].operation != Operation::Constant;
    if (has_level) text += ", " + inside(step.c, kSum);
    return {text + ")", kWhole};
  }

  Text written(std::uint32_t i) const {
    const Step& step = steps_[i];
    if (const auto [base, exponent] = power_of(i); exponent > 1) {
      return {fmt::format("{}^{}", inside(base, kWhole), exponent), kPower};
    }
    switch (step.operation) {
      case Operation::Input:
        return {name_of_(step).value_or(fmt::format("u{}", step.a)), kWhole};
      case Operation::Constant:
        return {fmt::format("{}", step.value), step.value < 0 ? kSign : kWhole};
      case Operation::Pi:
        return {"pi", kWhole};
      case Operation::Unknown:
        return {fmt::format("y{}", step.c + 1), kWhole};
      case Operation::Root:
        return root(step);
      case Operation::Add:
        return pair(step, "+", kSum, kProduct, kSum);
      case Operation::Subtract:
        return pair(step, "-", kSum, kProduct, kSum);
      case Operation::Multiply:
        return pair(step, "*", kProduct, kSign, kProduct);
      case Operation::Divide:
        return pair(step, "/", kProduct, kSign, kProduct);
      case Operation::Negate:
        return {"-" + inside(step.a, kSign), kSign};
      case Operation::Power:
        return {fmt::format("{}^{}", inside(step.a, kWhole), inside(step.b, kWhole)), kPower};
      default:
        break;
    }
    const std::uint32_t from[] = {step.a, step.b, step.c};
    std::string arguments;
    for (std::size_t k = 0; k < operands(step.operation); ++k) {
      arguments += (k > 0 ? ", " : "") + inside(from[k], kSum);
    }
    return {fmt::format("{}({})", function_name(step.operation), arguments), kWhole};
  }

  const std::vector<Step>& steps_;
  const FormulaRoots& roots_;
  const NameOfStep& name_of_;
  std::vector<int> uses_;
  std::vector<std::uint32_t> order_;  ///< of the steps that the value needs, itself the last
  std::map<std::uint32_t, std::string> names_;
};

}  // namespace

FormulaLines lines_of(const Formula& formula, std::uint32_t value, const NameOfStep& name_of) {
  return LineWriter(formula, name_of)(value);
}

}  // namespace camlaw
