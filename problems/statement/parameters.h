// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "problems/statement/statement.h"

/// Parameters as a problem names them: those of its mechanism and those of its laws.
namespace camlaw::problems {

/// Where a name is looked for.
enum class Owner { Either, Machine, Law };

/// A parameter that a problem names, with what it accepts. Of several laws that have it, what all
/// accept.
struct NamedParameter {
  std::string name;  ///< "blades", "alpha"; "law.v" where the machine understands v too
  bool of_law = false;
  std::size_t parameter = 0;           ///< of the mechanism
  std::string law_parameter = {};      ///< of the laws
  std::optional<std::size_t> element;  ///< of a list, from 0; none: the whole list
  std::string unit;
  double low = 0, high = 0;
  bool integer = false;
  bool list = false;
  bool structural = false;

  /// As reported: "alpha", of a list "c[2]".
  std::string element_name(std::size_t index) const;
};

/// A parameter of one law.
NamedParameter named(const Parameter& parameter);

/// Finds "stroke", "S_f", "alpha", "c", "c[2]", "law.v", "machine.v". Case counts: a machine may
/// have both v and V. Throws std::invalid_argument with near or known names, where both machine and
/// law have it, and where a list has no such element.
NamedParameter find_parameter(const ProblemStatement& problem, std::string_view name,
                              Owner owner = Owner::Either);

/// Where a law has a parameter of exactly that name; none: it has not.
std::optional<std::size_t> index_in(const Family& law, std::string_view parameter);

/// Which parameter of a law a variable is, the law's own or one that the machine's gives it; none:
/// the law has none such.
std::optional<std::size_t> law_place(const Family& law, const VariableStatement& variable);

/// The numbers that a parameter has: one, or a list's. Of several laws, those of the first that has
/// it.
std::vector<double> values_of(const ProblemStatement& problem, const NamedParameter& parameter);
/// Sets one number, in every law that has the parameter.
void put_value(ProblemStatement& problem, const NamedParameter& parameter, std::size_t index,
               double value);
/// Sets all numbers of a law's parameter, in every law that has it.
void put_values(ProblemStatement& problem, const NamedParameter& parameter,
                const std::vector<double>& values);

/// A size of the machine, in its listed unit. Throws std::invalid_argument with near and known
/// names.
double constant_of(const ProblemStatement& problem, std::string_view name);

/// Where among the problem's variables one number of a parameter is; none: it does not vary.
std::optional<std::size_t> find_variable(const ProblemStatement& problem,
                                         const NamedParameter& parameter, std::size_t index);

/// One number of a parameter as a variable, with the names, the unit and the place in the
/// statement.
VariableStatement new_variable(const NamedParameter& parameter, std::size_t index);

/// A value that rounding in a change of units has left beside an end of the range: that end.
double onto_range(double value, double low, double high);
/// Why a parameter cannot have a value, in words; empty where it can.
std::optional<std::string> refusal(const NamedParameter& parameter, double value);

/// Throws std::invalid_argument where a law cannot be made with the values it has, in any load
/// case or over a range.
void check_laws(const ProblemStatement& problem);
/// The same, at the end of a range that leaves a law least, where the range gives it something.
void check_laws_over(const ProblemStatement& problem, const ParameterRange& range);
/// The same, of one load case.
void check_laws_in(const ProblemStatement& problem, const LoadCase& load);
/// A law of the problem as the machine moves it in a load case.
Member law_in_case(Member law, const ProblemStatement& problem, const LoadCase& load);
/// Whether it would not.
bool are_possible(const std::vector<Member>& laws);
/// "cosine", or of several laws "cosine, polynomial-5".
std::string law_names(const ProblemStatement& problem);

/// "21.6 mm": a value of a variable in the unit that its tolerance is stated in; empty where that
/// is the variable's own.
std::string measure_of(const VariableStatement& variable, double value);
/// The same of a variable by its name, which may be none of the problem's.
std::string measure_of(const ProblemStatement& problem, std::string_view variable, double value);
/// " (4.7 to 5.3 mm)": its bounds in that unit, to stand behind them; empty likewise.
std::string measured_bounds(const VariableStatement& variable);

/// "40 mm", "17".
std::string with_unit(double value, const std::string& unit);
/// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& parts);
/// "40, 50 and 63 mm"; of many "400 values from 1 to 400 mm".
std::string values_text(const std::vector<double>& values, const std::string& unit);
/// "-10 .. 0", "10 .. 60 mm".
std::string range_text(double low, double high, const std::string& unit);

}  // namespace camlaw::problems
