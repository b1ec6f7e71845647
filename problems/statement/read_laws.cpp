// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "problems/law_files/json_text.h"
#include "problems/law_files/law_file.h"
#include "problems/law_files/pieces_json.h"
#include "problems/statement/law_names.h"
#include "problems/statement/parameters.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {
namespace {

using Kind = Entry::Kind;

/// Laws as their names tell, and what the names give.
struct NamedLaws {
  LawList list;
  std::set<std::string> given;
};

void read_law(const Entry& file, const Entry& name, HeldFiles& files, NamedLaws& result) {
  if (name.kind == Kind::Text && is_free_name(name.text)) {
    result.list.laws.push_back(read_free_law(file, files));
  } else if (auto all = read_law_class(name)) {
    for (Member& law : *all) result.list.laws.push_back(std::move(law));
    result.list.is_of_class.resize(result.list.laws.size(), true);
  } else {
    NamedLaw law = read_law_name(name, files);
    result.given.merge(law.given);
    result.list.laws.push_back(std::move(law.law));
  }
  result.list.is_of_class.resize(result.list.laws.size(), false);
}

NamedLaws read_names(const Entry& file, const Entry& name, HeldFiles& files) {
  NamedLaws result;
  if (name.kind == Kind::List) {
    if (name.items.empty()) refuse(name, "the list is empty; name at least one law");
    for (const Entry& item : name.items) read_law(file, item, files, result);
  } else {
    expect(name, Kind::Text, "a law's name in quotes, or a list of names");
    read_law(file, name, files, result);
  }
  leave_to_free_law(name, result.list);
  tell_apart(result.list.laws);
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
    if (!entry.items.empty()) values = quantities_of(entry, parameter.unit);
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

/// The law's name in the table that is to be written: the one given as a text, if it is such a
/// name.
std::string name_for_table(const Entry& law) {
  constexpr std::size_t kMostShown = 100;
  const bool plain =
      law.kind == Kind::Text && !law.text.empty() && law.text.size() <= kMostShown &&
      std::none_of(law.text.begin(), law.text.end(), [](char c) {
        return static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '"' || c == '\\';
      });
  return plain ? law.text : "polynomial-5";
}

const Entry& law_entry(const Entry& file) {
  const Entry* law = find(file, "law");
  if (law == nullptr) refuse(file, "law is missing; write [law] and name = \"polynomial-5\"");
  expect(*law, Kind::Table, fmt::format("a table, [law] with name = \"{}\"", name_for_table(*law)));
  return *law;
}

const Entry& name_entry(const Entry& law) {
  const Entry* name = find(law, "name");
  if (name == nullptr) refuse(law, "name is missing; 'camlaw laws' lists all laws");
  return *name;
}

}  // namespace

namespace {

/// The table that a mechanism of this kind does without.
void refuse_table(const Entry& file, const Mechanism& mechanism, const char* key) {
  const Entry* table = find(file, key);
  if (table == nullptr) return;
  const char* wanted = mechanism.moved_by == MovedBy::Program ? "; it needs [program]"
                       : mechanism.moved_by == MovedBy::Law   ? "; it needs [law]"
                                                              : "";
  refuse(*table, fmt::format("{} takes no {}{}", mechanism.name, key, wanted));
}

}  // namespace

void read_laws(const Entry& file, ProblemStatement& problem, FixedNames& fixed) {
  const Mechanism& mechanism = *problem.mechanism;
  if (mechanism.moved_by != MovedBy::Law) refuse_table(file, mechanism, "law");
  if (mechanism.moved_by != MovedBy::Program) refuse_table(file, mechanism, "program");
  if (mechanism.moved_by == MovedBy::Nothing) {
    problem.laws = {find_law("constant-velocity")};
    return;
  }
  if (mechanism.moved_by == MovedBy::Program) {
    const Entry* program = find(file, "program");
    if (program == nullptr) {
      refuse(file, "program is missing; write [program] and [[program.segments]]");
    }
    expect(*program, Kind::Table, "a table, [program] with [[program.segments]]");
    read_program(file, *program, problem);
    return;
  }
  const Entry& law = law_entry(file);
  const NamedLaws named_laws = read_names(file, name_entry(law), problem.files);
  problem.laws = named_laws.list.laws;
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

namespace {

/// What tells a law from others: its name, and of a file what is in it.
std::string identity_of(const Member& law) {
  return is_law_file(law) ? pieces_to_json(law.law()).dump() + to_string(law.law().ends())
                          : law.name();
}

}  // namespace

void check_laws_at_start(const Entry& file, const ProblemStatement& problem) {
  const MovedBy moved_by = problem.mechanism->moved_by;
  if (moved_by == MovedBy::Nothing) return;
  const Entry& name =
      moved_by == MovedBy::Program ? *find(file, "program") : name_entry(law_entry(file));
  located(name, [&] { check_laws(problem); });
  std::set<std::string> seen;
  for (const Member& law : problem.laws) {
    if (!seen.insert(identity_of(law)).second) {
      refuse(name, fmt::format("'{}' appears twice, with what varies at its start", law.label()));
    }
  }
}

}  // namespace camlaw::problems
