// SPDX-License-Identifier: MIT
#include "problems/results/judged_design.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "problems/statement/parameters.h"

namespace camlaw::problems {

std::optional<HeldProblem> held_problem(const ReadDesign& read) {
  ProblemStatement held = read.statement;
  held.laws.erase(held.laws.begin() + 1, held.laws.end());
  std::erase_if(held.variables, [&](const VariableStatement& v) {
    const bool others = v.of_law && !index_in(*held.laws.front().family, v.law_parameter);
    return others || v.integer || !v.values.empty();
  });
  if (held.objectives.empty() || read.statement.variables.empty()) return {};
  const bool whole =
      read.problem.laws.size() == 1 && held.variables.size() == read.statement.variables.size();
  const BoundProblem bound(std::move(held), true);
  optim::MultiProblem problem = bound.problem({});
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
  const optim::Sizes sizes = optim::sizes(problem, held.x);
  optim::Assessment found = optim::assess(problem, sizes, held.x, true);
  if (optim::is_feasible(found) && !found.global) {
    const auto division = optim::subdivided(problem, sizes, held.x);
    if (division && !division->better) {
      optim::take_subdivision(problem, sizes, *division, found);
    } else if (division) {
      found.reason +=
          fmt::format("; a better design is known: {}", words_of(problem, *division->better));
    }
  }
  if (found.verdict != optim::Verdict::Failed) return found;
  optim::Assessment least = optim::assess_least_violation(problem, sizes, held.x);
  return least.verdict == optim::Verdict::Infeasible ? least : found;
}

namespace {

/// Whether what was found says at least as much as what was claimed.
bool supports(optim::Verdict found, const std::string& claimed) {
  using optim::Verdict;
  if (claimed == to_string(found)) return true;
  return claimed == to_string(Verdict::Feasible) && found == Verdict::Certified;
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
  const double value = found.objective.value;
  constexpr double kDigits = 1e-9;  // results print every digit; what remains is rounding
  const double slack = std::max(kDigits * std::abs(value), found.objective.tolerance);
  if (read.objective && !(std::abs(*read.objective - value) <= slack)) {
    result.push_back(fmt::format("the result says {:.10g}; the objective is {:.10g}{}",
                                 *read.objective, value, unit == "1" ? "" : " " + unit));
  }
  return result;
}

}  // namespace

VerifiedDesign verified(const ReadDesign& read) {
  if (!read.verdict) {
    throw std::invalid_argument(
        "a problem file claims nothing; verify takes the result.json of a search, or what --json "
        "prints");
  }
  if (read.statement.objectives.size() != 1) {
    throw std::invalid_argument("only a result with one objective can be verified");
  }
  const auto held = held_problem(read);
  if (!held) throw std::invalid_argument("nothing varies in this result, so it claims nothing");
  VerifiedDesign result;
  result.found = judged(*held);
  result.whole = held->whole;
  result.limits = as_stated(read.statement, result.found.limits);
  result.disagreements = disagreements(read, result.found, held->whole,
                                       held->problem.objectives.front().response.unit);
  if (read.global && !held->whole) {
    result.not_judged.push_back(
        "the result says that no better design exists; of other choices and whole numbers only a "
        "search can tell");
  }
  return result;
}

}  // namespace camlaw::problems
