// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "problems/statement/statement.h"
#include "problems/statement/toml_entry.h"

/// What `--set` says of the tables [variation.NAME], [ranges.NAME] and [[cases]], whether the file
/// has them or not.
namespace camlaw::problems {

/// Whether a name is of one of them: "variation.base_radius.plus", "ranges.speed.lower",
/// "cases.fast.speed"; not where a cam or a load case has the table's name.
bool is_table_setting(const ProblemStatement& problem, std::string_view name);

/// Puts such a value among the file's entries, where it is read and checked as if the file stated
/// it. Throws std::invalid_argument for a name that lacks a part.
void put_in_table(Entry& file, const ProblemStatement& problem, std::string_view name,
                  std::string_view text, const std::string& place);

/// The same of a parameter, or the weight, of a load case, which is made where there is none of
/// that name.
void put_in_case(Entry& file, const ProblemStatement& problem, std::string_view load_case,
                 std::string_view key, std::string_view text, const std::string& place);

/// "base_radius" of "base_radius.plus", which lacks the table's name; empty for other names.
std::string_view varied_name(std::string_view name);

}  // namespace camlaw::problems
