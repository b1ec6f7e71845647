// SPDX-License-Identifier: MIT
#include "problems/published/cam_shape/cam_shape.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "benchmarks/timing.h"
#include "optim/search/exchange.h"
#include "optim/verdict/verdict.h"

/// The cam shape by its number of radii: Ipopt's solve, and the verdict of what it found.
namespace camlaw::benchmarks {

void print_cam_shape_table() {
  fmt::print(
      "cam shape, seconds\n\n| n | iterations | solve | verdict | verdict over solve | solve per "
      "radius and iteration, us | solve over that at n = 1000, per radius |\n"
      "|--:|--:|--:|--:|--:|--:|--:|\n");
  double first = 0;
  for (const int n : {1000, 2000, 4000, 7000, 10000}) {
    const optim::Problem problem = problems::cam_shape(n);
    const std::vector<double> start = problem.start();
    const optim::Scales scales = optim::scales(problem, start);
    std::vector<double> solve, judge;
    optim::Attempt attempt;
    for (int i = 0; i < 3; ++i) {
      solve.push_back(seconds(
          [&] { attempt = optim::exchange(problem, scales, start, optim::ipopt_solver(), {}); }));
      judge.push_back(seconds([&] { optim::assess(problem, scales, attempt.x, true); }));
    }
    const double s = median(solve), v = median(judge);
    if (first == 0) first = s / n;
    fmt::print("| {} | {} | {:.3f} | {:.3f} | {:.3f} | {:.2f} | {:.2f} |\n", n, attempt.iterations,
               s, v, v / s, 1e6 * s / n / attempt.iterations, s / n / first);
  }
  fmt::print("\n");
}

}  // namespace camlaw::benchmarks
