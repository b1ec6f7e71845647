// SPDX-License-Identifier: MIT
#include "problems/published/table/implied.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <map>
#include <tuple>

#include "numerics/scalar/root.h"
#include "numerics/text/units.h"
#include "problems/statement/parameters.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems::stated {
namespace {

/// Values of the parameter under which a value prints as it does; not numbers where there are none.
struct ImpliedRange {
  double lower, upper;
  bool is_found() const { return std::isfinite(lower) && std::isfinite(upper); }
  double middle() const { return (lower + upper) / 2; }
  double share() const { return std::abs(upper - lower) / std::max(1e-300, std::abs(middle())); }
};

/// What is asked for, as one mechanism has it.
struct AskedParameter {
  std::size_t parameter;
  Overrides overrides;  ///< by its settings
  double low, high;
};

AskedParameter asked(const ImpliedParameter& implied, ProblemStatement problem) {
  return located(implied.where, [&] {
    const auto parameter = find_parameter(problem, implied.parameter, Owner::Machine);
    AskedParameter result{parameter.parameter, {}, parameter.low, parameter.high};
    const auto end = [&](const std::optional<std::string>& text, double otherwise) {
      return text ? parse_quantity(*text, parameter.unit, parameter.unit, implied.parameter)
                  : otherwise;
    };
    result.low = std::max(parameter.low, end(implied.lower, parameter.low));
    result.high = std::min(parameter.high, end(implied.upper, parameter.high));
    if (!(result.low < result.high)) {
      throw std::invalid_argument(fmt::format("{}: the range from {} to {} {} is empty",
                                              implied.parameter, result.low, result.high,
                                              parameter.unit));
    }
    for (const std::string& setting : implied.set) {
      const auto set = find_parameter(problem, name_of_setting(setting), Owner::Machine);
      set_value(problem, setting);
      result.overrides.emplace_back(set.parameter, problem.constants[set.parameter]);
    }
    return result;
  });
}

/// The lowest value of the parameter at which the value passes the target.
double first_crossing(Model& model, std::size_t row, const AskedParameter& of, double target) {
  Overrides overrides = of.overrides;
  overrides.emplace_back(of.parameter, 0);
  const auto missed = [&](double at) {
    overrides.back().second = at;
    return model.value_with(row, overrides) - target;
  };
  return root_of(of.low, of.high, missed, [](double at) { return -at; });
}

ImpliedRange implied_range(Model& model, std::size_t row, const AskedParameter& of) {
  const auto& [value, decimals] = model.row(row).row->printed.number;
  const double half = 0.5 * std::pow(10.0, -decimals);
  const double a = first_crossing(model, row, of, value - half);
  const double b = first_crossing(model, row, of, value + half);
  return {std::min(a, b), std::max(a, b)};
}

std::string with_settings(const ImpliedParameter& implied) {
  return implied.set.empty() ? "" : fmt::format(" with {}", fmt::join(implied.set, ", "));
}

std::string value_text(const ImpliedParameter& implied, double value, const std::string& unit) {
  return fmt::format("{} = {:.4g}{}", implied.parameter, value, unit == "1" ? "" : " " + unit);
}

/// "299.98 to 300.02": as many digits as tell the ends apart, four at least.
std::string range_words(const ImpliedRange& range) {
  constexpr int kLeast = 4, kMost = 12;  // ends that agree in twelve digits are one value
  for (int digits = kLeast; digits <= kMost; ++digits) {
    const std::string lower = fmt::format("{:.{}g}", range.lower, digits),
                      upper = fmt::format("{:.{}g}", range.upper, digits);
    if (lower != upper) return fmt::format("{} to {}", lower, upper);
  }
  return fmt::format("{:.{}g}", range.lower, kLeast);
}

/// What one value says, where the values beside it need `shared`.
std::vector<std::string> said_of(Model& model, std::size_t row, const ImpliedParameter& implied,
                                 const AskedParameter& of, const ImpliedRange& own,
                                 const ImpliedRange& shared, const std::string& by) {
  const auto& printed = model.row(row).row->printed;
  const std::string& unit = model.row(row).problem->mechanism->parameters[of.parameter].unit;
  if (!shared.is_found()) {
    return {fmt::format("no value of {}{} gives the printed value", implied.parameter,
                        with_settings(implied))};
  }
  std::vector<std::string> result{fmt::format("{}{} is what {} needs",
                                              value_text(implied, shared.middle(), unit),
                                              with_settings(implied), by)};
  Overrides overrides = of.overrides;
  overrides.emplace_back(of.parameter, shared.middle());
  const double value = model.value_with(row, overrides);
  if (optim::agrees(printed.number, value)) return result;
  const bool misprint = optim::one_digit_misprint(printed.number, value);
  std::string text =
      fmt::format("that gives {}{}", optim::as_printed(value, printed.number.decimals),
                  misprint ? ", so that one digit is misprinted" : "");
  if (own.is_found()) {
    text += "; the printed value needs " + range_words(own);
  }
  result.push_back(std::move(text));
  return result;
}

using RowGroup = std::tuple<std::string, std::string, std::vector<std::string>>;

RowGroup group_of(const StatedRow& row) { return {row.mechanism, row.law, row.set}; }

}  // namespace

void add_implied(Model& model, SystemReproduction& result) {
  for (const ImpliedParameter& implied : model.table().implied) {
    std::map<RowGroup, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < model.size(); ++i) {
      const std::size_t by = model.row(i).laws_by;
      const bool has_no_law = by != kNone && model.table().hypotheses[by].unstated;
      if (!has_no_law) groups[group_of(*model.row(i).row)].push_back(i);
    }
    for (const auto& [key, rows] : groups) {
      const bool any = std::any_of(rows.begin(), rows.end(), [&](std::size_t i) {
        return result.values[i].verdict == optim::Finding::Unexplained;
      });
      if (!any) continue;
      const AskedParameter of = asked(implied, *model.row(rows.front()).problem);
      std::vector<ImpliedRange> ranges;
      std::size_t closest = 0;
      for (const std::size_t i : rows) {
        ranges.push_back(implied_range(model, i, of));
        const ImpliedRange& best = ranges[closest];
        const ImpliedRange& last = ranges.back();
        if (last.is_found() && (!best.is_found() || last.share() < best.share())) {
          closest = ranges.size() - 1;
        }
      }
      for (std::size_t k = 0; k < rows.size(); ++k) {
        ReproducedValue& value = result.values[rows[k]];
        if (value.verdict != optim::Finding::Unexplained) continue;
        const std::string by = k == closest
                                   ? "the printed value"
                                   : fmt::format("the {} printed with it",
                                                 model.row(rows[closest]).row->printed.quantity);
        for (auto& text : said_of(model, rows[k], implied, of, ranges[k], ranges[closest], by)) {
          value.causes.push_back(std::move(text));
        }
      }
    }
  }
}

}  // namespace camlaw::problems::stated
