// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "problems/statement/parameters.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"
#include "problems/units.h"

namespace camlaw::problems {
namespace {

using Kind = Entry::Kind;

double read_value(std::string_view text, const Parameter& parameter, const std::string& what) {
  return parse_quantity(text, parameter.unit, parameter.unit, what);
}

/// "polynomial-5 alpha=-3" is an entry of the catalogue in its own right, which has no alpha that
/// could vary; the same law as a member of polynomial-5 has one.
Member as_family_member(const Member& law) {
  const std::string& name = law.family->name;
  const std::size_t space = name.find(' ');
  if (space == std::string::npos || name.find('=') == std::string::npos) return law;
  const Family& family = find_family(name.substr(0, space));
  Member result{&family, family.standard()};
  set_argument(result, name.substr(space + 1));
  return result;
}

void check_accepted(const Entry& entry, const NamedParameter& parameter, double value) {
  if (const auto why = refusal(parameter, value)) refuse(entry, *why);
}

/// The parameters that a law's name gives: those before an equals sign.
std::set<std::string> given_in(std::string_view name, const Family& family) {
  std::set<std::string> given;
  for (std::size_t equals = name.find('='); equals != std::string_view::npos;
       equals = name.find('=', equals + 1)) {
    const std::size_t end = name.find_last_not_of(' ', equals - 1) + 1;
    const std::size_t start = name.rfind(' ', end - 1) + 1;
    given.insert(family.parameters[family.parameter(name.substr(start, end - start))].name);
  }
  return given;
}

/// Laws as their names tell, and what the names give.
struct NamedLaws {
  std::vector<Member> laws;
  std::set<std::string> given;
};

void read_law(const Entry& name, NamedLaws& result) {
  const std::string& text = text_of(name);
  const Member found = located(name, [&] { return find_law(text, read_value); });
  const Member law = as_family_member(found);
  for (std::size_t i = 0; i < law.arguments.size(); ++i) {
    for (const double value : law.arguments.list(i)) {
      check_accepted(name, named(law.family->parameters[i]), value);
    }
  }
  // An entry of the catalogue with parameters in its name may have been found by another name.
  const std::string& told = law.family == found.family ? text : found.family->name;
  result.given.merge(given_in(told, *law.family));
  result.laws.push_back(law);
}

NamedLaws read_names(const Entry& name) {
  NamedLaws result;
  if (name.kind == Kind::List) {
    if (name.items.empty()) refuse(name, "the list is empty; name at least one law");
    for (const Entry& item : name.items) read_law(item, result);
  } else {
    expect(name, Kind::Text, "a law's name in quotes, or a list of names");
    read_law(name, result);
  }
  return result;
}

void add_fixed(const Entry& entry, const NamedParameter& parameter, FixedNames& fixed) {
  if (!fixed.insert(parameter.name).second) {
    refuse(entry, fmt::format("{} is given twice", parameter.name));
  }
}

/// A parameter's number, or a list's.
std::vector<double> fixed_values(const Entry& entry, const NamedParameter& parameter) {
  std::vector<double> values;
  if (parameter.list && entry.kind == Kind::List) {
    for (const Entry& item : entry.items) values.push_back(quantity_of(item, parameter.unit));
  } else {
    values.push_back(quantity_of(entry, parameter.unit));
  }
  for (double& value : values) {
    value = onto_range(value, parameter.low, parameter.high);
    check_accepted(entry, parameter, value);
  }
  return values;
}

void read_fixed(const Entry& entry, const std::set<std::string>& given, ProblemStatement& problem,
                FixedNames& fixed) {
  const auto parameter =
      located(entry, [&] { return find_parameter(problem, entry.key, Owner::Law); });
  if (parameter.element) {
    refuse(entry, "an element alone cannot be fixed; give the whole list");
  }
  if (given.contains(parameter.law_parameter)) {
    refuse(entry, fmt::format("the law's name gives {} already", parameter.law_parameter));
  }
  add_fixed(entry, parameter, fixed);
  put_values(problem, parameter, fixed_values(entry, parameter));
}

const Entry& law_entry(const Entry& file) {
  const Entry* law = find(file, "law");
  if (law == nullptr) refuse(file, "law is missing; write [law] and name = \"polynomial-5\"");
  expect(*law, Kind::Table, "a table, [law] with name = \"polynomial-5\"");
  return *law;
}

const Entry& name_entry(const Entry& law) {
  const Entry* name = find(law, "name");
  if (name == nullptr) refuse(law, "name is missing; 'camlaw laws' lists all laws");
  return *name;
}

}  // namespace

void read_laws(const Entry& file, ProblemStatement& problem, FixedNames& fixed) {
  const Entry& law = law_entry(file);
  const NamedLaws named_laws = read_names(name_entry(law));
  problem.laws = named_laws.laws;
  for (const Entry& entry : law.items) {
    if (entry.key != "name") read_fixed(entry, named_laws.given, problem, fixed);
  }
}

void read_constants(const Entry& file, ProblemStatement& problem, FixedNames& fixed) {
  const Entry* constants = find(file, "constants");
  if (constants == nullptr) return;
  expect(*constants, Kind::Table, "a table, [constants]");
  for (const Entry& entry : constants->items) {
    const auto parameter =
        located(entry, [&] { return find_parameter(problem, entry.key, Owner::Machine); });
    add_fixed(entry, parameter, fixed);
    const double value =
        onto_range(quantity_of(entry, parameter.unit), parameter.low, parameter.high);
    check_accepted(entry, parameter, value);
    put_value(problem, parameter, 0, value);
  }
}

void check_laws_at_start(const Entry& file, const ProblemStatement& problem) {
  const Entry& name = name_entry(law_entry(file));
  located(name, [&] { check_laws(problem); });
  std::set<std::string> seen;
  for (const Member& law : problem.laws) {
    if (!seen.insert(law.name()).second) {
      refuse(name, fmt::format("'{}' is there twice, with what varies at its start", law.label()));
    }
  }
}

}  // namespace camlaw::problems
