// SPDX-License-Identifier: MIT
#include "optim/search/optimise.h"

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "kinematics/interval.h"
#include "optim/problem/automatic_curve.h"
#include "optim/problem/starts.h"
#include "optim/search/exchange.h"

namespace camlaw::optim {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
using Point = std::vector<double>;
using Names = std::vector<std::string>;

/// Of intervals Boost's own, which is narrower, is found by the argument.
template <class T>
T square(const T& x) {
  return x * x;
}

Variable variable(const std::string& name, double lower, double upper, double start = 0) {
  return {.name = name, .lower = lower, .upper = upper, .start = start};
}

Variable whole(const std::string& name, double lower, double upper, double start = 0) {
  return {.name = name, .lower = lower, .upper = upper, .start = start, .integer = true};
}

Objective least(Function f) { return {{"cost", "N", std::move(f)}, Sense::Minimize, {}, {}}; }
Objective most(Function f) { return {{"gain", "N", std::move(f)}, Sense::Maximize, {}, {}}; }

template <class F>
Function convex(std::vector<std::size_t> inputs, F f) {
  return function<Interval>(std::move(inputs), f, Shape::Convex);
}

template <class F>
Function linear(std::vector<std::size_t> inputs, F f) {
  return function<Interval>(std::move(inputs), f, Shape::Linear);
}

Constraint at_most(const std::string& name, Function f, double bound) {
  return {.response = {name, "mm", std::move(f)}, .upper = bound};
}
Constraint at_least(const std::string& name, Function f, double bound) {
  return {.response = {name, "mm", std::move(f)}, .lower = bound};
}
Constraint equal(const std::string& name, Function f, double bound) {
  return {.response = {name, "mm", std::move(f)}, .lower = bound, .upper = bound};
}

/// Least (x - 1)^2 + 2 (y + 1/2)^2 + x y in [-3, 3]^2. From 2 (x - 1) + y = 0 and
/// 4 (y + 1/2) + x = 0: x = 10/7, y = -6/7, (18 + 25 - 120) / 98 = -11/14.
Problem bowl() {
  Problem problem;
  problem.variables = {variable("x", -3, 3), variable("y", -3, 3)};
  problem.objective = least(convex({0, 1}, [](const auto& u) {
    return square(u[0] - 1.0) + 2.0 * square(u[1] + 0.5) + u[0] * u[1];
  }));
  return problem;
}

Function sum() {
  return linear({0, 1}, [](const auto& u) { return u[0] + u[1]; });
}

/// (x^2 - 1)^2 + x / 5 + y^2: two valleys, the deeper one by x = -1.
Problem two_valleys() {
  Problem problem;
  problem.variables = {variable("x", -2, 2, 0.9), variable("y", -2, 2, 0.5)};
  problem.objective = least(function<Interval>({0, 1}, [](const auto& u) {
    return square(square(u[0]) - 1.0) + 0.2 * u[0] + square(u[1]);
  }));
  return problem;
}

/// A stationary point of (x^2 - 1)^2 + x / 5: a root of 4 x^3 - 4 x + 1/5 by Newton's method.
double valley(double x) {
  for (int i = 0; i < 50; ++i) x -= (4 * x * x * x - 4 * x + 0.2) / (12 * x * x - 4);
  return x;
}

/// A function that does something before each evaluation: waits, counts, throws.
class Watched final : public Kernel {
 public:
  Watched(Function f, std::function<void(std::span<const double>)> before)
      : f_(std::move(f)), before_(std::move(before)) {}
  double value(std::span<const double> u) const override {
    before_(u);
    return f_.value(u);
  }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    before_(u);
    return f_.gradient(u, g);
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    before_(u);
    return f_.hessian(u, g, h);
  }

 private:
  Function f_;
  std::function<void(std::span<const double>)> before_;
};

/// f is of all variables, in their order.
Function watched(Function f, std::function<void(std::span<const double>)> before) {
  std::vector<std::size_t> inputs = f.inputs();
  return Function(std::move(inputs), std::make_shared<Watched>(std::move(f), std::move(before)));
}

/// Rosenbrock's valley from its usual start: many iterations for every method.
Function rosenbrock() {
  return function<Interval>({0, 1}, [](const auto& u) {
    return 100.0 * square(u[1] - square(u[0])) + square(1.0 - u[0]);
  });
}

Problem valley_of(Function f) {
  Problem problem;
  problem.variables = {variable("x", -5, 5, -1.2), variable("y", -5, 5, 1)};
  problem.objective = least(std::move(f));
  return problem;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Every number of an answer.
Point numbers(const Optimum& optimum) {
  const Assessment& a = optimum.found.assessment;
  Point all = optimum.found.x;
  all.insert(all.end(), {a.objective.value, a.kkt_residual, a.condition});
  for (const LimitReport& limit : a.limits) {
    all.insert(all.end(), {limit.value, limit.margin, limit.tolerance, limit.multiplier,
                           limit.worst_angle.value_or(0)});
  }
  for (const VariableReport& v : a.variables) all.insert(all.end(), {v.value, v.multiplier});
  return all;
}

bool same_bits(const Point& a, const Point& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

}  // namespace

TEST_CASE("an optimum is certified, and found by the method that auto names", "[optimise]") {
  const Optimum optimum = optimise(bowl());
  const Found& found = optimum.found;
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.status == Status::Solved);
  CHECK(found.x[0] == Approx(10.0 / 7).epsilon(1e-6));
  CHECK(found.x[1] == Approx(-6.0 / 7).epsilon(1e-6));
  CHECK(found.assessment.objective.value == Approx(-11.0 / 14).epsilon(1e-10));
  CHECK(found.assessment.global);
  CHECK(found.solver == "slsqp");
  CHECK(contains(found.why_solver, "slsqp"));
  CHECK(found.starts == 1);
  CHECK(found.agreed == 1);
  CHECK(found.evaluations > 0);
  CHECK(found.solves >= 1);
  CHECK(optimum.combinations == 1);
  CHECK(optimum.solved == 1);
  CHECK(optimum.options.empty());
  CHECK(optimum.wall_s > 0);
}

TEST_CASE("limits, equations and maximising", "[optimise]") {
  // On x + y = 1 the bowl is 2 x^2 - 7 x + 11/2: x = 7/4, y = -3/4, -5/8.
  for (const bool equation : {false, true}) {
    Problem problem = bowl();
    problem.constraints = {equation ? equal("sum", sum(), 1) : at_least("sum", sum(), 1)};
    const Found found = optimise(problem).found;
    CHECK(found.assessment.verdict == Verdict::Certified);
    CHECK(found.x[0] == Approx(1.75).epsilon(1e-6));
    CHECK(found.x[1] == Approx(-0.75).epsilon(1e-6));
    CHECK(found.assessment.objective.value == Approx(-0.625).epsilon(1e-8));
    CHECK(found.assessment.active == Names{"sum"});
  }
  // Most x + y in the disc of radius 2: 2 sqrt(2) at (sqrt 2, sqrt 2).
  Problem problem = bowl();
  problem.objective = most(sum());
  problem.constraints = {at_most(
      "radius", convex({0, 1}, [](const auto& u) { return square(u[0]) + square(u[1]); }), 4)};
  const Found found = optimise(problem).found;
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.assessment.objective.value == Approx(2 * std::sqrt(2)).epsilon(1e-6));
  // d(r sqrt 2)/d(r^2) = 1 / (r sqrt 2).
  CHECK(found.assessment.limits[0].multiplier == Approx(1 / (2 * std::sqrt(2))).epsilon(1e-5));
}

