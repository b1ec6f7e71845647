// SPDX-License-Identifier: MIT
// What is said of limits where there is no time to prove them.
#include "optim/verdict/limits_in_haste.h"

#include <catch2/catch.hpp>
#include <memory>

#include "tests/optim/verdict/judged_problems.h"

namespace camlaw::optim::limits_in_haste_test {
namespace {

using namespace verdict_tests;

/// A number that a search has missed by 1: it says x, and a proof finds x less 1.
class Missed final : public Kernel {
 public:
  explicit Missed(double found = 0) : found_(found) {}
  double value(std::span<const double> u) const override { return u[0] - found_; }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    g[0] = 1;
    return value(u);
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    h[0] = 0;
    return gradient(u, g);
  }
  bool is_searched() const override { return true; }
  std::shared_ptr<const Kernel> proved() const override { return std::make_shared<Missed>(1); }

 private:
  double found_;
};

Problem between(double lower, double upper) {
  Problem problem;
  problem.variables = {{.name = "x", .lower = 0, .upper = 10, .start = 5}};
  problem.objectives = {least(variable_function(0))};
  problem.constraints = {
      {.response = {"missed", "mm", Function({0}, std::make_shared<Missed>(), Shape::Linear)},
       .lower = lower,
       .upper = upper}};
  return problem;
}

}  // namespace

TEST_CASE("a limit with two sides is judged in haste by the side with less room", "[verdict]") {
  // The search says 5, nearer to the upper bound; a proof finds 4.
  const Assessment broken = assess_in_haste(between(4.5, 5.2), Point{5});
  REQUIRE(broken.limits.size() == 1);
  CHECK_FALSE(broken.limits[0].is_upper);
  CHECK(broken.limits[0].value == 4);
  CHECK(broken.limits[0].bound == 4.5);
  CHECK(broken.limits[0].margin == -0.5);
  CHECK_FALSE(broken.limits[0].met);
  CHECK(broken.verdict != Verdict::Feasible);
  CHECK_THAT(broken.reason, Catch::Contains("missed"));
  const Assessment met = assess_in_haste(between(3.9, 5.2), Point{5});
  CHECK_FALSE(met.limits[0].is_upper);
  CHECK(met.limits[0].margin == Approx(0.1));
  CHECK(met.verdict == Verdict::Feasible);
}

TEST_CASE("a design of a search loses its verdict in haste where its hidden side is broken",
          "[verdict]") {
  for (const double lower : {3.9, 4.5}) {
    INFO(lower);
    const Problem problem = between(lower, 5.2);
    Assessment a = judge(problem, {5}, false);
    REQUIRE(a.verdict == Verdict::Feasible);
    judge_in_haste(problem, Point{5}, a);
    CHECK((a.verdict == Verdict::Feasible) == (lower < 4));
    CHECK(a.limits[0].met == (lower < 4));
  }
}

}  // namespace camlaw::optim::limits_in_haste_test
