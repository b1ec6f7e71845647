// SPDX-License-Identifier: MIT
#include "optim/problem/problem.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "numerics/scalar/interval.h"
#include "optim/cycle/scales.h"
#include "optim/problem/automatic_curve.h"
#include "optim/problem/check_derivatives.h"
#include "optim/problem/starts.h"

namespace camlaw::optim::problem_test {
namespace {

// Of plain numbers; those of other scalars are found by their arguments.
using std::exp;
using std::log;
using std::sin;
using std::sqrt;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
using Point = std::vector<double>;

/// u0 + u1 of a declared shape; only the declaration matters.
Function sum(Shape shape = Shape::Linear) {
  return function(
      {0, 1}, [](const auto& u) { return u[0] + u[1]; }, shape);
}

std::shared_ptr<const Curve> wave(Shape shape = Shape::Linear) {
  return curve(
      {0, 1}, 0, 3, [](const auto& u, const auto& angle) { return u[0] + u[1] * angle; }, shape);
}

/// Least "cost" = x + y over [0, 1]^2, where "load" <= 5.
Problem sound() {
  Problem problem;
  problem.variables = {{.name = "x", .lower = 0, .upper = 1, .start = 0.5},
                       {.name = "y", .lower = 0, .upper = 1, .start = 0.5}};
  problem.objectives = {{.response = {"cost", "N", sum()}}};
  problem.constraints = {{.response = {"load", "N", sum()}, .upper = 5}};
  return problem;
}

/// What check() says of a sound problem that was changed; empty where it says nothing.
std::string complaint(const std::function<void(Problem&)>& change) {
  Problem problem = sound();
  change(problem);
  try {
    problem.check();
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return {};
}

Objective of_curve(Part part, Sense sense, Shape shape = Shape::Linear) {
  return {{"cost", "N", wave(shape)}, sense, part, {}};
}

}  // namespace

TEST_CASE("a sound problem passes the check", "[optimise]") {
  CHECK(complaint([](Problem&) {}).empty());
  CHECK(complaint([](Problem& p) { p.variables[0].lower = p.variables[0].upper = 0.5; }).empty());
  CHECK(complaint([](Problem& p) { p.constraints[0].lower = 5; }).empty());
  CHECK(complaint([](Problem& p) {
          p.variables[0].integer = true;
          p.variables[1] = {.name = "y"};  // without bounds
        }).empty());
}

TEST_CASE("the check names a variable and what is wrong with it", "[optimise]") {
  CHECK(complaint([](Problem& p) { p.variables[0].lower = kNan; }) ==
        "variable 'x': a bound is not a number");
  CHECK(complaint([](Problem& p) { p.variables[1].lower = 2.5; }) ==
        "variable 'y': lower 2.5 exceeds upper 1");
  CHECK(complaint([](Problem& p) { p.variables[1].start = kNan; }) ==
        "variable 'y': its start is not a finite number");
  CHECK(complaint([](Problem& p) { p.variables[1].start = kInfinity; }) ==
        "variable 'y': its start is not a finite number");
  for (const double scale : {0.0, -1.0, kInfinity, kNan}) {
    CHECK(complaint([&](Problem& p) {
            p.variables[0].scale = scale;
          }).starts_with("variable 'x': scale "));
  }
  CHECK(complaint([](Problem& p) {
          p.variables[0].integer = true;
          p.variables[0].upper = kInfinity;
        }) == "variable 'x': an integer variable needs a lower and an upper bound");
}

TEST_CASE("the check refuses an integer variable that no integer lies between", "[optimise]") {
  const std::string words = complaint([](Problem& p) {
    p.variables[0].integer = true;
    p.variables[0].lower = 0.2;
    p.variables[0].upper = 0.8;
  });
  CHECK(words.starts_with("variable 'x': "));
}

TEST_CASE("the check refuses bounds that leave no number", "[optimise]") {
  const auto with = [](double lower, double upper) {
    return complaint([&](Problem& p) {
      p.variables[0].lower = lower;
      p.variables[0].upper = upper;
    });
  };
  CHECK(with(kInfinity, kInfinity).starts_with("variable 'x': "));
  CHECK(with(-kInfinity, -kInfinity).starts_with("variable 'x': "));
}

TEST_CASE("the check names a response that uses a variable that is not there", "[optimise]") {
  const auto third = [] { return function({0, 2}, [](const auto& u) { return u[0] * u[1]; }); };
  CHECK(complaint([&](Problem& p) { p.objectives[0].response.measure = third(); }) ==
        "response 'cost': it uses variable 2; there are 2");
  CHECK(complaint([&](Problem& p) { p.constraints[0].response.measure = third(); }) ==
        "response 'load': it uses variable 2; there are 2");
}

TEST_CASE("the check sees the inputs of curves too", "[optimise]") {
  const auto third = [] {
    return curve({0, 2}, 0, 3, [](const auto& u, const auto& a) { return u[0] + u[1] * a; });
  };
  CHECK(complaint([&](Problem& p) { p.constraints[0].response.measure = third(); }) ==
        "response 'load': it uses variable 2; there are 2");
}

TEST_CASE("the check names a constraint and what is wrong with it", "[optimise]") {
  CHECK(complaint([](Problem& p) { p.constraints[0].upper.reset(); }) ==
        "constraint on 'load': it needs a lower or an upper bound");
  for (const double bound : {kNan, kInfinity}) {
    CHECK(complaint([&](Problem& p) { p.constraints[0].upper = bound; }) ==
          "constraint on 'load': a bound is not a finite number");
    CHECK(complaint([&](Problem& p) { p.constraints[0].lower = -bound; }) ==
          "constraint on 'load': a bound is not a finite number");
  }
  CHECK(complaint([](Problem& p) { p.constraints[0].lower = 7; }) ==
        "constraint on 'load': lower 7 exceeds upper 5");
  CHECK(complaint([](Problem& p) {
          p.constraints[0].response.measure = wave();
          p.constraints[0].lower = 5;
        }) == "constraint on 'load': a curve cannot be held at one value over the whole cycle");
  for (const double tolerance : {0.0, -1.0, kInfinity, kNan}) {
    CHECK(complaint([&](Problem& p) {
            p.constraints[0].tolerance = tolerance;
          }).starts_with("constraint on 'load': tolerance "));
  }
}

TEST_CASE("the check refuses a constraint's scale that is not a positive number", "[optimise]") {
  for (const double scale : {0.0, -1.0, kInfinity, kNan}) {
    CHECK(complaint([&](Problem& p) {
            p.constraints[0].scale = scale;
          }).starts_with("constraint on 'load': scale "));
  }
}

TEST_CASE("the check refuses peaks that are asked for the wrong way", "[optimise]") {
  const auto words = [](Objective objective) {
    return complaint([&](Problem& p) { p.objectives = {objective}; });
  };
  CHECK(words(of_curve(Part::Highest, Sense::Minimize)).empty());
  CHECK(words(of_curve(Part::Magnitude, Sense::Minimize)).empty());
  CHECK(words(of_curve(Part::Lowest, Sense::Maximize)).empty());
  CHECK(words(of_curve(Part::Highest, Sense::Maximize)) ==
        "objective 'cost': a highest value can be minimised, not maximised");
  CHECK(words(of_curve(Part::Magnitude, Sense::Maximize)).starts_with("objective 'cost': "));
  CHECK(words(of_curve(Part::Lowest, Sense::Minimize)) ==
        "objective 'cost': a lowest value can be maximised, not minimised");
  CHECK(words(of_curve(Part::Value, Sense::Minimize)) ==
        "objective 'cost': a curve needs a part: highest, lowest or magnitude");
  CHECK(words({{"cost", "N", sum()}, Sense::Minimize, Part::Highest, {}}) ==
        "objective 'cost': a number has no highest or lowest part");
  CHECK(words({{"cost", "N", sum()}, Sense::Minimize, Part::Value, 0.0})
            .starts_with("objective 'cost': tolerance "));
}

TEST_CASE("a function's inputs must increase and it needs a kernel", "[optimise]") {
  const auto f = [](const auto& u) { return u[0]; };
  CHECK_THROWS_AS(function({1, 0}, f), std::invalid_argument);
  CHECK_THROWS_AS(function({1, 1}, f), std::invalid_argument);
  CHECK_THROWS_AS(Function({0}, nullptr), std::invalid_argument);
  CHECK(Function().value(Point{1, 2}) == 0);
  CHECK(variable_function(1).value(Point{1, 2}) == 2);
}

TEST_CASE("the start lies within the bounds, whole where it must be", "[optimise]") {
  Problem problem;
  problem.variables = {{.name = "below", .lower = 1, .upper = 2, .start = -7},
                       {.name = "above", .lower = 1, .upper = 2, .start = 7},
                       {.name = "inside", .lower = 1, .upper = 2, .start = 1.25},
                       {.name = "whole", .lower = 0, .upper = 9, .start = 3.6, .integer = true},
                       {.name = "edge", .lower = 0.5, .upper = 2.5, .start = 9, .integer = true},
                       {.name = "fixed", .lower = 4, .upper = 4, .start = 0}};
  CHECK(problem.start() == Point{1, 2, 1.25, 4, 2, 4});
}

TEST_CASE("which objectives have one valley", "[optimise]") {
  using S = Shape;
  const std::array shapes{S::General, S::Quasiconvex, S::Quasiconcave, S::Quasilinear,
                          S::Convex,  S::Concave,     S::Linear};
  const auto known = [&](Sense sense, Part part) {
    std::set<Shape> result;
    for (const Shape shape : shapes) {
      Problem problem = sound();
      problem.objectives = {of_curve(part, sense, shape)};
      if (part == Part::Value) problem.objectives[0].response.measure = sum(shape);
      if (!why_convex(problem)) continue;
      result.insert(shape);
      // Stationary points of a quasiconvex function may be no minima: it must slope.
      CHECK(needs_slope(problem) ==
            (shape == S::Quasiconvex || shape == S::Quasiconcave || shape == S::Quasilinear));
    }
    return result;
  };
  const std::set below{S::Convex, S::Linear, S::Quasiconvex, S::Quasilinear};
  const std::set above{S::Concave, S::Linear, S::Quasiconcave, S::Quasilinear};
  CHECK(known(Sense::Minimize, Part::Value) == below);
  CHECK(known(Sense::Maximize, Part::Value) == above);
  // Sets where the highest value is at most c are intersections of sets that are convex; where the
  // lowest is at least c, likewise; where |f| is at most c, both.
  CHECK(known(Sense::Minimize, Part::Highest) == below);
  CHECK(known(Sense::Maximize, Part::Lowest) == above);
  CHECK(known(Sense::Minimize, Part::Magnitude) == std::set{S::Linear, S::Quasilinear});
}

TEST_CASE("which limits leave a convex set", "[optimise]") {
  using S = Shape;
  const std::array shapes{S::General, S::Quasiconvex, S::Quasiconcave, S::Quasilinear,
                          S::Convex,  S::Concave,     S::Linear};
  const auto known = [&](std::optional<double> lower, std::optional<double> upper, bool on_curve) {
    std::set<Shape> result;
    for (const Shape shape : shapes) {
      Problem problem = sound();
      Constraint& c = problem.constraints[0];
      c.lower = lower;
      c.upper = upper;
      if (on_curve) {
        c.response.measure = wave(shape);
      } else {
        c.response.measure = sum(shape);
      }
      CHECK(convex_set(problem) == why_convex(problem).has_value());
      if (convex_set(problem)) result.insert(shape);
    }
    return result;
  };
  for (const bool on_curve : {false, true}) {
    CHECK(known({}, 1, on_curve) == std::set{S::Convex, S::Linear, S::Quasiconvex, S::Quasilinear});
    CHECK(known(1, {}, on_curve) ==
          std::set{S::Concave, S::Linear, S::Quasiconcave, S::Quasilinear});
    CHECK(known(0, 1, on_curve) == std::set{S::Linear, S::Quasilinear});
  }
  CHECK(known(1, 1, false) == std::set{S::Linear, S::Quasilinear});
}

TEST_CASE("the reason for convexity names the objective and speaks of limits where there are any",
          "[optimise]") {
  Problem problem = sound();
  REQUIRE(why_convex(problem));
  CHECK(why_convex(problem)->find("cost") != std::string::npos);
  CHECK(why_convex(problem)->find("feasible set") != std::string::npos);
  problem.constraints.clear();
  CHECK(why_convex(problem)->find("feasible set") == std::string::npos);
}

TEST_CASE("typical changes: as stated, else the range, else the size of the start", "[optimise]") {
  Problem problem;
  problem.variables = {{.name = "a", .lower = 2, .upper = 5, .scale = 0.25},
                       {.name = "b", .lower = 2, .upper = 5},
                       {.name = "c", .lower = 0, .start = -40},
                       {.name = "d", .start = 0.01},
                       {.name = "e", .lower = 7, .upper = 7, .start = 7}};
  CHECK(variable_scales(problem) == Point{0.25, 3, 40, 1, 7});
}

TEST_CASE("scales follow from typical changes, tolerances from bounds", "[optimise]") {
  Problem problem;
  problem.variables = {{.name = "x", .lower = 0, .upper = 2, .start = 1},
                       {.name = "y", .lower = 0, .upper = 1, .start = 1}};
  const auto linear = [](double a, double b) {
    return function({0, 1}, [=](const auto& u) { return a * u[0] + b * u[1]; });
  };
  problem.objectives = {{.response = {"cost", "N", linear(3, 4)}}};
  problem.constraints = {
      {.response = {"wide", "N", linear(10, -30)}, .upper = 5},
      {.response = {"flat", "N", linear(1e-9, 0)}, .lower = -50, .upper = 20},
      {.response = {"zero", "N", linear(1, 7)}, .upper = 0},
      {.response = {"told", "N", linear(1, 1)}, .upper = 3, .tolerance = 0.5, .scale = 11},
      {.response = {"dead", "N", Function()}, .upper = 0}};
  const Scales s = scales(problem, problem.start());
  CHECK(s.variables == Point{1, 1});             // their own magnitudes, whatever the box
  CHECK(s.objective == 4);                       // of 3 * 1 and 4 * 1 the larger
  CHECK(s.objective_tolerance == Approx(7e-7));  // of the value
  CHECK(s.objective_typical == 4);
  REQUIRE(s.constraints.size() == 5);
  CHECK(s.constraints[0].scale == 30);
  CHECK(s.constraints[0].tolerance == Approx(5e-6));
  CHECK(s.constraints[1].scale == Approx(0.05));  // no less than 1e-3 of the larger bound
  CHECK(s.constraints[1].tolerance == Approx(5e-5));
  CHECK(s.constraints[2].scale == 7);
  CHECK(s.constraints[2].tolerance == Approx(8e-6));  // of what the variables contribute
  CHECK(s.constraints[3].scale == 11);
  CHECK(s.constraints[3].tolerance == 0.5);
  CHECK(s.constraints[4].scale == 1);
}

TEST_CASE("a wider box changes neither scales nor tolerances", "[optimise]") {
  Problem problem;
  problem.variables = {{.name = "x", .lower = 5, .upper = 40, .start = 20},
                       {.name = "near zero", .lower = -2, .upper = 2, .start = 1e-9}};
  const auto f = [](const auto& u) { return u[0] * u[0] - 400.0 + u[1]; };
  problem.objectives = {{.response = {"cost", "N", function({0, 1}, f)}}};
  problem.constraints = {{.response = {"zero", "N", function({0, 1}, f)}, .upper = 0}};
  const Point x{20, 1e-9};
  const Scales narrow = scales(problem, x);
  CHECK(narrow.own == Point{20, 1});
  CHECK(narrow.constraints[0].tolerance == Approx(1e-6 * (40 * 20 + 1)));
  for (Variable& v : problem.variables) v.lower -= 1e6, v.upper += 1e6;
  const Scales wide = scales(problem, x);
  CHECK(wide.own == narrow.own);
  CHECK(wide.variables == narrow.variables);
  CHECK(wide.constraints[0].tolerance == narrow.constraints[0].tolerance);
  CHECK(wide.objective_tolerance == Approx(narrow.objective_tolerance).epsilon(0.1));
}

TEST_CASE("a start unlike all other designs does not make the scales", "[optimise]") {
  Problem problem;
  problem.variables = {{.name = "r", .lower = 1e-4, .upper = 10, .start = 1e-4}};
  problem.objectives = {{.response = {"steep", "N", function({0}, [](const auto& u) {
                                        return 1.0 / (u[0] * u[0] * u[0]);
                                      })}}};
  const Scales steep = scales(problem, problem.start());  // the slope at the start: 3e17
  CHECK(steep.objective <= 100 * steep.objective_typical);
  CHECK(steep.objective_typical < 1000);
  problem.variables = {{.name = "x", .lower = -1, .upper = 3, .start = 1}};
  problem.objectives = {{.response = {"level", "N", function({0}, [](const auto& u) {
                                        return (u[0] - 1.0) * (u[0] - 1.0);
                                      })}}};
  const Scales level = scales(problem, problem.start());  // the slope at the start: 0
  CHECK(level.objective > 0.1);
  // What is fixed does not count.
  problem.variables.push_back({.name = "load", .lower = 5, .upper = 5, .start = 5});
  problem.objectives[0].response.measure = function(
      {0, 1}, [](const auto& u) { return 3.0 * u[0] + 1e9 * u[1]; }, Shape::Linear);
  CHECK(scales(problem, problem.start()).objective == 3);
}

TEST_CASE("scales are finite where derivatives are not", "[optimise]") {
  Problem problem;
  problem.variables = {{.name = "x", .lower = 0, .upper = 1, .start = 0}};
  problem.objectives = {
      {.response = {"root", "1", function({0}, [](const auto& u) { return sqrt(u[0]); })}}};
  // 1 / (2 sqrt(x)) at eight places of [0, 1].
  CHECK(scales(problem, problem.start()).objective == Approx(0.75).margin(0.25));
  problem.objectives[0].response.measure =
      function({0}, [](const auto& u) { return log(u[0] - 2.0); });
  CHECK(std::isfinite(scales(problem, problem.start()).objective));
}

TEST_CASE("the value of each part of a curve", "[optimise]") {
  // u0 + u1 a over [0, 3] at u = (1, -2): from 1 down to -5.
  const Point x{1, -2};
  CHECK(objective_value(of_curve(Part::Highest, Sense::Minimize), x) == 1);
  CHECK(objective_value(of_curve(Part::Lowest, Sense::Maximize), x) == -5);
  CHECK(objective_value(of_curve(Part::Magnitude, Sense::Minimize), x) == 5);
  CHECK(objective_value({{"cost", "N", sum()}, Sense::Minimize, Part::Value, {}}, x) == -1);
}

TEST_CASE("the first start is the problem's own, and all lie inside the box", "[optimise]") {
  Problem problem = sound();
  problem.variables[0].start = 0.125;
  problem.variables[1].lower = -3;
  const auto points = starts(problem, 100, 5);
  REQUIRE(points.size() == 100);
  CHECK(points.front() == problem.start());
  for (const Point& x : points) {
    REQUIRE(x.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
      CHECK(x[i] >= problem.variables[i].lower);
      CHECK(x[i] <= problem.variables[i].upper);
    }
  }
  CHECK(starts(problem, 1, 5).size() == 1);
}

TEST_CASE("starts fill the box evenly", "[optimise]") {
  // N points of van der Corput's sequence leave every share [0, a) its N a right to
  // log2(N) / 3 + 1 in base 2 and about as much in base 3 (Niederreiter 1992, theorem 3.6). A slice
  // of the shifted sequence is the difference of two such shares, or what one leaves; the point of
  // index 0 is missing: 2 (8 / 3 + 1) + 1 < 9 for 255 points.
  const auto points = starts(sound(), 256, 9);
  std::array<std::array<int, 8>, 2> slices{};
  std::array<int, 16> cells{};
  for (std::size_t n = 1; n < points.size(); ++n) {
    for (std::size_t i = 0; i < 2; ++i) ++slices[i][static_cast<std::size_t>(8 * points[n][i])];
    ++cells[static_cast<std::size_t>(4 * points[n][0]) * 4 +
            static_cast<std::size_t>(4 * points[n][1])];
  }
  for (const auto& slice : slices) {
    for (const int count : slice) CHECK(std::abs(count - 32) <= 8);
  }
  // In the plane no bound as narrow is known. Of random points every third draw would leave some
  // cell outside 8 to 24.
  for (const int count : cells) CHECK(std::abs(count - 16) <= 8);
}

TEST_CASE("starts fill a box with bounds also where typical changes are small", "[optimise]") {
  Problem problem = sound();
  for (Variable& v : problem.variables) v.scale = 1e-3;
  double lowest = 1, highest = 0;
  for (const Point& x : starts(problem, 64, 1)) {
    lowest = std::min(lowest, x[0]);
    highest = std::max(highest, x[0]);
  }
  CHECK(lowest < 0.1);
  CHECK(highest > 0.9);
}

TEST_CASE("the seed moves all starts but the first, and equal seeds give equal bits",
          "[optimise]") {
  const auto one = starts(sound(), 20, 1), again = starts(sound(), 20, 1),
             two = starts(sound(), 20, 2);
  CHECK(one == again);
  CHECK(one[0] == two[0]);
  for (std::size_t n = 1; n < one.size(); ++n) {
    CHECK(one[n][0] != two[n][0]);
    CHECK(one[n][1] != two[n][1]);
  }
}

TEST_CASE("fixed and integer variables keep their start", "[optimise]") {
  Problem problem = sound();
  problem.variables.push_back({.name = "n", .lower = 0, .upper = 9, .start = 3.2, .integer = true});
  problem.variables.push_back({.name = "c", .lower = 2.5, .upper = 2.5, .start = 2.5});
  for (const Point& x : starts(problem, 30, 4)) {
    CHECK(x[2] == 3);
    CHECK(x[3] == 2.5);
  }
}

TEST_CASE("a side without a bound reaches ten typical changes from the start", "[optimise]") {
  Problem problem;
  problem.variables = {{.name = "free", .start = 5, .scale = 2},
                       {.name = "half", .lower = 4, .start = 5, .scale = 2}};
  double lowest = kInfinity, highest = -kInfinity, least_half = kInfinity;
  for (const Point& x : starts(problem, 200, 1)) {
    lowest = std::min(lowest, x[0]);
    highest = std::max(highest, x[0]);
    least_half = std::min(least_half, x[1]);
    CHECK(x[1] <= 25);
  }
  CHECK(lowest >= -15);
  CHECK(lowest < -14);
  CHECK(highest <= 25);
  CHECK(highest > 24);
  CHECK(least_half >= 4);
  CHECK(least_half < 4.5);
}

TEST_CASE("derivatives of one to nine inputs equal the closed forms", "[optimise]") {
  // s^3 with s = sum (i + 1) u_i, and the product of all u_i: one dense Hessian with, one without
  // a diagonal.
  for (std::size_t n = 1; n <= 9; ++n) {
    INFO(n << " inputs");
    std::vector<std::size_t> inputs(n);
    std::iota(inputs.begin(), inputs.end(), std::size_t{0});
    Point u;
    for (std::size_t i = 0; i < n; ++i) u.push_back(0.5 + 0.25 * static_cast<double>(i % 4));
    const Function cube = function(inputs, [](const auto& v) {
      auto s = v[0];
      for (std::size_t i = 1; i < v.size(); ++i) s = s + static_cast<double>(i + 1) * v[i];
      return s * s * s;
    });
    const Function product = function(inputs, [](const auto& v) {
      auto p = v[0];
      for (std::size_t i = 1; i < v.size(); ++i) p = p * v[i];
      return p;
    });
    double s = 0, p = 1;
    for (std::size_t i = 0; i < n; ++i) s += static_cast<double>(i + 1) * u[i], p *= u[i];
    Point g(n), first(n), h(packed_size(n));
    CHECK(cube.value(u) == Approx(s * s * s).epsilon(1e-14));
    CHECK(cube.gradient(u, first) == Approx(s * s * s).epsilon(1e-14));
    CHECK(cube.hessian(u, g, h) == Approx(s * s * s).epsilon(1e-14));
    for (std::size_t i = 0; i < n; ++i) {
      const auto a = static_cast<double>(i + 1);
      CHECK(first[i] == Approx(3 * s * s * a).epsilon(1e-14));
      CHECK(g[i] == Approx(3 * s * s * a).epsilon(1e-14));
      for (std::size_t j = 0; j <= i; ++j) {
        const auto b = static_cast<double>(j + 1);
        CHECK(h[packed(i, j)] == Approx(6 * s * a * b).epsilon(1e-14));
      }
    }
    CHECK(product.gradient(u, first) == Approx(p).epsilon(1e-14));
    CHECK(product.hessian(u, g, h) == Approx(p).epsilon(1e-14));
    for (std::size_t i = 0; i < n; ++i) {
      CHECK(first[i] == Approx(p / u[i]).epsilon(1e-14));
      CHECK(g[i] == Approx(p / u[i]).epsilon(1e-14));
      for (std::size_t j = 0; j < i; ++j) {
        CHECK(h[packed(i, j)] == Approx(p / (u[i] * u[j])).epsilon(1e-14));
      }
      CHECK(h[packed(i, i)] == 0);
    }
  }
}

TEST_CASE("a function of no inputs is a constant with enclosure", "[optimise]") {
  const Function seven = function<Interval>({}, [](const auto& u) {
    using T = std::remove_cvref_t<decltype(u[0])>;
    return constant<T>(7);
  });
  Point none;
  CHECK(seven.value(Point{1, 2}) == 7);
  CHECK(seven.gradient(Point{1, 2}, none) == 7);
  CHECK(seven.hessian(Point{1, 2}, none, none) == 7);
  CHECK(seven.enclose(Point{1, 2}).lower == 7);
  CHECK(seven.enclose(Point{1, 2}).upper == 7);
}

TEST_CASE("a formula with an interval type encloses its value, without one nothing", "[optimise]") {
  const auto f = [](const auto& u) { return sin(u[0]) * u[1] + 1.0; };
  const Point x{1, 0, 0.1};
  const double value = std::sin(1.0) * 0.1 + 1;
  const Bounds bounds = function<Interval>({0, 2}, f).enclose(x);
  CHECK(bounds.lower <= value);
  CHECK(bounds.upper >= value);
  CHECK(bounds.upper - bounds.lower < 1e-14);
  CHECK(std::isinf(function({0, 2}, f).enclose(x).upper));
}

namespace {

/// x y with a derivative that is wrong by 0.5: that by y, or the mixed second one.
class WrongProduct final : public Kernel {
 public:
  WrongProduct(double first, double second) : first_(first), second_(second) {}
  double value(std::span<const double> u) const override { return u[0] * u[1]; }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    g[0] = u[1];
    g[1] = u[0] + first_;
    return value(u);
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    gradient(u, g);
    h[packed(0, 0)] = h[packed(1, 1)] = 0;
    h[packed(1, 0)] = 1 + second_;
    return value(u);
  }

