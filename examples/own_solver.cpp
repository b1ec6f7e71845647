// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <memory>

#include "numerics/scalar/interval.h"
#include "optim/problem/automatic.h"
#include "optim/search/optimise.h"
#include "optim/solvers/solver.h"

using namespace camlaw::optim;

/// Steps along one variable after the other, half as long where none leads down.
class Compass final : public Solver {
 public:
  std::string name() const override { return "compass"; }
  bool is_global() const override { return false; }
  std::optional<std::string> refusal(const Program& program) const override {
    if (program.rows() == 0) return {};
    return "compass takes no constraints besides bounds on the variables";
  }
  std::vector<NativeRule> native_rules() const override {
    return {{.name = "first_step", .lower = 0, .above_lower = true}};
  }

 private:
  Solution search(const Program& program, const SolverOptions& options,
                  const WarmStart*) const override {
    const auto given = options.native.find("first_step");
    double step = given == options.native.end() ? 0.5 : number_of(given->second);
    Solution s{.status = Status::Solved, .message = "the steps are small enough"};
    s.y.assign(program.start().begin(), program.start().end());
    double least = program.objective(s.y);
    for (; step > options.tolerance; step /= 2) {
      for (bool moved = true; moved;) {
        moved = false;
        for (std::size_t k = 0; k < 2 * s.y.size(); ++k) {
          const std::size_t i = k / 2;
          std::vector<double> y = s.y;
          y[i] = std::clamp(y[i] + (k % 2 == 0 ? step : -step), program.lower()[i],
                            program.upper()[i]);
          if (++s.evaluations > options.max_evaluations) {
            s.status = Status::IterationLimit;
            return s;
          }
          const double value = program.objective(y);  // NaN is never less
          if (value < least) s.y = y, least = value, moved = true;
        }
      }
    }
    return s;
  }
};

int main() {
  register_solver(std::make_unique<Compass>());
  Problem problem;  // least (x - 1)^2 + x y + 2 y^2 in a box
  problem.variables = {{.name = "x", .lower = -3, .upper = 3, .start = 0},
                       {.name = "y", .lower = -3, .upper = 3, .start = 0}};
  problem.objectives = {{{"cost", "1", function<camlaw::Interval>({0, 1}, [](const auto& u) {
                            return (u[0] - 1.0) * (u[0] - 1.0) + u[0] * u[1] + 2.0 * u[1] * u[1];
                          })}}};
  const Optimum best =
      optimise(problem, {.solver = "compass", .native = {{"compass", {{"first_step", 0.25}}}}});
  const auto verdict = to_string(best.found.assessment.verdict);
  std::printf("%.6f at (%.6f, %.6f) by %s: %.*s\n", best.found.assessment.objective.value,
              best.found.x[0], best.found.x[1], best.found.solver.c_str(),
              static_cast<int>(verdict.size()), verdict.data());
}