TEST_CASE("two limits that contradict each other are blamed, an innocent one is not",
          "[optimise]") {
  // 3 - x and x^2 - 1 are equal where x^2 + x = 4: x = (sqrt(17) - 1) / 2.
  Problem problem;
  problem.variables = {variable("x", -5, 5), variable("y", -5, 5)};
  problem.objective = least(convex({1}, [](const auto& u) { return square(u[0]); }));
  problem.constraints = {
      at_least("low", linear({0}, [](const auto& u) { return u[0]; }), 3),
      at_most("innocent", linear({0, 1}, [](const auto& u) { return u[0] + u[1]; }), 100),
      at_most("high", convex({0}, [](const auto& u) { return square(u[0]); }), 1)};
  problem.constraints[0].scale = problem.constraints[2].scale = 1;
  const Optimum optimum = optimise(problem);
  const Assessment& a = optimum.found.assessment;
  CHECK(a.verdict == Verdict::Infeasible);
  CHECK(a.blamed == Names{"low", "high"});
  CHECK(a.reason == "low and high contradict one another");
  CHECK(a.global);
  const double x = (std::sqrt(17) - 1) / 2;
  CHECK(optimum.found.x[0] == Approx(x).epsilon(1e-6));
  CHECK(a.limits[0].margin == Approx(x - 3).epsilon(1e-6));
  CHECK(a.limits[1].met);
  CHECK(a.limits[2].margin == Approx(1 - x * x).epsilon(1e-6));
  CHECK(optimum.found.status == Status::Infeasible);
}

TEST_CASE("a variable's bound is blamed with the limit that it contradicts", "[optimise]") {
  Problem problem = bowl();
  problem.variables[0].upper = 1;
  problem.constraints = {at_least("reach", linear({0}, [](const auto& u) { return u[0]; }), 2)};
  const Optimum optimum = optimise(problem);
  CHECK(optimum.found.assessment.verdict == Verdict::Infeasible);
  CHECK(optimum.found.assessment.blamed == Names{"reach", "upper bound of x"});
  CHECK(optimum.found.x[0] == Approx(1).epsilon(1e-8));
  CHECK(optimum.found.x[0] <= 1);
  CHECK(optimum.found.assessment.limits[0].margin == Approx(-1).epsilon(1e-7));
}

TEST_CASE("equations and limits over the cycle are blamed too", "[optimise]") {
  // x = 1/2, and x sin(a) <= -1 over a of 1 to 2: for x < 0 it is highest at a = 1. Both are missed
  // by as much where 1/2 - x = x sin(1) + 1.
  Problem problem = bowl();
  problem.constraints = {
      equal("fixed", linear({0}, [](const auto& u) { return u[0]; }), 0.5),
      {.response = {"wave", "mm",
                    curve<Interval>(
                        {0}, 1, 2,
                        [](const auto& u, const auto& angle) { return u[0] * sin(angle); },
                        Shape::Linear)},
       .upper = -1}};
  for (Constraint& c : problem.constraints) c.scale = 1;
  const Found found = optimise(problem).found;
  CHECK(found.assessment.verdict == Verdict::Infeasible);
  CHECK(found.assessment.blamed == Names{"fixed", "wave"});
  CHECK(found.x[0] == Approx(-0.5 / (1 + std::sin(1))).epsilon(1e-6));
  CHECK(found.assessment.limits[1].worst_angle == 1);
}

TEST_CASE("limits that only touch are met", "[optimise]") {
  // x <= 1 and x >= 1: one value of x is left.
  Problem problem = bowl();
  problem.constraints = {at_most("high", linear({0}, [](const auto& u) { return u[0]; }), 1),
                         at_least("low", linear({0}, [](const auto& u) { return u[0]; }), 1)};
  const Found found = optimise(problem).found;
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.x[0] == Approx(1).epsilon(1e-6));
  CHECK(found.x[1] == Approx(-0.75).epsilon(1e-6));  // 4 (y + 1/2) + 1 = 0
}

TEST_CASE("an optimum near a region without numbers is found", "[optimise]") {
  // x - log(x) / 100 is undefined for x <= 0 and least at 0.01.
  Problem problem;
  problem.variables = {variable("x", -1, 5, 3)};
  problem.objective = least(function({0}, [](const auto& u) { return u[0] - 0.01 * log(u[0]); }));
  const Found found = optimise(problem).found;
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.x[0] == Approx(0.01).epsilon(1e-4));
}

TEST_CASE("an optimum on the edge of a region without numbers is come close to", "[optimise]") {
  // Least -x, undefined for x > 1.
  Problem problem;
  problem.variables = {variable("x", -5, 5, -2)};
  problem.objective =
      least(function({0}, [](const auto& u) { return 0.0 * sqrt(1.0 - u[0]) - u[0]; }));
  const Found found = optimise(problem).found;
  REQUIRE(found.x.size() == 1);
  CHECK(found.assessment.verdict == Verdict::Feasible);
  CHECK(found.x[0] <= 1);
  CHECK(found.x[0] > 0.99);
}

TEST_CASE("a start without numbers: alone it fails, among others it does no harm", "[optimise]") {
  // (x - 2)^2 + sqrt(x) from x = -3.
  Problem problem;
  problem.variables = {variable("x", -4, 4, -3)};
  problem.objective =
      least(function({0}, [](const auto& u) { return square(u[0] - 2.0) + 0.0 * sqrt(u[0]); }));
  const Found alone = optimise(problem, {.starts = 1}).found;
  CHECK(alone.assessment.verdict == Verdict::Failed);
  CHECK(alone.status == Status::NonFiniteStart);
  CHECK(alone.assessment.reason == "the model gives no number at the start");
  const Found found = optimise(problem).found;
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.x[0] == Approx(2).epsilon(1e-6));
  CHECK(found.starts == 8);
  // And where no number is anywhere.
  problem.objective = least(function({0}, [](const auto& u) { return sqrt(-9.0 - u[0] * u[0]); }));
  CHECK(optimise(problem).found.assessment.verdict == Verdict::Failed);
}

TEST_CASE("what the model throws is a failed assessment with its words", "[optimise]") {
  const auto always = [](std::span<const double>) { throw std::runtime_error("no such follower"); };
  for (const std::string solver : {"auto", "ipopt", "slsqp", "cobyla", "crs2"}) {
    INFO(solver);
    const Found found =
        optimise(valley_of(watched(rosenbrock(), always)), {.solver = solver}).found;
    CHECK(found.assessment.verdict == Verdict::Failed);
    CHECK(found.assessment.reason == "the model threw: no such follower");
    CHECK(found.status == Status::Failed);
  }
  const auto odd = [](std::span<const double>) { throw 42; };
  const Found found = optimise(valley_of(watched(rosenbrock(), odd))).found;
  CHECK(found.assessment.verdict == Verdict::Failed);
  CHECK(contains(found.assessment.reason, "the model threw"));
}

