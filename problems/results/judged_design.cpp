// SPDX-License-Identifier: MIT
#include "problems/results/judged_design.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "optim/cycle/scales.h"
#include "optim/pareto/costs.h"
#include "optim/pareto/judged_again.h"
#include "optim/search/told.h"
#include "optim/verdict/none_possible.h"
#include "optim/verdict/subdivision.h"
#include "optim/verdict/verdict.h"
#include "problems/results/recorded_design.h"
#include "problems/statement/parameters.h"
#include "problems/statement/parts.h"

namespace camlaw::problems {

std::optional<HeldProblem> held_problem(const ReadDesign& read) {
  ProblemStatement held = read.statement;
  held.laws.erase(held.laws.begin() + 1, held.laws.end());
  for (const PartStatement& part : read.statement.parts) keep_item(held, part.name, part.start);
  std::erase_if(held.variables, [&](const VariableStatement& v) {
    const bool others = v.of_law && !index_in(*held.laws.front().family, v.law_parameter);
    return others || v.integer || !v.values.empty();
  });
  if (held.objectives.empty() || read.statement.variables.empty()) return {};
  const bool whole = read.problem.laws.size() == 1 && !chooses_part(read.problem) &&
                     held.variables.size() == read.statement.variables.size();
  const BoundProblem bound(std::move(held), true);
  optim::Problem problem = bound.problem({});
  std::vector<double> x = problem.alone(0).start();
  return HeldProblem{std::move(problem), std::move(x), whole};
}

namespace {

/// "base_radius = 52.6 mm, offset = 3 mm".
std::string words_of(const optim::Problem& problem, const std::vector<double>& x) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const optim::Variable& v = problem.variables[i];
    words.push_back(fmt::format("{} = {:.6g}{}", v.name, x[i], v.unit == "1" ? "" : " " + v.unit));
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

optim::Assessment judged(const HeldProblem& held) {
  const optim::Problem problem = held.problem.alone(0);
  const optim::Scales scales = optim::scales(problem, held.x);
  optim::Assessment found =
      optim::assess(problem, scales, held.x, true, optim::teller_at(problem, scales, held.x));
  if (optim::is_feasible(found) && !found.global) {
    const auto division = optim::subdivided(problem, scales, held.x);
    if (division && !division->better) {
      // Nothing is known of what is possible where a part of the box has no bound.
      if (std::isfinite(division->best_possible))
        optim::take_subdivision(problem, scales, *division, found);
    } else if (division) {
      found.reason +=
          fmt::format("; a better design is known: {}", words_of(problem, *division->better));
    }
  }
  if (found.verdict != optim::Verdict::Failed) return found;
  // A search weighs limits by their scales where it began, which the result does not hold. Any
  // weights show that the limits contradict one another about this design, and of convex limits
  // that they do everywhere, which is told apart.
  const auto least_of = [&](const optim::Problem& posed) {
    const auto by = [&](const optim::Scales& weights) {
      return optim::assess_least_violation(
          posed, weights, held.x,
          optim::teller_at(posed, weights, held.x, optim::Aim::LeastViolation));
    };
    optim::Assessment least = by(scales);
    if (least.verdict == optim::Verdict::Infeasible) return least;
    return by(optim::broken_alike(posed, scales, held.x));
  };
  optim::Assessment least = least_of(problem);
  const auto strict = optim::with_strict_edges(problem);
  if (least.verdict != optim::Verdict::Infeasible && strict) least = least_of(*strict);
  if (least.verdict == optim::Verdict::Infeasible) return least;
  if (std::isfinite(found.objective.value)) return found;
  if (const auto none = optim::none_possible(problem)) {
    found.verdict = optim::Verdict::Infeasible;
    found.reason = fmt::format("{}; {}", *none, found.reason);
    found.global = none;
  }
  return found;
}

namespace {

/// A limit's stated value against its stated margin and bound, and the bound against the problem's.
void compare_bound(const StatedLimit& stated, const optim::Constraint& constraint,
                   std::vector<std::string>& words) {
  constexpr double kDigits = 1e-9;  // results print every digit; what remains is rounding
  const double size = std::max(std::abs(stated.value), std::abs(stated.bound));
  const double margin = stated.is_upper ? stated.bound - stated.value : stated.value - stated.bound;
  if (std::isfinite(margin) && !(std::abs(margin - stated.margin) <= kDigits * size)) {
    const auto shown = [&](double value) { return std::abs(value) <= kDigits * size ? 0 : value; };
    words.push_back(fmt::format(
        "the value of {} is stated as {:.9g}, but its margin and bound give {:.9g}", stated.name,
        shown(stated.value),
        shown(stated.is_upper ? stated.bound - stated.margin : stated.bound + stated.margin)));
  }
  if (!std::isfinite(stated.bound)) return;
  const auto is_its = [&](const std::optional<double>& bound) {
    return bound && std::abs(std::abs(*bound) - std::abs(stated.bound)) <= kDigits * size;
  };
  if (is_its(stated.is_upper ? constraint.upper : constraint.lower)) return;
  if (is_its(stated.is_upper ? constraint.lower : constraint.upper)) {
    words.push_back(fmt::format(
        "the bound on {} is stated as its {} bound, but in its problem it is its {} bound",
        stated.name, stated.is_upper ? "upper" : "lower", stated.is_upper ? "lower" : "upper"));
    return;
  }
  const auto& own = stated.is_upper ? constraint.upper : constraint.lower;
  const auto& other = stated.is_upper ? constraint.lower : constraint.upper;
  words.push_back(
      fmt::format("the bound on {} is stated as {:.9g}, but in its problem it is {:.9g}",
                  stated.name, stated.bound, own ? *own : other.value_or(std::nan(""))));
}

void compare_shown_variables(const ReadDesign& read, std::vector<std::string>& words) {
  constexpr double kDigits = 1e-9;  // results print every digit; what remains is rounding
  for (const VariableStatement& v : read.statement.variables) {
    const auto shown = read.stated.variables.find(v.name);
    if (shown == read.stated.variables.end()) continue;
    const double slack = kDigits * std::max(std::abs(v.start), std::abs(shown->second));
    if (std::abs(shown->second - v.start) <= slack) continue;
    words.push_back(fmt::format("{} is shown as {:.9g}, but in the design it is {:.9g}", v.name,
                                shown->second, v.start));
  }
}

/// The stated value of an objective; NaN where there is none.
double stated_value(const ReadDesign& read, const std::string& name, bool alone) {
  if (alone && read.objective) return *read.objective;
  const auto at = read.stated.objectives.find(name);
  return at == read.stated.objectives.end() ? std::nan("") : at->second;
}

/// Keeps of the problem what the result states a number of.
optim::FrontPoint stated_point(const ReadDesign& read, const std::vector<double>& x,
                               optim::Problem& problem, std::vector<std::string>& words) {
  optim::FrontPoint point;
  point.x = x;
  const bool alone = problem.objectives.size() == 1;
  std::erase_if(problem.objectives, [&](const optim::Objective& o) {
    const double value = stated_value(read, o.response.name, alone);
    if (std::isnan(value)) return true;
    point.objectives.push_back(value);
    point.costs.push_back(optim::as_cost(o, value));
    return false;
  });
  const auto& limits = read.stated.limits;
  if (!limits && !problem.constraints.empty() && read.stated.seal == Seal::Broken) {
    words.emplace_back("the limits are not stated");
  }
  if (limits) {
    std::map<std::string, int> times;
    for (const StatedLimit& limit : *limits) {
      if (++times[limit.name] == 2) words.push_back(fmt::format("{} is stated twice", limit.name));
    }
  }
  std::erase_if(problem.constraints, [&](const optim::Constraint& c) {
    if (!limits) return true;
    const auto at = std::find_if(limits->begin(), limits->end(), [&](const StatedLimit& limit) {
      return limit.name == c.response.name;
    });
    if (at == limits->end()) {
      // Where laws were chosen from, limits of the laws' own are called otherwise.
      if (read.problem.laws.size() <= 1) {
        words.push_back(fmt::format("the limit on {} is not stated", c.response.name));
      }
      return true;
    }
    compare_bound(*at, c, words);
    point.limits.push_back({at->name, c.response.unit, at->margin, {}, at->met, false, 0});
    return false;
  });
  return point;
}

}  // namespace

std::vector<std::string> differences(const ReadDesign& read) {
  if (!read.verdict) return {};
  std::vector<std::string> words;
  compare_shown_variables(read, words);
  const auto held = held_problem(read);
  if (!held) return words;
  optim::Problem problem = held->problem;
  optim::FrontPoint point = stated_point(read, held->x, problem, words);
  if (problem.objectives.empty()) {
    // Of a design where it is not a number nothing can be.
    const auto is_number = [&](const optim::Objective& o) {
      return !std::isnan(optim::objective_value(o, held->x));
    };
    const auto& sought = held->problem.objectives;
    if (std::any_of(sought.begin(), sought.end(), is_number)) {
      words.emplace_back("the objective is not stated");
      return words;
    }
    problem.objectives = {optim::no_objective()};
    point.objectives = point.costs = {0};
  }
  const std::vector<std::string> more = optim::differences(problem, point);
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::vector<std::string> record_notes(const ReadDesign& read, const std::string& program) {
  if (!read.verdict) return {};
  if (read.stated.seal == Seal::Broken) {
    return {
        "the result was changed after it was written, as its checksum shows: its claims are "
        "ignored, and everything here is evaluated from its design"};
  }
  if (read.stated.seal == Seal::None) {
    return {
        "the result has no checksum, like those of earlier versions: its claims are ignored, and "
        "everything here is evaluated from its design"};
  }
  if (read.stated.program == program) return {};
  return {fmt::format("the result was written by {}: its claims are judged again",
                      read.stated.program.empty() ? "an unknown version" : read.stated.program)};
}

namespace {

/// Whether what was found says at least as much as what was claimed.
bool supports(optim::Verdict found, const std::string& claimed) {
  using optim::Verdict;
  if (claimed == to_string(found)) return true;
  return claimed == to_string(Verdict::Feasible) && found == Verdict::Certified;
}

/// A bound that a result states against the one that is found. One that is weaker, and none that
/// "global" rests on, is true as well.
void compare_best_possible(const ReadDesign& read, const optim::Assessment& found,
                           const std::string& unit, std::vector<std::string>& words) {
  if (!read.stated.best_possible) return;
  const double stated = *read.stated.best_possible;
  const std::string in_unit = unit == "1" ? "" : " " + unit;
  if (!found.best_possible) {
    words.push_back(
        fmt::format("the result says that no design is better than {:.9g}{}; no lower "
                    "bound shows it",
                    stated, in_unit));
    return;
  }
  const double sense = read.statement.objectives.front().sense == optim::Sense::Minimize ? 1 : -1;
  const double slack =
      std::max(found.objective.tolerance, optim::kBoundTolerance * found.objective_measure);
  const double tighter = sense * (stated - *found.best_possible);
  const bool differs = found.global ? std::abs(tighter) > slack : tighter > slack;
  if (!differs) return;
  words.push_back(fmt::format(
      "the result says that no design is better than {:.9g}{}; judged again, the bound is {:.9g}{}",
      stated, in_unit, *found.best_possible, in_unit));
}

std::vector<std::string> disagreements(const ReadDesign& read, const optim::Assessment& found,
                                       bool whole, const std::string& unit) {
  std::vector<std::string> result;
  if (!supports(found.verdict, *read.verdict)) {
    result.push_back(fmt::format("the result says {}; the design is {}: {}", *read.verdict,
                                 to_string(found.verdict), found.reason));
  }
  if (read.global && whole && !found.global) {
    result.push_back("the result says that no better design exists; no lower bound shows it");
  }
  if (whole && read.statement.objectives.size() == 1)
    compare_best_possible(read, found, unit, result);
  for (const std::string& words : differences(read)) result.push_back(words);
  return result;
}

}  // namespace

namespace {

/// The verdict of a point of a front: the best that one of the objectives gives, the others held.
optim::Assessment judged_on_front(const HeldProblem& held) {
  optim::Assessment best;
  for (std::size_t sought = 0; sought < held.problem.objectives.size(); ++sought) {
    optim::Assessment found = optim::assessed_on_front(held.problem, held.x, sought);
    if (sought == 0 || found.verdict == optim::Verdict::Certified) best = std::move(found);
    if (best.verdict == optim::Verdict::Certified) break;
  }
  return best;
}

}  // namespace

VerifiedDesign verified(const ReadDesign& read,
                        const std::function<void(optim::Assessment&)>& also) {
  if (!read.verdict) {
    throw std::invalid_argument(
        "a problem file claims nothing; verify takes the result.json of a search, or what --json "
        "prints");
  }
  const auto held = held_problem(read);
  if (!held)
    throw std::invalid_argument(
        "no number varies in this result: verify does not judge a choice among laws alone; run "
        "optimize again");
  VerifiedDesign result;
  result.found = held->problem.objectives.size() == 1 ? judged(*held) : judged_on_front(*held);
  if (also && held->problem.objectives.size() == 1) also(result.found);
  result.whole = held->whole;
  result.found.limits.resize(held->problem.constraints.size());  // without those on objectives
  result.limits = as_stated(read.statement, result.found.limits);
  result.disagreements = disagreements(read, result.found, held->whole,
                                       held->problem.objectives.front().response.unit);
  if (read.global && !held->whole) {
    result.not_judged.push_back(
        "the result says that no better design exists; only a search can tell that of other "
        "choices and integers");
  }
  if (read.stated.seal == Seal::Broken && !read.stated.others.empty()) {
    result.not_judged.push_back(
        fmt::format("what else the changed result states was not checked: {}",
                    fmt::join(read.stated.others, ", ")));
  }
  return result;
}

}  // namespace camlaw::problems
