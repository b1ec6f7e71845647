// SPDX-License-Identifier: MIT
#include "optim/search/exchange.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "optim/cycle/peak_function.h"
#include "optim/search/plan.h"
#include "optim/search/polish.h"
#include "optim/search/working_set.h"
#include "optim/verdict/verdict.h"

namespace camlaw::optim {
namespace {

using Clock = std::chrono::steady_clock;

/// The solver's tolerance, tight enough for every constraint's own.
SolverOptions tightened(const Problem& problem, const Scales& scales, SolverOptions options) {
  // Rounding of scaled rows keeps solvers from coming nearer (SC4).
  constexpr double kTightest = 1e-11;
  for (const ConstraintScale& c : scales.constraints) {
    options.tolerance = std::min(options.tolerance, 0.1 * c.tolerance / c.scale);
  }
  const double wanted = 0.1 * scales.objective_tolerance / scales.objective;
  if (problem.objective().tolerance) options.tolerance = std::min(options.tolerance, wanted);
  options.tolerance = std::max(options.tolerance, kTightest);
  return options;
}

bool went_well(Status status) { return status == Status::Solved || status == Status::Acceptable; }

/// Whether an optimum that a sharp method has found needs no polish, and its conditions of
/// optimality are left to the verdict: to look at them takes longer than a few rounds more. Of few
/// variables one peak that moves tells.
bool needs_no_polish(const Problem& problem) { return is_large(problem); }

/// To what share of their tolerances the exchange goes after peaks from such an optimum on: not to
/// where the method's own rounding lies.
double finest_without_polish(const Problem& problem) {
  constexpr std::size_t kMost = 280;  // variables: of more it lies above a tenth
  return problem.variables.size() > kMost ? 0.1 : 5e-3;
}

/// Whether no place of a curve moves along with the design.
bool stands_still(const Problem& problem) {
  const auto moves = [](const Response& r) { return r.is_curve() && r.curve().breaks_move(); };
  return !moves(problem.objective().response) &&
         std::none_of(problem.constraints.begin(), problem.constraints.end(),
                      [&](const Constraint& c) { return moves(c.response); });
}

/// A multiplier below this is an idle row's of an interior-point method.
constexpr double kIdleRow = 1e-13;

/// What of the program's rows holds its solution.
void add_pushing_rows(const Program& program, const Solution& solution, std::vector<Push>& pushes) {
  const double unit = program.objective_size();
  for (std::size_t r = 0; r < solution.rows.size(); ++r) {
    const Row& row = program.row_list()[r];
    const bool equation = row.lower == row.upper;
    // A row with one bound pushes from its side alone, whatever rounding says.
    double sign = solution.rows[r] > 0 || equation ? 1 : -1;
    if (std::isinf(row.lower)) sign = 1;
    if (std::isinf(row.upper)) sign = -1;
    const double multiplier = sign * solution.rows[r];
    if (!((equation ? std::abs(multiplier) : multiplier) > kIdleRow)) continue;
    pushes.push_back({.constraint = row.constraint,
                      .variable = {},
                      .function = row.function,
                      .sign = sign,
                      .size = row.size,
                      .at_rest = row.at_rest,
                      .price = multiplier * unit / row.size,
                      .place = row.place,
                      .rest = row.rest});
  }
}

/// What of the variables' bounds does.
void add_pushing_bounds(const Problem& problem, const Program& program, const Solution& solution,
                        std::vector<Push>& pushes) {
  const double unit = program.objective_size();
  for (std::size_t k = 0; k < solution.lower.size(); ++k) {
    const std::size_t variable = program.column(k);
    if (variable >= problem.variables.size()) continue;
    const double scale = program.columns()[variable].scale;
    const auto add = [&](double sign, double multiplier) {
      if (!(multiplier > kIdleRow)) return;
      pushes.push_back({.constraint = {},
                        .variable = variable,
                        .function = {},
                        .sign = sign,
                        .size = scale,
                        .price = multiplier * unit / scale});
    };
    add(1, solution.upper[k]), add(-1, solution.lower[k]);
  }
}

/// Point and multipliers of one solve as the start of the next, whose groups of rows have grown at
/// their ends; new rows begin without a multiplier.
WarmStart carried_over(const Solution& last, const std::vector<std::size_t>& before,
                       const std::vector<std::size_t>& now) {
  WarmStart warm{last.y, {}, last.lower, last.upper};
  auto next = last.rows.begin();
  for (std::size_t g = 0; g < now.size(); ++g) {
    const auto end = next + static_cast<std::ptrdiff_t>(before[g]);
    warm.rows.insert(warm.rows.end(), next, end);
    warm.rows.resize(warm.rows.size() + now[g] - before[g], 0.0);
    next = end;
  }
  return warm;
}

/// A start may lie outside the bounds, and a solver may end there, if only by rounding.
void draw_into_box(const Problem& problem, std::vector<double>& x) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Variable& v = problem.variables[i];
    x[i] = std::clamp(x[i], v.lower, v.upper);
  }
}

