// SPDX-License-Identifier: MIT
#include "optim/search/plan.h"

#include <fmt/format.h>

namespace camlaw::optim {

Plan plan(const Problem& problem, const std::string& wanted) {
  constexpr std::size_t kSmall = 30;
  const Solver& ipopt = ipopt_solver();
  const Solver& slsqp = find_solver("slsqp");
  const std::size_t n = problem.variables.size(), m = problem.constraints.size();
  if (wanted != "auto") {
    const Solver& chosen = find_solver(wanted);
    // A global method finds the valley; a local one finds its bottom.
    if (chosen.is_global()) return {{&chosen, &slsqp, &ipopt}, "as asked for"};
    return {{&chosen}, "as asked for"};
  }
  if (n <= kSmall && m <= kSmall) {
    return {{&slsqp, &ipopt},
            fmt::format("slsqp: {} variable{}, exact gradients; ipopt where that is not enough", n,
                        n == 1 ? "" : "s")};
  }
  return {{&ipopt}, fmt::format("ipopt: {} variables and {} limits, sparse", n, m)};
}

std::vector<const Solver*> least_violation_plan(const Problem& problem) {
  constexpr std::size_t kSmall = 30;
  const Solver& ipopt = ipopt_solver();
  const bool small = problem.variables.size() + problem.constraints.size() <= kSmall;
  if (small) return {&find_solver("slsqp"), &ipopt};
  return {&ipopt};
}

}  // namespace camlaw::optim
