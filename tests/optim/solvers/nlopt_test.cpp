// SPDX-License-Identifier: MIT
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

#include "optim/problem/automatic.h"
#include "optim/solvers/solver.h"

namespace camlaw::optim::nlopt_test {
namespace {

// Of plain numbers; those of other scalars are found by their arguments.
using std::cos;
using std::log;
using std::sqrt;

using Names = std::vector<std::string>;

const Names kLocal{"slsqp",        "mma",    "ccsaq",  "lbfgs",
                   "auglag-lbfgs", "cobyla", "bobyqa", "auglag-bobyqa"};
const Names kGlobal{"direct-l", "crs2", "isres", "esch", "mlsl", "ags"};

const Solver& method(const std::string& name) {
  const auto& all = nlopt_solvers();
  return **std::find_if(all.begin(), all.end(), [&](auto* s) { return s->name() == name; });
}

bool takes(const std::string& name, const Program& program) {
  return !method(name).refusal(program);
}

/// The names of `list` that take the program.
Names taking(const Program& program, const Names& list) {
  Names result;
  std::copy_if(list.begin(), list.end(), std::back_inserter(result),
               [&](const std::string& name) { return takes(name, program); });
  return result;
}

Names all() {
  Names names = kLocal;
  names.insert(names.end(), kGlobal.begin(), kGlobal.end());
  return names;
}

std::vector<ProgramColumn> box(double lower, double upper, std::vector<double> start,
                               double scale = 1) {
  std::vector<ProgramColumn> columns;
  for (const double s : start) columns.push_back({lower, upper, s, scale});
  return columns;
}

double square(double v) { return v * v; }

// The problems as plain formulas, to check answers by other code than the program's.

double valley(double a, double b) { return square(1 - a) + 100 * square(b - a * a); }

Function valley_function() {
  return function({0, 1}, [](const auto& u) {
    const auto a = 1.0 - u[0];
    const auto b = u[1] - u[0] * u[0];
    return a * a + 100.0 * b * b;
  });
}

Function sum() {
  return function(
      {0, 1}, [](const auto& u) { return u[0] + u[1]; }, Shape::Linear);
}

Function squares() {
  return function({0, 1}, [](const auto& u) { return u[0] * u[0] + u[1] * u[1]; });
}

/// Squared distance to (2, 1).
Function distance() {
  return function({0, 1}, [](const auto& u) {
    return (u[0] - 2.0) * (u[0] - 2.0) + (u[1] - 1.0) * (u[1] - 1.0);
  });
}

Program rosenbrock(double half = 2) {
  return Program(box(-half, half, {-1.2, 1}), valley_function(), 1, 1, {});
}

/// Nearest to (2, 1) under a line and inside a parabola: both hold with equality at (1, 1), where
/// the distance squared is 1. The multipliers are 2/3 and 2/3.
Program corner(std::vector<double> start = {0, 0}) {
  const Function parabola = function(
      {0, 1}, [](const auto& u) { return u[0] * u[0] - u[1]; }, Shape::Convex);
  return Program(box(-5, 5, start), distance(), 1, 1,
                 {{.function = sum(), .upper = 2}, {.function = parabola, .upper = 0}});
}

/// Nearest to (2, 1) on the unit circle: (2, 1) / sqrt(5), at the distance sqrt(5) - 1.
Program circle() {
  return Program(box(-5, 5, {0.3, -0.7}), distance(), 1, 1,
                 {{.function = squares(), .lower = 1, .upper = 1}});
}

/// 10 (1 - cos(2 pi x)) + x^2 in each variable: many valleys, the deepest at 0.
Program rastrigin() {
  const double turn = 2 * std::acos(-1.0);
  const Function f = function({0, 1}, [turn](const auto& u) {
    return 20.0 + u[0] * u[0] + u[1] * u[1] - 10.0 * (cos(turn * u[0]) + cos(turn * u[1]));
  });
  return Program(box(-5.12, 4, {3, 2.5}), f, 1, 10, {});
}

/// Nearest to (0, 1) with a model that is undefined for x < 0.5.
Program cliff() {
  const Function f = function({0, 1}, [](const auto& u) {
    return 0.0 * sqrt(u[0] - 0.5) + u[0] * u[0] + (u[1] - 1.0) * (u[1] - 1.0);
  });
  return Program(box(-5, 5, {3, 3}), f, 1, 1, {});
}

bool claims_success(const Solution& s) {
  return s.status == Status::Solved || s.status == Status::Acceptable;
}

TEST_CASE("NLopt offers each method under its name, local or global", "[nlopt]") {
  Names names;
  for (const Solver* solver : nlopt_solvers()) names.push_back(solver->name());
  Names expected = all();
  std::sort(names.begin(), names.end());
  std::sort(expected.begin(), expected.end());
  CHECK(names == expected);
  for (const auto& name : kLocal) CHECK_FALSE(method(name).is_global());
  for (const auto& name : kGlobal) CHECK(method(name).is_global());
}

TEST_CASE("local methods go down Rosenbrock's valley", "[nlopt]") {
  // The valley's floor rises with 0.2 square(step): an objective of 1e-15 leaves 1e-7 in x.
  const std::map<std::string, double> bounds{
      {"slsqp", 1e-20},        {"mma", 1e-10},    {"ccsaq", 1e-10},  {"lbfgs", 1e-18},
      {"auglag-lbfgs", 1e-18}, {"cobyla", 1e-11}, {"bobyqa", 1e-18}, {"auglag-bobyqa", 1e-18}};
  for (const auto& name : kLocal) {
    CAPTURE(name);
    const Solution s = method(name).solve(rosenbrock(), {});
    CAPTURE(s.message);
    CHECK(s.status == Status::Solved);
    CHECK(valley(s.y.at(0), s.y.at(1)) < bounds.at(name));
  }
}

TEST_CASE("local methods work in a box without walls", "[nlopt]") {
  for (const char* name : {"slsqp", "lbfgs", "auglag-lbfgs", "bobyqa", "auglag-bobyqa"}) {
    CAPTURE(name);
    const Solution s = method(name).solve(rosenbrock(kInfinity), {});
    CHECK(s.status == Status::Solved);
    CHECK(valley(s.y.at(0), s.y.at(1)) < 1e-18);
  }
}

TEST_CASE("local methods meet two rows at once in a corner", "[nlopt]") {
  const Names names = taking(corner(), kLocal);
  CHECK(names == Names{"slsqp", "mma", "ccsaq", "auglag-lbfgs", "cobyla", "auglag-bobyqa"});
  for (const auto& name : names) {
    CAPTURE(name);
    const Solution s = method(name).solve(corner(), {});
    CAPTURE(s.message);
    CHECK(s.status == Status::Solved);
    const double a = s.y.at(0), b = s.y.at(1);
    // Rows hold to the tolerance 1e-9, which the multipliers turn into 1.4e-9 of the objective.
    CHECK(a + b <= 2 + 1e-9);
    CHECK(a * a - b <= 1e-9);
    CHECK(square(a - 2) + square(b - 1) == Approx(1).margin(1e-8).epsilon(0));
  }
}

TEST_CASE("local methods that take equations find the nearest point of a circle", "[nlopt]") {
  const Names names = taking(circle(), kLocal);
  CHECK(names == Names{"slsqp", "auglag-lbfgs", "cobyla", "auglag-bobyqa"});
  for (const auto& name : names) {
    CAPTURE(name);
    const Solution s = method(name).solve(circle(), {});
    CHECK(s.status == Status::Solved);
    CHECK(std::abs(square(s.y.at(0)) + square(s.y.at(1)) - 1) <= 1e-9);
    // An error e along the circle costs sqrt(5) e^2: what has no gradients sees about 1e-5.
    CHECK(s.y.at(0) == Approx(2 / std::sqrt(5.0)).margin(1e-4).epsilon(0));
    CHECK(square(s.y.at(0) - 2) + square(s.y.at(1) - 1) ==
          Approx(square(std::sqrt(5.0) - 1)).margin(1e-8).epsilon(0));
  }
}

TEST_CASE("a row with two bounds keeps both, and a sign of -1 maximises", "[nlopt]") {
  const Row ring{.function = squares(), .lower = 1, .upper = 2};
  const Program most(box(-3, 3, {0.5, 0.9}), sum(), -1, 1, {ring});
  const Program nearest(box(-3, 3, {1.2, 0.3}), squares(), 1, 1, {ring});
  for (const auto& name : taking(most, kLocal)) {
    CAPTURE(name);
    const Solution top = method(name).solve(most, {});
    CHECK(top.y.at(0) + top.y.at(1) == Approx(2).margin(1e-8).epsilon(0));
    const Solution rim = method(name).solve(nearest, {});
    CHECK(square(rim.y.at(0)) + square(rim.y.at(1)) == Approx(1).margin(2e-9).epsilon(0));
  }
}

TEST_CASE("a fixed column and an auxiliary variable stand in their places", "[nlopt]") {
  // The least t with t >= (x - 1)^2 and t >= (x + k)^2, k = 1 fixed: t = 1 at x = 0.
  const std::vector<ProgramColumn> columns{{-4, 4, 3, 2}, {1, 1, 1, 1}, {0, 100, 50, 5}};
  const std::pair<std::size_t, double> minus_t{2, -1.0};
  const Function right = function({0}, [](const auto& u) { return (u[0] - 1.0) * (u[0] - 1.0); });
  const Function left =
      function({0, 1}, [](const auto& u) { return (u[0] + u[1]) * (u[0] + u[1]); });
  const Program program(columns, variable_function(2), 1, 1,
                        {{.function = right, .upper = 0, .size = 3, .auxiliary = minus_t},
                         {.function = left, .upper = 0, .size = 7, .auxiliary = minus_t}});
  for (const auto& name : taking(program, kLocal)) {
    CAPTURE(name);
    const Solution s = method(name).solve(program, {});
    CHECK(claims_success(s));
    const std::vector<double> x = program.design(s.y);
    CHECK(x.at(2) == Approx(1).margin(1e-6).epsilon(0));
    CHECK(std::max(square(x.at(0) - 1), square(x.at(0) + 1)) <= x.at(2) + 1e-8);
  }
}

TEST_CASE("a Lagrangian gets away from an infeasible start where the objective is zero",
          "[nlopt]") {
  // NLopt would take its first penalty from the objective: next to nothing.
  const Program program(box(-5, 5, {2, 1}), distance(), 1, 1,
                        {{.function = squares(), .lower = 1, .upper = 1}});
  for (const char* name : {"auglag-lbfgs", "auglag-bobyqa"}) {
    CAPTURE(name);
    const Solution s = method(name).solve(program, {.max_evaluations = 5000});
    CHECK(s.status == Status::Solved);
    CHECK(program.objective(s.y) == Approx(square(std::sqrt(5.0) - 1)).margin(1e-8).epsilon(0));
  }
}

TEST_CASE("an end within rounding of the rows is preferred to a poorer feasible point", "[nlopt]") {
  // To this tolerance mma's end is infeasible (by 6e-13), and the best feasible point is 2e-5
  // worse.
  const Solution s = method("mma").solve(corner({0, 0.5}), {.tolerance = 1e-13});
  CHECK(square(s.y.at(0) - 2) + square(s.y.at(1) - 1) == Approx(1).margin(1e-9).epsilon(0));
  CHECK(s.status == Status::Acceptable);
}

TEST_CASE("a variable may enter a row twice, by its function and beside it", "[nlopt]") {
  const Function f = function({0, 1}, [](const auto& u) { return u[0] * u[0] + u[1]; });
  const std::pair<std::size_t, double> minus_four{0, -4.0};  // square(x - 2) + y <= 3
  const Program program(box(-5, 5, {2, 1}), sum(), -1, 1,
                        {{.function = f, .upper = -1, .size = 2, .auxiliary = minus_four}});
  for (const char* name : {"slsqp", "mma", "ccsaq", "auglag-lbfgs"}) {
    CAPTURE(name);  // x + y is greatest at x - 2 = 1/2, y = 3 - 1/4
    const Solution s = method(name).solve(program, {});
    CHECK(claims_success(s));
    CHECK(s.y.at(0) + s.y.at(1) == Approx(5.25).margin(1e-7).epsilon(0));
  }
}

TEST_CASE("global methods find the deepest of many valleys", "[nlopt]") {
  // Measured: direct-l, crs2 and mlsl reach rounding, the others draw random points around.
  const std::map<std::string, double> bounds{{"direct-l", 1e-12}, {"crs2", 1e-12}, {"isres", 1e-6},
                                             {"esch", 1e-3},      {"mlsl", 1e-12}, {"ags", 1e-3}};
  for (const auto& name : taking(rastrigin(), kGlobal)) {
    CAPTURE(name);
    const long limit = name == "mlsl" ? 2000 : 15000;  // mlsl compares each point with all before
    const Solution s = method(name).solve(rastrigin(), {.max_evaluations = limit});
    CHECK(s.status == Status::IterationLimit);
    CHECK(s.evaluations <= limit);
    CHECK(rastrigin().objective(s.y) < bounds.at(name));
  }
}

TEST_CASE("global methods respect rows", "[nlopt]") {
  const std::map<std::string, double> bounds{{"direct-l", 1e-6}, {"crs2", 1e-6}, {"isres", 1e-4},
                                             {"esch", 0.1},      {"mlsl", 1e-8}, {"ags", 1e-2}};
  for (const auto& name : taking(corner(), kGlobal)) {
    CAPTURE(name);
    const Solution s = method(name).solve(corner(), {});
    const double a = s.y.at(0), b = s.y.at(1);
    CHECK(a + b <= 2 + 1e-9);
    CHECK(a * a - b <= 1e-9);
    CHECK(square(a - 2) + square(b - 1) < 1 + bounds.at(name));
  }
}

TEST_CASE("global methods use all evaluations where rows leave the optimum alone", "[nlopt]") {
  const Program easy(box(-5, 5, {-3, 4}), valley_function(), 1, 1,
                     {{.function = sum(), .lower = -9}});
  for (const char* name : {"direct-l", "crs2", "isres", "esch", "mlsl"}) {
    CAPTURE(name);
    CHECK(method(name).solve(easy, {.max_evaluations = 3000}).evaluations == 3000);
  }
}

TEST_CASE("global methods approach an equation and say by how much they miss it", "[nlopt]") {
  for (const auto& name : taking(circle(), kGlobal)) {
    CAPTURE(name);
    const Solution s = method(name).solve(circle(), {});
    CAPTURE(s.message);
    const double miss = std::abs(square(s.y.at(0)) + square(s.y.at(1)) - 1);
    CHECK(miss < 1e-3);
    CHECK_FALSE(claims_success(s));
    CHECK((miss > 1e-6) == (s.message.find("violated") != std::string::npos));
  }
}

TEST_CASE("a refusal names the method and its reason", "[nlopt]") {
  const auto why = [](const char* name, const Program& program) {
    return method(name).refusal(program).value_or("taken");
  };
  const Program open(box(-kInfinity, 5, {0, 0}), distance(), 1, 1, {});
  for (const char* name : {"direct-l", "crs2", "isres", "esch", "mlsl"}) {
    CHECK(why(name, open) ==
          std::string(name) +
              " searches the whole box: each variable needs a lower and an upper bound");
  }
  CHECK(why("lbfgs", corner()) == "lbfgs takes no constraints besides bounds on the variables");
  CHECK(why("bobyqa", circle()) == "bobyqa takes no constraints besides bounds on the variables");
  CHECK(why("mma", circle()) == "mma takes no equations");
  CHECK(why("ccsaq", circle()) == "ccsaq takes no equations");
  const Row equation{.function = squares(), .lower = 1, .upper = 1};
  const Program crowded(box(-5, 5, {0, 0}), distance(), 1, 1, {equation, equation, equation});
  CHECK(why("slsqp", crowded) ==
        "slsqp needs at least as many variables as equations; there are 2 and 3");
}

TEST_CASE("ags works where NLopt has it, and says so where not", "[nlopt]") {
  const Program program = rastrigin();
  if (const auto why = method("ags").refusal(program)) {
    CHECK(*why == "ags is not compiled into this build of NLopt");
    return;
  }
  CHECK(method("ags").refusal(circle()) == "ags takes no equations");
  const Program large(box(-1, 1, std::vector<double>(11)), distance(), 1, 1, {});
  CHECK(method("ags").refusal(large) == "ags takes at most 10 variables; there are 11");
}

TEST_CASE("a program that was refused is not solved without its rows", "[nlopt]") {
  const Solution s = method("lbfgs").solve(corner(), {});
  CHECK(s.status == Status::Failed);
  CHECK(s.message == "lbfgs takes no constraints besides bounds on the variables");
  CHECK(s.y.empty());
}

TEST_CASE("a region where the model is undefined never wins", "[nlopt]") {
  for (const auto& name : taking(cliff(), all())) {
    CAPTURE(name);
    const Solution s = method(name).solve(cliff(), {.max_evaluations = 3000});
    CHECK(s.y.at(0) >= 0.5);
    CHECK(square(s.y.at(0)) + square(s.y.at(1) - 1) < 13);  // the start's
    if (!method(name).is_global()) {
      CHECK(s.status == Status::Stalled);
      CHECK(s.message == "ended where the model is undefined");
    }
  }
}

TEST_CASE("a row that is not a number is not satisfied", "[nlopt]") {
  // log(x) + y <= 0.5 is undefined for x <= 0, where the objective would be least.
  const Function row = function({0, 1}, [](const auto& u) { return log(u[0]) + u[1]; });
  const Function goal = function({0, 1}, [](const auto& u) {
    return (u[0] + 2.0) * (u[0] + 2.0) + (u[1] + 3.0) * (u[1] + 3.0);
  });
  const Program program(box(-5, 5, {3, -1}), goal, 1, 1, {{.function = row, .upper = 0.5}});
  for (const auto& name : taking(program, all())) {
    CAPTURE(name);
    const Solution s = method(name).solve(program, {.max_evaluations = 3000});
    CHECK(s.y.at(0) > 0);
    CHECK(std::log(s.y.at(0)) + s.y.at(1) <= 0.5 + 1e-6);
  }
}

TEST_CASE("a passing encounter with an undefined region does no harm", "[nlopt]") {
  const Function f = function(
      {0, 1}, [](const auto& u) { return u[0] - log(u[0]) + (u[1] - 1.0) * (u[1] - 1.0); });
  const Program program(box(-5, 5, {3, 3}), f, 1, 1, {});  // 1 at (1, 1)
  for (const auto& name : kLocal) {
    CAPTURE(name);
    const Solution s = method(name).solve(program, {});
    CHECK(s.status == Status::Solved);
    CHECK(s.y.at(0) == Approx(1).margin(1e-6).epsilon(0));
    CHECK(s.y.at(1) == Approx(1).margin(1e-6).epsilon(0));
  }
}

TEST_CASE("a start that is not a number is said to be one", "[nlopt]") {
  const Function root = function({0, 1}, [](const auto& u) { return sqrt(u[0]) + u[1]; });
  const Program bad(box(-5, 5, {-1, 0}), root, 1, 1, {});
  const Program bad_row(box(-5, 5, {-1, 0}), distance(), 1, 1, {{.function = root, .upper = 9}});
  for (const Program* program : {&bad, &bad_row}) {
    for (const auto& name : taking(*program, all())) {
      CAPTURE(name);
      const Solution s = method(name).solve(*program, {});
      CHECK(s.status == Status::NonFiniteStart);
      CHECK(s.y.empty());
      CHECK(s.evaluations == 1);
    }
  }
  const Program steep(box(0, 5, {0, 0}), root, 1, 1, {});  // the slope of a root at 0
  CHECK(method("slsqp").solve(steep, {}).status == Status::NonFiniteStart);
  CHECK(method("bobyqa").solve(steep, {}).status == Status::Solved);
}

TEST_CASE("what the model throws is kept, with the best point before", "[nlopt]") {
  const Function fragile = function({0, 1}, [](const auto& u) {
    if (u[0] > 0.5) throw std::domain_error("beyond a half");
    return (u[0] - 1.0) * (u[0] - 1.0) + u[1] * u[1];
  });
  const Program program(box(-2, 2, {0, 0.3}), fragile, 1, 1, {});
  for (const auto& name : taking(program, all())) {
    CAPTURE(name);
    const Solution s = method(name).solve(program, {});
    CHECK(s.status == Status::Failed);
    CHECK(s.message == "the model raised an error");
    REQUIRE(s.error);
    CHECK_THROWS_WITH(std::rethrow_exception(s.error), "beyond a half");
    CHECK(s.y.at(0) <= 0.5);
  }
  const Program thrown_at_once(box(-2, 2, {1, 0}), fragile, 1, 1, {});
  const Solution s = method("slsqp").solve(thrown_at_once, {});
  CHECK(s.status == Status::Failed);
  CHECK(s.error);
}

TEST_CASE("a stop flag ends each method at once, whatever its limits", "[nlopt]") {
  for (const auto& name : taking(rosenbrock(), all())) {
    CAPTURE(name);
    std::atomic<bool> stop = true;
    CHECK(method(name).solve(rosenbrock(), {.stop = &stop}).status == Status::Stopped);
    stop = false;
    int reports = 0;
    const Solution s = method(name).solve(
        rosenbrock(), {.max_evaluations = std::numeric_limits<long>::max() / 4,
                       .stop = &stop,
                       .progress = [&](const Progress&) { stop = ++reports == 2; }});
    CHECK(s.status == Status::Stopped);
    CHECK(reports == 2);
    CHECK_FALSE(s.y.empty());
  }
}

TEST_CASE("a time limit ends each method", "[nlopt]") {
  int calls = 0;  // each of 2 ms or more: their number does not grow on a busy machine
  const Function slow = function({0, 1}, [&calls](const auto& u) {
    ++calls;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    const auto a = 1.0 - u[0];
    const auto b = u[1] - u[0] * u[0];
    return a * a + 100.0 * b * b;
  });
  const Program program(box(-2, 2, {-1.2, 1}), slow, 1, 1, {});
  for (const auto& name : taking(program, all())) {
    CAPTURE(name);
    calls = 0;
    const Solution s = method(name).solve(program, {.time_limit = 0.02});
    CHECK(s.status == Status::TimeLimit);
    CHECK(calls < 1000);
    CHECK_FALSE(s.y.empty());
  }
}

TEST_CASE("limits of evaluations are kept to the letter", "[nlopt]") {
  for (const auto& name : taking(rosenbrock(), kGlobal)) {
    CAPTURE(name);
    const Solution s = method(name).solve(rosenbrock(), {.max_evaluations = 123});
    CHECK(s.status == Status::IterationLimit);
    CHECK(s.evaluations == 123);
  }
  for (const auto& name : kLocal) {
    CAPTURE(name);
    const Solution s =
        method(name).solve(rosenbrock(), {.max_iterations = 1, .max_evaluations = 10});
    CHECK(s.status == Status::IterationLimit);
    CHECK(s.evaluations == 10);  // ten to the iteration for those with gradients
  }
}

TEST_CASE("an objective that falls without end is said to", "[nlopt]") {
  const Program hill(box(-kInfinity, kInfinity, {0.1, 0}), squares(), -1, 1, {});
  for (const auto& name : kLocal) {
    CAPTURE(name);
    const Solution s = method(name).solve(hill, {});
    CHECK(s.status == Status::Unbounded);
  }
  // Down a plane steps may grow too slowly, but nobody calls it solved.
  const Program plane(box(-kInfinity, kInfinity, {0, 0}), sum(), 1, 1, {});
  for (const auto& name : kLocal) {
    CAPTURE(name);
    CHECK_FALSE(claims_success(method(name).solve(plane, {})));
  }
}

TEST_CASE("rows that contradict one another are never solved", "[nlopt]") {
  const Program program(box(-5, 5, {0, 0}), distance(), 1, 1,
                        {{.function = squares(), .upper = 1}, {.function = sum(), .lower = 3}});
  for (const auto& name : taking(program, all())) {
    CAPTURE(name);
    const Solution s = method(name).solve(program, {.max_evaluations = 3000});
    CAPTURE(s.message);
    CHECK_FALSE(claims_success(s));
    CHECK(s.message.find("violated") != std::string::npos);
  }
  CHECK(method("slsqp").solve(program, {}).status == Status::Infeasible);
}

TEST_CASE("the same seed gives the same bits, another seed another way", "[nlopt]") {
  for (const Program& program : {rosenbrock(), corner()}) {
    for (const auto& name : taking(program, all())) {
      CAPTURE(name);
      const auto run = [&](std::uint64_t seed) {
        return method(name).solve(program, {.max_evaluations = 700, .seed = seed});
      };
      const Solution first = run(7);
      const Solution other = run(8);
      const Solution again = run(7);
      CHECK(first.y == again.y);
      CHECK(first.evaluations == again.evaluations);
      const bool draws = name == "crs2" || name == "isres" || name == "esch";
      if (draws) CHECK(first.y != other.y);
    }
  }
}

/// Counts how often it is asked for its value.
class Counting final : public Kernel {
 public:
  explicit Counting(long& calls) : calls_(calls) {}
  double value(std::span<const double> u) const override {
    ++calls_;
    return square(u[0] - 2) + square(u[1] - 1);
  }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    g[0] = 2 * (u[0] - 2);
    g[1] = 2 * (u[1] - 1);
    return square(u[0] - 2) + square(u[1] - 1);
  }
  double hessian(std::span<const double> u, std::span<double> g, std::span<double>) const override {
    return gradient(u, g);
  }

