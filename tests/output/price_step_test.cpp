// SPDX-License-Identifier: MIT
// The step for which an answer's words tell a price.
#include "output/answers/price_step.h"

#include <catch2/catch.hpp>
#include <limits>

namespace camlaw::cli {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

optim::LimitReport limit_at(double bound, double price) {
  optim::LimitReport limit;
  limit.bound = limit.value = bound;
  limit.multiplier = price;
  return limit;
}

optim::VariableReport variable_at_lower(double lower, double upper, double price) {
  optim::VariableReport v;
  v.lower = v.value = lower;
  v.upper = upper;
  v.at_lower = true;
  v.multiplier = price;
  return v;
}

TEST_CASE("a price is told for a round step that is small beside limit and objective", "[prices]") {
  struct Row {
    double bound, price, objective, step;
  };
  const Row row = GENERATE(Row{30, 2.951, 52.6, 1},       // deg, mm
                           Row{1.05, 358.3, 420, 0.1},    // a ratio: a tenth of it
                           Row{1.05, 358.3, 180, 0.01},   // which would gain too much
                           Row{-40, 2.951, 52.6, 1},      // the sign does not count
                           Row{10, 1, 100, 1},            // a tenth itself
                           Row{60000, 1e-4, 50, 1000},    // large, N
                           Row{0.00025, 1000, 20, 1e-5},  // small, m
                           Row{0, 0.001, 50, 1},          // no size of its own
                           Row{0, 358.3, 180, 0.01},      // but the objective has one
                           Row{30, 2, 0, 1},              // an objective of 0
                           Row{0, 2, 0, 1});
  CAPTURE(row.bound, row.price, row.objective);
  const auto told = priced_step(limit_at(row.bound, row.price), row.objective);
  REQUIRE(told);
  CHECK(told->step == Approx(row.step).epsilon(1e-12));
  CHECK(told->gain == Approx(row.price * row.step).epsilon(1e-12));
}

TEST_CASE("the step keeps the sign of a price and is none without one", "[prices]") {
  const auto loss = priced_step(limit_at(30, -2.951), 52.6);
  REQUIRE(loss);
  CHECK(loss->step == Approx(1));
  CHECK(loss->gain == Approx(-2.951));
  CHECK_FALSE(priced_step(limit_at(30, kNone), 52.6));
  CHECK_FALSE(priced_step(limit_at(30, 0), 52.6));
  CHECK_FALSE(priced_step(limit_at(30, 1e-12), 52.6));
  optim::LimitReport equation = limit_at(30, 2);
  equation.is_equation = true;
  CHECK_FALSE(priced_step(equation, 52.6));
}

TEST_CASE("a variable's bound is eased by little of the bound or of the range", "[prices]") {
  const auto step = [](double lower, double upper) {
    return priced_step(variable_at_lower(lower, upper, 1e-6), 50)->step;
  };
  CHECK(step(20, 150) == Approx(1));
  CHECK(step(1000, 1002) == Approx(0.1));
  CHECK(step(0, 1) == Approx(0.1));
  CHECK(step(0, optim::kInfinity) == Approx(1));
  CHECK_FALSE(priced_step(optim::VariableReport{}, 50));
}

}  // namespace
}  // namespace camlaw::cli