TEST_CASE("a model that throws on the way never throws out of optimise", "[optimise]") {
  for (const long first : {2, 3, 5, 10, 20, 40}) {
    for (const std::string solver : {"auto", "ipopt", "mma", "bobyqa", "direct-l"}) {
      INFO(solver << " from evaluation " << first);
      long count = 0;
      const auto later = [&](std::span<const double>) {
        if (++count >= first) throw std::runtime_error("worn out");
      };
      const Problem problem = valley_of(watched(rosenbrock(), later));
      Found found;
      REQUIRE_NOTHROW(found = optimise(problem, {.solver = solver}).found);
      if (found.assessment.verdict == Verdict::Failed) {
        CHECK(contains(found.assessment.reason, "worn out"));
      }
    }
  }
}

TEST_CASE("a limit that throws, on a number or a curve, is a failed assessment", "[optimise]") {
  Problem problem = bowl();
  problem.constraints = {
      at_most("load", watched(sum(), [](auto) { throw std::runtime_error("no such roller"); }), 1)};
  CHECK(contains(optimise(problem).found.assessment.reason, "no such roller"));
  problem.constraints[0].response.measure =
      curve({0, 1}, 0, 1, [](const auto& u, const auto& angle) {
        if (angle > 0.3) throw std::runtime_error("no such angle");
        return u[0] * angle + u[1];
      });
  const Found found = optimise(problem).found;
  CHECK(found.assessment.verdict == Verdict::Failed);
  CHECK(contains(found.assessment.reason, "no such angle"));
}

TEST_CASE("after the time limit the best design so far comes back soon", "[optimise]") {
  const auto slow = [](std::span<const double>) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  };
  for (const std::string solver : {"auto", "ipopt", "cobyla", "crs2"}) {
    INFO(solver);
    const Problem problem = valley_of(watched(rosenbrock(), slow));
    const Optimum optimum = optimise(problem, {.solver = solver, .time_limit = 0.1});
    CHECK(optimum.wall_s < 5);
    CHECK(optimum.found.status == Status::TimeLimit);
    CHECK(optimum.found.assessment.verdict == Verdict::Feasible);
    CHECK(contains(optimum.found.assessment.reason, "the time limit of 0.1 s was reached"));
    REQUIRE(optimum.found.x.size() == 2);
    // No worse than the start: 100 (1 - 1.44)^2 + 2.2^2 = 24.2.
    CHECK(optimum.found.assessment.objective.value <= 24.2 + 1e-9);
    CHECK(optimum.found.assessment.objective.value == rosenbrock().value(optimum.found.x));
  }
}

TEST_CASE("the stop flag ends the search with the best design so far", "[optimise]") {
  for (const std::string solver : {"auto", "ipopt", "mma", "cobyla", "isres"}) {
    INFO(solver);
    std::atomic<bool> stop = false;
    int count = 0;
    const auto stopping = [&](std::span<const double>) { stop = ++count >= 12; };
    const Problem problem = valley_of(watched(rosenbrock(), stopping));
    const Found found = optimise(problem, {.solver = solver, .stop = &stop}).found;
    CHECK(found.status == Status::Stopped);
    CHECK(found.assessment.verdict == Verdict::Feasible);
    CHECK(contains(found.assessment.reason, "stopped"));
    CHECK(found.assessment.objective.value <= 24.2 + 1e-9);
    CHECK(count < 200);
  }
}

TEST_CASE("stopped before it began, a search hands back its start", "[optimise]") {
  const std::atomic<bool> stop = true;
  const Found found = optimise(valley_of(rosenbrock()), {.stop = &stop}).found;
  CHECK(found.status == Status::Stopped);
  CHECK(found.x == Point{-1.2, 1});
  CHECK(found.assessment.verdict == Verdict::Feasible);
}

TEST_CASE("a limit of iterations is a status, and the design is feasible", "[optimise]") {
  for (const std::string solver : {"ipopt", "slsqp", "lbfgs"}) {
    INFO(solver);
    const Found found =
        optimise(valley_of(rosenbrock()), {.solver = solver, .starts = 1, .max_iterations = 1})
            .found;
    CHECK(found.status == Status::IterationLimit);
    CHECK(found.assessment.verdict == Verdict::Feasible);
    CHECK(contains(found.assessment.reason, "limit of"));
    CHECK(found.assessment.objective.value <= 24.2 + 1e-9);
  }
}

TEST_CASE("an objective without end is a failure that says so", "[optimise]") {
  Problem problem;
  problem.variables = {variable("x", -kInfinity, kInfinity), variable("y", 0, 1)};
  const std::vector<Objective> endless{
      least(linear({0, 1}, [](const auto& u) { return u[0] + u[1]; })),
      most(function({0, 1}, [](const auto& u) { return u[0] * u[0] * u[0] + u[0] - u[1]; })),
      least(function({0}, [](const auto& u) { return u[0] - u[0] * u[0]; }))};
  for (const Objective& objective : endless) {
    problem.objective = objective;
    const Found found = optimise(problem).found;
    CHECK(found.assessment.verdict == Verdict::Failed);
    CHECK(found.status == Status::Unbounded);
    CHECK(found.assessment.reason == "the objective improves without end: a limit is missing");
  }
}

TEST_CASE("equations that say the same twice are certified, without unique multipliers",
          "[optimise]") {
  // Least x^2 + y^2 where x + y = 2: (1, 1). With a third variable, z^2, and without: then there
  // are as many equations as variables, and still a line of designs.
  for (const bool third : {true, false}) {
    INFO((third ? "three" : "two") << " variables");
    Problem problem;
    problem.variables = {variable("x", -5, 5, 3), variable("y", -5, 5, -1)};
    problem.objective =
        least(convex({0, 1}, [](const auto& u) { return square(u[0]) + square(u[1]); }));
    if (third) {
      problem.variables.push_back(variable("z", -5, 5, 2));
      problem.objective = least(convex(
          {0, 1, 2}, [](const auto& u) { return square(u[0]) + square(u[1]) + square(u[2]); }));
    }
    problem.constraints = {
        equal("once", sum(), 2),
        equal("twice", linear({0, 1}, [](const auto& u) { return 2.0 * u[0] + 2.0 * u[1]; }), 4)};
    const Found found = optimise(problem).found;
    CHECK(found.assessment.verdict == Verdict::Certified);
    CHECK(found.x[0] == Approx(1).epsilon(1e-6));
    CHECK(found.x[1] == Approx(1).epsilon(1e-6));
    CHECK(std::isinf(found.assessment.condition));
    // The optimum c^2 / 2 rises by c = 2 to each unit of x + y, whichever equation moves.
    const auto& limits = found.assessment.limits;
    CHECK(limits[0].multiplier + 2 * limits[1].multiplier == Approx(2).epsilon(1e-6));
  }
}

