// SPDX-License-Identifier: MIT
#include "problems/results/recorded_design.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "problems/law_files/json_text.h"
#include "problems/law_files/law_file.h"
#include "problems/results/seal.h"
#include "problems/results/stated_numbers.h"
#include "problems/statement/assignment.h"
#include "problems/statement/choices.h"
#include "problems/statement/held_files.h"
#include "problems/statement/parameters.h"
#include "problems/statement/parts.h"
#include "problems/statement/restated.h"

namespace camlaw::problems {
namespace {

constexpr const char* kWanted = "give a problem file or a result of 'camlaw optimize'";

[[noreturn]] void refuse_result(const std::string& why) { throw std::invalid_argument(why); }

const Json& key(const Json& record, const char* name, bool (Json::*is)() const noexcept,
                const char* kind) {
  const auto found = record.find(name);
  if (found == record.end()) refuse_result(fmt::format("its design has no {}", name));
  if (!((*found).*is)())
    refuse_result(fmt::format("{} of its design is not of type {}", name, kind));
  return *found;
}

std::string text_of(const Json& record, const char* name) {
  return key(record, name, &Json::is_string, "text").get<std::string>();
}

HeldFiles files_of(const Json& record) {
  HeldFiles files{laws_from_json(key(record, "law_files", &Json::is_object, "object"))};
  if (record.contains("tables")) files.tables = tables_from_json(record["tables"]);
  return files;
}

/// What was set beside the file; results of earlier programs have none.
std::vector<std::string> settings_of(const Json& record) {
  std::vector<std::string> settings;
  if (!record.contains("set")) return settings;
  for (const Json& setting : key(record, "set", &Json::is_array, "list")) {
    if (!setting.is_string()) refuse_result("set of its design is not a list of texts");
    settings.push_back(setting.get<std::string>());
  }
  return settings;
}

/// Whether a name is a law's, by the names that its parameters had in an older program too.
bool is_called(const Member& law, const std::string& name) {
  if (law.name() == name) return true;
  const bool has_older = std::any_of(law.family->parameters.begin(), law.family->parameters.end(),
                                     [](const Parameter& p) { return !p.also.empty(); });
  if (!has_older || !name.starts_with(law.family->name + " ")) return false;
  try {
    return find_law(name).name() == law.name();
  } catch (const std::invalid_argument&) {
    return false;
  }
}

/// Leaves the law that was chosen.
void choose_law(const Json& record, ProblemStatement& statement) {
  if (statement.laws.size() < 2) return;
  const std::string name = text_of(record, "law");
  const auto chosen = std::find_if(statement.laws.begin(), statement.laws.end(),
                                   [&](const Member& law) { return is_called(law, name); });
  if (chosen == statement.laws.end()) {
    refuse_result(
        fmt::format("its design has the law '{}', which its problem does not have", name));
  }
  statement.laws = std::vector<Member>{*chosen};
}

/// Leaves of each part the one that was chosen.
void choose_parts(const Json& record, ProblemStatement& statement) {
  if (statement.parts.empty()) return;
  const Json& chosen = key(record, "parts", &Json::is_object, "object");
  for (std::size_t i = 0; i < statement.parts.size(); ++i) {
    const PartStatement part = statement.parts[i];
    keep_item(statement, part.name, item_named(part, text_of(chosen, part.name.c_str())));
  }
}

/// Where a variable's number is among the parameters; none: the chosen law has it not.
std::optional<NamedParameter> parameter_of(const ProblemStatement& statement,
                                           const VariableStatement& variable) {
  NamedParameter result;
  result.of_law = variable.of_law;
  result.parameter = variable.parameter;
  result.law_parameter = variable.law_parameter;
  const bool has = !variable.of_law ||
                   index_in(*statement.laws.front().family, variable.law_parameter).has_value();
  return has ? std::optional(result) : std::nullopt;
}

/// The number of a variable, by the name that its parameter had in an older program where it is
/// there by that.
const Json* number_of(const Json& numbers, const ProblemStatement& statement,
                      const VariableStatement& variable) {
  auto number = numbers.find(variable.name);
  if (number == numbers.end() && variable.of_law) {
    const Family& family = *statement.laws.front().family;
    const Parameter& p = family.parameters[*index_in(family, variable.law_parameter)];
    std::string older = variable.name;
    const std::size_t at = older.find(p.name);
    if (p.also.empty() || at == std::string::npos) return nullptr;
    number = numbers.find(older.replace(at, p.name.size(), p.also));
  }
  return number == numbers.end() || !number->is_number() ? nullptr : &*number;
}

void set_variables(const Json& record, ProblemStatement& statement) {
  const Json& numbers = key(record, "variables", &Json::is_object, "object");
  for (VariableStatement& variable : statement.variables) {
    const auto parameter = parameter_of(statement, variable);
    if (!parameter) continue;
    const Json* const number = number_of(numbers, statement, variable);
    if (number == nullptr) {
      refuse_result(fmt::format("its design has no number for {}", variable.name));
    }
    const auto value = number->get<double>();
    if (const auto why = why_not(variable, value)) {
      refuse_result(fmt::format("{} of its design: {}", variable.name, *why));
    }
    variable.start = value;
    put_value(statement, *parameter, variable.element, value);
  }
  check_laws(statement);
}

/// The object of a result with a design.
Json result_of(std::string_view json) {
  Json result = [&] {
    try {
      return parse_json(json);
    } catch (const std::invalid_argument& error) {
      refuse_result(fmt::format("{}; {}", error.what(), kWanted));
    }
  }();
  // Results of earlier programs state none; what another kind of answer is, its format says best.
  if (const auto format = result.find("format"); format != result.end()) {
    if (!format->is_string()) refuse_result("its format is not text");
    try {
      kResultFormat.check(format->get<std::string>());
    } catch (const std::invalid_argument& error) {
      refuse_result(fmt::format("{}; {}", error.what(), kWanted));
    }
  }
  if (!result.is_object() || !result.contains("design") || !result.contains("verdict")) {
    refuse_result(fmt::format("it is not a result with a design in it; {}", kWanted));
  }
  if (result["design"].is_null()) {
    refuse_result(fmt::format("it holds no design; its verdict is {}", result["verdict"].dump()));
  }
  if (!result["design"].is_object()) refuse_result("its design is not an object");
  return result;
}

/// Why the search's verdict is what it is, where the result says so.
void read_reason(const Json& result, ReadDesign& design) {
  const auto reason = result.find("reason"), blamed = result.find("blamed");
  if (reason != result.end() && reason->is_string()) design.reason = reason->get<std::string>();
  if (blamed == result.end() || !blamed->is_array()) return;
  for (const Json& name : *blamed) {
    if (name.is_string()) design.blamed.push_back(name.get<std::string>());
  }
}

}  // namespace

ReadDesign read_result(std::string_view json, const std::string& source) {
  try {
    const Json result = result_of(json);
    const Json& record = result["design"];
    ProblemStatement problem =
        read_problem(text_of(record, "problem"), text_of(record, "source"), files_of(record));
    set_values(problem, settings_of(record));
    ReadDesign design{std::move(problem)};
    choose_law(record, design.statement);
    choose_parts(record, design.statement);
    set_variables(record, design.statement);
    if (result["verdict"].is_string()) design.verdict = result["verdict"].get<std::string>();
    read_reason(result, design);
    if (record.contains("path")) design.problem_file = text_of(record, "path");
    const auto value = result.find("objective"), global = result.find("global");
    if (value != result.end() && value->is_number()) design.objective = value->get<double>();
    const bool is_said = global != result.end() && global->is_boolean() && global->get<bool>();
    design.global = is_said || (global != result.end() && global->is_string());
    design.stated = stated_numbers(result);
    return design;
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", source, error.what()));
  }
}

ReadDesign read_design_file(const std::string& path) {
  const std::string text = text_of_file(path, "problem file or a result");
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first != std::string::npos && text[first] == '{') return read_result(text, path);
  return {read_problem(text, path)};
}

void set_in_design(ProblemStatement& statement, const ReadDesign& read,
                   std::span<const std::string> settings) {
  for (const std::string& setting : settings) {
    const std::string_view name = parse_assignment(setting, "speed=60 rpm").name;
    if (!read.verdict || !is_free_setting(read.problem, name)) continue;
    refuse_result(
        fmt::format("{}: the result's coefficients fit its own free law only; set it where the "
                    "law is sought, with camlaw optimize",
                    name));
  }
  set_values(statement, settings);
}

}  // namespace camlaw::problems
