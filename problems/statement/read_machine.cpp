// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

#include "machines/model/cycle.h"
#include "machines/model/stated_response.h"
#include "machines/registry.h"
#include "numerics/text/dimension.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

/// The mechanism of a problem file: one of the registry's, or the file's own, [machine]; with the
/// responses that the file adds, [responses].
namespace camlaw::problems {
namespace {

using Kind = Entry::Kind;

constexpr std::size_t kMostStated = 200;  // parameters of a machine, and responses of a file
/// Of a parameter without lower or upper, in its unit.
constexpr double kWidest = 1e12;

std::string known_mechanisms() {
  std::string names;
  for (const Mechanism& mechanism : mechanisms()) {
    names += (names.empty() ? "" : ", ") + mechanism.name;
  }
  return names;
}

}  // namespace

const std::string& printable_text(const Entry& entry) {
  text_of(entry);
  for (std::size_t i = 0; i < entry.text.size(); ++i) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(entry.text[k]); };
    const bool c1 = byte(i) == 0xC2 && i + 1 < entry.text.size() && byte(i + 1) < 0xA0;
    if (byte(i) >= 0x20 && byte(i) != 0x7F && !c1) continue;
    refuse(entry, fmt::format("it has a control character, U+{:04X}; a {} is one line of text",
                              c1 ? byte(i + 1) : byte(i), entry.key));
  }
  return entry.text;
}

namespace {

/// The text of a table's entry; empty where there is none.
std::string text_or_none(const Entry& table, const char* key) {
  const Entry* entry = find(table, key);
  return entry == nullptr ? "" : printable_text(*entry);
}

/// Names that [variables] has for the tables of what they belong to.
const std::set<std::string> kTables{"law", "program", "machine", "variables"};

[[noreturn]] void refuse_word(const Entry& table, const std::string& name) {
  refuse(table,
         fmt::format("'{}' means something else in problem files; give it another name", name));
}

}  // namespace

void check_spelling(const Entry& table, const std::string& name) {
  const auto accepted = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  };
  const bool begins = !name.empty() && std::isdigit(static_cast<unsigned char>(name[0])) == 0;
  if (!begins || !std::all_of(name.begin(), name.end(), accepted)) {
    refuse(table, fmt::format("'{}' is not a name for formulas; a name has letters, digits and _, "
                              "and begins with a letter or _",
                              name));
  }
  if (kTables.contains(name)) refuse_word(table, name);
}

