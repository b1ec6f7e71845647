// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <memory>
#include <string>
#include <vector>

#include "tests/optim/verdict/judged_problems.h"

namespace camlaw::optim::second_order_test {

using namespace verdict_tests;

namespace {

/// A curve that does not tell how its slope depends on the design.
class WithoutSlope final : public Curve {
 public:
  explicit WithoutSlope(std::shared_ptr<const Curve> curve) : curve_(std::move(curve)) {}
  Function at(Place place) const override { return curve_->at(place); }
  std::unique_ptr<Trace> trace(Design x) const override { return curve_->trace(x); }
  Shape shape() const override { return curve_->shape(); }

 private:
  std::shared_ptr<const Curve> curve_;
};

/// 5 + x^2 - (a - k x)^2 over a in [-1.5, 1.5], whose peak 5 + x^2 stands at a = k x. At a fixed
/// angle its second derivative by x is 2 - 2 k^2.
Problem moving_peak(double k, double bend, bool tells_slope) {
  std::shared_ptr<const Curve> peak =
      curve<Interval>({0}, -1.5, 1.5, [k, bend](const auto& u, const auto& angle) {
        using T = std::remove_cvref_t<decltype(angle)>;
        const T away = angle - constant<T>(k) * u[0];
        return constant<T>(5) + constant<T>(bend) * u[0] * u[0] - away * away;
      });
  if (!tells_slope) peak = std::make_shared<const WithoutSlope>(peak);
  Problem problem;
  problem.variables = {{.name = "x", .lower = -0.25, .upper = 0.25, .start = 0.1}};
  problem.objectives = {{{"peak", "N", peak}, Sense::Minimize, Part::Magnitude, {}}};
  return problem;
}

Problem smooth(Function f) {
  Problem problem;
  problem.variables = {{.name = "x", .lower = -2, .upper = 2, .start = 0.5},
                       {.name = "y", .lower = -2, .upper = 2, .start = 0.5}};
  problem.objectives = {least(std::move(f))};
  return problem;
}

const auto kSaddle = [](const auto& u) { return u[0] * u[0] - u[1] * u[1]; };

}  // namespace

TEST_CASE("a peak that moves with the design is certified where it is least", "[verdict]") {
  for (const double k : {0.0, 0.5, 2.0, 5.0}) {
    INFO("the peak moves by " << k);
    const Assessment a = judge(moving_peak(k, 1, true), {0});
    CHECK(a.objective.value == Approx(5).epsilon(1e-15));
    CHECK(a.verdict == Verdict::Certified);
    CHECK(a.second_order);
    // Without the slope the motion is unknown: 2 - 2 k^2 decides.
    CHECK(judge(moving_peak(k, 1, false), {0}).second_order == (k < 1));
  }
}

TEST_CASE("a peak that moves is not certified where its height is greatest", "[verdict]") {
  for (const double k : {0.0, 0.5, 2.0, 5.0}) {
    const Assessment a = judge(moving_peak(k, -1, true), {0});
    CHECK(a.verdict == Verdict::Feasible);
    CHECK_FALSE(a.second_order);
    CHECK(a.kkt_residual <= kKktTolerance);  // stationary it is
  }
}

TEST_CASE("stationary maxima and saddles are feasible, not certified", "[verdict]") {
  const auto hill = [](const auto& u) { return 1.0 - u[0] * u[0] - u[1] * u[1]; };
  for (const Problem& problem :
       {smooth(function({0, 1}, hill)), smooth(function({0, 1}, kSaddle))}) {
    const Assessment a = judge(problem, {0, 0});
    CHECK(a.kkt_residual <= kKktTolerance);
    CHECK_FALSE(a.second_order);
    CHECK(a.verdict == Verdict::Feasible);
    CHECK(a.reason.find("second order") != std::string::npos);
  }
  const auto bowl = [](const auto& u) { return u[0] * u[0] + u[1] * u[1]; };
  CHECK(judge(smooth(function({0, 1}, bowl)), {0, 0}).verdict == Verdict::Certified);
}

TEST_CASE("a saddle is a minimum where limits close the way down", "[verdict]") {
  // x^2 - y^2 with y = 0 by an equation, or held at y = 1 by its bound with the slope -2.
  Problem problem = smooth(function({0, 1}, kSaddle));
  problem.constraints = {
      {.response = {"y", "mm", function({1}, [](const auto& u) { return 1.0 * u[0]; })},
       .lower = 0,
       .upper = 0}};
  CHECK(judge(problem, {0, 0}).verdict == Verdict::Certified);
  problem.constraints.clear();
  problem.variables[1].upper = 1;
  const Assessment a = judge(problem, {0, 1});
  CHECK(a.verdict == Verdict::Certified);
  CHECK(a.variables[1].multiplier == Approx(2).epsilon(1e-9));
  problem.variables[1].lower = problem.variables[1].upper = 0;  // fixed
  CHECK(judge(problem, {0, 0}).verdict == Verdict::Certified);
}

TEST_CASE("a limit that is met without pushing closes the way to one side only", "[verdict]") {
  struct Corner {
    const char* what;
    Function f;
    bool x_held, y_held;  ///< lower bound 0
    bool minimum;         ///< at the origin
  };
  const auto product = [](const auto& u) { return u[0] * u[1]; };
  const auto narrow = [](const auto& u) {
    return u[0] * u[0] - 4.0 * u[0] * u[1] + u[1] * u[1];  // -2 x^2 along x = y
  };
  const Corner corners[] = {
      {"x^2 - y^2 falls into the box", function({0, 1}, kSaddle), false, true, false},
      {"x y falls where x may be negative", function({0, 1}, product), false, true, false},
      {"x y is least at the corner", function({0, 1}, product), true, true, true},
      {"between two sides that rise", function({0, 1}, narrow), true, true, false},
  };
  for (const Corner& corner : corners) {
    INFO(corner.what);
    Problem problem = smooth(corner.f);
    if (corner.x_held) problem.variables[0].lower = 0;
    if (corner.y_held) problem.variables[1].lower = 0;
    const Assessment a = judge(problem, {0, 0});
    CHECK(a.kkt_residual <= kKktTolerance);
    CHECK(a.second_order == corner.minimum);
    CHECK((a.verdict == Verdict::Certified) == corner.minimum);
  }
}

TEST_CASE("one stiff direction does not hide that others curve down", "[verdict]") {
  for (const std::size_t soft : {std::size_t{5}, std::size_t{320}}) {
    INFO(soft);
    Problem problem;
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i <= soft; ++i) {
      problem.variables.push_back({.name = "x", .lower = -1, .upper = 1, .start = 0.5});
      all.push_back(i);
    }
    const auto f = [soft](const auto& u) {
      auto sum = 1e7 * u[0] * u[0];
      for (std::size_t i = 1; i <= soft; ++i) sum = sum - u[i] * u[i];
      return sum;
    };
    problem.objectives = {least(function(all, f))};
    const Assessment a = judge(problem, Point(soft + 1, 0.0));
    CHECK_FALSE(a.second_order);
    CHECK(a.verdict == Verdict::Feasible);
  }
}