 private:
  double first_, second_;
};

/// A curve whose functions at each place are the given one.
class CurveOf final : public Curve {
 public:
  explicit CurveOf(Function f) : f_(std::move(f)) {}
  Function at(Place) const override { return f_; }
  std::unique_ptr<Trace> trace(Design x) const override { return wave()->trace(x); }
  Shape shape() const override { return f_.shape(); }

 private:
  Function f_;
};

Function wrong_product(double first, double second) {
  return Function({0, 1}, std::make_shared<WrongProduct>(first, second));
}

Problem with_load(Function load) {
  Problem problem = sound();
  problem.constraints[0].response.measure = std::move(load);
  return problem;
}

}  // namespace

TEST_CASE("a curve knows how its slope changes with each design variable", "[optimise]") {
  // u0 sin(u1 a): by the angle u0 u1 cos(u1 a); of that the derivatives by u0 and u1.
  const auto c = curve({0, 2}, 0, 6,
                       [](const auto& u, const auto& angle) { return u[0] * sin(u[1] * angle); });
  const Point x{2, 77, 0.5};
  const double a = 1.3, r = 0.5 * a;
  CHECK(c->at({a}).value(x) == Approx(2 * std::sin(r)).epsilon(1e-14));
  const Point slope = c->slope_gradient({a}, x);
  REQUIRE(slope.size() == 3);
  CHECK(slope[0] == Approx(0.5 * std::cos(r)).epsilon(1e-14));
  CHECK(slope[1] == 0);
  CHECK(slope[2] == Approx(2 * (std::cos(r) - r * std::sin(r))).epsilon(1e-14));
  CHECK(CurveOf(sum()).slope_gradient({a}, x).empty());  // unless it says so, it does not know
}

TEST_CASE("right derivatives agree with differences, at bounds too", "[optimise]") {
  Problem problem = sound();
  problem.objectives[0].response.measure = function(
      {0, 1}, [](const auto& u) { return exp(u[0]) * sin(3.0 * u[1]) + u[0] * u[0] * u[0]; });
  problem.constraints.push_back({.response = {"wave", "N",
                                              curve({0, 1}, 0, 2,
                                                    [](const auto& u, const auto& angle) {
                                                      return u[0] * sin(angle) * u[1] + u[1] * u[1];
                                                    })},
                                 .upper = 1});
  for (const Point& x : {Point{0.3, 0.6}, Point{0, 0}, Point{1, 1}, Point{0, 1}}) {
    const DerivativeCheck check = check_derivatives(problem, x);
    INFO(check.worst.response << " by " << check.worst.variable << " " << check.worst.second);
    CHECK(check.agrees);
    CHECK(check.worst.error <= kDerivativeTolerance);
    CHECK(check.shapes.empty());
    // Objective, load, and the curve at two places or more: 2 first and 3 second derivatives each.
    CHECK(check.entries >= 20);
    CHECK(check.entries % 5 == 0);
  }
}

TEST_CASE("right derivatives agree where value and gradient vanish", "[optimise]") {
  Problem problem = sound();
  for (Variable& v : problem.variables) v.lower = -1;
  problem.objectives[0].response.measure =
      function({0, 1}, [](const auto& u) { return u[0] * u[0] + u[0] * u[1] - u[1] * u[1]; });
  CHECK(check_derivatives(problem, Point{0, 0}).agrees);
  problem.objectives[0].response.measure = function({0}, [](const auto& u) { return 0.0 * u[0]; });
  CHECK(check_derivatives(problem, Point{0, 0}).agrees);
}

TEST_CASE("a wrong first derivative is found and named", "[optimise]") {
  const DerivativeCheck check =
      check_derivatives(with_load(wrong_product(0.5, 0)), Point{0.4, 0.7});
  CHECK_FALSE(check.agrees);
  CHECK(check.worst.response == "load");
  CHECK(check.worst.variable == "y");
  CHECK(check.worst.second.empty());
  CHECK_FALSE(check.worst.angle);
  CHECK(check.worst.exact == Approx(0.9));
  CHECK(check.worst.difference == Approx(0.4).epsilon(1e-9));
}

TEST_CASE("a wrong second derivative is found and both variables are named", "[optimise]") {
  const DerivativeCheck check =
      check_derivatives(with_load(wrong_product(0, 0.5)), Point{0.4, 0.7});
  CHECK_FALSE(check.agrees);
  CHECK(check.worst.response == "load");
  CHECK(std::set{check.worst.variable, check.worst.second} == std::set<std::string>{"x", "y"});
  CHECK(check.worst.exact == Approx(1.5));
  CHECK(check.worst.difference == Approx(1).epsilon(1e-9));
}

TEST_CASE("a wrong derivative of a curve is found with its angle", "[optimise]") {
  Problem problem = sound();
  problem.constraints[0].response.measure = std::make_shared<const CurveOf>(wrong_product(0.5, 0));
  const DerivativeCheck check = check_derivatives(problem, Point{0.4, 0.7});
  CHECK_FALSE(check.agrees);
  CHECK(check.worst.response == "load");
  CHECK(check.worst.variable == "y");
  REQUIRE(check.worst.angle);
  CHECK(*check.worst.angle > 0);
  CHECK(*check.worst.angle < 3);
}

TEST_CASE("a derivative that is not a number does not agree", "[optimise]") {
  const DerivativeCheck check =
      check_derivatives(with_load(wrong_product(kNan, 0)), Point{0.4, 0.7});
  CHECK_FALSE(check.agrees);
  CHECK(check.worst.response == "load");
}

TEST_CASE("a declared shape that does not hold is found, one that holds is not", "[optimise]") {
  using S = Shape;
  const auto found = [](const auto& f, Shape shape) {
    const Problem problem = with_load(function({0, 1}, f, shape));
    const DerivativeCheck check = check_derivatives(problem, Point{0.4, 0.7});
    for (const std::string& words : check.shapes) CHECK(words.find("load") != std::string::npos);
    return !check.shapes.empty();
  };
  const auto bowl = [](const auto& u) { return u[0] * u[0] + u[1] * u[1]; };
  CHECK_FALSE(found(bowl, S::General));
  CHECK_FALSE(found(bowl, S::Convex));
  CHECK_FALSE(found(bowl, S::Quasiconvex));
  for (const Shape wrong : {S::Concave, S::Linear, S::Quasiconcave, S::Quasilinear}) {
    CHECK(found(bowl, wrong));
  }
  const auto plane = [](const auto& u) { return 2.0 * u[0] - u[1]; };
  for (const Shape right :
       {S::Convex, S::Concave, S::Linear, S::Quasiconvex, S::Quasiconcave, S::Quasilinear}) {
    CHECK_FALSE(found(plane, right));
  }
  // Beyond a line it has no value, which says nothing; with a hole its designs are not convex.
  const auto cut = [&](const auto& u) { return plane(u) + 0.0 * sqrt(u[0] + u[1] - 0.5); };
  CHECK_FALSE(found(cut, S::Linear));
  const auto holed = [&](const auto& u) {
    return plane(u) + 0.0 * sqrt((u[0] - 0.5) * (u[0] - 0.5) + (u[1] - 0.5) * (u[1] - 0.5) - 0.04);
  };
  CHECK(found(holed, S::Linear));
  // (x - 1) / (y + 1), y >= 0: linear over positive linear, neither convex nor concave.
  const auto quotient = [](const auto& u) { return (u[0] - 1.0) / (u[1] + 1.0); };
  CHECK_FALSE(found(quotient, S::Quasilinear));
  CHECK(found(quotient, S::Linear));
  const auto saddle = [](const auto& u) { return u[0] * u[1]; };
  for (const Shape wrong : {S::Convex, S::Concave, S::Linear, S::Quasiconvex, S::Quasilinear}) {
    CHECK(found(saddle, wrong));
  }
  // On the positive quadrant x y is quasiconcave: log x + log y is concave.
  CHECK_FALSE(found(saddle, S::Quasiconcave));
}

TEST_CASE("shapes and their opposites", "[optimise]") {
  using S = Shape;
  for (const Shape shape : {S::General, S::Quasiconvex, S::Quasiconcave, S::Quasilinear, S::Convex,
                            S::Concave, S::Linear}) {
    CHECK(negated(negated(shape)) == shape);
    CHECK(is_convex(negated(shape)) == is_concave(shape));
    CHECK(convex_below(negated(shape)) == convex_above(shape));
  }
}

}  // namespace camlaw::optim::problem_test