TEST_CASE("three limits through one point of the plane are certified", "[optimise]") {
  // Most x + 2 y where x <= 1, y <= 1, x + y <= 2: (1, 1).
  Problem problem;
  problem.variables = {variable("x", -5, 5), variable("y", -5, 5)};
  problem.objective = most(linear({0, 1}, [](const auto& u) { return u[0] + 2.0 * u[1]; }));
  problem.constraints = {at_most("right", linear({0}, [](const auto& u) { return u[0]; }), 1),
                         at_most("top", linear({1}, [](const auto& u) { return u[0]; }), 1),
                         at_most("corner", sum(), 2)};
  const Found found = optimise(problem).found;
  const Assessment& a = found.assessment;
  CHECK(a.verdict == Verdict::Certified);
  CHECK(a.objective.value == Approx(3).epsilon(1e-7));
  CHECK(a.active == Names{"right", "top", "corner"});
  CHECK(std::isinf(a.condition));
  CHECK(a.limits[0].multiplier + a.limits[2].multiplier == Approx(1).epsilon(1e-6));
  CHECK(a.limits[1].multiplier + a.limits[2].multiplier == Approx(2).epsilon(1e-6));
}

namespace {

/// x (1 + cos(angle) / 10) + a spike of height 1 and half width 0.002 deg at `place`, which no
/// sample meets: those of the search are 1.4 deg apart. Its tail slopes by 2 w^2 / d^3, 1e-4 at a
/// distance of 0.4 deg, less than the wave does: no sample there looks like a peak.
auto spiked(double place) {
  return [place](const auto& u, const auto& angle) {
    using T = std::remove_cvref_t<decltype(angle)>;
    const auto number = [](double c) { return constant<T>(c); };
    const T away = (angle - number(place)) / number(0.002);
    const T wave = cos(angle * number(std::acos(-1.0) / 180));
    return u[0] * (number(1) + number(0.1) * wave) + number(1) / (number(1) + away * away);
  };
}

}  // namespace

TEST_CASE("a limit that breaks only between the samples is found by the proof and respected",
          "[optimise]") {
  constexpr double kPlace = 100.123, kLimit = 3;
  Problem problem;
  problem.variables = {variable("x", 0, 10, 1)};
  problem.objective = most(linear({0}, [](const auto& u) { return u[0]; }));
  problem.constraints = {
      {.response = {"stress", "MPa", curve<Interval>({0}, 0, 360, spiked(kPlace), Shape::Linear)},
       .upper = kLimit}};
  const Found found = optimise(problem).found;
  REQUIRE(found.x.size() == 1);
  const LimitReport& stress = found.assessment.limits.at(0);
  CHECK(is_feasible(found.assessment));
  CHECK(found.assessment.verdict != Verdict::Failed);
  CHECK(stress.proved);
  // Without the spike x would be 3 / 1.1 = 2.73. With it x (1 + cos(100.123 deg) / 10) = 2, but for
  // 1e-11, by which the wave moves the top: its slope is 0.0035 a degree.
  const double wave = 1 + 0.1 * std::cos(kPlace * std::acos(-1.0) / 180);
  CHECK(found.x[0] == Approx(2 / wave).epsilon(2e-6));
  CHECK(found.x[0] * wave + 1 <= kLimit + stress.tolerance);
}

TEST_CASE("a limit that no design meets between the samples is not called met", "[optimise]") {
  // The spike alone is higher than 0.5, whatever x >= 0 is.
  Problem problem;
  problem.variables = {variable("x", 0, 10, 1)};
  problem.objective = most(linear({0}, [](const auto& u) { return u[0]; }));
  problem.constraints = {
      {.response = {"stress", "MPa", curve<Interval>({0}, 0, 360, spiked(100.123), Shape::Linear)},
       .upper = 0.5}};
  const Assessment a = optimise(problem).found.assessment;
  CHECK_FALSE(is_feasible(a));
  CHECK((a.verdict == Verdict::Failed || a.verdict == Verdict::Infeasible));
  CHECK(contains(a.reason, "stress"));
}

TEST_CASE("a peak between the samples counts in the objective too", "[optimise]") {
  // Least highest of x (1 + cos / 10) + spike + 4 (x - 2)^2 over the cycle: about the spike 1 +
  // wave x + 4 (x - 2)^2, least at x = 2 - wave / 8; elsewhere at most 1.1 x + 4 (x - 2)^2.
  constexpr double kPlace = 100.123;
  Problem problem;
  problem.variables = {variable("x", 0, 10, 1)};
  const auto f = [](const auto& u, const auto& angle) {
    using T = std::remove_cvref_t<decltype(angle)>;
    const T off = u[0] - constant<T>(2);
    return spiked(kPlace)(u, angle) + constant<T>(4) * off * off;
  };
  problem.objective = {{"stress", "MPa", curve<Interval>({0}, 0, 360, f, Shape::Convex)},
                       Sense::Minimize,
                       Part::Highest,
                       {}};
  const Found found = optimise(problem).found;
  const double wave = 1 + 0.1 * std::cos(kPlace * std::acos(-1.0) / 180);
  const double x = 2 - wave / 8, peak = 1 + wave * x + wave * wave / 16;
  // A design may only be certified with the peak that is there.
  if (found.assessment.verdict == Verdict::Certified) {
    CHECK(found.x[0] == Approx(x).epsilon(1e-3));
    CHECK(found.assessment.objective.value == Approx(peak).epsilon(1e-6));
  }
  CHECK(found.assessment.objective.proved.upper >= peak - 1e-6);
}

TEST_CASE("the line nearest to a cube is Chebyshev's", "[optimise]") {
  // a^3 - 3 a / 4 = T3(a) / 4 on [-1, 1] takes 1/4 and -1/4 four times in turn, at -1, -1/2, 1/2,
  // 1: no line comes nearer (Chebyshev's alternation).
  Problem problem;
  problem.variables = {variable("offset", -2, 2, 0.3), variable("slope", -2, 2, -0.4)};
  problem.objective = {{"error", "mm",
                        curve<Interval>(
                            {0, 1}, -1, 1,
                            [](const auto& u, const auto& angle) {
                              return angle * angle * angle - u[0] - u[1] * angle;
                            },
                            Shape::Linear)},
                       Sense::Minimize,
                       Part::Magnitude,
                       {}};
  const Found found = optimise(problem).found;
  const Assessment& a = found.assessment;
  CHECK(a.verdict == Verdict::Certified);
  CHECK(a.global);
  CHECK(a.objective.value == Approx(0.25).epsilon(1e-6));
  CHECK(found.x[0] == Approx(0).margin(1e-6));
  CHECK(found.x[1] == Approx(0.75).epsilon(1e-6));
  CHECK(a.objective.proved.lower <= 0.25);
  CHECK(a.objective.proved.upper >= 0.25);
  CHECK(a.objective.proved.upper <= 0.25 + 1e-6);
}

TEST_CASE("the highest value minimised and the lowest maximised", "[optimise]") {
  // (a - x)^2 over a in [0, 3], least highest: x = 3/2, 9/4, both ends. With -(a - x)^2 the lowest.
  Problem problem;
  problem.variables = {variable("x", -10, 10, -3)};
  const auto f = [](double sign) {
    return [sign](const auto& u, const auto& angle) {
      using T = std::remove_cvref_t<decltype(angle)>;
      const T away = angle - u[0];
      return constant<T>(sign) * away * away;
    };
  };
  problem.objective = {{"gap", "mm", curve<Interval>({0}, 0, 3, f(1), Shape::Convex)},
                       Sense::Minimize,
                       Part::Highest,
                       {}};
  const Found highest = optimise(problem).found;
  CHECK(highest.assessment.verdict == Verdict::Certified);
  CHECK(highest.x[0] == Approx(1.5).epsilon(1e-6));
  CHECK(highest.assessment.objective.value == Approx(2.25).epsilon(1e-6));
  problem.objective = {{"gap", "mm", curve<Interval>({0}, 0, 3, f(-1), Shape::Concave)},
                       Sense::Maximize,
                       Part::Lowest,
                       {}};
  const Found lowest = optimise(problem).found;
  CHECK(lowest.assessment.verdict == Verdict::Certified);
  CHECK(lowest.x[0] == Approx(1.5).epsilon(1e-6));
  CHECK(lowest.assessment.objective.value == Approx(-2.25).epsilon(1e-6));
}

