// SPDX-License-Identifier: MIT
#include "optim/solvers/interior.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "optim/solvers/read_off.h"
#include "optim/solvers/run_end.h"

namespace camlaw::optim {
namespace {

/// Puts on its bound each variable that is as near to it as the method's end leaves it and that is
/// held there by far more: a vertex method would say the same, and what is infinite at the bound is
/// not a large number beside it.
void settle_at_bounds(const QuadraticProgram& program, const InteriorSolution& found,
                      std::vector<double>& y) {
  // The method ends where multiplier times distance is some 1e-11: a multiplier a million times the
  // distance is then one that holds.
  constexpr double kNear = 1e-9, kHeld = 1e6;
  for (std::size_t k = 0; k < y.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const auto settle = [&](double bound, double multiplier) {
      const double left = std::abs(y[k] - bound);
      const bool is_near = left <= kNear * std::max(1.0, std::abs(bound));
      if (is_near && multiplier > kHeld * left) y[k] = bound;
    };
    settle(program.lower[column], found.lower_multipliers[column]);
    settle(program.upper[column], found.upper_multipliers[column]);
  }
}

Eigen::VectorXd vector_of(std::span<const double> values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

class InteriorSolver final : public Solver {
 public:
  std::string name() const override { return "interior"; }
  bool is_global() const override { return false; }
  bool solves_linear_programs() const override { return true; }
  std::optional<std::string> refusal(const Program& program) const override {
    if (!program.is_linear()) {
      return "interior takes only linear problems, and this one is not known to be linear";
    }
    return {};
  }

 private:
  Solution search(const Program& program, const SolverOptions& options,
                  const WarmStart* warm) const override {
    Solution solution;
    if (const auto why = refusal(program)) {
      solution.message = *why;
      return solution;
    }
    const std::span<const double> start = warm != nullptr ? warm->y : program.start();
    const auto read = read_at_start(program, start, solution);
    if (!read) return solution;
    const QuadraticProgram& linear = *read;
    RunEnd cut_short{Status::Stopped, "stopped"};
    const auto found_from = [&](const InteriorSolution* near, int before) {
      const int most = std::min(options.max_iterations, InteriorOptions{}.most_iterations);
      return solve_by_interior_point(linear, vector_of(start),
                                     {.most_iterations = std::max(1, most - before),
                                      .near = near,
                                      .goes_on = watch(program, options, cut_short)});
    };
    std::optional<InteriorSolution> near;
    if (warm != nullptr && !warm->rows.empty()) {
      near = InteriorSolution{.y = {},
                              .row_multipliers = vector_of(warm->rows),
                              .lower_multipliers = vector_of(warm->lower),
                              .upper_multipliers = vector_of(warm->upper)};
    }
    InteriorSolution found = found_from(near ? &*near : nullptr, 0);
    const bool is_left = found.end != InteriorEnd::Optimal && found.end != InteriorEnd::Ended;
    if (near && is_left) {
      InteriorSolution again = found_from(nullptr, found.iterations);
      again.iterations += found.iterations;
      const bool is_worse = found.end == InteriorEnd::Acceptable &&
                            again.end != InteriorEnd::Optimal && again.end != InteriorEnd::Ended;
      if (is_worse) {
        found.iterations = again.iterations;
      } else {
        found = std::move(again);
      }
    }
    const RunEnd end = found.end == InteriorEnd::Ended ? cut_short : run_end(found.end);
    solution.status = end.status;
    solution.message = end.message;
    solution.iterations = found.iterations;
    solution.y.assign(found.y.begin(), found.y.end());
    if (found.end == InteriorEnd::Optimal) settle_at_bounds(linear, found, solution.y);
    solution.rows.assign(found.row_multipliers.begin(), found.row_multipliers.end());
    solution.lower.assign(found.lower_multipliers.begin(), found.lower_multipliers.end());
    solution.upper.assign(found.upper_multipliers.begin(), found.upper_multipliers.end());
    return solution;
  }

  /// Tells of each iteration, and ends the run when the user or the clock says so; why, it leaves
  /// in `cut_short`.
  static std::function<bool(int, double, double)> watch(const Program& program,
                                                        const SolverOptions& options,
                                                        RunEnd& cut_short) {
    return [&, began = std::chrono::steady_clock::now()](int iterations, double objective,
                                                         double primal) {
      if (options.progress)
        options.progress({iterations, program.unscaled_objective(objective), primal});
      if (is_stopped(options)) return false;
      if (!is_late(options, began)) return true;
      cut_short = {Status::TimeLimit, "time limit"};
      return false;
    };
  }

  static RunEnd run_end(InteriorEnd end) {
    switch (end) {
      case InteriorEnd::Optimal:
        return {Status::Solved, "optimal to tolerance"};
      case InteriorEnd::Acceptable:
        return {Status::Acceptable, "no more progress"};
      case InteriorEnd::IterationLimit:
        return {Status::IterationLimit, "limit of iterations"};
      case InteriorEnd::Stalled:
      case InteriorEnd::Ended:
        break;
    }
    return {Status::Stalled, "no more progress"};
  }
};

}  // namespace

const Solver& interior_solver() {
  static const InteriorSolver solver;
  return solver;
}

}  // namespace camlaw::optim
