// SPDX-License-Identifier: MIT
#include "problems/statement/buildable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "machines/model/known_names.h"
#include "problems/statement/added_part.h"
#include "problems/statement/bind.h"
#include "problems/statement/law_rooms.h"
#include "problems/statement/parameters.h"
#include "problems/statement/parts.h"
#include "problems/statement/ranges.h"
#include "problems/statement/variation.h"

namespace camlaw::problems {
namespace {

using optim::Part;

const std::vector<MechanismParameter>& parameters_of(const ProblemStatement& problem) {
  return problem.mechanism->parameters;
}

/// A parameter of the machine by its name; how many there are where it has none.
std::size_t parameter_named(const ProblemStatement& problem, std::string_view name) {
  const auto& all = parameters_of(problem);
  return static_cast<std::size_t>(
      std::find_if(all.begin(), all.end(), [&](const auto& p) { return p.name == name; }) -
      all.begin());
}

/// What the problem states by that name for a check, of the machine with these constants or for its
/// checks.
std::optional<double> stated_number(const BuildableCheck& check, const ProblemStatement& problem,
                                    const std::vector<double>& constants, std::string_view name) {
  const auto input = problem.buildable.inputs.find(name);
  if (input != problem.buildable.inputs.end()) return input->second;
  const std::size_t i = parameter_named(problem, name);
  for (const auto& [parameter, value] : check.in_case) {
    if (parameter == i) return value;
  }
  return problem.stated.contains(i) ? std::optional(constants[i]) : std::nullopt;
}

/// All of these; while the three are there.
StatedNumber stated_numbers(const BuildableCheck& check, const ProblemStatement& problem,
                            const std::vector<double>& constants) {
  return [&](std::string_view name) { return stated_number(check, problem, constants, name); };
}

double bound_with(const BuildableCheck& check, const ProblemStatement& problem,
                  const std::vector<double>& constants) {
  return check.bound(stated_numbers(check, problem, constants));
}

double bound_of(const BuildableCheck& check, const ProblemStatement& problem) {
  return bound_with(check, problem, problem.constants);
}

/// Whether a check's bound is another at one end of a parameter's range than at the other.
bool bound_moves(const BuildableCheck& check, const ProblemStatement& problem,
                 const ParameterRange& range) {
  std::vector<double> low = problem.constants, high = problem.constants;
  low[range.parameter] = range.lower;
  high[range.parameter] = range.upper;
  return bound_with(check, problem, low) != bound_with(check, problem, high);
}

/// Whether a name is of that response, over ranges or not.
bool is_of(const ResponseName& name, const MechanismResponse& response) {
  return name.response != nullptr && name.response->name == response.name;
}

/// What is sought and limited by the problem itself, not by its checks.
bool asks_for(const ProblemStatement& problem, const MechanismResponse* response) {
  const auto& wanted = problem.objectives;
  const auto& limits = problem.constraints;
  return std::any_of(wanted.begin(), wanted.end(),
                     [&](const auto& o) { return is_of(o.response, *response); }) ||
         std::any_of(limits.begin(), limits.end(), [&](const auto& c) {
           return (!c.of_check || c.required_by) && is_of(c.response, *response);
         });
}

/// On a shaft the cam that a check is of.
std::optional<std::size_t> cam_of(const ProblemStatement& problem, const BuildableCheck& check) {
  if (problem.cams.empty()) return {};
  return find_response(*problem.mechanism, check.response).response->cam;
}

/// Whether the roller runs in a groove, so that the cam has an outer flank: only the problem knows,
/// which then asks for what grooves alone have.
Closure closure_of(const ProblemStatement& problem, std::optional<std::size_t> cam) {
  for (const BuildableCheck& check : problem.mechanism->checks) {
    if (check.closure != Closure::Form || cam_of(problem, check) != cam) continue;
    if (asks_for(problem, find_response(*problem.mechanism, check.response).response)) {
      return Closure::Form;
    }
  }
  return Closure::Force;
}

/// Whether a parameter is above 0, and whether it is 0, at some of the values that it takes within
/// a design: over a range or a variation both may be.
struct Presence {
  bool above_zero, zero;
  bool is_mixed() const { return above_zero && zero; }
};

Presence presence(const BuildableCheck& check, const ProblemStatement& problem,
                  const std::string& parameter) {
  const double value = stated_number(check, problem, problem.constants, parameter).value_or(0);
  double lower = value, upper = value;
  const std::size_t index = parameter_named(problem, parameter);
  const bool is_set = std::any_of(check.in_case.begin(), check.in_case.end(),
                                  [&](const auto& set) { return set.first == index; });
  for (const TakenRange& range : taken_ranges(problem)) {
    if (is_set || range.parameter != index) continue;
    lower = range.lower + (range.is_offset ? value : 0);
    upper = range.upper + (range.is_offset ? value : 0);
  }
  return {upper > 0, !(lower > 0)};
}

/// Whether the machine has what a check is made with, and not what it is made without.
bool is_made_with(const BuildableCheck& check, const ProblemStatement& problem) {
  const auto at = [&](const std::string& parameter) { return presence(check, problem, parameter); };
  if (!check.only_with.empty() && !at(check.only_with).above_zero) return false;
  return check.only_without.empty() || at(check.only_without).zero;
}

/// Why a check cannot be made over all values that a parameter takes; empty where it can be.
std::string mixed(const BuildableCheck& check, const ProblemStatement& problem) {
  const std::string& parameter = check.only_with;
  if (parameter.empty() || !presence(check, problem, parameter).is_mixed()) return "";
  return fmt::format(
      "the values that {} takes begin at 0, where the check without it is made; let them begin "
      "above 0",
      parameter);
}

/// "mass is not stated", "neither speed nor mass is stated", "none of speed, mass and spring_rate
/// is stated".
std::string not_stated(const std::vector<std::string>& names) {
  if (names.size() == 1) return names[0] + " is not stated";
  if (names.size() == 2) return fmt::format("neither {} nor {} is stated", names[0], names[1]);
  return fmt::format("none of {} is stated", listed(names));
}

/// What a check needs and the problem does not state; empty where nothing is missing.
std::string missing(const BuildableCheck& check, const ProblemStatement& problem) {
  const StatedNumber stated = stated_numbers(check, problem, problem.constants);
  const auto is_stated = [&](const auto& name) { return stated(name).has_value(); };
  std::vector<std::string> names, parts;
  for (const std::string& name : check.needs) {
    if (!is_stated(name)) names.push_back(name);
  }
  const auto& some = check.one_of;
  const bool has_none = !some.empty() && std::none_of(some.begin(), some.end(), is_stated);
  if (has_none && some.size() == 1) names.push_back(some.front());
  if (!names.empty()) parts.push_back(not_stated(names));
  if (has_none && some.size() > 1) parts.push_back(not_stated(some));
  if (!parts.empty()) return listed(parts);
  if (std::string why = mixed(check, problem); !why.empty()) return why;
  for (const ParameterRange& range : problem.ranges) {
    if (bound_moves(check, problem, range)) {
      return fmt::format("its bound changes over the range of {}",
                         problem.mechanism->parameters[range.parameter].name);
    }
  }
  for (const VariationStatement& v : variations_of(problem)) {
    if (v.parameter.of_law) continue;
    const double meant = meant_value(problem, v);
    const optim::Variation off = v.at(meant);
    const ParameterRange made{v.parameter.parameter, meant + off.lower, meant + off.upper};
    if (bound_moves(check, problem, made)) {
      return fmt::format("its bound changes with the variation of {}", v.name());
    }
  }
  return "";
}

ConstraintStatement limit_of(const BuildableCheck& check, const ProblemStatement& problem) {
  ConstraintStatement limit;
  limit.response = find_response(*problem.mechanism, check.response);
  (check.is_upper ? limit.upper : limit.lower) = bound_of(check, problem);
  limit.of_check = true;
  return over_ranges(problem, limit).front();  // it has one side
}

/// Whether the bound is counted from a keyway that the problem states for the same cam.
bool is_beyond_keyway(const BuildableCheck& check, const ProblemStatement& problem) {
  constexpr std::string_view kWall = "wall";
  if (!check.input.ends_with(kWall)) return false;
  const std::string of_cam = check.input.substr(0, check.input.size() - kWall.size());
  return problem.buildable.inputs.contains(of_cam + "keyway_depth");
}

/// The part that states what a check needs; null where none does.
const PartStatement* part_behind(const BuildableCheck& check, const ProblemStatement& problem) {
  for (const std::string& name : check.needs) {
    if (const PartStatement* part = part_with_input(problem, name)) return part;
  }
  return part_with_input(problem, check.input);
}

/// Which material a permissible pressure is of, and who says so.
std::string material_of(const BuildableCheck& check, const ProblemStatement& problem) {
  const PartStatement* part = part_behind(check, problem);
  if (part == nullptr) return problem.buildable.material;
  const PartItem& item = part->items[part->start];
  return fmt::format("{}, {}", item.name, item.source.empty() ? part->catalogue : item.source);
}

std::string note_of(const BuildableCheck& check, const ProblemStatement& problem) {
  const auto& needs = check.needs;
  const bool pressed = std::any_of(needs.begin(), needs.end(), is_allowable_pressure);
  if (pressed) return material_of(check, problem);
  const bool is_own = problem.buildable.inputs.contains(check.input);
  if (!is_beyond_keyway(check, problem)) return is_own ? "" : check.standard;
  return (is_own ? "wall" : check.standard) + " beyond keyway_depth";
}

/// Whether intervals prove it, where it is a number.
void judge(BuildableAnswer& answer) {
  const optim::LimitReport& report = answer.report;
  if (std::isnan(report.margin)) {
    answer.built = Built::Fails;  // there is no such profile, or no such contact
  } else if (!report.met) {
    answer.built = Built::Fails;
  } else if (report.proved) {
    answer.built = Built::Holds;
  } else {
    answer.why = "it holds wherever it was evaluated, which is not a proof";
  }
}

/// Whether a check is made with the same machine as another: not with a rigid train where the other
/// has an elastic one.
bool goes_with(const BuildableCheck& first, const BuildableCheck& check) {
  return (first.only_with.empty() || first.only_with == check.only_with) &&
         (first.only_without.empty() || first.only_without == check.only_without);
}

/// What was judged and waits for a check that does not hold says nothing.
void await(std::vector<BuildableAnswer>& answers) {
  for (BuildableAnswer& answer : answers) {
    if (!answer.limit.of_check) continue;
    for (const BuildableAnswer& first : answers) {
      const auto& after = answer.check->after;
      const bool waits = std::find(after.begin(), after.end(), first.check->name) != after.end() &&
                         goes_with(*first.check, *answer.check);
      if (!waits || first.built == Built::Holds) continue;
      answer.built = Built::NotChecked;
      answer.why = fmt::format("{} {}", first.check->name,
                               first.built == Built::Fails ? "fails" : "is not checked");
    }
  }
}

/// How the design stands to the limits of these answers that have none missing.
std::vector<optim::LimitReport> reports_of(const ProblemStatement& design,
                                           const std::vector<BuildableAnswer>& answers) {
  ProblemStatement asked = design;
  asked.constraints.clear();
  for (const BuildableAnswer& answer : answers) {
    if (answer.why.empty()) asked.constraints.push_back(answer.limit);
  }
  return standing(asked);
}

/// Whether a limit keeps a response as a check wants it.
bool is_as_tight(const ConstraintStatement& c, const ConstraintStatement& wanted) {
  if (c.response.response == nullptr || !is_of(c.response, *wanted.response.response)) return false;
  if (c.of_range.operator bool() != wanted.of_range.operator bool()) return false;
  if (c.response.window || c.tolerance) return false;
  if (c.reliability) return false;  // some parts may break it
  const Part part = c.response.part;
  if (wanted.upper) return c.upper && *c.upper <= *wanted.upper && part != Part::Lowest;
  return c.lower && *c.lower >= *wanted.lower && (part == Part::Value || part == Part::Lowest);
}

/// Whether the file does not state a limit itself, and that of a check says more.
bool is_covered(const ConstraintStatement& c, const ConstraintStatement& limit) {
  const bool has_one_side = c.upper.has_value() != c.lower.has_value();
  return c.required_by && has_one_side && c.response.response != nullptr && is_as_tight(limit, c);
}

/// Adds the limit of a check, or puts it in place of a looser one that only a response requires.
void add_limit(ConstraintStatement limit, ProblemStatement& problem) {
  auto& all = problem.constraints;
  const bool kept =
      std::any_of(all.begin(), all.end(), [&](const auto& c) { return is_as_tight(c, limit); });
  if (kept) return;
  const auto looser =
      std::find_if(all.begin(), all.end(), [&](const auto& c) { return is_covered(c, limit); });
  if (looser == all.end()) {
    all.push_back(std::move(limit));
  } else {
    limit.required_by = looser->required_by;
    *looser = std::move(limit);
  }
}

/// Refuses a bound that would be another at another design: limits have numbers.
void check_stays(const BuildableCheck& check, const ProblemStatement& problem) {
  for (const PartStatement& part : problem.parts) {
    std::vector<double> constants = problem.constants;
    for (std::size_t item = 0; item < part.items.size(); ++item) {
      put_item(part, item, constants);
      if (bound_of(check, problem) == bound_with(check, problem, constants)) continue;
      throw std::invalid_argument(
          fmt::format("{} is chosen, and with it the bound of {}, {}; state {}", part.name,
                      check.name, check.standard, check.input));
    }
  }
  for (const VariableStatement& v : problem.variables) {
    if (v.of_law || v.lower == v.upper) continue;
    if (!bound_moves(check, problem, {v.parameter, v.lower, v.upper})) continue;
    throw std::invalid_argument(fmt::format("{} varies, and with it the bound of {}, {}; state {}",
                                            v.name, check.name, check.standard, check.input));
  }
}

/// Refuses to require checks of which one is made where a parameter is 0 and another where it is
/// above 0, where the search may choose either: the limits are those of one of them.
void check_model_stays(const ProblemStatement& problem) {
  const auto refuse = [](const std::string& what, const std::string& parameter) {
    throw std::invalid_argument(
        fmt::format("require = true, and {} {}: at 0 other checks are made than above it; keep it "
                    "at 0, or above 0",
                    parameter, what));
  };
  for (const BuildableCheck& check : problem.mechanism->checks) {
    if (check.only_with.empty()) continue;
    const std::string& name = check.only_with;
    const std::size_t index = parameter_named(problem, name);
    if (!mixed(check, problem).empty()) refuse("takes values from 0 on", name);
    const bool is_set = std::any_of(check.in_case.begin(), check.in_case.end(),
                                    [&](const auto& set) { return set.first == index; });
    for (const VariableStatement& v : problem.variables) {
      const bool is_it = !v.of_law && v.parameter == index && !is_set;
      if (is_it && v.lower <= 0 && v.upper > 0) refuse("varies from 0 on", name);
    }
    for (const PartStatement& part : problem.parts) {
      const auto& own = part.parameters;
      const auto column = std::find(own.begin(), own.end(), index);
      if (column == own.end()) continue;
      const auto has = [&](const PartItem& item) {
        return item.values[static_cast<std::size_t>(column - own.begin())] > 0;
      };
      const auto with = std::count_if(part.items.begin(), part.items.end(), has);
      const bool all = with == static_cast<std::ptrdiff_t>(part.items.size());
      if (with > 0 && !all) refuse(fmt::format("is 0 in some rows of {}", part.name), name);
    }
  }
}

}  // namespace

std::vector<const BuildableCheck*> checks_for(const ProblemStatement& problem) {
  std::vector<const BuildableCheck*> result;
  for (const BuildableCheck& check : problem.mechanism->checks) {
    const bool is_for = check.closure == Closure::Any ||
                        check.closure == closure_of(problem, cam_of(problem, check));
    const StatedNumber stated = stated_numbers(check, problem, problem.constants);
    if (is_for && is_made_with(check, problem) && has_part_of(*problem.mechanism, check, stated)) {
      result.push_back(&check);
    }
  }
  return result;
}

bool runs_in_groove(const ProblemStatement& problem) {
  return closure_of(problem, {}) == Closure::Form;
}

int Buildability::count(Built built) const {
  return static_cast<int>(
      std::count_if(checks.begin(), checks.end(), [&](const auto& a) { return a.built == built; }));
}

Buildability buildability(const ProblemStatement& design) {
  Buildability result{{}, design.buildable.require};
  if (design.laws.empty()) return result;
  for (const BuildableCheck* check : checks_for(design)) {
    BuildableAnswer answer{check, Built::NotChecked, missing(*check, design)};
    if (answer.why.empty()) answer.limit = limit_of(*check, design);
    if (answer.why.empty()) answer.note = note_of(*check, design);
    result.checks.push_back(std::move(answer));
  }
  const std::vector<optim::LimitReport> reports = reports_of(design, result.checks);
  std::size_t next = 0;
  for (BuildableAnswer& answer : result.checks) {
    if (!answer.why.empty()) continue;
    answer.report = reports[next++];
    answer.report.name = answer.limit.response.name;
    judge(answer);
  }
  await(result.checks);
  return result;
}

const BuildableInput* find_input(const Mechanism& mechanism, std::string_view name) {
  const auto& all = mechanism.inputs;
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& input) { return input.name == name; });
  return found == all.end() ? nullptr : &*found;
}

