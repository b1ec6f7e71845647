// SPDX-License-Identifier: MIT
#include "optim/verdict/kinks.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <vector>

#include "numerics/scalar/extremes.h"
#include "numerics/scalar/interval.h"
#include "numerics/scalar/series.h"
#include "optim/problem/automatic.h"
#include "optim/search/optimise.h"
#include "optim/search/unbounded.h"
#include "optim/verdict/unknown_prices.h"
#include "optim/verdict/verdict.h"
#include "tests/optim/small_problems.h"

namespace camlaw::optim::kinks_test {

using namespace small_problems;

namespace {

template <class T>
T size_of(const T& x) {
  return greater_of(x, -x);
}

template <class Of>
Problem square_box(Of objective, Sense sense) {
  Problem problem;
  problem.variables = {{.name = "p", .lower = -5, .upper = 5, .start = 0.5},
                       {.name = "q", .lower = -5, .upper = 5, .start = 0.2}};
  problem.objectives = {{{"f", "N", function({0, 1}, objective)}, sense, {}, {}}};
  return problem;
}

template <class Of>
Problem limited(Problem problem, Of limit, double upper) {
  problem.constraints = {{.response = {"g", "1", function({0, 1}, limit)}, .upper = upper}};
  return problem;
}

const auto kSum = [](const auto& u) { return u[0] + u[1]; };

/// The price of the limit, which how the optimum moves with the bound bears out.
double price(const std::function<Problem(double)>& of, double bound) {
  constexpr double kStep = 1e-3;
  const auto optimum = [&](double at) { return optimise(of(at)).found.assessment; };
  const Assessment found = optimum(bound);
  CHECK(found.verdict == Verdict::Certified);
  CHECK(found.kkt_residual <= 1e-7);
  const double gained = std::abs(optimum(bound + kStep).objective.value - found.objective.value);
  CHECK(found.limits.at(0).multiplier == Approx(gained / kStep).epsilon(1e-3));
  return found.limits.at(0).multiplier;
}

}  // namespace

TEST_CASE("prices at a kink are what easing gains", "[verdict][kinks]") {
  // Of |p - 1| + 2 |q - 2| where p + q <= b < 3: q stays 2 and p gives way, one for one.
  const auto distances = [](double b) {
    const auto f = [](const auto& u) { return size_of(u[0] - 1.0) + 2.0 * size_of(u[1] - 2.0); };
    return limited(square_box(f, Sense::Minimize), kSum, b);
  };
  CHECK(price(distances, 2) == Approx(1));
  // Of the lesser of p and 3 q: p = 3 q = 3 b / 4.
  const auto lesser = [](double b) {
    const auto f = [](const auto& u) { return lesser_of(u[0], 3.0 * u[1]); };
    return limited(square_box(f, Sense::Maximize), kSum, b);
  };
  CHECK(price(lesser, 2) == Approx(0.75));
  // The greater of 2 p + q and p + 3 q at most b: p = 2 q, q = b / 5, and p + q = 3 b / 5.
  const auto two_limits = [](double b) {
    const auto g = [](const auto& u) { return greater_of(2.0 * u[0] + u[1], u[0] + 3.0 * u[1]); };
    return limited(square_box(kSum, Sense::Maximize), g, b);
  };
  CHECK(price(two_limits, 3) == Approx(0.6));
  // Curved pieces: 1 / p^2 and 4 / q^2 are equal at q = 2 p, p = b / 3: 9 / b^2, of slope -18 /
  // b^3.
  const auto curved = [](double b) {
    const auto f = [](const auto& u) {
      return greater_of(1.0 / (u[0] * u[0]), 4.0 / (u[1] * u[1]));
    };
    Problem problem = limited(square_box(f, Sense::Minimize), kSum, b);
    for (Variable& v : problem.variables) v.lower = 0.2, v.start = 0.4;
    return problem;
  };
  CHECK(price(curved, 3) == Approx(18.0 / 27));
}

TEST_CASE("a kink that bends the other way has no pieces", "[verdict][kinks]") {
  const auto f = [](const auto& u) { return lesser_of(u[0], 3.0 * u[1]) + 0.0 * u[1]; };
  const Problem problem = square_box(f, Sense::Minimize);
  const Point x{0.75, 0.25};
  CHECK_FALSE(with_pieces_apart(problem, scales(problem, x), x));
  CHECK(kinked_name(problem, scales(problem, x), x) == "f");
  const Problem other = square_box(f, Sense::Maximize);
  CHECK(with_pieces_apart(other, scales(other, x), x));
}

TEST_CASE("prices that no small step bears out are none", "[verdict][prices]") {
  using std::sqrt;
  const auto root = [](const auto& u) {
    using std::sqrt;
    return sqrt(u[0] + 5.0) + 0.0 * u[1];
  };
  // At the edge of the formula's domain, a hair inside.
  Problem edge = square_box(root, Sense::Minimize);
  edge.variables[0].lower = -5 + 1e-13;
  const Point at_edge{-5 + 1e-13, 0};
  const Assessment a = assess(edge, scales(edge, edge.start()), at_edge, true);
  CHECK(a.kkt_residual <= 1e-7);
  CHECK(std::isnan(a.variables[0].multiplier));
  CHECK(why_no_price(edge, a, at_edge).find("lower bound of p") != std::string::npos);
  // A bound where the formula goes on has its price, 1 / (2 sqrt(4)).
  edge.variables[0].lower = -1;
  const Point inside{-1, 0};
  const Assessment b = assess(edge, scales(edge, edge.start()), inside, true);
  CHECK(b.variables[0].multiplier == Approx(0.25));
  CHECK(why_no_price(edge, b, inside).empty());
  // (p - 1)^2 = 0, beside p = 1.
  Problem flat = square_box(kSum, Sense::Minimize);
  const auto g = [](const auto& u) { return (u[0] - 1.0) * (u[0] - 1.0); };
  flat.constraints = {{.response = {"g", "1", function({0}, g)}, .lower = 0, .upper = 0}};
  const Point beside{1 - 1e-11, -5};
  const Assessment c = assess(flat, scales(flat, flat.start()), beside, true);
  CHECK(std::isnan(c.limits[0].multiplier));
}

TEST_CASE("an objective that has no bound is named", "[verdict][unbounded]") {
  using std::log;
  const auto pole = [](const auto& u) { return 1.0 / u[0] + 0.0 * u[1]; };
  const Problem far = square_box(pole, Sense::Minimize);
  CHECK(unbounded_words(far, Point{-1e-9, 0}) == "f seems to be unbounded near p = -1e-09");
  CHECK(unbounded_words(far, Point{-1, 0}).empty());
  Problem slow = square_box(pole, Sense::Minimize);
  slow.objectives[0].response.measure =
      function<Interval, Series<Interval, 2>>({0}, [](const auto& u) {
        using std::log;
        return log(u[0]);
      });
  slow.variables[0].lower = 0;
  CHECK(unbounded_words(slow, Point{1e-200, 0}) == "f seems to be unbounded near p = 1e-200");
  CHECK(unbounded_words(slow, Point{0.1, 0}).empty());
}

TEST_CASE("what makes an answer global is said as it was asked for", "[verdict]") {
  Problem problem = square_box(kSum, Sense::Maximize);
  problem.objectives[0].response.measure = function({0, 1}, kSum, Shape::Linear);
  CHECK(why_convex(problem) == "f is concave in the variables");
  problem.objectives[0].sense = Sense::Minimize;
  CHECK(why_convex(problem) == "f is convex in the variables");
}

TEST_CASE("a better design behind a pole is found", "[optimise]") {
  // Of 1 / q, with a limit on p alone: 1/5 where q > 0, without bound where q < 0.
  const auto pole = [](const auto& u) { return 1.0 / u[1] + 0.0 * u[0]; };
  const auto g = [](const auto& u) { return u[0] * u[0] * u[0] + u[0] + 0.0 * u[1]; };
  Problem problem = limited(square_box(pole, Sense::Minimize), g, -60);
  problem.variables[1].lower = -1;
  problem.variables[1].start = 1.5;
  CHECK(optimise(problem).found.assessment.objective.value < -1);
}

}  // namespace camlaw::optim::kinks_test