TEST_CASE("a limit over the cycle on a smooth objective", "[optimise]") {
  // Most y where x sin(a) + y <= 2 over a whole turn: |x| + y <= 2, and x >= 1/2: y = 3/2.
  Problem problem;
  problem.variables = {variable("x", 0.5, 10, 3), variable("y", -10, 10)};
  problem.objective = most(linear({1}, [](const auto& u) { return u[0]; }));
  problem.constraints = {
      {.response = {"wave", "mm",
                    curve<Interval>(
                        {0, 1}, 0, 7,
                        [](const auto& u, const auto& angle) { return u[0] * sin(angle) + u[1]; },
                        Shape::Linear)},
       .upper = 2}};
  const Found found = optimise(problem).found;
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.x[0] == Approx(0.5).epsilon(1e-6));
  CHECK(found.x[1] == Approx(1.5).epsilon(1e-6));
  CHECK(found.assessment.limits[0].multiplier == Approx(1).epsilon(1e-6));
  CHECK(found.assessment.variables[0].multiplier == Approx(1).epsilon(1e-6));
}

TEST_CASE("a saddle as the start is not certified", "[optimise]") {
  // x^2 - y^2 + y^4 / 2 is stationary at the origin; it is least, -1/2, at (0, +-1).
  Problem problem;
  problem.variables = {variable("x", -2, 2), variable("y", -2, 2)};
  problem.objective = least(function({0, 1}, [](const auto& u) {
    return square(u[0]) - square(u[1]) + 0.5 * square(square(u[1]));
  }));
  const Found stuck = optimise(problem, {.starts = 1}).found;
  const bool escaped = std::abs(std::abs(stuck.x[1]) - 1) < 1e-3;
  CHECK((stuck.assessment.verdict == Verdict::Certified) == escaped);
  const Found found = optimise(problem).found;
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.assessment.objective.value == Approx(-0.5).epsilon(1e-8));
  CHECK(std::abs(found.x[1]) == Approx(1).epsilon(1e-5));
}

TEST_CASE("of two valleys the deeper one is found, and the starts that agree are counted",
          "[optimise]") {
  const Problem problem = two_valleys();
  const double x = valley(-1), deepest = std::pow(x * x - 1, 2) + x / 5;
  CHECK(std::abs(4 * x * x * x - 4 * x + 0.2) < 1e-14);
  constexpr int kStarts = 12;
  const Found found = optimise(problem, {.starts = kStarts}).found;
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK_FALSE(found.assessment.global);
  CHECK(found.x[0] == Approx(x).epsilon(1e-6));
  CHECK(found.assessment.objective.value == Approx(deepest).epsilon(1e-9));
  CHECK(found.starts == kStarts);
  // Each start alone: both valleys are met, and the count is right.
  const Sizes about_start = sizes(problem, problem.start());
  int deep = 0;
  for (const Point& start : starts(problem, kStarts, 1)) {
    const Attempt alone = exchange(problem, about_start, start, find_solver("slsqp"), {});
    deep += std::abs(problem.objective.response.function().value(alone.x) - deepest) < 1e-6;
  }
  CHECK(found.agreed == deep);
  CHECK(deep > 0);
  CHECK(deep < kStarts);
}

TEST_CASE("the start that led to the answer agrees with it", "[optimise]") {
  // (x^2 + y^2 - 2)^2 <= 0: a circle on which the limit has no gradient. Methods in turn end at
  // points that differ by more than 1e-6; one of them is the answer.
  Problem problem;
  problem.variables = {variable("x", -5, 5, 3), variable("y", -5, 5, -1)};
  problem.objective =
      least(convex({0, 1}, [](const auto& u) { return square(u[0]) + square(u[1]); }));
  problem.constraints = {at_most(
      "circle",
      function({0, 1}, [](const auto& u) { return square(square(u[0]) + square(u[1]) - 2.0); }),
      0)};
  problem.constraints[0].tolerance = 1e-6;
  const Found found = optimise(problem, {.starts = 1}).found;
  CHECK(is_feasible(found.assessment));
  CHECK(found.agreed == 1);
}

TEST_CASE("a search that ends against a region without numbers has stalled", "[optimise]") {
  // Least -x where the model is undefined for x > 1.
  Problem problem;
  problem.variables = {variable("x", -5, 5, -2)};
  problem.objective =
      least(function({0}, [](const auto& u) { return 0.0 * sqrt(1.0 - u[0]) - u[0]; }));
  for (const std::string solver : {"slsqp", "mma", "lbfgs", "cobyla"}) {
    INFO(solver);
    const Found found = optimise(problem, {.solver = solver}).found;
    CHECK(found.status == Status::Stalled);
    CHECK(found.assessment.verdict == Verdict::Feasible);
  }
}

TEST_CASE("rows that rounding keeps from being met tightly are solved acceptably", "[optimise]") {
  // (x + 1e10) - 1e10 takes multiples of 2^-19 = 1.9e-6 only: 0.3 is missed by 7.6e-7, which the
  // tolerance allows. That is 7.6e-8 of the range of x, 10: more than the 1e-9 that methods aim at.
  Problem problem;
  problem.variables = {variable("x", -5, 5, -1.2), variable("y", -5, 5, 1)};
  problem.objective =
      least(convex({0, 1}, [](const auto& u) { return square(u[0] - 2.0) + square(u[1]); }));
  problem.constraints = {
      equal("coarse", function({0}, [](const auto& u) { return (u[0] + 1e10) - 1e10; }), 0.3)};
  problem.constraints[0].tolerance = 2e-6;
  const Found found = optimise(problem, {.solver = "slsqp", .starts = 1}).found;
  CHECK(found.status == Status::Acceptable);
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.x[0] == Approx(0.3).margin(3e-6));
}

TEST_CASE("equal seeds give equal bits, with every method that draws numbers", "[optimise]") {
  for (const std::string solver : {"auto", "crs2", "isres", "esch", "mlsl", "direct-l"}) {
    INFO(solver);
    Problem problem = two_valleys();
    problem.constraints = {at_most("sum", sum(), 0.5)};
    const OptimiseOptions options{.solver = solver, .seed = 7, .max_evaluations = 2000};
    const Optimum one = optimise(problem, options), two = optimise(problem, options);
    CHECK(same_bits(numbers(one), numbers(two)));
    CHECK(one.found.evaluations == two.found.evaluations);
    CHECK(one.found.iterations == two.found.iterations);
    CHECK(one.found.agreed == two.found.agreed);
  }
}