TEST_CASE("where nothing curves, a few steps tell a minimum from a maximum", "[verdict]") {
  for (const double sign : {1.0, -1.0}) {
    const auto quartic = [sign](const auto& u) {
      return sign * (u[0] * u[0] * u[0] * u[0]) + u[1] * u[1];
    };
    const Assessment a = judge(smooth(function({0, 1}, quartic)), {0, 0});
    CHECK(a.kkt_residual <= kKktTolerance);
    CHECK((a.verdict == Verdict::Certified) == (sign > 0));
  }
  // A level valley is no worse for being level.
  const auto valley = [](const auto& u) { return (u[0] + u[1]) * (u[0] + u[1]); };
  CHECK(judge(smooth(function({0, 1}, valley)), {0.5, -0.5}).verdict == Verdict::Certified);
}

TEST_CASE("two peaks whose slopes are rounding alone do not hold a design between them",
          "[verdict]") {
  for (const double falls : {1.0, 0.0}) {
    // Peaks at a = -1/2 and 1/2 whose slopes at x = 0 are opposite, and below what is told from
    // none; both fall by x^3, or stand.
    std::shared_ptr<const Curve> peaks =
        curve<Interval>({0}, -1, 1, [falls](const auto& u, const auto& angle) {
          using T = std::remove_cvref_t<decltype(angle)>;
          const T apart = angle * angle - constant<T>(0.25);
          return constant<T>(5) - constant<T>(falls) * u[0] * u[0] * u[0] -
                 constant<T>(4) * apart * apart + constant<T>(6e-11) * angle * u[0];
        });
    Problem problem;
    problem.variables = {{.name = "x", .lower = -0.25, .upper = 0.25, .start = 0}};
    problem.objectives = {{{"peak", "N", peaks}, Sense::Minimize, Part::Highest, {}}};
    const Assessment a = judge(problem, {0});
    CHECK(a.kkt_residual <= kKktTolerance);
    CHECK((a.verdict == Verdict::Certified) == (falls == 0));
  }
}

TEST_CASE("curved limits count in the second order", "[verdict]") {
  // Least -x^2 - 3 y on the disc x^2 + y^2 <= 1 at (0, 1): the multiplier is 3/2, so by x the
  // Lagrangian bends by -2 + 3: a minimum. With -y / 2 in place of -3 y it bends by -2 + 1/2: none.
  const auto disc = [](double pull) {
    Problem problem = smooth(
        function({0, 1}, [pull](const auto& u) { return -1.0 * u[0] * u[0] - pull * u[1]; }));
    problem.constraints = {
        {.response = {"radius", "mm",
                      function(
                          {0, 1}, [](const auto& u) { return u[0] * u[0] + u[1] * u[1]; },
                          Shape::Convex)},
         .upper = 1}};
    return problem;
  };
  const Assessment minimum = judge(disc(3), {0, 1});
  CHECK(minimum.verdict == Verdict::Certified);
  CHECK(minimum.limits[0].multiplier == Approx(1.5).epsilon(1e-9));
  CHECK(judge(disc(0.5), {0, 1}).verdict == Verdict::Feasible);
  CHECK_FALSE(judge(disc(0.5), {0, 1}).second_order);
}

}  // namespace camlaw::optim::second_order_test
