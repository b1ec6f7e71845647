// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "machines/model/known_names.h"
#include "machines/model/over_ranges.h"
#include "machines/model/robust_number.h"
#include "problems/statement/cases.h"
#include "problems/statement/law_rooms.h"
#include "problems/statement/parameters.h"
#include "problems/statement/parts.h"
#include "problems/statement/ranges.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"
#include "problems/statement/validity.h"
#include "problems/statement/variation.h"

namespace camlaw::problems {
namespace {

using Kind = Entry::Kind;
using optim::Part, optim::Sense;

/// Refuses a parameter of the law, where it is asked for as a response.
void refuse_law_parameter(const std::string& name, const ProblemStatement& problem) {
  const std::string bare = name.substr(0, name.find('['));
  for (const Member& law : problem.laws) {
    if (!index_in(*law.family, bare)) continue;
    throw std::invalid_argument(fmt::format(
        "{} is a parameter of the law, which is not a response: it can vary between bounds, "
        "[variables.{}], but not be an objective or a constraint",
        name, bare));
  }
}

ResponseName read_response(const Entry& entry, const ProblemStatement& problem) {
  const std::string& name = text_of(entry);
  return located(entry, [&] {
    try {
      return find_response(*problem.mechanism, name);
    } catch (const std::invalid_argument&) {
      refuse_law_parameter(name, problem);
      throw;
    }
  });
}

/// The curve that a response is, or is a part of; empty for a number.
std::string curve_of(const ResponseName& name) {
  return name.response != nullptr && name.response->curve ? name.response->name : "";
}

/// Whether a response is the largest size of a curve.
bool is_size(const ResponseName& name) { return name.part == Part::Magnitude; }

bool is_peak(const ResponseName& name) {
  return name.part == Part::Highest || name.part == Part::Magnitude;
}

void check_part(const Entry& entry, const ResponseName& name, Sense sense) {
  const std::string curve = curve_of(name);
  if (!curve.empty() && name.part == Part::Value) {
    refuse(entry,
           fmt::format("{0} is a curve over the cycle; write \"peak {0}\" (the largest size), "
                       "\"highest {0}\" or \"lowest {0}\"",
                       curve));
  }
  if (is_peak(name) && sense == Sense::Maximize) {
    refuse(entry, "the highest value of a curve can be minimised, not maximised");
  }
  if (name.part == Part::Lowest && sense == Sense::Minimize) {
    refuse(entry, "the lowest value of a curve can be maximised, not minimised");
  }
}

/// Refuses a constant: no design has less or more of it.
void check_varies(const Entry& entry, const ResponseName& name, const ProblemStatement& problem) {
  if (name.response == nullptr) {
    const PartStatement* part = part_of(problem, name.parameter);
    if (part != nullptr && part->is_chosen()) return;
  }
  if (name.response != nullptr || problem.variables.empty()) return;
  for (const VariableStatement& variable : problem.variables) {
    if (!variable.of_law && variable.parameter == name.parameter) return;
  }
  refuse(entry, fmt::format("{0} is a constant here; let it vary, [variables.{0}]",
                            problem.mechanism->parameters[name.parameter].name));
}

/// The bounds of a constraint as its table gives them.
struct Limits {
  const Entry *lower, *upper, *equals;
};

Limits find_limits(const Entry& table) {
  const Limits limits{find(table, "lower"), find(table, "upper"), find(table, "equals")};
  if (limits.equals != nullptr && (limits.lower != nullptr || limits.upper != nullptr)) {
    refuse(*limits.equals, "equals is given with lower or upper; drop one of the two");
  }
  if (limits.equals == nullptr && limits.lower == nullptr && limits.upper == nullptr) {
    refuse(table, "there is no bound; give lower, upper or both, or equals");
  }
  return limits;
}

/// Refuses bounds that a curve or its part cannot be held to by limiting every angle.
void check_limits(const Limits& limits, const ResponseName& name) {
  const std::string curve = curve_of(name);
  if (curve.empty()) return;
  if (limits.equals != nullptr) {
    refuse(*limits.equals, fmt::format("{} cannot be held at one value; give lower or upper",
                                       name.part == Part::Value ? "a curve" : "a peak of a curve"));
  }
  if (limits.lower != nullptr && is_peak(name)) {
    refuse(*limits.lower, fmt::format("a peak can be limited from above only; to keep the whole "
                                      "curve above a value write response = \"{}\"",
                                      curve));
  }
  if (limits.upper != nullptr && name.part == Part::Lowest) {
    refuse(*limits.upper, fmt::format("a lowest value can be limited from below only; to keep the "
                                      "whole curve below a value write response = \"{}\"",
                                      curve));
  }
}

/// Refuses an upper bound that the largest size of a curve passes whatever the design.
void check_size_limit(const Limits& limits, const ConstraintStatement& constraint) {
  if (!is_size(constraint.response) || *constraint.upper > 0) return;
  refuse(*limits.upper,
         fmt::format("{} is the largest size of the curve {}, which is not below zero; give an "
                     "upper bound above zero instead of {}, or limit the curve itself",
                     constraint.response.name, curve_of(constraint.response),
                     with_unit(*constraint.upper, constraint.response.unit)));
}

std::optional<double> read_limit(const Entry* entry, const std::string& unit) {
  return entry == nullptr ? std::nullopt : std::optional(quantity_of(*entry, unit));
}

/// Refuses a bound on a pressure angle that no cam has: it was meant for something else.
void check_possible(const Entry* entry, const std::optional<double>& bound,
                    const ResponseName& name) {
  constexpr double most = 90;
  const bool is_angle = name.response != nullptr && is_pressure_angle(*name.response);
  if (entry == nullptr || !is_angle || std::abs(*bound) <= most) return;
  const double least = is_size(name) ? 0 : -most;
  refuse(*entry, fmt::format("{} is never outside {}; the bound is {}", name.name,
                             range_text(least, most, name.unit), with_unit(*bound, name.unit)));
}

/// Refuses bounds that cross, and for a curve bounds that leave one value.
void check_order(const Entry& table, const Limits& limits, const ConstraintStatement& constraint) {
  if (limits.lower == nullptr || limits.upper == nullptr) return;
  const std::string& unit = constraint.response.unit;
  Entry both = *limits.lower;
  both.path = table.path;
  if (*constraint.lower > *constraint.upper) {
    refuse(both, fmt::format("lower {} exceeds upper {}", with_unit(*constraint.lower, unit),
                             with_unit(*constraint.upper, unit)));
  }
  if (*constraint.lower == *constraint.upper && !curve_of(constraint.response).empty()) {
    refuse(both, "a curve cannot be held at one value; lower and upper are the same");
  }
}

/// The probability with which a limit must hold; none where the table does not say.
std::optional<double> read_reliability(const Entry& table, const ProblemStatement& problem) {
  const Entry* entry = find(table, "reliability");
  if (entry == nullptr) return {};
  const double share = quantity_of(*entry, "1");
  if (!(share >= 0.5 && share <= kLargestShare)) {
    refuse(*entry, fmt::format("{:.6g} is not between 0.5 and {:g}; a limit that holds for every "
                               "part has no reliability",
                               share, kLargestShare));
  }
  if (variations_of(problem).empty()) {
    refuse(*entry, "no variation is stated; give [variation.NAME]");
  }
  return share;
}

/// What is taken of an objective's values; null where the table does not say.
std::shared_ptr<const Robust> read_robust(const Entry& table, const ProblemStatement& problem) {
  const Entry* entry = find(table, "robust");
  if (entry == nullptr) return nullptr;
  const std::string& text = text_of(*entry);
  const Robust robust = located(*entry, [&] { return parse_robust(text); });
  if (variations_of(problem).empty()) {
    refuse(*entry, "no variation is stated; give [variation.NAME]");
  }
  return std::make_shared<const Robust>(robust);
}

ConstraintStatement read_constraint(const Entry& table, const ProblemStatement& problem) {
  expect(table, Kind::Table, "a table, [[constraints]]");
  check_keys(table, {"response", "over", "from", "to", "lower", "upper", "equals", "tolerance",
                     "cases", "reliability"});
  const Entry* response = find(table, "response");
  if (response == nullptr) refuse(table, "response is missing; name the response to be limited");
  ConstraintStatement constraint;
  constraint.response = read_response(*response, problem);
  read_window(table, problem, constraint.response);
  const std::string& unit = constraint.response.unit;
  const Limits limits = find_limits(table);
  check_limits(limits, constraint.response);
  constraint.lower = read_limit(limits.equals != nullptr ? limits.equals : limits.lower, unit);
  constraint.upper = read_limit(limits.equals != nullptr ? limits.equals : limits.upper, unit);
  check_order(table, limits, constraint);
  check_size_limit(limits, constraint);
  const Entry* const above = limits.equals != nullptr ? limits.equals : limits.upper;
  check_possible(limits.lower, constraint.lower, constraint.response);
  check_possible(above, constraint.upper, constraint.response);
  constraint.tolerance = find_positive(table, "tolerance", unit);
  constraint.reliability = read_reliability(table, problem);
  if (constraint.reliability && !changes_by_manufacture(problem, constraint.response)) {
    refuse(
        *find(table, "reliability"),
        fmt::format("no variation of a parameter of the machine changes {}; drop the reliability",
                    constraint.response.name));
  }
  if (limits.equals != nullptr && changes_over_ranges(problem, constraint.response)) {
    refuse(*limits.equals, fmt::format("{} changes over the ranges or variations of this file, and "
                                       "cannot be held at one value; give lower or upper",
                                       constraint.response.name));
  }
  return constraint;
}

/// Those of the responses that are sought or limited, which `as_named` the file has.
void add_validity_of(const ResponseName& name, const std::string& as_named,
                     ProblemStatement& problem) {
  if (name.response == nullptr) return;
  const auto limits = name.response->defined_while;
  for (const ValidityLimit& limit : limits) add_validity(limit, as_named, problem);
}

std::string as_named(const ObjectiveStatement& objective) {
  if (!objective.one_case.name.empty()) return objective.one_case.name;
  return objective.of_ranges ? objective.one_value.name : objective.response.name;
}

}  // namespace

namespace {

/// What is wanted, by a table with minimize or maximize.
ObjectiveStatement read_wanted(const Entry& table, const ProblemStatement& problem) {
  const Entry *least = find(table, "minimize"), *greatest = find(table, "maximize");
  if (least != nullptr && greatest != nullptr) {
    refuse(
        table,
        "minimize and maximize are both given; an objective has one of them; a front has several "
        "objectives, each a table headed [[objectives]]");
  }
  if (least == nullptr && greatest == nullptr) {
    refuse(table, "there is neither minimize nor maximize; give one of them");
  }
  const Entry& wanted = least != nullptr ? *least : *greatest;
  ObjectiveStatement objective;
  objective.sense = least != nullptr ? Sense::Minimize : Sense::Maximize;
  objective.response = read_response(wanted, problem);
  check_part(wanted, objective.response, objective.sense);
  check_varies(wanted, objective.response, problem);
  read_window(table, problem, objective.response);
  objective.tolerance = find_positive(table, "tolerance", objective.response.unit);
  objective.robust = read_robust(table, problem);
  if (objective.robust && objective.response.response == nullptr) {
    refuse(*find(table, "robust"), "it is of a response, not of a parameter itself");
  }
  if (objective.robust && !changes_by_manufacture(problem, objective.response)) {
    refuse(*find(table, "robust"),
           fmt::format("no variation of a parameter of the machine changes {}; drop it",
                       objective.response.name));
  }
  return read_over_cases(table, problem, std::move(objective));
}

ObjectiveStatement read_one_of_several(const Entry& table, const ProblemStatement& problem) {
  expect(table, Kind::Table, "a table, [[objectives]] with minimize or maximize");
  check_keys(table, {"minimize", "maximize", "over", "from", "to", "tolerance", "reference",
                     "cases", "robust"});
  ObjectiveStatement objective = read_wanted(table, problem);
  if (const Entry* reference = find(table, "reference")) {
    objective.reference = quantity_of(*reference, objective.response.unit);
  }
  for (const ObjectiveStatement& other : problem.objectives) {
    if (other.response.name != objective.response.name) continue;
    refuse(table, fmt::format("{} is an objective already", objective.response.name));
  }
  return objective;
}

/// Hypervolumes are measured from the references of all objectives, or from one that is chosen.
void check_references(const Entry& list, const ProblemStatement& problem) {
  const auto stated = std::count_if(problem.objectives.begin(), problem.objectives.end(),
                                    [](const auto& o) { return o.reference.has_value(); });
  if (stated == 0 || stated == static_cast<std::ptrdiff_t>(problem.objectives.size())) return;
  refuse(list, "reference is given for some objectives only; give it for all or for none");
}

}  // namespace

void read_objectives(const Entry& file, ProblemStatement& problem) {
  const Entry *one = find(file, "objective"), *several = find(file, "objectives");
  if (one != nullptr && several != nullptr) {
    refuse(*several, "there is an [objective] too; drop one of the two");
  }
  if (one != nullptr) {
    expect(*one, Kind::Table, "a table, [objective] with minimize or maximize");
    check_keys(*one,
               {"minimize", "maximize", "over", "from", "to", "tolerance", "cases", "robust"});
    problem.objectives = {read_wanted(*one, problem)};
  }
  if (several == nullptr) return;
  expect(*several, Kind::List, "a list of tables, each headed [[objectives]]");
  for (const Entry& table : several->items) {
    problem.objectives.push_back(read_one_of_several(table, problem));
  }
  if (problem.objectives.size() < 2) {
    refuse(*several, "a front needs two objectives or more; for a single one write [objective]");
  }
  check_references(*several, problem);
}

void read_constraints(const Entry& file, ProblemStatement& problem) {
  if (const Entry* constraints = find(file, "constraints")) {
    expect(*constraints, Kind::List, "a list of tables, each headed [[constraints]]");
    for (const Entry& table : constraints->items) {
      const ConstraintStatement limit = read_constraint(table, problem);
      for (ConstraintStatement& own : in_cases(problem, limit, read_case_names(table, problem))) {
        for (ConstraintStatement& side : over_ranges(problem, own)) {
          problem.constraints.push_back(std::move(side));
        }
      }
    }
  }
  limit_to_validity(problem);
  for (const ObjectiveStatement& objective : problem.objectives) {
    add_validity_of(objective.response, as_named(objective), problem);
  }
  const std::size_t stated = problem.constraints.size();
  for (std::size_t i = 0; i < stated; ++i) {
    const ResponseName name = problem.constraints[i].response;
    add_validity_of(name, name.name, problem);
  }
}

}  // namespace camlaw::problems
