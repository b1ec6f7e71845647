// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "benchmarks/accuracy/accuracy.h"
#include "problems/published/cam_shape/solve.h"

namespace camlaw::benchmarks {

void print_cam_shape_accuracy() {
  fmt::print(
      "cam shape\n\n| n | objective | true optimum | relative error | largest violation as "
      "published "
      "| verdict | iterations |\n|--:|--:|--:|--:|--:|---|--:|\n");
  for (const int n : {100, 200, 400, 800, 1000, 2000, 4000, 7000, 10000}) {
    const problems::CamShapeCase c = problems::solve_cam_shape(n);
    fmt::print("| {} | {:.10f} | {:.10f} | {:.1e} | {:.1e} | {} | {} |\n", n, c.objective,
               c.true_optimum, std::abs(c.objective / c.true_optimum - 1), c.max_violation,
               c.verdict, c.iterations);
  }
  fmt::print("\n");
}

}  // namespace camlaw::benchmarks
