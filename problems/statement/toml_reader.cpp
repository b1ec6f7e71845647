// SPDX-License-Identifier: MIT
#include "problems/statement/toml_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "kinematics/laws/catalogue.h"
#include "numerics/text/names.h"
#include "numerics/text/units.h"
#include "problems/statement/parameters.h"

namespace camlaw::problems {

using Kind = Entry::Kind;

/// Of a parameter that is a list: what is made of its elements takes their square at least.
constexpr std::size_t kMostNumbers = 1000;

std::string suggestion(std::string_view typed, const std::vector<std::string>& known,
                       const std::string& lead) {
  const auto near = near_names(typed, known);
  return near.empty() ? fmt::format("{} {}", lead, fmt::join(known, ", ")) : did_you_mean(near);
}

void expect(const Entry& entry, Kind kind, const std::string& wanted) {
  if (entry.kind != kind) {
    refuse(entry, fmt::format("{} is given; write {}", to_string(entry.kind), wanted));
  }
}

void check_keys(const Entry& table, const std::vector<std::string>& known) {
  for (const Entry& entry : table.items) {
    if (std::find(known.begin(), known.end(), entry.key) == known.end()) {
      refuse(entry, "unknown key; " + suggestion(entry.key, known));
    }
  }
}

const Entry* find(const Entry& table, std::string_view key) {
  const auto found = std::find_if(table.items.begin(), table.items.end(),
                                  [&](const Entry& entry) { return entry.key == key; });
  return found == table.items.end() ? nullptr : &*found;
}

const std::string& text_of(const Entry& entry) {
  expect(entry, Kind::Text, "a text in quotes");
  if (entry.text.find_first_not_of(" \t\r\n") == std::string::npos) {
    refuse(entry, "the text is empty");
  }
  return entry.text;
}

std::int64_t whole_of(const Entry& entry, std::int64_t low, std::int64_t high) {
  expect(entry, Kind::Integer, fmt::format("an integer from {} to {}", low, high));
  if (entry.integer < low || entry.integer > high) {
    refuse(entry, fmt::format("{} is outside {} .. {}", entry.integer, low, high));
  }
  return entry.integer;
}

double quantity_of(const Entry& entry, const std::string& unit) {
  if (entry.kind != Kind::Text && !entry.is_number()) {
    refuse(entry, fmt::format("{} is given; write a number{}", to_string(entry.kind),
                              unit == "1" ? "" : fmt::format(", such as 1 or \"1 {}\"", unit)));
  }
  double value = entry.number;
  if (entry.kind == Kind::Text) {
    try {
      value = parse_quantity(entry.text, unit, unit, entry.path);
    } catch (const std::invalid_argument& error) {  // it has named the path itself
      throw std::invalid_argument(fmt::format("{}: {}", entry.place, error.what()));
    }
  }
  if (!std::isfinite(value)) refuse(entry, fmt::format("{} is not a finite number", value));
  return value;
}

double positive_of(const Entry& entry, const std::string& unit) {
  const double value = quantity_of(entry, unit);
  if (!(value > 0)) refuse(entry, fmt::format("{} is not above zero", with_unit(value, unit)));
  return value;
}

std::optional<double> find_positive(const Entry& table, std::string_view key,
                                    const std::string& unit) {
  const Entry* entry = find(table, key);
  return entry == nullptr ? std::nullopt : std::optional(positive_of(*entry, unit));
}

std::vector<double> quantities_of(const Entry& list, const std::string& unit) {
  expect(list, Kind::List, "a list of numbers, such as [1, 2]");
  if (list.items.empty()) refuse(list, "the list is empty");
  if (list.items.size() > kMostNumbers) {
    refuse(list, fmt::format("a list of {} numbers; at most {} are accepted", list.items.size(),
                             kMostNumbers));
  }
  std::vector<double> values;
  for (const Entry& item : list.items) values.push_back(quantity_of(item, unit));
  return values;
}

bool truth_of(const Entry& table, const char* key) {
  const Entry* entry = find(table, key);
  if (entry == nullptr) return false;
  expect(*entry, Kind::Truth, "true or false");
  return entry->integer != 0;
}

bool reads_integer(const Entry& table) {
  const Entry* type = find(table, "type");
  if (type == nullptr) return false;
  const std::string& text = text_of(*type);
  if (text != "integer" && text != "continuous") {
    refuse(*type, fmt::format("'{}' is not a type; use integer or continuous", text));
  }
  return text == "integer";
}

}  // namespace camlaw::problems
