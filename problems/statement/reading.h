// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "kinematics/program/program.h"
#include "problems/statement/parameters.h"
#include "problems/statement/statement.h"
#include "problems/statement/toml_entry.h"

/// The parts of reading a problem file, in the order in which they are done. Each takes the whole
/// file and adds its part to the problem; errors as those of read_problem.
namespace camlaw::problems {

/// Parameters that the file fixes, by NamedParameter::name; they may not vary as well.
using FixedNames = std::set<std::string>;

/// The folder of the problem file, from which paths in it count; empty: the one worked in.
std::string folder_of(const Entry& entry);
/// A text that does nothing to a terminal and is one line.
const std::string& printable_text(const Entry& entry);

/// Refuses a name that is not one of a formula's, or that problem files have for something else.
void check_spelling(const Entry& table, const std::string& name);

/// Refuses an entry with a value that the parameter does not accept.
void check_accepted(const Entry& entry, const NamedParameter& parameter, double value);

/// Where a file states a parameter of its mechanism; null where it does not.
struct StatedParameter {
  const Entry* fixed = nullptr;    ///< in [constants]
  const Entry* varying = nullptr;  ///< in [variables]
};
StatedParameter stated_parameter(const Entry& file, const MechanismParameter& parameter);

/// The problem of a file's entries, which were read from `toml`.
ProblemStatement read_entries(const Entry& file, std::string_view toml, const std::string& source,
                              HeldFiles known);
void read_title(const Entry& file, ProblemStatement& problem);
/// Its mechanism, with the responses that the file states.
void read_mechanism(const Entry& file, ProblemStatement& problem);
/// Adds the responses that a file states to its mechanism.
void read_stated_responses(const Entry& file, Mechanism& mechanism);
/// The cams of a file that states several on one shaft, [cams.NAME]; and what varies of them.
void read_cams(const Entry& file, ProblemStatement& problem, FixedNames& fixed);
/// All that a mechanism's file says of its motion, its sizes and what varies of both.
void read_motion(const Entry& file, ProblemStatement& problem, FixedNames& fixed);
void read_laws(const Entry& file, ProblemStatement& problem, FixedNames& fixed);
/// The programs of a file's table [program], one for each combination of its segments' laws. A free
/// law is what the file's table [free] says.
void read_program(const Entry& file, const Entry& program, ProblemStatement& problem);
/// The text of a table beside the problem, in UTF-8 whatever it was written in: a result carries
/// it.
const std::string& table_text(const Entry& name, HeldFiles& files);
/// How many natural periods the train has in a turn for which a program's lift is made, where it is
/// `polydyne`: a number, or those that the machine's train has at a stated speed.
std::optional<Polydyne> read_polydyne(const Entry& file, const Entry& program,
                                      const Mechanism& mechanism);
/// The motion of a program's `table`, and the stroke that it has.
void read_table(const Entry& file, const Entry& program, ProblemStatement& problem);
/// The tolerances of a program's points and ends: as variables, but for those that the file states.
void read_tolerances(const Entry& file, ProblemStatement& problem);
/// What [free] says: the law that the name "free" stands for, and its coefficients (and knots) as
/// variables, but for those that the file states. Refuses the table where no law is free.
bool is_free_name(std::string_view name);
/// Whether a segment's law is free, or may be.
bool is_free(const Entry& segment);
Member read_free_law(const Entry& file, HeldFiles& files);
/// The same with ends of its own, where a segment states them.
Member read_free_law(const Entry& file, const Entry& segment, HeldFiles& files);
void read_free_variables(const Entry& file, ProblemStatement& problem, const FixedNames& fixed);
void read_constants(const Entry& file, ProblemStatement& problem, FixedNames& fixed);
/// The parts that come from catalogues, [parts]; each has numbers that nothing else states.
void read_parts(const Entry& file, ProblemStatement& problem);
void read_variables(const Entry& file, ProblemStatement& problem, const FixedNames& fixed);
/// Load cases, and what differs in them among the mechanism's responses.
void read_cases(const Entry& file, ProblemStatement& problem);
/// Ranges of parameters, [ranges.speed].
void read_ranges(const Entry& file, ProblemStatement& problem);
/// What manufacture does, [variation.base_radius].
void read_variation(const Entry& file, ProblemStatement& problem);
/// The cases that a limit's table names; without the key all.
std::vector<std::string> read_case_names(const Entry& table, const ProblemStatement& problem);
/// What an objective's table takes of the cases: the worst, where it does not say.
ObjectiveStatement read_over_cases(const Entry& table, const ProblemStatement& problem,
                                   ObjectiveStatement objective);
/// That each law can be made with its fixed values and starts, and that no two are the same.
void check_laws_at_start(const Entry& file, const ProblemStatement& problem);
/// The part of the cycle that a table confines a response to, `over` or `from` and `to`; its name
/// then says so. Refuses them of a number.
void read_window(const Entry& table, const ProblemStatement& problem, ResponseName& response);
void read_objectives(const Entry& file, ProblemStatement& problem);
void read_constraints(const Entry& file, ProblemStatement& problem);
/// Its inputs of the mechanism's checks; where it requires these, they are limits.
void read_buildable(const Entry& file, ProblemStatement& problem);
/// How its profile is made other than it is meant, [profile].
void read_profile_errors(const Entry& file, ProblemStatement& problem);
void read_solver(const Entry& file, ProblemStatement& problem);

}  // namespace camlaw::problems
