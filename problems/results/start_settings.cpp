// SPDX-License-Identifier: MIT
#include "problems/results/start_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string_view>

#include "numerics/text/names.h"
#include "numerics/text/units.h"
#include "problems/statement/parts.h"

namespace camlaw::problems {
namespace {

struct Number {
  double value;
  std::string unit;
};

/// The number that a design has for a variable of another problem: of its own variable of that
/// name, or of the machine's constant.
std::optional<Number> known_number(const ProblemStatement& design,
                                   const VariableStatement& variable) {
  for (const VariableStatement& own : design.variables) {
    if (own.name == variable.name) return Number{own.start, own.unit};
  }
  if (variable.of_law) return {};
  const auto& parameters = design.mechanism->parameters;
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const auto& p) { return p.name == variable.name; });
  if (found == parameters.end()) return {};
  const auto index = static_cast<std::size_t>(found - parameters.begin());
  if (!design.stated.contains(index)) return {};
  return Number{design.constants[index], found->unit};
}

/// The value that the variable accepts which is nearest.
double accepted(const VariableStatement& variable, double value) {
  if (!variable.values.empty()) {
    return *std::min_element(
        variable.values.begin(), variable.values.end(),
        [&](double a, double b) { return std::abs(a - value) < std::abs(b - value); });
  }
  const double within = std::clamp(value, variable.lower, variable.upper);
  return variable.integer ? std::round(within) : within;
}

/// Names of laws by where they stand: "" for the law itself, "rise" for a program's segment,
/// "infeed" or "infeed.rise" for a cam of several.
std::map<std::string, std::string> laws_by_place(const Family& family) {
  std::map<std::string, std::string> laws;
  for (const LawPart& part : family.parts) {
    for (const auto& [place, law] : laws_by_place(*part.law->family)) {
      laws[place.empty() ? part.name : part.name + "." + place] = law;
    }
  }
  if (!family.parts.empty()) return laws;
  const std::vector<std::string_view> words = parted(family.name, ' ');
  if (words.front() != "program") return {{"", family.name}};
  for (const std::string_view word : words) {  // "rise=cycloidal"
    const std::size_t equals = word.find('=');
    if (equals == std::string_view::npos) continue;
    laws[std::string(word.substr(0, equals))] = word.substr(equals + 1);
  }
  return laws;
}

/// What is fixed in the design's law and is another number there: of two laws of one family that
/// the problem lists, "polynomial-5 alpha=-3" and "polynomial-5 alpha=0.9", the name says too
/// little.
void add_fixed_arguments(const ProblemStatement& settled, const Member& law,
                         std::vector<std::string>& settings) {
  const Member& own = settled.laws.front();
  const auto& parameters = law.family->parameters;
  if (own.family->name != law.family->name) return;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Parameter& parameter = parameters[i];
    const bool is_varied =
        std::any_of(settled.variables.begin(), settled.variables.end(),
                    [&](const auto& v) { return v.of_law && v.name == parameter.name; });
    const auto& there = law.arguments.list(i);
    if (is_varied || there.size() != 1 || there == own.arguments.list(i)) continue;
    settings.push_back(fmt::format("{}={}", parameter.name, there.front()));
  }
}

}  // namespace

std::vector<std::string> law_settings(const ProblemStatement& problem,
                                      const ProblemStatement& design) {
  if (!problem.chooses_law() || design.chooses_law()) return {};
  std::map<std::string, std::set<std::string>> choices;
  for (const Member& law : problem.laws) {
    for (const auto& [place, name] : laws_by_place(*law.family)) choices[place].insert(name);
  }
  // Laws of one family alone differ in their numbers: then each is named.
  const bool is_one_family = std::none_of(choices.begin(), choices.end(),
                                          [](const auto& each) { return each.second.size() > 1; });
  std::vector<std::string> settings;
  for (const auto& [place, name] : laws_by_place(*design.laws.front().family)) {
    if (choices[place].size() < 2 && !is_one_family) continue;
    settings.push_back(fmt::format("{}law={}", place.empty() ? "" : place + ".", name));
  }
  ProblemStatement settled = problem;
  set_values(settled, settings);
  add_fixed_arguments(settled, design.laws.front(), settings);
  return settings;
}

std::vector<std::string> start_settings(const ProblemStatement& problem, const ReadDesign& design) {
  std::vector<std::string> settings;
  for (const PartStatement& part : problem.parts) {
    const PartStatement* own = find_part(design.statement, part.name);
    if (!part.is_chosen() || own == nullptr || own->is_chosen()) continue;
    const std::string& name = own->items.front().name;
    const bool is_there = std::any_of(part.items.begin(), part.items.end(),
                                      [&](const PartItem& item) { return item.name == name; });
    if (is_there) settings.push_back(fmt::format("{}={}", part.name, name));
  }
  for (const VariableStatement& variable : problem.variables) {
    const auto number = known_number(design.statement, variable);
    if (!number || !std::isfinite(number->value)) continue;
    const double value = number->unit == variable.unit
                             ? number->value
                             : convert_unit(number->value, number->unit, variable.unit);
    settings.push_back(fmt::format("{}={}{}", variable.name, accepted(variable, value),
                                   variable.unit == "1" ? "" : " " + variable.unit));
  }
  if (settings.empty()) {
    throw std::invalid_argument("none of what varies in the problem is in its design");
  }
  return settings;
}

std::vector<std::string> restated_settings(const ProblemStatement& statement) {
  std::vector<std::string> settings = statement.settings;
  ProblemStatement plain = read_problem(statement.text, statement.source, statement.files);
  set_values(plain, settings);
  const std::vector<std::string> laws = law_settings(plain, statement);
  if (!laws.empty()) set_values(plain, laws);
  settings.insert(settings.end(), laws.begin(), laws.end());
  const bool is_chosen =
      !statement.parts.empty() && !chooses_part(statement) && chooses_part(plain);
  const bool stands_elsewhere = !std::equal(
      plain.variables.begin(), plain.variables.end(), statement.variables.begin(),
      statement.variables.end(), [](const auto& a, const auto& b) { return a.start == b.start; });
  if (!is_chosen && !stands_elsewhere) return settings;
  for (std::string& found : start_settings(plain, ReadDesign{statement})) {
    settings.push_back(std::move(found));
  }
  return settings;
}

std::vector<std::string> start_settings(const ProblemStatement& problem, const std::string& path) {
  const ReadDesign design = read_design_file(path);
  if (!design.verdict) {
    throw std::invalid_argument(fmt::format(
        "{}: this is a problem file; --start needs a result of 'camlaw optimize'", path));
  }
  try {
    return start_settings(problem, design);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", path, error.what()));
  }
}

}  // namespace camlaw::problems
