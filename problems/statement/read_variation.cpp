// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"
#include "problems/statement/variation.h"

namespace camlaw::problems {
namespace {

using Kind = Entry::Kind;

/// A number that is not negative; none where the table has no such key.
std::optional<double> find_offset(const Entry& table, const char* key, const std::string& unit) {
  const Entry* entry = find(table, key);
  if (entry == nullptr) return {};
  const double value = quantity_of(*entry, unit);
  if (value < 0) {
    refuse(*entry, fmt::format("{:.6g} is below 0; plus and minus are how far a value may be off "
                               "to either side",
                               value));
  }
  return value;
}

void read_fit(const Entry& table, const Entry& fit, VariationStatement& variation) {
  for (const char* key : {"plus", "minus", "standard_deviation"}) {
    if (find(table, key) != nullptr) {
      refuse(table, fmt::format("fit and {} are both given; drop one of the two", key));
    }
  }
  if (variation.parameter.unit != "mm") {
    refuse(fit,
           fmt::format("a fit is of a length in mm; {} is in {}", variation.parameter.name,
                       variation.parameter.unit == "1" ? "no unit" : variation.parameter.unit));
  }
  const std::string& text = text_of(fit);
  variation.fit = located(fit, [&] { return parse_fit(text); });
  variation.of_diameter = truth_of(table, "of_diameter");
}

void read_offsets(const Entry& table, VariationStatement& variation) {
  const std::string& unit = variation.parameter.unit;
  const auto plus = find_offset(table, "plus", unit), minus = find_offset(table, "minus", unit);
  const auto deviation = find_positive(table, "standard_deviation", unit);
  if (deviation && (plus || minus)) {
    refuse(table, "standard_deviation and plus or minus are both given; drop one of the two");
  }
  if (deviation) {
    variation.plus = variation.minus = 3 * *deviation;
    variation.is_normal = true;
    return;
  }
  if (!plus && !minus) {
    refuse(table, "it states no variation; give plus, minus or both, standard_deviation or fit");
  }
  variation.plus = plus.value_or(0);
  variation.minus = minus.value_or(0);
  if (variation.plus + variation.minus == 0) refuse(table, "plus and minus are both 0");
}

void read_distribution(const Entry& table, VariationStatement& variation) {
  const Entry* entry = find(table, "distribution");
  if (entry == nullptr) return;
  const std::string& name = text_of(*entry);
  const std::vector<std::string> known{"normal", "uniform"};
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    refuse(*entry, fmt::format("there is no distribution '{}'; {}", name, suggestion(name, known)));
  }
  if (variation.is_normal && name == "uniform") {
    refuse(*entry,
           "only a normal distribution has a standard_deviation here; give plus and minus instead");
  }
  variation.is_normal = name == "normal";
}

/// The same at the ends of a variable: a search reaches both.
void check_variable(const ProblemStatement& problem, const VariationStatement& variation) {
  const auto i = find_variable(problem, variation.parameter, variation.index);
  if (!i) return;
  const VariableStatement& variable = problem.variables[*i];
  const optim::Variation off = variation.at(meant_value(problem, variation));
  for (const double value : {variable.lower, variable.upper}) {
    check_variation_at(variation, value, off);
  }
}

VariationStatement read_one(const Entry& table, const ProblemStatement& problem) {
  constexpr std::string_view kBefore = "variation.";
  const std::string name = table.path.substr(table.path.rfind(kBefore) + kBefore.size());
  expect(table, Kind::Table, "a table with plus and minus, standard_deviation or fit");
  check_keys(table, {"plus", "minus", "standard_deviation", "fit", "of_diameter", "distribution"});
  VariationStatement result;
  result.parameter = located(table, [&] { return find_parameter(problem, name); });
  located(table, [&] { check_may_vary(problem, result.parameter); });
  result.index = result.parameter.element.value_or(0);
  if (const Entry* fit = find(table, "fit")) {
    read_fit(table, *fit, result);
  } else {
    if (const Entry* of = find(table, "of_diameter")) refuse(*of, "it belongs to a fit");
    read_offsets(table, result);
  }
  read_distribution(table, result);
  located(table, [&] {
    check_variation(problem, result);
    check_variable(problem, result);
  });
  return result;
}

/// Whether a table is [variation.law.c], which TOML reads as c in a table called law.
bool groups_variations(const Entry& table) {
  return (table.key == "law" || table.key == "machine") && table.kind == Kind::Table;
}

}  // namespace

void read_variation(const Entry& file, ProblemStatement& problem) {
  const Entry* tables = find(file, "variation");
  if (tables == nullptr) return;
  expect(*tables, Kind::Table, "tables, such as [variation.base_radius] with plus and minus");
  Variations variations;
  const auto add = [&](const Entry& table) {
    VariationStatement own = read_one(table, problem);
    located(table, [&] { add_variation(variations.all, std::move(own)); });
  };
  for (const Entry& table : tables->items) {
    if (!groups_variations(table)) {
      add(table);
      continue;
    }
    for (const Entry& owned : table.items) add(owned);
  }
  if (!variations.all.empty()) {
    problem.variation = std::make_shared<const Variations>(std::move(variations));
  }
}

}  // namespace camlaw::problems
