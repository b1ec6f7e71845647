// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "problems/statement/parameters.h"
#include "problems/statement/statement.h"
#include "problems/statement/toml_entry.h"

/// The parts of reading a problem file, in the order in which they are done. Each takes the whole
/// file and adds its part to the problem; errors as those of read_problem.
namespace camlaw::problems {

/// Parameters that the file fixes, by NamedParameter::name; they may not vary as well.
using FixedNames = std::set<std::string>;

/// A text that does nothing to a terminal and is one line.
const std::string& printable_text(const Entry& entry);

/// Refuses an entry with a value that the parameter does not accept.
void check_accepted(const Entry& entry, const NamedParameter& parameter, double value);

void read_title(const Entry& file, ProblemStatement& problem);
/// Its mechanism, with the responses that the file states.
void read_mechanism(const Entry& file, ProblemStatement& problem);
void read_laws(const Entry& file, ProblemStatement& problem, FixedNames& fixed);
/// What [free] says: the law that the name "free" stands for, and its coefficients (and knots) as
/// variables, but for those that the file states. Refuses the table where no law is free.
bool is_free_name(std::string_view name);
Member read_free_law(const Entry& file, LawFiles& files);
void read_free_variables(const Entry& file, ProblemStatement& problem, const FixedNames& fixed);
void read_constants(const Entry& file, ProblemStatement& problem, FixedNames& fixed);
void read_variables(const Entry& file, ProblemStatement& problem, const FixedNames& fixed);
/// That each law can be made with its fixed values and starts, and that no two are the same.
void check_laws_at_start(const Entry& file, const ProblemStatement& problem);
void read_objectives(const Entry& file, ProblemStatement& problem);
void read_constraints(const Entry& file, ProblemStatement& problem);
/// Its inputs of the mechanism's checks; where it requires these, they are limits.
void read_buildable(const Entry& file, ProblemStatement& problem);
void read_solver(const Entry& file, ProblemStatement& problem);

}  // namespace camlaw::problems