namespace {

/// Refuses a name that a formula could not hold, or that means something in every formula.
void check_name(const Entry& table, const std::string& name) {
  check_spelling(table, name);
  if (is_formula_word(name)) refuse_word(table, name);
}

/// Refuses a name that the mechanism has already.
void check_new(const Entry& table, const Mechanism& mechanism, const std::string& name) {
  const auto has_name = [&](const auto& named) { return named.name == name; };
  const auto& parameters = mechanism.parameters;
  const bool is_parameter =
      std::any_of(parameters.begin(), parameters.end(),
                  [&](const MechanismParameter& p) { return p.name == name || p.symbol == name; });
  const bool is_response =
      std::any_of(mechanism.responses.begin(), mechanism.responses.end(), has_name) ||
      std::any_of(mechanism.peaks.begin(), mechanism.peaks.end(), has_name);
  if (!is_parameter && !is_response) return;
  refuse(table, fmt::format("{} has a {} of this name already; give it another one", mechanism.name,
                            is_parameter ? "parameter" : "response"));
}

/// A unit in the spelling of the unit library; of none "1".
std::string read_unit(const Entry& table) {
  const Entry* entry = find(table, "unit");
  if (entry == nullptr) return "1";
  const std::string& text = text_of(*entry);
  return located(*entry, [&] { return written_unit(text).spelled; });
}

double number_or(const Entry& table, const char* key, const std::string& unit,
                 double default_value) {
  const Entry* entry = find(table, key);
  return entry == nullptr ? default_value : quantity_of(*entry, unit);
}

MechanismParameter read_parameter(const Entry& table, const Mechanism& machine) {
  expect(table, Kind::Table, "a table with unit and default");
  check_keys(table, {"unit", "default", "lower", "upper", "type", "symbol", "meaning"});
  check_name(table, table.key);
  check_new(table, machine, table.key);
  MechanismParameter parameter;
  parameter.name = table.key;
  parameter.unit = parameter.stored = read_unit(table);
  parameter.symbol = text_or_none(table, "symbol");
  if (const Entry* symbol = find(table, "symbol")) {
    check_name(*symbol, parameter.symbol);
    check_new(*symbol, machine, parameter.symbol);
  } else {
    parameter.symbol = parameter.name;
  }
  parameter.meaning = text_or_none(table, "meaning");
  const Entry* value = find(table, "default");
  if (value == nullptr) refuse(table, "default is missing; give its usual value");
  parameter.default_value = quantity_of(*value, parameter.unit);
  parameter.low = number_or(table, "lower", parameter.unit, -kWidest);
  parameter.high = number_or(table, "upper", parameter.unit, kWidest);
  parameter.integer = reads_integer(table);
  if (parameter.low > parameter.high) {
    refuse(table, fmt::format("lower {} exceeds upper {}", with_unit(parameter.low, parameter.unit),
                              with_unit(parameter.high, parameter.unit)));
  }
  if (parameter.default_value < parameter.low || parameter.default_value > parameter.high) {
    refuse(*value,
           fmt::format("{} is not within {}", with_unit(parameter.default_value, parameter.unit),
                       range_text(parameter.low, parameter.high, parameter.unit)));
  }
  if (parameter.integer && parameter.default_value != std::floor(parameter.default_value)) {
    refuse(*value, fmt::format("{:g} is not an integer", parameter.default_value));
  }
  return parameter;
}

/// The tables of a table, at most kMostStated of them; none where there is no such entry.
const std::vector<Entry>& tables_of(const Entry* entry, const std::string& example) {
  static const std::vector<Entry> none;
  if (entry == nullptr) return none;
  expect(*entry, Kind::Table, "tables, such as " + example);
  if (entry->items.size() > kMostStated) {
    refuse(*entry,
           fmt::format("{} tables; at most {} are accepted", entry->items.size(), kMostStated));
  }
  return entry->items;
}

MovedBy read_moved_by(const Entry& machine) {
  const Entry* entry = find(machine, "moved_by");
  if (entry == nullptr) return MovedBy::Nothing;
  const std::map<std::string, MovedBy> known{
      {"law", MovedBy::Law}, {"program", MovedBy::Program}, {"nothing", MovedBy::Nothing}};
  const auto found = known.find(text_of(*entry));
  if (found == known.end()) {
    refuse(*entry,
           fmt::format("'{}' does not move a machine; use law, program or nothing", entry->text));
  }
  return found->second;
}

/// A machine of the file's own.
Mechanism read_own_machine(const Entry& table) {
  expect(table, Kind::Table, "a table, [machine]");
  check_keys(table, {"name", "title", "source", "moved_by", "parameters"});
  Mechanism machine;
  machine.name = text_or_none(table, "name");
  if (machine.name.empty()) machine.name = "machine";
  if (const Mechanism* known = known_mechanism(machine.name)) {
    refuse(*find(table, "name"),
           fmt::format("{} is a mechanism of this program; give the machine another name, or write "
                       "mechanism = \"{}\" instead of [machine]",
                       machine.name, known->name));
  }
  machine.title = text_or_none(table, "title");
  if (machine.title.empty()) machine.title = machine.name;
  machine.source = text_or_none(table, "source");
  if (machine.source.empty()) machine.source = "the problem file";
  machine.moved_by = read_moved_by(table);
  machine.cycle = std::make_shared<Cycle>(usual_cycle(machine.moved_by));
  for (const Entry& entry :
       tables_of(find(table, "parameters"), "[machine.parameters.crank_radius]")) {
    machine.parameters.push_back(read_parameter(entry, machine));
  }
  return machine;
}

/// A response that the file states, and where.
struct Stated {
  const Entry* table;
  StatedResponse response;
};

/// A formula that may be written over several lines.
std::string in_one_line(const std::string& text) {
  std::string line;
  for (const char c : text) {
    const bool is_blank = std::isspace(static_cast<unsigned char>(c)) != 0;
    if (!is_blank) {
      line += c;
    } else if (!line.empty() && line.back() != ' ') {
      line += ' ';
    }
  }
  return line;
}

Stated read_stated(const Entry& table, const Mechanism& mechanism) {
  expect(table, Kind::Table, "a table with formula and unit");
  check_keys(table, {"formula", "unit", "meaning"});
  check_name(table, table.key);
  check_new(table, mechanism, table.key);
  const Entry* formula = find(table, "formula");
  if (formula == nullptr) refuse(table, "formula is missing, such as formula = \"mass * speed^2\"");
  const std::string& text = text_of(*formula);
  StatedResponse response{table.key, read_unit(table), text_or_none(table, "meaning"),
                          located(*formula, [&] { return parse_formula(text); })};
  if (response.meaning.empty()) response.meaning = in_one_line(text);
  return {&table, std::move(response)};
}

/// Adds responses to a mechanism, each after those that its formula holds.
class Adding {
 public:
  Adding(Mechanism& mechanism, const std::vector<Stated>& all) : mechanism_(mechanism), all_(all) {
    for (const Stated& stated : all) names_.push_back(stated.response.name);
    is_added_.resize(all.size());
  }

