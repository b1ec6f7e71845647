// SPDX-License-Identifier: MIT
#include "problems/statement/validity.h"

#include <algorithm>
#include <cmath>

#include "problems/statement/law_rooms.h"
#include "problems/statement/ranges.h"
#include "problems/statement/variation.h"

namespace camlaw::problems {
namespace {

const char* const kMechanism = "the mechanism";

/// Whether some row of a part has a parameter other than 0. The limits are those of every row:
/// what reports a choice, such as a front's table, has the same limits for each of its rows, so a
/// row without the parameter keeps the limit of the others.
bool sets_to_more(const PartStatement& part, std::size_t parameter) {
  const auto column = std::find(part.parameters.begin(), part.parameters.end(), parameter);
  if (column == part.parameters.end()) return false;
  const auto at = static_cast<std::size_t>(column - part.parameters.begin());
  return std::any_of(part.items.begin(), part.items.end(),
                     [&](const PartItem& item) { return item.values[at] != 0; });
}

/// Whether the machine has what a limit of validity is about, at some value of what may change.
bool concerns(const ProblemStatement& problem, const ValidityLimit& limit) {
  if (limit.only_with.empty()) return true;
  const std::size_t parameter = problem.mechanism->parameter(limit.only_with);
  if (problem.constants[parameter] != 0) return true;
  const auto is_in = [&](const auto& all, const auto& is_it) {
    return std::any_of(all.begin(), all.end(), is_it);
  };
  const auto sets_it = [&](const LoadCase& load) {
    return is_in(load.parameters, [&](const auto& value) { return value.first == parameter; });
  };
  return is_in(problem.variables,
               [&](const auto& v) { return !v.of_law && v.parameter == parameter; }) ||
         is_in(problem.ranges, [&](const auto& range) { return range.parameter == parameter; }) ||
         is_in(variations_of(problem),
               [&](const auto& v) {
                 return !v.parameter.of_law && v.parameter.parameter == parameter;
               }) ||
         is_in(problem.parts, [&](const auto& part) { return sets_to_more(part, parameter); }) ||
         is_in(problem.cases, sets_it);
}

}  // namespace

void add_validity(const ValidityLimit& limit, const std::string& required_by,
                  ProblemStatement& problem) {
  for (const ConstraintStatement& c : problem.constraints) {
    if (c.response.name != limit.response) continue;
    const bool above = std::isinf(limit.lower) || (c.lower && *c.lower >= limit.lower);
    const bool below = std::isinf(limit.upper) || (c.upper && *c.upper <= limit.upper);
    if (above && below) return;
  }
  ConstraintStatement required = valid_limit(*problem.mechanism, limit);
  required.required_by = required_by;
  for (auto& side : over_ranges(problem, required)) problem.constraints.push_back(std::move(side));
}

void limit_to_validity(ProblemStatement& problem) {
  for (const ValidityLimit& limit : problem.mechanism->validity) {
    if (concerns(problem, limit)) {
      add_validity(limit, kMechanism, problem);
    } else {
      std::erase_if(problem.constraints, [&](const ConstraintStatement& c) {
        return c.required_by == kMechanism && c.response.name == limit.response;
      });
    }
  }
}

}  // namespace camlaw::problems
