// SPDX-License-Identifier: MIT
#include "optim/verdict/tolerance.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "optim/problem/automatic.h"

namespace camlaw::optim::tolerance_test {

using std::sqrt;
namespace {

/// sqrt(1 - x) and x, with x + y <= 2.
Problem with_an_edge() {
  Problem problem;
  problem.variables = {{.name = "x", .lower = 0, .upper = 1, .start = 0.5},
                       {.name = "y", .lower = 0, .upper = 1, .start = 0.5}};
  const auto response = [](const char* name, auto f) {
    return Response{name, "mm", function({0, 1}, f)};
  };
  problem.objectives = {
      {.response = response("root", [](const auto& u) { return sqrt(1.0 - u[0]) + 0.0 * u[1]; })},
      {.response = response("x", [](const auto& u) { return u[0] + 0.0 * u[1]; })}};
  problem.constraints = {
      {.response = response("sum", [](const auto& u) { return u[0] + u[1]; }), .upper = 2}};
  return problem;
}

}  // namespace

TEST_CASE("designs that cannot be made are counted and left out of the spread", "[tolerance]") {
  const Problem problem = with_an_edge();
  // x from -0.1 to 1.1: beyond 1 there is no root.
  const ToleranceReport report =
      tolerance_report(problem, std::vector<double>{0.5, 0.5}, {0.6, 0.1}, 4000);
  CHECK(report.all_corners);
  CHECK(report.impossible_corners == 2);
  CHECK(static_cast<double>(report.impossible_samples) / 4000 == Approx(0.1 / 1.2).margin(0.02));
  CHECK(report.yield == Approx(1 - static_cast<double>(report.impossible_samples) / 4000));
  const Spread& root = report.spreads[0];
  CHECK_FALSE(root.possible);
  CHECK_FALSE(root.worst_is_lowest);
  CHECK(root.highest == Approx(std::sqrt(1.1)));
  CHECK(root.lowest < 0.2);
  // Of x even over -0.1 .. 1: 2/3 (1.1^1.5) / 1.1 is the mean.
  CHECK(root.mean == Approx(2.0 / 3 * std::sqrt(1.1)).epsilon(0.03));
  CHECK(root.deviation > 0);
  CHECK(root.low < root.high);
  CHECK(root.by_variable[0] == Approx(std::sqrt(1.1) - std::sqrt(0.5)));
  CHECK(report.spreads[1].possible);
  CHECK(report.spreads[2].possible);
  CHECK(report.spreads[2].worst_is_lowest);
}

TEST_CASE("where every design can be made nothing is said of others", "[tolerance]") {
  const ToleranceReport report =
      tolerance_report(with_an_edge(), std::vector<double>{0.5, 0.5}, {0.1, 0.1}, 200);
  CHECK(report.impossible_corners == 0);
  CHECK(report.impossible_samples == 0);
  CHECK(report.yield == 1);
  for (const Spread& spread : report.spreads) CHECK(spread.possible);
  CHECK(report.spreads[0].highest == Approx(std::sqrt(0.6)));
  CHECK(report.spreads[0].lowest == Approx(std::sqrt(0.4)));
}

}  // namespace camlaw::optim::tolerance_test
