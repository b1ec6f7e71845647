// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "machines/model/load_case.h"
#include "problems/statement/cases.h"
#include "problems/statement/parts.h"
#include "problems/statement/ranges.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {
namespace {

using Kind = Entry::Kind;

constexpr std::size_t kMostCases = 50;

/// A name that may stand before a dot, and is no word of problem files.
std::string read_case_name(const Entry& table, const ProblemStatement& problem) {
  const Entry* name = find(table, "name");
  if (name == nullptr) refuse(table, "name is missing, such as name = \"fast\"");
  const std::string& text = text_of(*name);
  check_spelling(*name, text);
  for (const char* word : {"worst", "mean", "all"}) {
    if (text == word) {
      refuse(*name, fmt::format("'{}' means all cases; give this one another name", text));
    }
  }
  for (const CamStatement& cam : problem.cams) {
    if (cam.name == text) {
      refuse(*name, fmt::format("'{}' is a cam of this file; give the case another name", text));
    }
  }
  if (find_case(problem, text) != nullptr) {
    refuse(*name, fmt::format("there is a case '{}' already", text));
  }
  return text;
}

/// The value that a case gives a parameter, which is the same at every design.
std::pair<std::size_t, double> read_value(const Entry& entry, const ProblemStatement& problem) {
  const NamedParameter parameter =
      located(entry, [&] { return find_parameter(problem, entry.key, Owner::Machine); });
  if (find_variable(problem, parameter, 0)) {
    refuse(entry, fmt::format("{} varies; a case sets what does not vary", parameter.name));
  }
  if (const PartStatement* part = part_of(problem, parameter.parameter)) {
    refuse(entry, fmt::format("{} comes with {}, [parts.{}], which is the same in every case",
                              parameter.name, part->name, part->name));
  }
  if (problem.told_by_motion.contains(parameter.parameter)) {
    refuse(entry, fmt::format("the motion is stated in {}, so {} is the same in every case",
                              parameter.unit, parameter.name));
  }
  const double value =
      onto_range(quantity_of(entry, parameter.unit), parameter.low, parameter.high);
  check_accepted(entry, parameter, value);
  return {parameter.parameter, value};
}

LoadCase read_case(const Entry& table, const ProblemStatement& problem) {
  expect(table, Kind::Table, "a table, [[cases]] with a name and parameters");
  LoadCase load;
  load.name = read_case_name(table, problem);
  load.weight = find_positive(table, "weight", "1").value_or(1);
  for (const Entry& entry : table.items) {
    if (entry.key == "name" || entry.key == "weight") continue;
    load.parameters.push_back(read_value(entry, problem));
  }
  if (load.parameters.empty()) {
    refuse(table, "it sets no parameter, such as speed = \"400 rpm\"");
  }
  std::sort(load.parameters.begin(), load.parameters.end());
  for (std::size_t i = 1; i < load.parameters.size(); ++i) {
    if (load.parameters[i].first != load.parameters[i - 1].first) continue;
    refuse(table, fmt::format("{} is set twice",
                              problem.mechanism->parameters[load.parameters[i].first].name));
  }
  return load;
}

/// A parameter that one case sets and another does not has there the value of [constants].
void complete(ProblemStatement& problem) {
  std::vector<std::size_t> all;
  for (const LoadCase& load : problem.cases) {
    for (const auto& [parameter, value] : load.parameters) all.push_back(parameter);
  }
  for (LoadCase& load : problem.cases) {
    for (const std::size_t parameter : all) {
      const bool is_set = std::any_of(load.parameters.begin(), load.parameters.end(),
                                      [&](const auto& set) { return set.first == parameter; });
      if (!is_set) load.parameters.emplace_back(parameter, problem.constants[parameter]);
    }
    std::sort(load.parameters.begin(), load.parameters.end());
  }
  problem.stated.insert(all.begin(), all.end());
}

}  // namespace

void read_cases(const Entry& file, ProblemStatement& problem) {
  const Entry* cases = find(file, "cases");
  if (cases == nullptr) return;
  expect(*cases, Kind::List, "a list of tables, each headed [[cases]]");
  if (cases->items.size() > kMostCases) {
    refuse(*cases,
           fmt::format("{} cases; at most {} are accepted", cases->items.size(), kMostCases));
  }
  for (const Entry& table : cases->items) problem.cases.push_back(read_case(table, problem));
  complete(problem);
  for (std::size_t i = 0; i < problem.cases.size(); ++i) {
    located(cases->items[i], [&] { check_laws_in(problem, problem.cases[i]); });
  }
  problem.without_cases = problem.mechanism;
  problem.mechanism =
      std::make_shared<const Mechanism>(with_cases(*problem.mechanism, problem.cases));
}

std::vector<std::string> read_case_names(const Entry& table, const ProblemStatement& problem) {
  std::vector<std::string> all;
  for (const LoadCase& load : problem.cases) all.push_back(load.name);
  const Entry* entry = find(table, "cases");
  if (entry == nullptr) return all;
  if (all.empty()) refuse(*entry, "the file has no load cases, [[cases]]");
  std::vector<std::string> names;
  const auto add = [&](const Entry& item) {
    const std::string& name = text_of(item);
    if (find_case(problem, name) == nullptr) {
      refuse(item, fmt::format("there is no case '{}'; {}", name, suggestion(name, all)));
    }
    names.push_back(name);
  };
  if (entry->kind != Kind::List) {
    if (text_of(*entry) == "all") return all;
    add(*entry);
  } else {
    for (const Entry& item : entry->items) add(item);
    if (names.empty()) refuse(*entry, "it names no case");
  }
  return names;
}

ObjectiveStatement read_over_cases(const Entry& table, const ProblemStatement& problem,
                                   ObjectiveStatement objective) {
  const Entry* entry = find(table, "cases");
  if (entry == nullptr) {
    objective = over_cases(problem, std::move(objective), OverCases::Worst);
    return over_ranges(problem, std::move(objective));
  }
  if (problem.cases.empty()) refuse(*entry, "the file has no load cases, [[cases]]");
  const std::string& wanted = text_of(*entry);
  if (wanted == "worst") return over_cases(problem, std::move(objective), OverCases::Worst);
  if (wanted == "mean") return over_cases(problem, std::move(objective), OverCases::Mean);
  std::vector<std::string> known{"worst", "mean"};
  for (const LoadCase& load : problem.cases) known.push_back(load.name);
  const LoadCase* one = find_case(problem, wanted);
  if (one == nullptr) {
    refuse(*entry, fmt::format("there is no case '{}'; {}", wanted, suggestion(wanted, known)));
  }
  objective.response = in_case(*problem.mechanism, objective.response, *one);
  return over_ranges(problem, std::move(objective));
}

}  // namespace camlaw::problems