/// What came of one solve: the attempt takes it; the auxiliary variable's value comes back.
double take(const Problem& problem, const Program& program, const Solution& solution,
            Attempt& attempt) {
  ++attempt.rounds;
  attempt.iterations += solution.iterations;
  attempt.evaluations += solution.evaluations;
  attempt.rows = program.rows();
  attempt.status = solution.status;
  attempt.message = solution.message;
  attempt.error = solution.error;
  if (solution.y.size() != program.variables()) return 0;
  const std::size_t variables = problem.variables.size();
  std::vector<double> x = program.design(solution.y);
  const double auxiliary = x.size() > variables ? x.back() : 0;
  x.resize(variables);
  draw_into_box(problem, x);
  const bool numbers = std::all_of(x.begin(), x.end(), [](double v) { return std::isfinite(v); });
  if (numbers) attempt.x = std::move(x);
  return auxiliary;
}

/// Whether a polished design may take the solver's place: Newton's method goes to saddles as well.
/// What the solver left may pass limits by a little, and look better by what that is worth.
bool is_no_worse(const Problem& problem, const Scales& scales, Design polished, Design solved,
                 Aim aim, bool settled) {
  constexpr double kShare = 1e-6;  // of the scales: the value of what the solver's tolerance allows
  if (aim == Aim::LeastViolation) {
    const double before = largest_violation(problem, scales, solved);
    return largest_violation(problem, scales, polished) <= before * (1 + kShare);
  }
  const Objective& objective = problem.objective();
  const double sign = objective.sense == Sense::Minimize ? 1 : -1;
  const double before = objective_value(objective, solved);
  const double slack = kShare * std::max(std::abs(before), scales.objective);
  const bool worse = sign * objective_value(objective, polished) > sign * before + slack;
  if (settled && worse) return false;
  return kkt(problem, scales, polished).second_order;
}

