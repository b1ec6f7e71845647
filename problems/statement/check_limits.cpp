// SPDX-License-Identifier: MIT
#include "problems/statement/check_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "machines/model/known_names.h"
#include "problems/statement/added_part.h"
#include "problems/statement/bind.h"
#include "problems/statement/buildable.h"
#include "problems/statement/law_rooms.h"
#include "problems/statement/parameters.h"
#include "problems/statement/parts.h"
#include "problems/statement/ranges.h"
#include "problems/statement/variation.h"

namespace camlaw::problems {
namespace {

const std::vector<MechanismParameter>& parameters_of(const ProblemStatement& problem) {
  return problem.mechanism->parameters;
}

}  // namespace

std::size_t parameter_named(const ProblemStatement& problem, std::string_view name) {
  const auto& all = parameters_of(problem);
  return static_cast<std::size_t>(
      std::find_if(all.begin(), all.end(), [&](const auto& p) { return p.name == name; }) -
      all.begin());
}

namespace {

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

}  // namespace

double bound_with(const BuildableCheck& check, const ProblemStatement& problem,
                  const std::vector<double>& constants) {
  return check.bound(stated_numbers(check, problem, constants));
}

double bound_of(const BuildableCheck& check, const ProblemStatement& problem) {
  return bound_with(check, problem, problem.constants);
}

bool bound_moves(const BuildableCheck& check, const ProblemStatement& problem,
                 const ParameterRange& range) {
  std::vector<double> low = problem.constants, high = problem.constants;
  low[range.parameter] = range.lower;
  high[range.parameter] = range.upper;
  return bound_with(check, problem, low) != bound_with(check, problem, high);
}

bool is_of(const ResponseName& name, const MechanismResponse& response) {
  return name.response != nullptr && name.response->name == response.name;
}

namespace {

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

}  // namespace

std::string mixed(const BuildableCheck& check, const ProblemStatement& problem) {
  const std::string& parameter = check.only_with;
  if (parameter.empty() || !presence(check, problem, parameter).is_mixed()) return "";
  return fmt::format(
      "the values that {} takes begin at 0, where the check without it is made; let them begin "
      "above 0",
      parameter);
}

namespace {

/// "mass is not stated", "neither speed nor mass is stated", "none of speed, mass and spring_rate
/// is stated".
std::string not_stated(const std::vector<std::string>& names) {
  if (names.size() == 1) return names[0] + " is not stated";
  if (names.size() == 2) return fmt::format("neither {} nor {} is stated", names[0], names[1]);
  return fmt::format("none of {} is stated", listed(names));
}

}  // namespace

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

const PartStatement* part_behind(const BuildableCheck& check, const ProblemStatement& problem) {
  for (const std::string& name : check.needs) {
    if (const PartStatement* part = part_with_input(problem, name)) return part;
  }
  return part_with_input(problem, check.input);
}

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

}  // namespace camlaw::problems
