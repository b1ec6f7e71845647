// SPDX-License-Identifier: MIT
#include "output/answers/free_limit.h"

#include <fmt/format.h>

#include <algorithm>

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

/// "a spline with 101 free coefficients", of a statement's free law.
std::string free_law_words(const problems::ProblemStatement& statement) {
  for (const problems::VariableStatement& v : statement.variables) {
    if (v.law_parameter.ends_with("coefficients")) {
      const auto count =
          std::count_if(statement.variables.begin(), statement.variables.end(),
                        [&](const auto& other) { return other.law_parameter == v.law_parameter; });
      return fmt::format("a spline with {} free coefficients", count);
    }
  }
  return "a spline";
}

bool is_ended(const optim::OptimiseOptions& search, double spent) {
  return (search.stop != nullptr && *search.stop) ||
         (search.time_limit && spent >= *search.time_limit);
}

/// The table waits for the free law: as long as the answer's own search took, and some seconds.
optim::OptimiseOptions within_patience(optim::OptimiseOptions search, const Answer& answer) {
  constexpr double kLeast = 20;  // s
  const double patience = search.spent + std::max(kLeast, answer.optimum.wall_s);
  search.time_limit = std::min(search.time_limit.value_or(patience), patience);
  return search;
}

}  // namespace

FreeLimit free_limit(const Answer& answer, const optim::OptimiseOptions& rest, int workers) {
  FreeLimit result;
  const optim::OptimiseOptions search = within_patience(rest, answer);
  try {
    if (is_ended(search, 0)) {  // of its limit what is left after the answer's own search
      result.why_none = "the search ended before a free law was tried";
      return result;
    }
    const problems::BoundProblem bound(
        problems::with_free_law(answer.bound.statement(), laws_of_designs(answer)));
    result.law = free_law_words(bound.statement());
    optim::Crew crew({.workers = workers});
    const optim::Optimum best = optim::optimise(bound.space(), search, crew);
    const optim::Assessment& a = best.found.assessment;
    result.verdict = optim::to_string(a.verdict);
    if (optim::is_feasible(a)) {
      result.objective = a.objective.value;
    } else {
      result.why_none = is_ended(search, search.spent + best.wall_s)
                            ? "its search ended before one was found that meets the limits"
                            : "no free law was found that meets the limits";
    }
  } catch (const std::exception& error) {
    result.why_none = error.what();  // the table stands without it
  }
  return result;
}

}  // namespace camlaw::cli
