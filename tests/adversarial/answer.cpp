// SPDX-License-Identifier: MIT
#include "tests/adversarial/answer.h"

#include <algorithm>
#include <stdexcept>

#include "optim/cycle/scales.h"
#include "optim/search/told.h"
#include "optim/verdict/verdict.h"

namespace camlaw::adversary {
namespace {

Answer read(const optim::Problem& problem, const optim::Assessment& a, const std::vector<double>& x,
            const std::vector<std::string>& names) {
  Answer answer;
  switch (a.verdict) {
    case optim::Verdict::Certified:
      answer.said = Said::Certified;
      break;
    case optim::Verdict::Feasible:
      answer.said = Said::Feasible;
      break;
    case optim::Verdict::Infeasible:
      answer.said = Said::Infeasible;
      break;
    default:
      answer.said = Said::Failed;
  }
  answer.global = a.global.has_value();
  answer.reason = a.reason;
  answer.objective = a.objective.value;
  answer.objective_tolerance = a.objective.tolerance;
  for (const optim::LimitReport& limit : a.limits) {
    answer.limits.push_back({limit.name, limit.met, limit.proved, limit.is_upper, limit.is_equation,
                             limit.bound, limit.value, limit.tolerance, limit.multiplier});
  }
  for (const optim::VariableReport& v : a.variables) {
    answer.at_a_bound = answer.at_a_bound || v.at_lower || v.at_upper;
  }
  if (x.empty()) return answer;
  for (const std::string& name : names) {
    const auto found = std::find_if(problem.variables.begin(), problem.variables.end(),
                                    [&](const optim::Variable& v) { return v.name == name; });
    if (found == problem.variables.end()) throw std::runtime_error("no variable " + name);
    answer.x.push_back(x[static_cast<std::size_t>(found - problem.variables.begin())]);
  }
  return answer;
}

}  // namespace

Answer answer_of(const optim::Optimum& optimum, const std::vector<std::string>& names) {
  Answer answer = read(optimum.problem, optimum.found.assessment, optimum.found.x, names);
  answer.starts = optimum.found.starts;
  answer.evaluations = optimum.found.evaluations;
  answer.wall_s = optimum.wall_s;
  return answer;
}

Answer in_wider_box(const optim::Optimum& optimum, double wider,
                    const std::vector<std::string>& names) {
  optim::Problem problem = optimum.problem;
  for (optim::Variable& v : problem.variables) {
    const double more = (wider - 1) / 2 * (v.upper - v.lower);
    v.lower -= more;
    v.upper += more;
  }
  const optim::Design x = optimum.found.x;
  const auto scales = optim::scales(problem, x);
  // What holds a design of a linear problem is told as it is to "camlaw verify".
  const auto teller = optim::teller_at(problem, scales, x);
  return read(problem, optim::assess(problem, scales, x, true, teller), optimum.found.x, names);
}

const char* word(Said said) {
  switch (said) {
    case Said::Certified:
      return "certified";
    case Said::Feasible:
      return "feasible";
    case Said::Infeasible:
      return "infeasible";
    default:
      return "failed";
  }
}

}  // namespace camlaw::adversary
