// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "problems/statement/statement.h"
#include "problems/statement/toml_entry.h"

/// What `--set` changes that only the file can say: laws, limits and bounds of variables, what a
/// load case does not set, and the tables of variations, ranges and load cases. It is put among the
/// file's entries, so that it is read and checked as if the file stated it.
namespace camlaw::problems {

/// Whether an assignment to this name changes entries of the file, and not a value of the problem
/// as it was read: "law", "rise.law", "base_radius.upper" of a variable, a limit that is not there
/// yet, "fast.load" that no case sets, "free.knots" of a free law, "speed" of an electronic cam
/// whose program has times.
bool is_of_file(const ProblemStatement& problem, std::string_view name);

/// Whether a limit that the file states is on that response, by the name that the file has for it
/// or, in a load case, the name in that case.
bool is_on(const ConstraintStatement& limit, std::string_view response);

/// Whether a name is of laws: "law", "rise.law".
bool is_law_setting(std::string_view name);

/// Whether a name is of the table [free]: "free.knots"; not where a cam on a shaft is called free.
bool is_free_setting(const ProblemStatement& problem, std::string_view name);

/// Puts it there. `assignment`, "law=cycloidal", is where errors place what is put. Throws
/// std::invalid_argument where the file has no place for it.
void restate(Entry& file, const ProblemStatement& problem, std::string_view name,
             std::string_view text, const std::string& assignment);

/// The names of laws in a text such as "cycloidal, modified-sine"; a class of laws, such as
/// "ends R-R, continuity >= 2", is one.
std::vector<std::string> law_list(std::string_view text);

}  // namespace camlaw::problems
