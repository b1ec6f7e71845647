// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"
#include "problems/statement/variation.h"

namespace camlaw::problems {
namespace {

using Kind = Entry::Kind;

constexpr std::size_t kMostVariations = 8;

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
  variation.fit = located(fit, [&] { return parse_fit(text_of(fit)); });
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
    refuse(table, "it says nothing; give plus, minus or both, standard_deviation or fit");
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
    refuse(*entry,
           fmt::format("no distribution is called '{}'; {}", name, suggestion(name, known)));
  }
  if (variation.is_normal && name == "uniform") {
    refuse(*entry, "a standard deviation is of normal values; give plus and minus instead");
  }
  variation.is_normal = name == "normal";
}

/// Refuses what has several values already, or what nobody makes.
void check_single(const Entry& table, const NamedParameter& p, const ProblemStatement& problem) {
  if (p.list && !p.element) {
    refuse(table,
           fmt::format("{} is a list; name one number of it, such as {}[1]", p.name, p.name));
  }
  if (p.integer || p.structural) {
    refuse(table, fmt::format("{} is an integer, which has no variation", p.name));
  }
  if (p.of_law) return;
  if (problem.told_by_motion.contains(p.parameter)) {
    refuse(table, fmt::format("the motion is stated in {}, so {} has one value", p.unit, p.name));
  }
  for (const ParameterRange& range : problem.ranges) {
    if (range.parameter != p.parameter) continue;
    refuse(table, fmt::format("{} has a range, [ranges.{}]; drop one of the two", p.name, p.name));
  }
  for (const LoadCase& load : problem.cases) {
    const bool is_set = std::any_of(load.parameters.begin(), load.parameters.end(),
                                    [&](const auto& set) { return set.first == p.parameter; });
    if (is_set) refuse(table, fmt::format("the load cases set {}; drop one of the two", p.name));
  }
}

VariationStatement read_one(const Entry& table, const ProblemStatement& problem) {
  constexpr std::string_view kBefore = "variation.";
  const std::string name = table.path.substr(table.path.rfind(kBefore) + kBefore.size());
  expect(table, Kind::Table, "a table with plus and minus, standard_deviation or fit");
  check_keys(table, {"plus", "minus", "standard_deviation", "fit", "of_diameter", "distribution"});
  VariationStatement result;
  result.parameter = located(table, [&] { return find_parameter(problem, name); });
  check_single(table, result.parameter, problem);
  result.index = result.parameter.element.value_or(0);
  if (const Entry* fit = find(table, "fit")) {
    read_fit(table, *fit, result);
  } else {
    if (const Entry* of = find(table, "of_diameter")) refuse(*of, "it belongs to a fit");
    read_offsets(table, result);
  }
  read_distribution(table, result);
  located(table, [&] { check_variation(problem, result); });
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
    for (const VariationStatement& other : variations.all) {
      if (other.name() == own.name()) refuse(table, "this variation is stated twice");
    }
    variations.all.push_back(std::move(own));
  };
  for (const Entry& table : tables->items) {
    if (!groups_variations(table)) {
      add(table);
      continue;
    }
    for (const Entry& owned : table.items) add(owned);
  }
  if (variations.all.size() > kMostVariations) {
    refuse(*tables, fmt::format("{} variations; at most {} are accepted", variations.all.size(),
                                kMostVariations));
  }
  if (!variations.all.empty()) {
    problem.variation = std::make_shared<const Variations>(std::move(variations));
  }
}

}  // namespace camlaw::problems
