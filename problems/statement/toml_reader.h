// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "problems/statement/toml_entry.h"

/// Entries read as what is wanted of them. Each function throws std::invalid_argument with place,
/// path and what is accepted.
namespace camlaw::problems {

/// What an entry must be; `wanted` says it with an example: "a list of tables, [[constraints]]".
void expect(const Entry& entry, Entry::Kind kind, const std::string& wanted);
/// Refuses a table's keys that are not known: with near names, else all.
void check_keys(const Entry& table, const std::vector<std::string>& known);
/// A table's entry; null where there is none.
const Entry* find(const Entry& table, std::string_view key);

/// A text that is not empty.
const std::string& text_of(const Entry& entry);
/// An integer from low to high.
std::int64_t whole_of(const Entry& entry, std::int64_t low, std::int64_t high);
/// A finite number in `unit`: bare, or a text with a unit of that kind.
double quantity_of(const Entry& entry, const std::string& unit);
/// The same, above zero.
double positive_of(const Entry& entry, const std::string& unit);
/// positive_of a table's entry, where there is one.
std::optional<double> find_positive(const Entry& table, std::string_view key,
                                    const std::string& unit);
/// Whether a table's entry is true; it is not where there is none.
bool truth_of(const Entry& table, const char* key);
/// Whether a table's type is "integer" and not "continuous", as it is without one.
bool reads_integer(const Entry& table);
/// The numbers of a list that is not empty.
std::vector<double> quantities_of(const Entry& list, const std::string& unit);

/// "did you mean lower?", or without near names "use lower, upper"; `lead` stands before them.
std::string suggestion(std::string_view typed, const std::vector<std::string>& known,
                       const std::string& lead = "use");

/// Does what knows nothing of files; its errors get the entry's place and path.
template <class Action>
auto located(const Entry& entry, Action action) {
  try {
    return action();
  } catch (const std::invalid_argument& error) {
    refuse(entry, error.what());
  }
}

}  // namespace camlaw::problems
