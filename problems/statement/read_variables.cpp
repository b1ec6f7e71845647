// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "problems/statement/advancing_cycle.h"
#include "problems/statement/choices.h"
#include "problems/statement/parameters.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {
namespace {

using Kind = Entry::Kind;

/// One number of what varies: the only one, or one of a list.
struct Element {
  const NamedParameter& parameter;
  std::size_t index = 0;  ///< in the list
  std::size_t count = 1;  ///< of numbers that vary together

  /// What an entry says of it: one number stands for all, a list has one for each.
  const Entry& part_of(const Entry& entry) const {
    if (!parameter.list || parameter.element || entry.kind != Kind::List) return entry;
    if (entry.items.size() != count) {
      refuse(entry, fmt::format("{} values are given for the {} of {}", entry.items.size(), count,
                                parameter.name));
    }
    return entry.items[index];
  }
};

/// A number that the parameter accepts.
double accepted_number(const Entry& entry, const NamedParameter& parameter) {
  const double value =
      onto_range(quantity_of(entry, parameter.unit), parameter.low, parameter.high);
  if (const auto why = refusal(parameter, value)) refuse(entry, *why);
  return value;
}

double read_bound(const Entry& table, const char* key, const Element& element, bool integer) {
  const Entry* entry = find(table, key);
  if (entry == nullptr) {
    refuse(table, fmt::format("{} is missing; give lower and upper, or values = [...]", key));
  }
  const Entry& part = element.part_of(*entry);
  const double bound = accepted_number(part, element.parameter);
  if (integer && bound != std::floor(bound)) {
    refuse(part, fmt::format("{:.6g} is not an integer, and the type is integer", bound));
  }
  return bound;
}

void read_range(const Entry& table, const Element& element, VariableStatement& variable) {
  variable.integer = reads_integer(table);
  variable.lower = read_bound(table, "lower", element, variable.integer);
  variable.upper = read_bound(table, "upper", element, variable.integer);
  if (variable.lower > variable.upper) {
    Entry crossing = *find(table, "lower");
    crossing.path = table.path;
    refuse(crossing,
           fmt::format("lower {} exceeds upper {}", with_unit(variable.lower, variable.unit),
                       with_unit(variable.upper, variable.unit)));
  }
  const NamedParameter& parameter = element.parameter;
  if (!variable.integer && (parameter.integer || parameter.structural)) {
    refuse(table, fmt::format("{} cannot vary continuously; write type = \"integer\", or values = "
                              "[...] instead of bounds",
                              parameter.name));
  }
  if (const Entry* scale = find(table, "scale")) {
    variable.scale = positive_of(element.part_of(*scale), variable.unit);
  }
}

void read_values(const Entry& table, const Entry& values, const Element& element,
                 VariableStatement& variable) {
  for (const char* key : {"lower", "upper", "scale", "type"}) {
    if (const Entry* other = find(table, key)) {
      refuse(*other, "values are given, so there is nothing to bound; drop one of the two");
    }
  }
  expect(values, Kind::List, "a list of numbers, such as [1, 2]");
  if (values.items.empty()) refuse(values, "the list is empty; give the values to choose from");
  for (const Entry& item : values.items) {
    const double value = accepted_number(item, element.parameter);
    if (find_choice(variable.values, value)) {
      refuse(item, fmt::format("{} is listed twice", with_unit(value, variable.unit)));
    }
    variable.values.push_back(value);
  }
  variable.lower = *std::min_element(variable.values.begin(), variable.values.end());
  variable.upper = *std::max_element(variable.values.begin(), variable.values.end());
}

/// The start: as given; else what the parameter is otherwise, where that is possible; else the
/// middle, or the first of a list.
double read_start(const Entry* start, const Element& element, const VariableStatement& variable,
                  double present) {
  if (start != nullptr) {
    const Entry& part = element.part_of(*start);
    const double wanted = accepted_number(part, element.parameter);
    return located(part, [&] { return as_chosen(variable, wanted); });
  }
  if (!why_not(variable, present)) return as_chosen(variable, present);
  if (!variable.values.empty()) return variable.values.front();
  const double middle = variable.lower + (variable.upper - variable.lower) / 2;
  return variable.integer ? std::floor(middle) : middle;
}

void read_element(const Entry& table, const Element& element, ProblemStatement& problem) {
  const NamedParameter& parameter = element.parameter;
  const std::size_t in_list = parameter.element.value_or(element.index);
  if (find_variable(problem, parameter, in_list)) {
    refuse(table, fmt::format("{} varies already; state it once", parameter.element_name(in_list)));
  }
  VariableStatement variable = new_variable(parameter, in_list);
  if (const Entry* values = find(table, "values")) {
    read_values(table, *values, element, variable);
  } else {
    read_range(table, element, variable);
  }
  const double present = values_of(problem, parameter).at(in_list);
  variable.start = read_start(find(table, "start"), element, variable, present);
  put_value(problem, parameter, in_list, variable.start);
  problem.variables.push_back(std::move(variable));
}

/// How many numbers of a list vary, all of them. A start says how long the list is.
std::size_t read_count(const Entry& table, const NamedParameter& parameter,
                       ProblemStatement& problem) {
  const Entry* start = find(table, "start");
  if (start != nullptr) {
    expect(*start, Kind::List, "a list with a start for each element, such as [1, 2]");
    put_values(problem, parameter, quantities_of(*start, parameter.unit));
  }
  const std::vector<double> present = values_of(problem, parameter);
  if (present.empty()) {
    refuse(table, fmt::format("start is missing; {} is a list, and start = [...] says how long",
                              parameter.name));
  }
  put_values(problem, parameter, present);  // as long in every law that has it
  return present.size();
}

void read_variable(const Entry& table, ProblemStatement& problem, const FixedNames& fixed) {
  // The name is the path after "variables.", so that [variables.law.v] is law.v too.
  constexpr std::string_view kBefore = "variables.";
  const std::string name = table.path.substr(table.path.rfind(kBefore) + kBefore.size());
  expect(table, Kind::Table, "a table with lower and upper, or with values");
  const auto parameter = located(table, [&] { return find_parameter(problem, name); });
  if (!parameter.of_law)
    located(table, [&] { check_may_vary(*problem.mechanism, parameter.name); });
  check_keys(table, {"lower", "upper", "start", "scale", "type", "values"});
  if (fixed.contains(parameter.name) && !parameter.element) {
    refuse(table, fmt::format("{} is given a fixed value too, under [{}]; drop one of the two",
                              parameter.name, parameter.of_law ? "law" : "constants"));
  }
  const bool whole_list = parameter.list && !parameter.element;
  const std::size_t count = whole_list ? read_count(table, parameter, problem) : 1;
  for (std::size_t i = 0; i < count; ++i) read_element(table, {parameter, i, count}, problem);
}

/// Whether a table is [variables.law.v], which TOML reads as v in a table called law.
bool is_owner(const Entry& table) {
  return (table.key == "law" || table.key == "machine") && table.kind == Kind::Table;
}

}  // namespace

void read_variables(const Entry& file, ProblemStatement& problem, const FixedNames& fixed) {
  const Entry* variables = find(file, "variables");
  if (variables == nullptr) return;
  expect(*variables, Kind::Table, "tables, such as [variables.alpha]");
  for (const Entry& entry : variables->items) {
    if (!is_owner(entry)) {
      read_variable(entry, problem, fixed);
      continue;
    }
    for (const Entry& owned : entry.items) read_variable(owned, problem, fixed);
  }
}

}  // namespace camlaw::problems