TEST_CASE("few whole combinations are all solved", "[optimise]") {
  // Most 5 a + 4 b where 6 a + 4 b <= 24 and a + 2 b <= 6. Without whole numbers 21 at (3, 3/2);
  // with them b = 0 allows a = 4: 20, b = 1 a = 3: 19, b = 2 a = 2: 18, b = 3 a = 0: 12.
  Problem problem;
  problem.variables = {whole("a", 0, 10), whole("b", 0, 10)};
  problem.objective = most(linear({0, 1}, [](const auto& u) { return 5.0 * u[0] + 4.0 * u[1]; }));
  problem.constraints = {
      at_most("hours", linear({0, 1}, [](const auto& u) { return 6.0 * u[0] + 4.0 * u[1]; }), 24),
      at_most("steel", linear({0, 1}, [](const auto& u) { return u[0] + 2.0 * u[1]; }), 6)};
  const Optimum optimum = optimise(problem);
  CHECK(optimum.found.assessment.verdict == Verdict::Certified);
  CHECK(optimum.found.x == Point{4, 0});
  CHECK(optimum.found.assessment.objective.value == 20);
  CHECK(optimum.combinations == 121);
  CHECK(optimum.solved == 121);
  CHECK(optimum.found.assessment.global);
  CHECK(contains(optimum.found.assessment.reason, "all 121 combinations were solved"));
}

TEST_CASE("whole and continuous variables together", "[optimise]") {
  // Least (n - 2.4)^2 + (x - n / 2)^2 + x: x = n / 2 - 1/2, and (n - 2.4)^2 + n / 2 - 1/4 over
  // whole n: 1.71 at 1, 0.91 at 2, 1.61 at 3. Bounds that are not whole narrow to 1 .. 6.
  Problem problem;
  problem.variables = {whole("n", 0.5, 6.5, 5), variable("x", -9, 9)};
  problem.objective = least(convex(
      {0, 1}, [](const auto& u) { return square(u[0] - 2.4) + square(u[1] - 0.5 * u[0]) + u[1]; }));
  const Optimum optimum = optimise(problem);
  CHECK(optimum.found.assessment.verdict == Verdict::Certified);
  CHECK(optimum.combinations == 6);
  CHECK(optimum.found.x[0] == 2);
  CHECK(optimum.found.x[1] == Approx(0.5).epsilon(1e-6));
  CHECK(optimum.found.assessment.objective.value == Approx(0.91).epsilon(1e-8));
  CHECK(optimum.found.assessment.global);
}

namespace {

/// A convex problem in three whole variables of 0 to 20, 9261 combinations: too many to try.
Problem many_combinations(double most_in_all) {
  Problem problem;
  problem.variables = {whole("a", 0, 20), whole("b", 0, 20, 7), whole("c", 0, 20, 20)};
  problem.objective = least(convex({0, 1, 2}, [](const auto& u) {
    return square(u[0] - 4.4) + 2.0 * square(u[1] - 7.5) + square(u[2] - 9.7) + square(u[0] - u[2]);
  }));
  problem.constraints = {at_most(
      "all", linear({0, 1, 2}, [](const auto& u) { return 3.0 * u[0] + 2.0 * u[1] + u[2]; }),
      most_in_all)};
  return problem;
}

/// The least objective over all combinations that meet the limits, by trying each.
double by_trying(const Problem& problem) {
  double least_value = kInfinity;
  Point x(3);
  for (x[0] = 0; x[0] <= 20; ++x[0]) {
    for (x[1] = 0; x[1] <= 20; ++x[1]) {
      for (x[2] = 0; x[2] <= 20; ++x[2]) {
        const auto meets = [&](const Constraint& c) {
          const double value = c.response.function().value(x);
          return value <= c.upper.value_or(kInfinity) && value >= c.lower.value_or(-kInfinity);
        };
        if (!std::all_of(problem.constraints.begin(), problem.constraints.end(), meets)) continue;
        least_value = std::min(least_value, problem.objective.response.function().value(x));
      }
    }
  }
  return least_value;
}

}  // namespace

TEST_CASE("many whole combinations are searched by branch and bound", "[optimise]") {
  for (const double limit : {1000.0, 37.5, 30.0, 17.2, 0.5}) {
    INFO("limit " << limit);
    const Problem problem = many_combinations(limit);
    const Optimum optimum = optimise(problem);
    const Assessment& a = optimum.found.assessment;
    CHECK(a.verdict == Verdict::Certified);
    CHECK(a.objective.value == Approx(by_trying(problem)).epsilon(1e-9));
    for (const double value : optimum.found.x) CHECK(value == std::round(value));
    CHECK(optimum.combinations == 9261);
    CHECK(optimum.solved < 1000);
    CHECK(a.global);
    CHECK(contains(a.reason, "branch and bound"));
  }
}

TEST_CASE("branch and bound maximises too", "[optimise]") {
  // Most 8 a + 11 b + 6 c where 5 a + 7 b + 4 c <= 14 and each is 0 to 20: a = 0, b = 2 gives 22,
  // a = 2, c = 1 also 22, a = 1, b = 1 19; the relaxation takes a = 14/5: 22.4. Against trying all.
  Problem problem = many_combinations(0);
  problem.objective =
      most(linear({0, 1, 2}, [](const auto& u) { return 8.0 * u[0] + 11.0 * u[1] + 6.0 * u[2]; }));
  problem.constraints = {at_most(
      "weight",
      linear({0, 1, 2}, [](const auto& u) { return 5.0 * u[0] + 7.0 * u[1] + 4.0 * u[2]; }), 14)};
  const Optimum optimum = optimise(problem);
  CHECK(optimum.found.assessment.verdict == Verdict::Certified);
  CHECK(optimum.found.assessment.objective.value == Approx(22).epsilon(1e-9));
  CHECK(optimum.combinations == 9261);
}

TEST_CASE("branch and bound certifies nothing that it excluded by problems that are not convex",
          "[optimise]") {
  // Least sin(n) for n of 0 to 3000: n = 11 is close to 7 pi/2, -0.99999.
  Problem problem;
  problem.variables = {whole("n", 0, 3000, 7)};
  problem.objective = least(function({0}, [](const auto& u) { return sin(u[0]); }));
  const Optimum optimum = optimise(problem);
  CHECK_FALSE(optimum.found.assessment.global);
  const bool good = optimum.found.assessment.objective.value <= std::sin(11.0);
  CHECK((good || optimum.found.assessment.verdict != Verdict::Certified));
}

TEST_CASE("whole values at which the model is undefined are passed over", "[optimise]") {
  // (n - 2)^2 + x^2 with numbers for n >= 5 only: 9.
  Problem problem;
  problem.variables = {whole("n", 0, 9, 1), variable("x", -1, 1, 0.5)};
  problem.objective = least(function({0, 1}, [](const auto& u) {
    return square(u[0] - 2.0) + square(u[1]) + 0.0 * log(u[0] - 4.5);
  }));
  const Optimum optimum = optimise(problem);
  CHECK(optimum.found.x.at(0) == 5);
  CHECK(optimum.found.assessment.objective.value == Approx(9).epsilon(1e-9));
  CHECK(optimum.found.assessment.verdict == Verdict::Feasible);
  CHECK(optimum.found.assessment.reason == "not every one of the 10 combinations was settled");
}