 private:
  long& calls_;
};

TEST_CASE("a point is evaluated once for its objective and all its rows", "[nlopt]") {
  long objective = 0, row = 0;
  const Function counted({0, 1}, std::make_shared<Counting>(objective));
  const Function counted_row({0, 1}, std::make_shared<Counting>(row));
  const Program program(box(-5, 5, {0, 0}), counted, 1, 1,
                        {{.function = counted_row, .lower = 0.25, .upper = 4},
                         {.function = sum(), .lower = 1, .upper = 1}});
  for (const auto& name : taking(program, all())) {
    CAPTURE(name);
    objective = row = 0;
    const Solution s = method(name).solve(program, {.max_evaluations = 500});
    CHECK(objective == s.evaluations);
    CHECK(row == s.evaluations);
  }
}

TEST_CASE("progress is told in the problem's unit whenever the best improves", "[nlopt]") {
  const Program program(box(-2, 2, {-1.2, 1}), valley_function(), 1, 50, {});
  for (const auto& name : taking(program, all())) {
    CAPTURE(name);
    std::vector<double> reports;
    const SolverOptions options{.max_evaluations = 500, .progress = [&](const Progress& progress) {
                                  CHECK(progress.violation == 0);
                                  reports.push_back(progress.objective);
                                }};
    const Solution s = method(name).solve(program, options);
    CHECK(reports.front() == Approx(valley(-1.2, 1)));
    CHECK(std::is_sorted(reports.rbegin(), reports.rend()));
    CHECK(reports.back() == Approx(valley(s.y.at(0), s.y.at(1))).margin(1e-300));
  }
}

TEST_CASE("where nothing varies, the one design is judged", "[nlopt]") {
  const std::vector<ProgramColumn> fixed{{1, 1, 1, 1}, {2, 2, 2, 1}};
  const Program good(fixed, sum(), 1, 1, {{.function = sum(), .upper = 3}});
  const Program bad(fixed, sum(), 1, 1, {{.function = sum(), .upper = 2}});
  for (const char* name : {"slsqp", "cobyla", "isres", "mlsl"}) {
    CHECK(method(name).solve(good, {}).status == Status::Solved);
    CHECK(method(name).solve(bad, {}).status == Status::Infeasible);
  }
}

TEST_CASE("a warm start is where the search begins", "[nlopt]") {
  const WarmStart warm{.y = {1, 1}, .rows = {}, .lower = {}, .upper = {}};
  const Solution s = method("slsqp").solve(rosenbrock(), {}, &warm);
  CHECK(s.y == warm.y);
  CHECK(s.evaluations <= 3);
  const WarmStart outside{.y = {9, 9}, .rows = {}, .lower = {}, .upper = {}};
  CHECK(method("slsqp").solve(rosenbrock(), {}, &outside).status == Status::Solved);
}

TEST_CASE("one variable is enough for each local method", "[nlopt]") {
  const Function f = function({0}, [](const auto& u) { return (u[0] - 1.0) * (u[0] - 1.0) + 1.0; });
  const Program program(box(-3, 3, {2}), f, 1, 1, {});
  for (const auto& name : kLocal) {
    CAPTURE(name);
    CHECK(method(name).solve(program, {}).y.at(0) == Approx(1).margin(1e-6).epsilon(0));
  }
}

}  // namespace
}  // namespace camlaw::optim::nlopt_test