  void add(std::size_t i) {
    if (is_added_[i]) return;
    const Entry& formula = *find(*all_[i].table, "formula");
    const auto before = std::find(path_.begin(), path_.end(), names_[i]);
    if (before != path_.end()) {
      if (before + 1 == path_.end()) refuse(formula, names_[i] + " refers to itself");
      refuse(formula, fmt::format("the formulas refer to one another in a circle: {}, {}",
                                  fmt::join(before, path_.end(), ", "), names_[i]));
    }
    path_.push_back(names_[i]);
    for (const std::string& held : names_held(all_[i].response.formula, names_)) {
      add(static_cast<std::size_t>(std::find(names_.begin(), names_.end(), held) - names_.begin()));
    }
    path_.pop_back();
    mechanism_.responses.push_back(
        located(formula, [&] { return stated_response(mechanism_, all_[i].response); }));
    is_added_[i] = true;
  }

 private:
  Mechanism& mechanism_;
  const std::vector<Stated>& all_;
  std::vector<std::string> names_, path_;
  std::vector<bool> is_added_;
};

}  // namespace

void read_stated_responses(const Entry& file, Mechanism& mechanism) {
  const Entry* responses = find(file, "responses");
  std::vector<Stated> all;
  for (const Entry& table : tables_of(responses, "[responses.grip_force]")) {
    all.push_back(read_stated(table, mechanism));
  }
  Adding adding(mechanism, all);
  for (std::size_t i = 0; i < all.size(); ++i) adding.add(i);
}

void read_title(const Entry& file, ProblemStatement& problem) {
  problem.title = text_or_none(file, "title");
}

void read_mechanism(const Entry& file, ProblemStatement& problem) {
  const Entry *name = find(file, "mechanism"), *own = find(file, "machine");
  const Entry* responses = find(file, "responses");
  if (name == nullptr && own == nullptr) {
    refuse(file, fmt::format("mechanism is missing; choose one of {}", known_mechanisms()));
  }
  if (name != nullptr && own != nullptr) {
    refuse(*own, "the file names a mechanism too; drop one of the two");
  }
  const Mechanism* known = nullptr;
  if (name != nullptr) {
    const std::string& text = text_of(*name);
    known = located(*name, [&] { return &find_mechanism(text); });
  }
  if (own == nullptr && responses == nullptr) {
    problem.mechanism = listed(*known);
  } else {
    Mechanism mechanism = known != nullptr ? *known : read_own_machine(*own);
    read_stated_responses(file, mechanism);
    if (mechanism.responses.empty()) {
      refuse(*own, "the machine has no responses; write [responses.NAME] with a formula");
    }
    problem.mechanism = std::make_shared<Mechanism>(std::move(mechanism));
  }
  for (const MechanismParameter& parameter : problem.mechanism->parameters) {
    problem.constants.push_back(parameter.default_value);
  }
}

}  // namespace camlaw::problems
