// SPDX-License-Identifier: MIT
#include "problems/statement/table_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>

#include "problems/statement/cases.h"
#include "problems/statement/made_entries.h"
#include "problems/statement/parameters.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {
namespace {

constexpr std::string_view kVariation = "variation", kRanges = "ranges", kCases = "cases";

/// "variation", "base_radius" and "plus"; what the name lacks is empty.
struct TableSetting {
  std::string_view table, owner, key;
};

std::optional<TableSetting> table_setting(const ProblemStatement& problem, std::string_view name) {
  const std::size_t dot = name.find('.');
  if (dot == std::string_view::npos) return {};
  TableSetting setting{name.substr(0, dot), {}, {}};
  if (setting.table != kVariation && setting.table != kRanges && setting.table != kCases) return {};
  const bool is_cam =
      std::any_of(problem.cams.begin(), problem.cams.end(),
                  [&](const CamStatement& cam) { return cam.name == setting.table; });
  if (is_cam || find_case(problem, setting.table) != nullptr) return {};
  // Parameters of cams on a shaft have a dot in their names, load cases have none.
  const std::string_view rest = name.substr(dot + 1);
  const std::size_t end = setting.table == kCases ? rest.find('.') : rest.rfind('.');
  setting.owner = rest.substr(0, end);
  if (end != std::string_view::npos) setting.key = rest.substr(end + 1);
  return setting;
}

std::string how_to_write(const TableSetting& setting) {
  const std::string_view owner = setting.owner;
  if (setting.table == kVariation) {
    return fmt::format(
        "write variation.{0}.plus, variation.{0}.minus, variation.{0}.standard_deviation or "
        "variation.{0}.fit",
        owner.empty() ? "base_radius" : owner);
  }
  if (setting.table == kRanges) {
    return fmt::format("write ranges.{0}.lower and ranges.{0}.upper",
                       owner.empty() ? "speed" : owner);
  }
  return fmt::format("write a parameter of the case, such as cases.{0}.speed, or cases.{0}.weight",
                     owner.empty() ? "fast" : owner);
}

/// Whether two names are of one parameter: its name and its symbol.
bool are_of_one(const ProblemStatement& problem, std::string_view a, std::string_view b,
                Owner owner) {
  if (a == b) return true;
  try {
    const NamedParameter one = find_parameter(problem, a, owner);
    const NamedParameter other = find_parameter(problem, b, owner);
    return one.of_law == other.of_law && one.parameter == other.parameter &&
           one.law_parameter == other.law_parameter && one.element == other.element;
  } catch (const std::invalid_argument&) {  // which is told where it is read
    return false;
  }
}

/// A table's entry for a parameter, by whichever of its names.
Entry* entry_of_parameter(Entry& table, const ProblemStatement& problem, std::string_view name,
                          Owner owner) {
  for (Entry& entry : table.items) {
    if (are_of_one(problem, entry.key, name, owner)) return &entry;
    // [variation.law.c] is c in a table called law.
    const bool is_group = owner == Owner::Either && entry.kind == Entry::Kind::Table &&
                          (entry.key == "law" || entry.key == "machine");
    if (!is_group) continue;
    for (Entry& own : entry.items) {
      if (are_of_one(problem, entry.key + "." + own.key, name, owner)) return &own;
    }
  }
  return nullptr;
}

/// "variation.base_radius.plus", "ranges.speed.lower".
void put_of_parameter(Entry& file, const ProblemStatement& problem, const TableSetting& setting,
                      std::string_view text, const std::string& place) {
  Entry& table = entry_or_made(file, setting.table, Entry::Kind::Table, place);
  if (table.kind != Entry::Kind::Table) return;  // which is refused where it is read
  const Owner owner = setting.table == kRanges ? Owner::Machine : Owner::Either;
  Entry* there = entry_of_parameter(table, problem, setting.owner, owner);
  Entry& own =
      there != nullptr ? *there : entry_or_made(table, setting.owner, Entry::Kind::Table, place);
  if (own.kind != Entry::Kind::Table) return;
  put_entry(own, setting.key == "of_diameter" ? written_entry(own, setting.key, text, place)
                                              : made_text(own, setting.key, text, place));
}

}  // namespace

bool is_table_setting(const ProblemStatement& problem, std::string_view name) {
  return table_setting(problem, name).has_value();
}

void put_in_case(Entry& file, const ProblemStatement& problem, std::string_view load_case,
                 std::string_view key, std::string_view text, const std::string& place) {
  Entry& list = entry_or_made(file, kCases, Entry::Kind::List, place);
  if (list.kind != Entry::Kind::List) return;
  const auto has_name = [&](const Entry& table) {
    const Entry* name = find(table, "name");
    return name != nullptr && name->text == load_case;
  };
  auto load = std::find_if(list.items.begin(), list.items.end(), has_name);
  if (load == list.items.end()) {
    Entry table = made_item(list, place);
    table.items = {made_text(table, "name", load_case, place)};
    load = list.items.insert(list.items.end(), std::move(table));
  }
  const bool is_parameter = key != "weight" && key != "name";
  const Entry* there =
      is_parameter ? entry_of_parameter(*load, problem, key, Owner::Machine) : nullptr;
  put_entry(*load, made_text(*load, there != nullptr ? there->key : key, text, place));
}

void put_in_table(Entry& file, const ProblemStatement& problem, std::string_view name,
                  std::string_view text, const std::string& place) {
  const auto setting = table_setting(problem, name);
  if (!setting) return;
  if (setting->owner.empty() || setting->key.empty()) {
    throw std::invalid_argument(fmt::format("{}: {}", name, how_to_write(*setting)));
  }
  if (setting->table == kCases) {
    return put_in_case(file, problem, setting->owner, setting->key, text, place);
  }
  put_of_parameter(file, problem, *setting, text, place);
}

std::string_view varied_name(std::string_view name) {
  constexpr std::array kKeys{"plus", "minus", "standard_deviation", "fit"};
  const auto [owner, key] = at_last_dot(name);
  return std::find(kKeys.begin(), kKeys.end(), key) == kKeys.end() ? std::string_view() : owner;
}

}  // namespace camlaw::problems
