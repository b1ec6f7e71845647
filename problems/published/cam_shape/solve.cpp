// SPDX-License-Identifier: MIT
#include "problems/published/cam_shape/solve.h"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>

#include "optim/problem/deadline.h"
#include "optim/search/optimise.h"
#include "optim/solvers/program.h"
#include "optim/solvers/solver.h"
#include "problems/cam_shape/cam_shape.csv.h"

namespace camlaw::problems {
namespace {

std::optional<double> printed_for(int n) {
  for (const PrintedValue& printed : printed_cam_shapes()) {
    if (points_of(printed) == n) return printed.number.value;
  }
  return {};
}

/// The rows as published: over 1 / d^2 (convexity: the upper bound alone) and 1 / d.
optim::Program published_program(const optim::Problem& problem) {
  const double d = cam_shape_angle(static_cast<int>(problem.variables.size()));
  std::vector<optim::Row> rows;
  for (const optim::Constraint& c : problem.constraints) {
    const bool slope = c.lower.has_value();
    rows.push_back({c.response.function(),
                    c.lower.value_or(-optim::kInfinity),
                    *c.upper,
                    slope ? 1 / d : 1 / (d * d),
                    {}});
  }
  std::vector<optim::ProgramColumn> columns;
  for (const optim::Variable& v : problem.variables) {
    columns.push_back({v.lower, v.upper, 1.5, 1});  // COPS's start
  }
  return {std::move(columns), problem.objective().response.function(), -1, 1, std::move(rows)};
}

}  // namespace

CamShapeCase solve_cam_shape(int n, const std::atomic<bool>* stop) {
  const optim::Optimum solved = optim::optimise(cam_shape(n), {.starts = 1, .stop = stop});
  optim::Deadline({}, stop).check();
  const optim::Assessment& assessment = solved.found.assessment;
  CamShapeCase result;
  result.n = n;
  result.printed = printed_for(n);
  result.objective = assessment.objective.value;
  result.true_optimum = cam_shape_optimum(n);
  result.max_violation = cam_shape_published_violation(solved.found.x);
  result.verdict = to_string(assessment.verdict);
  result.reason = assessment.reason;
  result.iterations = solved.found.iterations;
  result.wall_s = solved.wall_s;
  return result;
}

std::vector<double> cam_shape_by_ipopt_defaults(int n) {
  const optim::Program program = published_program(cam_shape(n));
  const optim::Solution solution = optim::ipopt_solver().solve(
      program,
      {.tolerance = 1e-8, .max_iterations = 3000, .native = {{"bound_relax_factor", 1e-8}}});
  if (solution.status != optim::Status::Solved) {
    throw std::runtime_error(
        fmt::format("cam shape, n = {}: Ipopt with its defaults: {}", n, solution.message));
  }
  return program.design(solution.y);
}

std::vector<PrintedValue> printed_cam_shapes() {
  return read_printed_values(data::cam_shape, "cam_shape.csv");
}

int points_of(const PrintedValue& printed) {
  constexpr std::string_view kName = "n=";
  const std::string& text = printed.condition;
  int n = 0;
  const char* last = text.data() + text.size();
  const char* first = text.starts_with(kName) ? text.data() + kName.size() : last;
  const auto [end, error] = std::from_chars(first, last, n);
  if (error != std::errc{} || end != last) {
    throw std::invalid_argument(fmt::format("cam_shape.csv: condition '{}' is not n=...", text));
  }
  return n;
}

}  // namespace camlaw::problems