void run(const Problem& problem, const Scales& scales, const Solver& solver,
         const SolverOptions& options, Aim aim, Attempt& attempt) {
  // Free laws of degree 5 take four to six programs (XM7). A peak that is a millionth of a
  // tolerance too high moves the conditions of optimality by nothing that counts.
  constexpr int kRounds = 40;
  constexpr double kFinest = 1e-6;
  double share = 0.1;  // of a tolerance: what the exchange goes after
  const auto began = Clock::now();
  WorkingSet working(problem, scales, aim);
  working.begin_at(attempt.x);
  SolverOptions left = tightened(problem, scales, options);
  std::optional<WarmStart> warm;
  while (true) {
    const Program program = working.program(attempt.x);
    const auto groups = working.row_groups();
    const Solution solution = solver.solve(program, left, warm ? &*warm : nullptr);
    attempt.told.clear();
    const double auxiliary = take(problem, program, solution, attempt);
    working.take_multipliers(solution.rows);
    const bool stalled = attempt.status == Status::Stalled && !solver.solves_linear_programs();
    const bool usable =
        went_well(attempt.status) || stalled || attempt.status == Status::IterationLimit;
    if (!usable || attempt.error) return;
    const bool solved_sharply = went_well(attempt.status) && solver.is_sharp();
    const bool sharp = solved_sharply && needs_no_polish(problem);
    if (sharp) share = finest_without_polish(problem);  // one solve more costs more than its rows
    bool settled = working.add_violated(attempt.x, auxiliary, share) == 0;
    if (solved_sharply && stands_still(problem)) {
      add_pushing_rows(program, solution, attempt.told);
      add_pushing_bounds(problem, program, solution, attempt.told);
    }
    if (!sharp && (settled || attempt.rounds > 1)) {
      const auto wanted = aim == Aim::Optimum ? Optimality::Objective : Optimality::LeastViolation;
      auto better = polished(problem, scales, attempt.x, wanted);
      if (better && is_no_worse(problem, scales, *better, attempt.x, aim, settled)) {
        attempt.x = std::move(*better);
        attempt.status = Status::Solved;
        return;
      }
    }
    // Peaks that pass their limits by less than counts may keep the conditions of optimality from
    // holding: then the exchange goes after them too.
    const double finest = sharp ? finest_without_polish(problem) : kFinest;
    while (settled && share > finest) {
      share *= 0.1;
      settled = working.add_violated(attempt.x, auxiliary, share) == 0;
    }
    if (settled) return;
    const bool refined = share < 0.1 && aim == Aim::Optimum && !sharp;
    if (refined && kkt(problem, scales, attempt.x).residual <= kKktTolerance) return;
    if (attempt.rounds >= kRounds || attempt.iterations >= options.max_iterations) {
      attempt.status = Status::IterationLimit;
      attempt.message =
          attempt.rounds >= kRounds ? "limit of exchange rounds" : "limit of iterations";
      return;
    }
    left.max_iterations = options.max_iterations - attempt.iterations;
    // Without multipliers the design alone is the start.
    warm.reset();
    if (!solution.rows.empty()) warm = carried_over(solution, groups, working.row_groups());
    if (options.time_limit) {
      const std::chrono::duration<double> spent = Clock::now() - began;
      left.time_limit = std::max(1e-3, *options.time_limit - spent.count());
    }
  }
}

/// Does work(problem, scales) with the problem as a method takes it: one that searches the whole
/// box wants no rows more than there are limits, and no smoothness; it gets peaks as numbers.
template <class Work>
auto as_taken(const Problem& problem, const Scales& scales, const Solver& solver, Work work) {
  if (!solver.is_global()) return work(problem, scales);
  const SizedProblem numbers = with_peaks_as_numbers(problem, scales);
  return work(numbers.problem, numbers.scales);
}

}  // namespace

Attempt exchange(const Problem& problem, const Scales& scales, Design start, const Solver& solver,
                 const SolverOptions& options, Aim aim) {
  Attempt attempt;
  attempt.x.assign(start.begin(), start.end());
  draw_into_box(problem, attempt.x);
  try {
    as_taken(problem, scales, solver, [&](const Problem& taken, const Scales& its_scales) {
      run(taken, its_scales, solver, options, aim, attempt);
    });
  } catch (...) {  // what the model throws between solves
    attempt.status = Status::Failed;
    attempt.message = "the model raised an error";
    attempt.error = std::current_exception();
  }
  return attempt;
}

std::optional<std::string> refusal(const Problem& problem, const Scales& scales, Design start,
                                   const Solver& solver) {
  auto why = as_taken(problem, scales, solver, [&](const Problem& taken, const Scales& its_scales) {
    WorkingSet working(taken, its_scales, Aim::Optimum);
    working.begin_at(start);
    return solver.refusal(working.program(start));
  });
  if (why && problem.objective().response.is_curve() && !solver.is_global()) {
    *why += "; a peak that is sought takes a limit at each of many angles";
  }
  return why;
}

}  // namespace camlaw::optim
