// SPDX-License-Identifier: MIT
#include "output/answers/free_limit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>

#include "optim/crew/crew.h"
#include "problems/statement/free_instead.h"

namespace camlaw::cli {
namespace {

/// The laws of the combinations that have a design.
std::vector<Member> laws_of_designs(const Answer& answer) {
  std::vector<Member> laws;
  for (const optim::PartFound& part : answer.optimum.parts) {
    if (!has_design(part)) continue;
    laws.push_back(answer.bound.at(part.options, part.x).laws.front());
  }
  return laws;
}

/// "a spline with 101 free coefficients", "2 splines with 60 free coefficients": of the segments
/// whose law is free.
std::string free_law_words(const problems::ProblemStatement& statement) {
  std::set<std::string> splines;
  std::size_t coefficients = 0;
  for (const problems::VariableStatement& v : statement.variables) {
    if (!v.of_law || !v.law_parameter.ends_with("coefficients")) continue;
    splines.insert(v.law_parameter);
    ++coefficients;
  }
  if (splines.empty()) return "a spline";
  const std::string which =
      splines.size() == 1 ? "a spline" : fmt::format("{} splines", splines.size());
  return fmt::format("{} with {} free coefficients", which, coefficients);
}

bool is_ended(const optim::OptimiseOptions& search) {
  return (search.stop != nullptr && *search.stop) ||
         (search.time_limit && search.spent >= *search.time_limit);
}

/// The table waits for the free law: as long as the answer's own search took, and some seconds.
optim::OptimiseOptions within_patience(optim::OptimiseOptions search, const Answer& answer) {
  constexpr double kLeast = 20;  // s
  const double patience = search.spent + std::max(kLeast, answer.optimum.wall_s);
  search.time_limit = std::min(search.time_limit.value_or(patience), patience);
  return search;
}

/// Whether one objective is better than another by more than rounding.
bool is_better(const Answer& answer, double objective, double than) {
  constexpr double kRounding = 1e-9;  // rounding makes one of two equal objectives better
  const bool least = answer.optimum.problem.objective().sense == optim::Sense::Minimize;
  return (least ? than - objective : objective - than) > kRounding * std::abs(than);
}

/// What a search with a free law finds; adds its time to what `search` has spent.
FreeLimit searched(const problems::BoundProblem& bound, optim::OptimiseOptions& search,
                   int workers) {
  FreeLimit result;
  result.law = free_law_words(bound.statement());
  optim::Crew crew({.workers = workers});
  const optim::Optimum best = optim::optimise(bound.space(), search, crew);
  search.spent += best.wall_s;
  const optim::Assessment& a = best.found.assessment;
  result.verdict = optim::to_string(a.verdict);
  if (optim::is_feasible(a)) {
    result.objective = a.objective.value;
  } else {
    result.why_none = is_ended(search)
                          ? "its search ended before one was found that meets the limits"
                          : "no free law was found that meets the limits";
  }
  return result;
}

/// The best that searches with ever more knots find in their time.
FreeLimit best_searched(const Answer& answer, optim::OptimiseOptions search, int workers) {
  // The last is what is wanted; where it takes too long the ones before say nearly as much.
  constexpr std::array kKnots{10, 30, 100};
  const std::vector<Member> laws = laws_of_designs(answer);
  FreeLimit result;
  for (const int knots : kKnots) {
    const problems::FreeInstead instead =
        problems::with_free_law(answer.bound.statement(), laws, knots);
    const FreeLimit next = searched(problems::BoundProblem(instead.problem), search, workers);
    const bool is_worse =
        result.objective &&
        (!next.objective || is_better(answer, *result.objective, *next.objective));
    if (!is_worse) result = next;
    if (!instead.has_these_knots || is_ended(search)) break;
  }
  return result;
}

FreeLimit none_because(const std::string& why) {
  FreeLimit result;
  result.why_none = why;
  return result;
}

}  // namespace

FreeLimit free_limit(const Answer& answer, const optim::OptimiseOptions& rest, int workers) {
  const optim::OptimiseOptions search = within_patience(rest, answer);
  // Of its limit what is left after the answer's own search.
  if (is_ended(search)) return none_because("the search ended before a free law was tried");
  try {
    FreeLimit result = best_searched(answer, search, workers);
    const optim::Assessment& best = answer.optimum.found.assessment;
    const bool is_behind = result.objective && optim::is_feasible(best) &&
                           result.verdict != optim::to_string(optim::Verdict::Certified) &&
                           is_better(answer, best.objective.value, *result.objective);
    if (is_behind) return none_because("its search has not yet matched the best law of the table");
    return result;
  } catch (const std::exception& error) {
    return none_because(error.what());  // the table stands without it
  }
}

}  // namespace camlaw::cli
