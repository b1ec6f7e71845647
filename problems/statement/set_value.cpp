// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "numerics/text/names.h"
#include "numerics/text/units.h"
#include "problems/statement/advancing_cycle.h"
#include "problems/statement/assignment.h"
#include "problems/statement/buildable.h"
#include "problems/statement/cases.h"
#include "problems/statement/choices.h"
#include "problems/statement/law_rooms.h"
#include "problems/statement/parameters.h"
#include "problems/statement/parts.h"
#include "problems/statement/reading.h"
#include "problems/statement/restated.h"
#include "problems/statement/table_settings.h"
#include "problems/statement/validity.h"
#include "problems/statement/variation.h"

namespace camlaw::problems {
namespace {

constexpr std::string_view kExample = "stroke=30 mm";

/// A number that the parameter accepts.
double accepted_number(std::string_view text, const NamedParameter& parameter,
                       const std::string& name) {
  const double value = onto_range(parse_quantity(text, parameter.unit, parameter.unit, name),
                                  parameter.low, parameter.high);
  if (const auto why = refusal(parameter, value)) {
    throw std::invalid_argument(fmt::format("{}: {}", name, *why));
  }
  return value;
}

/// Why a number of a part is not set by itself.
std::string came_with(const std::string& name, const PartStatement& part) {
  return fmt::format("{}: it comes with {}, from {}; set {}", name, part.name, part.catalogue,
                     part.name);
}

/// Sets one number: the start of what varies, or what is fixed.
void set_number(ProblemStatement& problem, const NamedParameter& parameter, std::size_t index,
                std::string_view text) {
  const std::string name = parameter.element_name(index);
  if (!parameter.of_law && problem.told_by_motion.contains(parameter.parameter)) {
    throw std::invalid_argument(
        fmt::format("{}: the motion is stated in {}; change it in the file", name, parameter.unit));
  }
  if (const PartStatement* part =
          parameter.of_law ? nullptr : part_of(problem, parameter.parameter)) {
    throw std::invalid_argument(came_with(name, *part));
  }
  double value = accepted_number(text, parameter, name);
  if (const auto i = find_variable(problem, parameter, index)) {
    VariableStatement& variable = problem.variables[*i];
    if (const auto why = why_not(variable, value)) {
      throw std::invalid_argument(fmt::format("{}: {}", name, *why));
    }
    value = variable.start = as_chosen(variable, value);
  }
  put_value(problem, parameter, index, value);
}

/// Sets a list. Its length is fixed where a number of it varies: each is a variable.
void set_list(ProblemStatement& problem, const NamedParameter& parameter, std::string_view text) {
  const auto parts = text.empty() ? std::vector<std::string_view>{} : parted(text, ',');
  std::vector<double> values = values_of(problem, parameter);
  bool varies = false;
  for (std::size_t i = 0; i < values.size(); ++i) {
    varies |= find_variable(problem, parameter, i).has_value();
  }
  if (varies && parts.size() != values.size()) {
    throw std::invalid_argument(fmt::format("{}: {} values are given; it varies, and has {}",
                                            parameter.name, parts.size(), values.size()));
  }
  put_values(problem, parameter, std::vector<double>(parts.size()));
  for (std::size_t i = 0; i < parts.size(); ++i) set_number(problem, parameter, i, parts[i]);
}

/// The case that "fast.speed" names; null where it names none.
const LoadCase* case_of(const ProblemStatement& problem, std::string_view name) {
  const std::size_t dot = name.find('.');
  return dot == std::string_view::npos ? nullptr : find_case(problem, name.substr(0, dot));
}

/// "fast.speed=380 rpm".
void set_parameter_in_case(ProblemStatement& problem, const LoadCase& load, std::string_view name,
                           std::string_view text) {
  const std::string_view own = name.substr(load.name.size() + 1);
  LoadCase changed = load;
  if (own == "weight") {
    changed.weight = parse_quantity(text, "1", "1", std::string(name));
    if (!(changed.weight > 0)) {
      throw std::invalid_argument(
          fmt::format("{} is {:g}; it must be above 0", name, changed.weight));
    }
  } else {
    const NamedParameter parameter = find_parameter(problem, own, Owner::Machine);
    const auto set = std::find_if(changed.parameters.begin(), changed.parameters.end(),
                                  [&](const auto& s) { return s.first == parameter.parameter; });
    if (set == changed.parameters.end()) {
      throw std::invalid_argument(
          fmt::format("{}: the cases of this file do not set {}", name, parameter.name));
    }
    set->second = accepted_number(text, parameter, std::string(name));
  }
  const auto index = &load - problem.cases.data();
  problem.cases[static_cast<std::size_t>(index)] = std::move(changed);
  renew(problem);
}

/// Refuses a value for what load cases or a range set: it would change nothing.
void check_has_one_value(const ProblemStatement& problem, const NamedParameter& parameter) {
  if (parameter.of_law) return;
  for (const LoadCase& load : problem.cases) {
    for (const auto& [set, value] : load.parameters) {
      if (set != parameter.parameter) continue;
      throw std::invalid_argument(
          fmt::format("{0}: each load case has its own; set {1}.{0}", parameter.name, load.name));
    }
  }
  for (const ParameterRange& range : problem.ranges) {
    if (range.parameter != parameter.parameter) continue;
    throw std::invalid_argument(
        fmt::format("{0} has a range; set {0}.lower or {0}.upper", parameter.name));
  }
}

struct Bound {
  std::string_view response;
  bool is_upper;
};

/// What "pressure_angle.upper" names.
std::optional<Bound> bound_named(std::string_view name) {
  for (const auto& [word, is_upper] : {std::pair{".lower", false}, std::pair{".upper", true}}) {
    if (name.ends_with(word)) {
      return Bound{name.substr(0, name.size() - std::string_view(word).size()), is_upper};
    }
  }
  return {};
}

/// "speed.upper=300 rpm", of a range: whether the name is of one.
bool set_range(ProblemStatement& problem, const Bound& bound, std::string_view name,
               std::string_view text) {
  for (ParameterRange& range : problem.ranges) {
    const MechanismParameter& p = problem.mechanism->parameters[range.parameter];
    if (bound.response != p.name && bound.response != p.symbol) continue;
    const NamedParameter parameter = find_parameter(problem, p.name, Owner::Machine);
    ParameterRange changed = range;
    (bound.is_upper ? changed.upper : changed.lower) =
        accepted_number(text, parameter, std::string(name));
    if (!(changed.lower < changed.upper)) {
      throw std::invalid_argument(fmt::format("{}: lower {} would not be below upper {}", name,
                                              with_unit(changed.lower, p.unit),
                                              with_unit(changed.upper, p.unit)));
    }
    range = changed;
    renew(problem);
    return true;
  }
  return false;
}

/// The name of the machine's parameter of this name or symbol.
std::optional<std::string> machine_parameter(const ProblemStatement& problem,
                                             std::string_view name) {
  for (const MechanismParameter& p : problem.mechanism->parameters) {
    if (p.name == name || p.symbol == name) return p.name;
  }
  return {};
}

/// "pressure_angle.upper=25 deg": another bound of a limit that there is.
void set_bound(ProblemStatement& problem, const Bound& bound, std::string_view name,
               std::string_view text) {
  std::vector<std::string> known;
  bool is_set = false;
  for (ConstraintStatement& limit : problem.constraints) {
    const bool mirrored = limit.is_size && limit.lower;  // the same bound as on the upper side
    std::optional<double>& own = bound.is_upper && !mirrored ? limit.upper : limit.lower;
    if (!own || (mirrored && !bound.is_upper)) continue;
    known.push_back(limit.response.name + (bound.is_upper ? ".upper" : ".lower"));
    if (!is_on(limit, bound.response)) continue;
    if (limit.lower == limit.upper) {
      throw std::invalid_argument(
          fmt::format("{}: the file holds it at one value; change it in the file", name));
    }
    const std::string& unit = limit.response.unit;
    const double value = parse_quantity(text, unit, unit, std::string(name));
    const bool is_size = limit.is_size || limit.response.part == optim::Part::Magnitude;
    if (is_size && !(value > 0)) {
      throw std::invalid_argument(
          fmt::format("{}: it is the largest size of a curve, whose bound is above 0", name));
    }
    own = mirrored ? -value : value;
    if (limit.lower && limit.upper && *limit.lower >= *limit.upper) {
      throw std::invalid_argument(fmt::format("{}: lower {} would not be below upper {}", name,
                                              with_unit(*limit.lower, unit),
                                              with_unit(*limit.upper, unit)));
    }
    is_set = true;
  }
  if (is_set) return;
  if (const auto parameter = machine_parameter(problem, bound.response)) {
    throw std::invalid_argument(fmt::format(
        "{}: {} has no range and no such limit; write ranges.{}.lower and ranges.{}.upper for a "
        "range",
        name, *parameter, *parameter, *parameter));
  }
  if (known.empty()) {
    throw std::invalid_argument(fmt::format("{}: the file has no limit with a bound {}", name,
                                            bound.is_upper ? "above" : "below"));
  }
  refuse_name("the file has no limit on", name, known);
}

/// "blades=21", without a look at whether the laws are possible.
void assign(ProblemStatement& problem, std::string_view assignment) {
  const auto [name, text] = parse_assignment(assignment, kExample);
  if (const BuildableInput* input = find_input(*problem.mechanism, name)) {
    const std::string& stated = input->name;
    if (const PartStatement* part = part_with_input(problem, stated)) {
      throw std::invalid_argument(came_with(stated, *part));
    }
    problem.buildable.inputs[stated] =
        accepted_input(*input, parse_quantity(text, input->unit, input->unit, stated));
    return;
  }
  if (const LoadCase* load = case_of(problem, name)) {
    const auto bound = bound_named(name);
    if (!bound) return set_parameter_in_case(problem, *load, name, text);
  }
  if (const auto bound = bound_named(name)) {
    if (!set_range(problem, *bound, name, text)) set_bound(problem, *bound, name, text);
    return;
  }
  if (const PartStatement* part = find_part(problem, name)) {
    start_with(problem, part->name, item_named(*part, text));
    return;
  }
  if (const std::string_view varied = varied_name(name); !varied.empty()) {
    throw std::invalid_argument(
        fmt::format("{}: write variation.{}, for what manufacture does to {}", name, name, varied));
  }
  const NamedParameter parameter = find_parameter(problem, name);
  check_has_one_value(problem, parameter);
  if (parameter.list && !parameter.element) {
    set_list(problem, parameter, text);
  } else {
    set_number(problem, parameter, parameter.element.value_or(0), text);
  }
}

/// Whether a law's parameter is a list of a free law, whose elements mean others with other knots.
bool is_of_free_list(std::string_view parameter) {
  return parameter.ends_with("coefficients") || parameter.ends_with("knots");
}

/// Begins at the design of another statement of the same file, as far as it has what varies; where
/// that has chosen among the laws of the file, at its law. Coefficients of a free law mean others
/// where its table was changed.
void begin_at(ProblemStatement& problem, const ProblemStatement& design,
              const ProblemStatement& plain, bool is_free_changed) {
  for (const PartStatement& part : design.parts) {
    const PartStatement* own = find_part(problem, part.name);
    if (own == nullptr || part.is_chosen() || !own->is_chosen()) continue;
    keep_item(problem, part.name, item_named(*own, part.items.front().name));
  }
  const bool is_chosen = plain.chooses_law() && !design.chooses_law() && problem.chooses_law();
  const auto same = std::find_if(problem.laws.begin(), problem.laws.end(), [&](const Member& law) {
    return is_chosen && law.family->name == design.laws.front().family->name;
  });
  if (same != problem.laws.end()) problem.laws = std::vector<Member>{*same};
  for (VariableStatement& variable : problem.variables) {
    for (const VariableStatement& other : design.variables) {
      if (other.name != variable.name || why_not(variable, other.start)) continue;
      if (is_free_changed && is_of_free_list(variable.law_parameter)) continue;
      const NamedParameter parameter =
          find_parameter(problem, variable.of_law ? variable.law_parameter : variable.name,
                         variable.of_law ? Owner::Law : Owner::Machine);
      variable.start = other.start;
      put_value(problem, parameter, variable.element, variable.start);
    }
  }
}

/// Puts into the file what only it can say; the rest is left.
std::vector<std::string> put_in_file(Entry& file, const ProblemStatement& known,
                                     std::span<const std::string> assignments) {
  std::vector<std::string> left;
  for (const std::string& assignment : assignments) {
    const auto [name, text] = parse_assignment(assignment, kExample);
    if (is_of_file(known, name)) {
      restate(file, known, name, text, assignment);
    } else {
      left.push_back(assignment);
    }
  }
  return left;
}

/// Reads the problem anew with what only its file can say, of what was set before and now, and sets
/// the rest of both.
void read_anew(ProblemStatement& problem, std::span<const std::string> assignments) {
  Entry file = parse_toml(problem.text, problem.source);
  const ProblemStatement plain = read_entries(file, problem.text, problem.source, problem.files);
  const bool is_free_changed =
      std::any_of(assignments.begin(), assignments.end(), [&](const std::string& one) {
        return is_free_setting(plain, parse_assignment(one, kExample).name);
      });
  if (is_free_changed) {
    std::erase_if(problem.settings, [](const std::string& one) {
      const std::string_view name = parse_assignment(one, kExample).name;
      return name.find('.') == name.npos && is_of_free_list(name.substr(0, name.find('[')));
    });
  }
  std::vector<std::string> before = problem.settings, now(assignments.begin(), assignments.end());
  std::optional<ProblemStatement> read;
  // What is put there may be what others are of, such as a limit in a load case that is added.
  for (std::size_t left = before.size() + now.size() + 1; before.size() + now.size() < left;) {
    left = before.size() + now.size();
    const ProblemStatement& known = read ? *read : plain;
    before = put_in_file(file, known, before);
    now = put_in_file(file, known, now);
    if (!read || before.size() + now.size() < left) {
      read = read_entries(file, problem.text, problem.source, problem.files);
    }
  }
  ProblemStatement fresh = *std::move(read);
  fresh.stop = problem.stop;
  for (const std::string& assignment : before) assign(fresh, assignment);
  begin_at(fresh, problem, plain, is_free_changed);
  for (const std::string& assignment : now) assign(fresh, assignment);
  fresh.settings = std::move(problem.settings);
  problem = std::move(fresh);
}

}  // namespace

void set_values(ProblemStatement& problem, std::span<const std::string> assignments) {
  ProblemStatement changed = problem;  // which stays as it is where a value is refused
  const bool is_restated =
      std::any_of(assignments.begin(), assignments.end(), [&](const std::string& one) {
        return is_of_file(problem, parse_assignment(one, kExample).name);
      });
  if (is_restated) {
    read_anew(changed, assignments);
  } else {
    for (const std::string& assignment : assignments) assign(changed, assignment);
  }
  const auto& varied = variations_of(changed);
  const bool has_fit =
      std::any_of(varied.begin(), varied.end(), [](const auto& v) { return v.fit.has_value(); });
  if (has_fit) renew(changed);  // its offsets are those of the size
  check_laws(changed);          // values that are possible together only come together
  check_advancing_cycle(changed);
  limit_to_validity(changed);
  limit_to_checks(changed);
  limit_to_laws(changed);
  changed.settings.insert(changed.settings.end(), assignments.begin(), assignments.end());
  problem = std::move(changed);
}

void set_value(ProblemStatement& problem, const std::string& assignment) {
  set_values(problem, {&assignment, 1});
}

}  // namespace camlaw::problems