TEST_CASE("whole numbers that no limit allows are infeasible, tried one by one", "[optimise]") {
  // 2 a = 3 is met between whole numbers alone.
  Problem problem;
  problem.variables = {whole("a", 0, 10), variable("x", 0, 1)};
  problem.objective = least(linear({0, 1}, [](const auto& u) { return u[0] + u[1]; }));
  problem.constraints = {equal("odd", linear({0}, [](const auto& u) { return 2.0 * u[0]; }), 3)};
  const Optimum optimum = optimise(problem);
  CHECK(optimum.found.assessment.verdict == Verdict::Infeasible);
  CHECK(optimum.combinations == 11);
  CHECK(contains(optimum.found.assessment.reason, "none of 11"));
  CHECK(std::find(optimum.found.assessment.blamed.begin(), optimum.found.assessment.blamed.end(),
                  "odd") != optimum.found.assessment.blamed.end());
}

TEST_CASE("whole numbers that no limit allows are infeasible by branch and bound", "[optimise]") {
  // 0.2 <= a <= 0.8 leaves reals, but no whole a.
  Problem problem = many_combinations(100);
  problem.constraints.push_back(
      {.response = {"narrow", "mm", linear({0}, [](const auto& u) { return u[0]; })},
       .lower = 0.2,
       .upper = 0.8});
  const Found found = optimise(problem).found;
  CHECK(found.assessment.verdict == Verdict::Infeasible);
  CHECK(contains(found.assessment.reason, "none of 9261"));
}

TEST_CASE("limits that even real numbers cannot meet are infeasible by branch and bound",
          "[optimise]") {
  // 3 a + 2 b + c <= 3.3 and a + b + c >= 9.9: with a = b = 0 c would be 3.3 and 9.9.
  Problem problem = many_combinations(3.3);
  problem.constraints.push_back(
      at_least("enough", linear({0, 1, 2}, [](const auto& u) { return u[0] + u[1] + u[2]; }), 9.9));
  const Found found = optimise(problem).found;
  CHECK(found.assessment.verdict == Verdict::Infeasible);
  CHECK(contains(found.assessment.reason, "none of 9261"));
}

namespace {

/// Least cost (x - target)^2 + price where x <= limit, by option.
ProblemSpace stock(std::vector<double> targets, std::vector<double> prices,
                   std::vector<double> limits) {
  ProblemSpace space;
  Choice size{"size", "mm", {}, {}};
  for (std::size_t i = 0; i < targets.size(); ++i)
    size.options.push_back("size " + std::to_string(i));
  space.choices = {size};
  space.problem = [=](const std::vector<std::size_t>& options) {
    const std::size_t i = options.at(0);
    const double target = targets[i], price = prices[i];
    Problem problem;
    problem.variables = {variable("x", 0, 10, 1)};
    problem.objective = least(
        convex({0}, [target, price](const auto& u) { return square(u[0] - target) + price; }));
    problem.constraints = {
        at_most("reach", linear({0}, [](const auto& u) { return u[0]; }), limits[i])};
    return problem;
  };
  return space;
}

}  // namespace

TEST_CASE("of several options the best is taken, and one that cannot be met is passed over",
          "[optimise]") {
  // Option 0: cost 5. Option 1 would be 0, but x <= -1 cannot be. Option 2: x <= 3 for 4: 1 + 2.
  const Optimum optimum = optimise(stock({2, 2, 4}, {5, 0, 2}, {9, -1, 3}));
  const Assessment& a = optimum.found.assessment;
  CHECK(a.verdict == Verdict::Certified);
  CHECK(optimum.options == std::vector<std::size_t>{2});
  CHECK(a.objective.value == Approx(3).epsilon(1e-6));
  CHECK(optimum.found.x[0] == Approx(3).epsilon(1e-6));
  CHECK(optimum.combinations == 3);
  CHECK(optimum.solved == 3);
  CHECK(a.global);
  CHECK(a.limits[0].multiplier == Approx(2).epsilon(1e-5));
  CHECK(optimum.problem.constraints[0].upper == 3);
}

TEST_CASE("where no option can be met, the one of least violation is shown", "[optimise]") {
  const Optimum optimum = optimise(stock({2, 2}, {5, 0}, {-3, -1}));
  CHECK(optimum.found.assessment.verdict == Verdict::Infeasible);
  CHECK(contains(optimum.found.assessment.reason, "none of 2"));
  CHECK(optimum.found.assessment.blamed == Names{"reach", "lower bound of x"});
}

TEST_CASE("an option whose model throws does not hide the others", "[optimise]") {
  for (const std::size_t broken : {0, 1}) {
    ProblemSpace space = stock({2, 2}, {5, 5}, {9, 9});
    const auto sound = space.problem;
    space.problem = [=](const std::vector<std::size_t>& options) {
      Problem problem = sound(options);
      if (options[0] == broken) {
        problem.objective.response.measure =
            watched(problem.objective.response.function(),
                    [](auto) { throw std::runtime_error("no such size"); });
      }
      return problem;
    };
    const Optimum optimum = optimise(space);
    CHECK(optimum.options == std::vector<std::size_t>{1 - broken});
    CHECK(optimum.found.assessment.objective.value == Approx(5).epsilon(1e-9));
    // One option was not settled: the answer is the best known, not the best.
    CHECK(optimum.found.assessment.verdict == Verdict::Feasible);
  }
}

TEST_CASE("choices and whole numbers multiply", "[optimise]") {
  // Two choices of two options and n of 1 to 3: 12 combinations; least |10 i + j - 2 n| by its
  // square: i = 0, j = 1 and n = 1: 1.
  ProblemSpace space;
  space.choices = {{"tens", "", {"0", "10"}, {0, 10}}, {"ones", "", {"1", "7"}, {1, 7}}};
  space.problem = [choices = space.choices](const std::vector<std::size_t>& options) {
    const double offset = choices[0].values[options[0]] + choices[1].values[options[1]];
    Problem problem;
    problem.variables = {whole("n", 1, 3, 2)};
    problem.objective =
        least(convex({0}, [offset](const auto& u) { return square(offset - 2.0 * u[0]); }));
    return problem;
  };
  const Optimum optimum = optimise(space);
  CHECK(optimum.combinations == 12);
  CHECK(optimum.solved == 12);
  // 7 and n = 3 give 1 as well: the first found stays.
  CHECK(optimum.options == std::vector<std::size_t>{0, 0});
  CHECK(optimum.found.x == Point{1});
  CHECK(optimum.found.assessment.objective.value == 1);
  CHECK(optimum.found.assessment.verdict == Verdict::Certified);
}

TEST_CASE("where time runs out among combinations, the best so far is feasible", "[optimise]") {
  Problem problem;
  problem.variables = {whole("a", 0, 400), variable("x", -1, 1, 0.5)};
  problem.objective = least(
      watched(convex({0, 1}, [](const auto& u) { return square(u[0] - 300.0) + square(u[1]); }),
              [](auto) { std::this_thread::sleep_for(std::chrono::milliseconds(2)); }));
  const Optimum optimum = optimise(problem, {.time_limit = 0.3});
  CHECK(optimum.wall_s < 5);
  CHECK(optimum.solved < 401);
  CHECK(optimum.found.assessment.verdict == Verdict::Feasible);
  REQUIRE(optimum.found.x.size() == 2);
  CHECK(optimum.found.x[0] == std::round(optimum.found.x[0]));
}