double accepted_input(const BuildableInput& input, double value) {
  if (value > 0) return value;
  throw std::invalid_argument(
      fmt::format("{} is {}; it must be above 0", input.name, with_unit(value, input.unit)));
}

void follow_parts(ProblemStatement& problem) {
  if (problem.constraints.empty()) return;
  for (const BuildableCheck* check : checks_for(problem)) {
    if (part_behind(*check, problem) == nullptr || !missing(*check, problem).empty()) continue;
    const ConstraintStatement wanted = limit_of(*check, problem);
    for (ConstraintStatement& c : problem.constraints) {
      if (!c.of_check || c.response.name != wanted.response.name) continue;
      if (wanted.upper && c.upper) c.upper = wanted.upper;
      if (wanted.lower && c.lower) c.lower = wanted.lower;
    }
  }
}

void limit_to_checks(ProblemStatement& problem) {
  std::erase_if(problem.constraints,
                [](const ConstraintStatement& c) { return c.of_check && !c.required_by; });
  if (!problem.buildable.require) return;
  check_model_stays(problem);
  for (const BuildableCheck* check : checks_for(problem)) {
    if (!missing(*check, problem).empty()) continue;
    check_stays(*check, problem);
    const ConstraintStatement limit = limit_of(*check, problem);
    if (part_behind(*check, problem) != nullptr) {
      problem.constraints.push_back(limit);  // whose bound may change
    } else {
      add_limit(limit, problem);
    }
    for (const ValidityLimit& valid : limit.response.response->defined_while) {
      ConstraintStatement more = valid_limit(*problem.mechanism, valid);
      more.of_check = true;
      for (ConstraintStatement& side : over_ranges(problem, more)) {
        add_limit(std::move(side), problem);
      }
    }
  }
}

}  // namespace camlaw::problems
