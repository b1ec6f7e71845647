// SPDX-License-Identifier: MIT
#include "optim/solvers/native_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "numerics/text/names.h"

namespace camlaw::optim {
namespace {

using Kind = NativeRule::Kind;

/// The names that may be set.
std::vector<std::string> free_names(const std::vector<NativeRule>& rules) {
  std::vector<std::string> names;
  for (const NativeRule& rule : rules) {
    if (rule.reserved.empty()) names.push_back(rule.name);
  }
  return names;
}

[[noreturn]] void refuse_unknown(const std::string& solver, const std::vector<NativeRule>& rules,
                                 const std::string& name) {
  constexpr std::size_t kListed = 20;  // Ipopt has hundreds
  const std::vector<std::string> known = free_names(rules);
  std::string more = "; it takes none";
  if (const auto near = near_names(name, known); !near.empty()) {
    more = "; " + did_you_mean(near);
  } else if (known.size() > kListed) {
    more = fmt::format("; it has {} others", known.size());
  } else if (!known.empty()) {
    more = fmt::format("; use {}", fmt::join(known, ", "));
  }
  throw std::invalid_argument(fmt::format("{} has no option '{}'{}", solver, name, more));
}

std::string bounds_text(const NativeRule& rule) {
  if (std::isfinite(rule.upper - rule.lower) && !rule.above_lower && !rule.below_upper) {
    return fmt::format(" from {:.15g} to {:.15g}", rule.lower, rule.upper);
  }
  std::vector<std::string> parts;
  if (std::isfinite(rule.lower)) {
    parts.push_back(fmt::format("{} {:.15g}", rule.above_lower ? "above" : "from", rule.lower));
  }
  if (std::isfinite(rule.upper)) {
    parts.push_back(fmt::format("{} {:.15g}", rule.below_upper ? "below" : "up to", rule.upper));
  }
  return parts.empty() ? "" : fmt::format(" {}", fmt::join(parts, " and "));
}

/// "an integer from 0", "a number above 0 and below 1", "one of monotone, adaptive".
std::string accepted(const NativeRule& rule) {
  if (rule.kind == Kind::Integer) return "an integer" + bounds_text(rule);
  if (rule.kind == Kind::Number) return "a number" + bounds_text(rule);
  if (rule.texts.empty()) return "a text";
  return fmt::format("one of {}", fmt::join(rule.texts, ", "));
}

bool is_within(const NativeRule& rule, double value) {
  const bool high_enough = rule.above_lower ? value > rule.lower : value >= rule.lower;
  const bool low_enough = rule.below_upper ? value < rule.upper : value <= rule.upper;
  return std::isfinite(value) && high_enough && low_enough;
}

bool has_kind(const NativeRule& rule, const NativeValue& value) {
  if (rule.kind == Kind::Text) return std::holds_alternative<std::string>(value);
  if (rule.kind == Kind::Integer) return std::holds_alternative<std::int64_t>(value);
  return !std::holds_alternative<std::string>(value);
}

bool accepts(const NativeRule& rule, const NativeValue& value) {
  if (!has_kind(rule, value)) return false;
  if (rule.kind != Kind::Text) return is_within(rule, number_of(value));
  const auto& text = std::get<std::string>(value);
  return rule.texts.empty() ||
         std::find(rule.texts.begin(), rule.texts.end(), text) != rule.texts.end();
}

}  // namespace

void check_native_option(const std::string& solver, const std::vector<NativeRule>& rules,
                         const std::string& name, const NativeValue& value) {
  const auto rule = std::find_if(rules.begin(), rules.end(),
                                 [&](const NativeRule& known) { return known.name == name; });
  if (rule == rules.end()) refuse_unknown(solver, rules, name);
  if (!rule->reserved.empty()) {
    throw std::invalid_argument(
        fmt::format("{}: option {} cannot be set: {}", solver, name, rule->reserved));
  }
  if (accepts(*rule, value)) return;
  const bool is_text = std::holds_alternative<std::string>(value);
  throw std::invalid_argument(fmt::format("{}: option {}: {}{}{} is not {}", solver, name,
                                          is_text ? "'" : "", to_text(value), is_text ? "'" : "",
                                          accepted(*rule)));
}

double number_of(const NativeValue& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return static_cast<double>(*integer);
  return std::get<double>(value);
}

std::string to_text(const NativeValue& value) {
  return std::visit([](const auto& v) { return fmt::format("{}", v); }, value);
}

}  // namespace camlaw::optim