TEST_CASE("a choice without options and too many combinations are refused", "[optimise]") {
  ProblemSpace space = ProblemSpace::of(bowl());
  space.choices = {{"empty", "", {}, {}}};
  CHECK_THROWS_WITH(optimise(space), "choice 'empty': it has no options");
  space.choices.assign(6, {"digit", "", Names(10, "option"), {}});
  CHECK_THROWS_AS(optimise(space), std::invalid_argument);
}

TEST_CASE("fixed variables stay where they are", "[optimise]") {
  // y = 1/2 is given: 2 (x - 1) + 1/2 = 0.
  Problem problem = bowl();
  problem.variables[1] = variable("y", 0.5, 0.5, 0.5);
  const Found found = optimise(problem).found;
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.x[0] == Approx(0.75).epsilon(1e-6));
  CHECK(found.x[1] == 0.5);
  CHECK(found.assessment.variables[1].multiplier == 0);
  CHECK_FALSE(found.assessment.variables[1].at_lower);
  // Not a bit off either where scaling rounds.
  problem.variables[1] = variable("y", 0.1, 0.1, 0.1);
  problem.variables[1].scale = 3;
  CHECK(optimise(problem).found.x[1] == 0.1);
  // And where nothing varies, the one design is judged.
  problem.variables[0] = variable("x", 1, 1, 1);
  const Found only = optimise(problem).found;
  CHECK(only.assessment.verdict == Verdict::Certified);
  CHECK(only.x == Point{1, 0.1});
}

TEST_CASE("a problem without variables is judged as it stands", "[optimise]") {
  const auto number = [](double c) {
    return linear({}, [c](const auto& u) {
      using T = std::remove_cvref_t<decltype(u[0])>;
      return constant<T>(c);
    });
  };
  Problem problem;
  problem.objective = least(number(4));
  problem.constraints = {at_most("load", number(2), 3)};
  for (const std::string solver : {"auto", "ipopt", "cobyla", "crs2"}) {
    INFO(solver);
    problem.constraints[0].upper = 3;
    const Found met = optimise(problem, {.solver = solver}).found;
    CHECK(met.assessment.verdict == Verdict::Certified);
    CHECK(met.assessment.objective.value == 4);
    CHECK(met.x.empty());
    problem.constraints[0].upper = 1;
    const Found passed = optimise(problem, {.solver = solver}).found;
    CHECK(passed.assessment.verdict == Verdict::Infeasible);
    CHECK(passed.assessment.blamed == Names{"load"});
  }
}

TEST_CASE("an unknown solver is refused with the list of known ones", "[optimise]") {
  try {
    optimise(bowl(), {.solver = "simplex"});
    FAIL("no exception");
  } catch (const std::invalid_argument& e) {
    CHECK(contains(e.what(), "'simplex'"));
    for (const std::string& name : solver_names()) CHECK(contains(e.what(), name));
  }
  CHECK_THROWS_AS(optimise(bowl(), {.starts = 0}), std::invalid_argument);
}

TEST_CASE("a problem that is not well posed is refused", "[optimise]") {
  Problem problem = bowl();
  problem.variables[0].lower = 5;
  CHECK_THROWS_WITH(optimise(problem), "variable 'x': lower 5 exceeds upper 3");
}

namespace {

/// Runs a back end on a problem with its optimum known; what it refuses it must refuse in words.
void check_back_end(const std::string& name, const Problem& problem, double optimum) {
  INFO(name << " on " << problem.name);
  const Point start = problem.start();
  const auto refused = refusal(problem, sizes(problem, start), start, find_solver(name));
  const Found found =
      optimise(problem, {.solver = name, .starts = 1, .max_evaluations = 3000}).found;
  if (refused) {
    CHECK(found.assessment.verdict == Verdict::Failed);
    CHECK(found.assessment.reason == *refused);
    CHECK(contains(*refused, name));
    CHECK(found.x.empty());
    return;
  }
  // Methods without derivatives come near; whether it is near enough the verdict says.
  CHECK(is_feasible(found.assessment));
  CHECK(found.assessment.verdict != Verdict::Failed);
  CHECK(found.assessment.objective.value == Approx(optimum).epsilon(1e-4));
  if (found.assessment.verdict == Verdict::Certified) {
    CHECK(found.assessment.objective.value == Approx(optimum).epsilon(1e-6));
  }
  const std::set<std::string> exact{"ipopt", "slsqp", "lbfgs", "auglag-lbfgs", "crs2", "isres"};
  if (exact.contains(name)) CHECK(found.assessment.verdict == Verdict::Certified);
}

}  // namespace

TEST_CASE("every back end solves what it accepts and refuses the rest in words", "[optimise]") {
  std::vector<Problem> problems(4, bowl());
  problems[0].name = "a box";
  problems[1].name = "a limit";
  problems[1].constraints = {at_least("sum", sum(), 1)};
  problems[2].name = "an equation";
  problems[2].constraints = {equal("sum", sum(), 1)};
  problems[3].name = "no box";
  problems[3].variables[0].upper = kInfinity;
  const Point optima{-11.0 / 14, -0.625, -0.625, -11.0 / 14};
  for (const std::string& name : solver_names()) {
    for (std::size_t i = 0; i < problems.size(); ++i) check_back_end(name, problems[i], optima[i]);
  }
}

TEST_CASE("some back ends refuse, and none drops a limit", "[optimise]") {
  Problem limited = bowl();
  limited.constraints = {at_least("sum", sum(), 1)};
  CHECK(optimise(limited, {.solver = "lbfgs"}).found.assessment.reason ==
        "lbfgs takes no constraints beside bounds on the variables");
  limited.constraints = {equal("sum", sum(), 1)};
  CHECK(optimise(limited, {.solver = "mma"}).found.assessment.reason == "mma takes no equations");
  limited.variables[0].upper = kInfinity;
  CHECK(optimise(limited, {.solver = "isres"}).found.assessment.reason ==
        "isres searches the whole box: each variable needs a lower and an upper bound");
}

TEST_CASE("progress is reported in the problem's units", "[optimise]") {
  int calls = 0;
  double last = kNan;
  OptimiseOptions options{.solver = "ipopt"};
  options.progress = [&](const Progress& p) { ++calls, last = p.objective; };
  Problem problem = bowl();
  const Found found = optimise(problem, options).found;
  CHECK(calls > 1);
  CHECK(last == Approx(found.assessment.objective.value).epsilon(1e-6));
}

TEST_CASE("statuses have words of their own", "[optimise]") {
  std::set<std::string_view> words;
  for (const Status status :
       {Status::Solved, Status::Acceptable, Status::Stalled, Status::IterationLimit,
        Status::TimeLimit, Status::Infeasible, Status::Unbounded, Status::NonFiniteStart,
        Status::Stopped, Status::Failed}) {
    words.insert(to_string(status));
  }
  CHECK(words.size() == 10);
  CHECK_FALSE(words.contains("?"));
}

}  // namespace camlaw::optim
