// SPDX-License-Identifier: MIT
// The checks of a machine as limits of a problem.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "machines/model/known_names.h"
#include "problems/statement/added_part.h"
#include "problems/statement/bind.h"
#include "problems/statement/buildable.h"
#include "problems/statement/check_limits.h"
#include "problems/statement/law_rooms.h"
#include "problems/statement/parameters.h"
#include "problems/statement/parts.h"
#include "problems/statement/ranges.h"
#include "problems/statement/variation.h"

namespace camlaw::problems {
namespace {

using optim::Part;

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
