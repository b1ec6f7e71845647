// SPDX-License-Identifier: MIT
#include "optim/solvers/solver.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "optim/solvers/run_end.h"

namespace camlaw::optim {
namespace {

/// What a method throws, or lets through of what the model throws.
Solution thrown(const std::string& solver) {
  Solution solution;
  solution.message = solver + " raised an error";
  solution.error = std::current_exception();
  return solution;
}

/// Why the point cannot be what a method came to; empty where it can.
std::string why_no_point(const Program& program, const Solution& solution) {
  const std::size_t size = solution.y.size(), variables = program.variables();
  if (size != variables) {
    return fmt::format("a point of {} number{} for {} variable{}", size, size == 1 ? "" : "s",
                       variables, variables == 1 ? "" : "s");
  }
  return all_finite(solution.y) ? "" : "a point that is not finite";
}

void drop_unsound_multipliers(const Program& program, Solution& solution) {
  const bool sound = solution.rows.size() == program.rows() &&
                     solution.lower.size() == program.variables() &&
                     solution.upper.size() == program.variables() && all_finite(solution.rows) &&
                     all_finite(solution.lower) && all_finite(solution.upper);
  if (sound) return;
  for (auto* multipliers : {&solution.rows, &solution.lower, &solution.upper}) multipliers->clear();
}

/// Without what cannot be true.
Solution believed(const std::string& solver, const Program& program, Solution solution) {
  constexpr int kMost = 1'000'000;  // more is not counted: sums of many searches are ints
  solution.iterations = std::clamp(solution.iterations, 0, kMost);
  solution.evaluations = std::max(solution.evaluations, 0L);
  drop_unsound_multipliers(program, solution);
  const bool claims_a_point = solution.status == Status::Solved ||
                              solution.status == Status::Acceptable ||
                              solution.status == Status::Unbounded;
  if (solution.y.empty() && !claims_a_point) return solution;
  if (const std::string why = why_no_point(program, solution); !why.empty()) {
    solution.y.clear();
    solution.status = Status::Failed;
    solution.message = fmt::format("{} came back with {}", solver, why);
  } else if (solution.status == Status::Unbounded && !is_far_out(program, solution.y)) {
    solution.status = Status::Failed;
    solution.message = fmt::format(
        "{} says that the objective decreases without bound, at a point that is not far out",
        solver);
  }
  return solution;
}

}  // namespace

std::string_view to_string(Status status) {
  switch (status) {
    case Status::Solved:
      return "solved";
    case Status::Acceptable:
      return "solved to a looser tolerance";
    case Status::Stalled:
      return "stalled";
    case Status::IterationLimit:
      return "limit of iterations";
    case Status::TimeLimit:
      return "time limit";
    case Status::Infeasible:
      return "infeasible";
    case Status::Unbounded:
      return "unbounded";
    case Status::NonFiniteStart:
      return "not a number at the start";
    case Status::Stopped:
      return "stopped";
    case Status::Failed:
      return "failed";
  }
  return "?";
}

Solution Solver::solve(const Program& program, const SolverOptions& options,
                       const WarmStart* warm) const {
  check_native_options(*this, options.native);
  try {
    return believed(name(), program, search(program, options, warm));
  } catch (...) {
    return thrown(name());
  }
}

void check_native_options(const Solver& solver, const NativeOptions& options) {
  if (options.empty()) return;
  const std::vector<NativeRule> rules = solver.native_rules();
  for (const auto& [option, value] : options) {
    check_native_option(solver.name(), rules, option, value);
  }
}

std::vector<std::string> solver_versions() {
  return {ipopt_version(), nlopt_version(), clp_version()};
}

}  // namespace camlaw::optim
