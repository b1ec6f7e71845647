// SPDX-License-Identifier: MIT
#include "optim/search/easing.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "optim/problem/deadline.h"
#include "optim/search/discrete.h"
#include "optim/search/plan.h"
#include "optim/verdict/limits.h"

namespace camlaw::optim {
namespace {

/// A problem whose objective is what is to be eased, and what that is.
struct EasedProblem {
  Problem problem;
  Easing easing;
};

/// Whether a curve's limit holds its magnitude: both bounds are eased together.
bool is_of_magnitude(const Constraint& limit) {
  return limit.response.is_curve() && limit.lower && limit.upper && *limit.lower == -*limit.upper;
}

std::optional<EasedProblem> without_limit(const Problem& problem, const Assessment& infeasible,
                                          const std::string& blamed) {
  for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
    const Constraint& limit = problem.constraints[i];
    if (limit.response.name != blamed) continue;
    const LimitReport& report = infeasible.limits[i];
    if (report.is_equation || std::isnan(report.value)) return {};
    const bool both = is_of_magnitude(limit), is_upper = both || report.is_upper;
    EasedProblem eased{problem, {}};
    eased.easing.name = limit.response.name;
    eased.easing.unit = limit.response.unit;
    eased.easing.is_upper = is_upper;
    eased.easing.bound = is_upper ? *limit.upper : *limit.lower;
    Objective sought{.response = limit.response,
                     .sense = is_upper ? Sense::Minimize : Sense::Maximize};
    if (limit.response.is_curve()) {
      sought.part = both ? Part::Magnitude : is_upper ? Part::Highest : Part::Lowest;
    }
    eased.problem.objectives = {std::move(sought)};
    Constraint& own = eased.problem.constraints[i];
    if (both || is_upper) own.upper.reset();
    if (both || !is_upper) own.lower.reset();
    if (!own.lower && !own.upper) {
      auto& all = eased.problem.constraints;
      all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return eased;
  }
  return {};
}

std::optional<EasedProblem> without_bound(const Problem& problem, const std::string& blamed) {
  for (std::size_t i = 0; i < problem.variables.size(); ++i) {
    const Variable& v = problem.variables[i];
    const bool is_upper = blamed == "upper bound of " + v.name;
    if (v.integer || (!is_upper && blamed != "lower bound of " + v.name)) continue;
    EasedProblem eased{problem, {}};
    eased.easing.name = v.name;
    eased.easing.unit = v.unit;
    eased.easing.is_bound = true;
    eased.easing.is_upper = is_upper;
    eased.easing.bound = is_upper ? v.upper : v.lower;
    // Farther than this a bound is no longer eased, but another problem is stated.
    constexpr double kFarther = 10;  // times the larger of the range and the bound
    Variable& own = eased.problem.variables[i];
    const double range = std::isfinite(v.upper - v.lower) ? v.upper - v.lower : 0;
    const double room = kFarther * std::max(range, std::abs(eased.easing.bound));
    if (!(room > 0)) return {};
    (is_upper ? own.upper : own.lower) += is_upper ? room : -room;
    // A size that was above 0 stays so.
    if (!is_upper && v.lower > 0) own.lower = std::max(own.lower, v.lower / (1 + kFarther));
    eased.problem.objectives = {{.response = {v.name, v.unit, variable_function(i)},
                                 .sense = is_upper ? Sense::Minimize : Sense::Maximize}};
    return eased;
  }
  return {};
}

/// Whether the problem's own objective, which the search for an easing leaves out, has a value: a
/// limit that it requires may be a looser one on what is eased.
bool has_objective(const Problem& problem, Design x) {
  return std::isfinite(objective_report(problem, scales(problem, x), x, false).value);
}

Problem begun_at(Problem problem, const std::vector<double>& x) {
  for (std::size_t i = 0; i < problem.variables.size(); ++i) {
    Variable& v = problem.variables[i];
    v.start = std::clamp(x[i], v.lower, v.upper);
  }
  return with_integers_fixed(problem, problem.start());
}

}  // namespace

std::vector<Easing> easings(const Problem& problem, const Found& infeasible,
                            const SearchFromStart& search) {
  std::vector<Easing> result;
  const Assessment& answer = infeasible.assessment;
  const std::size_t count = problem.variables.size();
  if (answer.verdict != Verdict::Infeasible || infeasible.x.size() != count) return result;
  if (answer.limits.size() != problem.constraints.size()) return result;
  const std::size_t looked_at = std::min(answer.blamed.size(), kMostEased);
  for (std::size_t k = 0; k < looked_at; ++k) {
    auto eased = without_limit(problem, answer, answer.blamed[k]);
    if (!eased) eased = without_bound(problem, answer.blamed[k]);
    if (!eased) continue;
    Problem posed = begun_at(std::move(eased->problem), infeasible.x);
    posed.known.reset();
    const Found found = search(posed);
    if (!is_feasible(found.assessment) || !has_objective(problem, found.x)) continue;
    Easing easing = std::move(eased->easing);
    easing.by = (easing.is_upper ? 1 : -1) * (found.assessment.objective.value - easing.bound);
    easing.x = found.x;
    if (easing.by > 0 && std::isfinite(easing.by)) result.push_back(std::move(easing));
  }
  return result;
}

FoundEasings easings(const Problem& problem, const Found& infeasible, OptimiseOptions options) {
  constexpr double kShare = 0.5;     // of the time that is left
  if (is_large(problem)) return {};  // each of these searches may take as long as the first
  std::optional<double> own;
  if (options.time_limit) own = kShare * std::max(0.0, *options.time_limit - options.spent);
  const Deadline deadline(own, options.stop);
  options.starts = 1;
  options.divides = false;
  options.narrows = false;  // where a limit cannot be eased nobody reads why
  options.progress = {};
  options.candidate = {};
  options.spent = 0;
  FoundEasings result;
  bool is_cut = false;
  result.all = easings(problem, infeasible, [&](const Problem& posed) -> Found {
    Found found;
    if (!deadline.passed()) {
      options.time_limit = deadline.left();
      found = optimise(ProblemSpace::of(posed), options).found;
    }
    if (!deadline.passed()) return found;
    is_cut = true;  // what was found by then need not be the least that helps
    return {};
  });
  if (!is_cut) return result;
  const bool had_none = own && *own <= 0;
  result.cut_short = deadline.stopped() ? "the search was stopped"
                     : had_none         ? "no time was left after the search"
                                        : "cures may take half of the time that the search left";
  return result;
}

}  // namespace camlaw::optim
