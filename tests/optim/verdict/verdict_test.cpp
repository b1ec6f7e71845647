// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "optim/cycle/peak_function.h"
#include "tests/optim/verdict/judged_problems.h"

namespace camlaw::optim::verdict_test {

using std::log, std::sqrt;

using namespace verdict_tests;

TEST_CASE("an optimum is certified, with its limit, multiplier and why none is better anywhere",
          "[verdict]") {
  const Assessment a = judge(projection(), {1.5, 0.5});
  CHECK(a.verdict == Verdict::Certified);
  CHECK(a.objective.value == 0.5);
  CHECK(a.objective.proved.lower <= 0.5);
  CHECK(a.objective.proved.upper >= 0.5);
  CHECK(a.objective.proved.upper - a.objective.proved.lower < 1e-15);
  CHECK(a.kkt_residual <= 1e-12);
  CHECK(a.second_order);
  CHECK(a.condition == Approx(1));
  CHECK(a.active == Names{"sum"});
  CHECK(a.blamed.empty());
  CHECK(a.global);
  CHECK(is_feasible(a));
  REQUIRE(a.limits.size() == 1);
  const LimitReport& sum = a.limits[0];
  CHECK(sum.name == "sum");
  CHECK(sum.unit == "mm");
  CHECK(sum.value == 2);
  CHECK(sum.bound == 2);
  CHECK(sum.is_upper);
  CHECK(sum.margin == 0);
  CHECK(sum.tolerance == Approx(2e-6));
  CHECK(sum.met);
  CHECK(sum.proved);
  CHECK_FALSE(sum.worst_angle);
  CHECK(sum.multiplier == Approx(1).epsilon(1e-12));
  REQUIRE(a.variables.size() == 2);
  CHECK(a.variables[0].name == "x");
  CHECK(a.variables[0].value == 1.5);
  CHECK(a.variables[0].upper == 10);
  CHECK_FALSE(a.variables[0].at_lower);
  CHECK(a.variables[0].multiplier == 0);
}

TEST_CASE("without proof a good design is feasible at best", "[verdict]") {
  const Assessment a = judge(projection(), {1.5, 0.5}, false);
  CHECK(a.verdict == Verdict::Feasible);
  CHECK(a.reason == "not proved yet");
  CHECK_FALSE(a.limits[0].proved);
  CHECK(std::isinf(a.objective.proved.upper));
  CHECK(a.kkt_residual <= 1e-12);
}

TEST_CASE("a design with room to improve is feasible, and the reason gives the residual",
          "[verdict]") {
  for (const Point& x : {Point{1, 0.5}, Point{1, 1}, Point{0, 2}, Point{2, 0}, Point{0, 0}}) {
    INFO(x[0] << " " << x[1]);
    const Assessment a = judge(projection(), x);
    CHECK(a.verdict == Verdict::Feasible);
    CHECK(a.reason.find("conditions of optimality") != std::string::npos);
    CHECK(a.kkt_residual > 1e-3);
    CHECK_FALSE(a.global);
    CHECK(a.limits[0].margin == 2 - x[0] - x[1]);
    CHECK(is_feasible(a));
  }
}

TEST_CASE("a limit passed within its tolerance counts as met", "[verdict]") {
  const Assessment a = judge(projection(), {1.5 + 4e-7, 0.5 + 4e-7});
  CHECK(a.verdict == Verdict::Certified);
  CHECK(a.limits[0].met);
  CHECK(a.limits[0].margin == Approx(-8e-7).epsilon(1e-6));
  CHECK(worst_violation(a.limits) == Approx(0.4).epsilon(1e-6));
  // The tolerance that was asked for decides.
  Problem strict = projection();
  strict.constraints[0].tolerance = 1e-9;
  CHECK(judge(strict, {1.5 + 4e-7, 0.5 + 4e-7}).verdict == Verdict::Failed);
}

TEST_CASE("a design that violates a limit fails, and the reason names it", "[verdict]") {
  const Assessment a = judge(projection(), {2, 1});
  CHECK(a.verdict == Verdict::Failed);
  CHECK(a.reason == "the design does not meet sum");
  CHECK(a.limits[0].margin == -1);
  CHECK_FALSE(a.limits[0].met);
  CHECK_FALSE(is_feasible(a));
  CHECK(worst_violation(a.limits) == Approx(1 / 2e-6));
}

TEST_CASE("a design outside a variable's bounds fails, and the reason names the variable",
          "[verdict]") {
  for (const Point& x : {Point{-1e-9, 0.5}, Point{-1, 1}, Point{-20, 10}}) {
    const Assessment a = judge(projection(), x);
    CHECK(a.verdict == Verdict::Failed);
    CHECK_FALSE(is_feasible(a));
    CHECK(a.reason.find("lower bound of x") != std::string::npos);
  }
}

namespace {

// Of plain numbers; those of other scalars are found by their arguments.
using std::log;
using std::sqrt;

/// x, proved to lie within `room` of itself.
class Vague final : public Kernel {
 public:
  explicit Vague(double room) : room_(room) {}
  double value(std::span<const double> u) const override { return u[0]; }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    g[0] = 1;
    return u[0];
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    h[0] = 0;
    return gradient(u, g);
  }
  Bounds enclose(std::span<const double> u) const override { return {u[0] - room_, u[0] + room_}; }
  bool is_enclosed() const override { return true; }

 private:
  double room_;
};

Response vague(const char* name, std::size_t variable, double room) {
  return {name, "mm", Function({variable}, std::make_shared<Vague>(room), Shape::Linear)};
}

}  // namespace

TEST_CASE("a number that its enclosure does not prove is not certified", "[verdict]") {
  for (const double room : {0.0, 1.0}) {
    Problem problem = projection();
    problem.constraints.push_back({.response = vague("vague", 0, room), .upper = 1.6});
    const Assessment a = judge(problem, {1.5, 0.5});
    CHECK(a.limits[1].met);
    CHECK(a.verdict == (room == 0 ? Verdict::Certified : Verdict::Feasible));
    if (room > 0) CHECK(a.reason == "vague is met, but intervals do not prove it");
    Problem lowest;
    lowest.variables = {{.name = "x", .lower = 1, .upper = 2, .start = 1.5}};
    lowest.objectives = {{.response = vague("vague", 0, room)}};
    const Assessment b = judge(lowest, {1});
    CHECK(b.verdict == (room == 0 ? Verdict::Certified : Verdict::Feasible));
    if (room > 0) CHECK(b.reason == "vague is only proved to lie between 0 and 2");
  }
}

TEST_CASE("a design at which the model is undefined fails", "[verdict]") {
  Problem problem = projection();
  problem.constraints[0].response.measure =
      function({0, 1}, [](const auto& u) { return sqrt(u[0] - 1.0) + u[1]; });
  CHECK(judge(problem, {0.5, 0.5}).verdict == Verdict::Failed);
  CHECK(judge(problem, {0.5, 0.5}).reason.find("undefined") != std::string::npos);
  CHECK_FALSE(judge(problem, {0.5, 0.5}).limits[0].met);
  CHECK_FALSE(judge(problem, {0.5, 0.5}).limits[0].proved);
  problem = projection();
  problem.objectives = {least(function({0, 1}, [](const auto& u) { return log(u[0]) + u[1]; }))};
  CHECK(judge(problem, {0, 1}).verdict == Verdict::Failed);
  problem = projection();
  problem.constraints[0].response.measure = curve<Interval>(
      {0, 1}, 0, 1, [](const auto& u, const auto& angle) { return sqrt(u[0] - angle) + u[1]; });
  CHECK(judge(problem, {0.5, 0.5}).verdict == Verdict::Failed);
  CHECK(judge(problem, {0.5, 0.5}).reason.find("undefined") != std::string::npos);
  CHECK(judge(problem, {2, 0.1}).limits[0].met);
  CHECK(judge(problem, {kNan, 0.5}).verdict == Verdict::Failed);
}

TEST_CASE("a derivative that is not a number keeps a design from being certified", "[verdict]") {
  // sqrt(x) at 0: the value is one, the slope is not.
  Problem problem;
  problem.variables = {{.name = "x", .lower = 0, .upper = 1, .start = 0.5}};
  problem.objectives = {least(function({0}, [](const auto& u) { return sqrt(u[0]) * u[0]; }))};
  const Assessment a = judge(problem, {0});
  CHECK(a.objective.value == 0);
  CHECK(a.verdict == Verdict::Feasible);
}

TEST_CASE("of two bounds the report takes the nearer, or the one passed by more", "[verdict]") {
  Problem problem = projection();
  problem.constraints[0].lower = -1;
  const auto at = [&](double x) { return judge(problem, {x, 0}).limits[0]; };
  CHECK(at(0.25).bound == -1);  // room of 1.25 below, 1.75 above
  CHECK_FALSE(at(0.25).is_upper);
  CHECK(at(0.25).margin == 1.25);
  CHECK(at(1).bound == 2);
  CHECK(at(1).is_upper);
  CHECK(at(1).margin == 1);
  CHECK(at(4).margin == -2);
  CHECK(at(4).is_upper);
  CHECK(at(-1.5).margin == -0.5);
  CHECK_FALSE(at(-1.5).is_upper);
}

TEST_CASE("a limit over the cycle reports the worst angle of the side it names", "[verdict]") {
  const auto at = [](const Point& x) { return judge(over_cycle(-2, 3, true), x).limits[0]; };
  // x sin(a) + y, highest at pi/2, lowest at 3 pi/2.
  const LimitReport above = at({1, 1.5});  // between 0.5 and 2.5
  CHECK(above.is_upper);
  CHECK(above.value == Approx(2.5).epsilon(1e-15));
  CHECK(above.margin == Approx(0.5).epsilon(1e-14));
  REQUIRE(above.worst_angle);
  CHECK(*above.worst_angle == Approx(kPi / 2).epsilon(1e-9));
  CHECK(above.met);
  CHECK(above.proved);
  const LimitReport below = at({1, -0.75});  // between -1.75 and 0.25
  CHECK_FALSE(below.is_upper);
  CHECK(below.value == Approx(-1.75).epsilon(1e-15));
  CHECK(below.margin == Approx(0.25).epsilon(1e-14));
  CHECK(*below.worst_angle == Approx(3 * kPi / 2).epsilon(1e-9));
  const LimitReport both = at({4, 1});  // between -3 and 5: passed by 1 and by 2
  CHECK(both.is_upper);
  CHECK(both.margin == Approx(-2).epsilon(1e-14));
  CHECK_FALSE(both.met);
  CHECK_FALSE(both.proved);
  // Sin has turned round where x is negative.
  CHECK(*at({-1, 1.5}).worst_angle == Approx(3 * kPi / 2).epsilon(1e-9));
}

TEST_CASE("an optimum over the cycle is certified where intervals prove the limit", "[verdict]") {
  // Most x + 3 y where |x| + y <= 3, and y <= 2 by the box: x = 1, y = 2. One more of 3 brings x
  // one; one more of y brings 3 and costs x one.
  Problem problem = over_cycle(-2, 3, true);
  problem.variables[1].upper = 2;
  const Assessment a = judge(problem, {1, 2});
  CHECK(a.verdict == Verdict::Certified);
  CHECK(a.limits[0].proved);
  CHECK(a.limits[0].multiplier == Approx(1).epsilon(1e-9));
  CHECK(a.variables[1].at_upper);
  CHECK(a.variables[1].multiplier == Approx(2).epsilon(1e-9));
  CHECK(a.active == Names{"wave", "upper bound of y"});
  CHECK(a.global);
}

TEST_CASE("without enclosures an optimum over the cycle is not certified", "[verdict]") {
  Problem problem = over_cycle(-2, 3, false);
  problem.variables[1].upper = 2;
  const Assessment a = judge(problem, {1, 2});
  CHECK(a.verdict == Verdict::Feasible);
  CHECK_FALSE(a.limits[0].proved);
  CHECK(a.limits[0].met);
  CHECK(a.reason == "wave is met wherever it was evaluated, but not proved over the whole cycle");
  CHECK_FALSE(a.global);
}

TEST_CASE("without enclosures a least peak is not certified", "[verdict]") {
  // Least highest of x sin(a) + y where y >= 1: x = 0, y = 1.
  for (const bool enclosed : {true, false}) {
    Problem problem = over_cycle({}, 3, enclosed);
    problem.objectives = {{problem.constraints[0].response, Sense::Minimize, Part::Highest, {}}};
    problem.constraints.clear();
    problem.variables[1].lower = 1;
    const Assessment a = judge(problem, {0, 1});
    CHECK(a.objective.value == 1);
    CHECK(a.kkt_residual <= kKktTolerance);
    CHECK(a.verdict == (enclosed ? Verdict::Certified : Verdict::Feasible));
    CHECK(std::isfinite(a.objective.proved.upper) == enclosed);
  }
}

TEST_CASE("a number that hangs on a peak is certified only where the peak is proved", "[verdict]") {
  // The least highest of x sin(a) + y as a number, |x| + y, where y >= 1; and a limit on it.
  for (const bool enclosed : {true, false}) {
    Problem problem = over_cycle({}, 3, enclosed);
    const Response peak{"crest", "mm",
                        peak_function(problem.constraints[0].response, Part::Highest, 2)};
    problem.constraints = {{.response = peak, .upper = 3}};
    problem.variables[0].lower = 1;
    const Assessment limited = judge(problem, {1, 2});
    CHECK(limited.kkt_residual <= kKktTolerance);
    CHECK(limited.verdict == (enclosed ? Verdict::Certified : Verdict::Feasible));
    CHECK(limited.limits[0].multiplier == Approx(3).epsilon(1e-9));
    problem.objectives = {{peak, Sense::Minimize, Part::Value, {}}};
    problem.constraints.clear();
    problem.variables[1].lower = 1;
    const Assessment least = judge(problem, {1, 1});
    CHECK(least.objective.value == Approx(2));
    CHECK(least.verdict == (enclosed ? Verdict::Certified : Verdict::Feasible));
    CHECK((enclosed || least.reason == "crest is not proved"));
  }
}

/// x a / 360 and a spike of height 1, 0.002 wide, at kSpike, between the samples; with an upper
/// limit.
constexpr double kSpike = 100.123;
Problem with_a_spike(double limit) {
  Problem problem;
  problem.variables = {{.name = "x", .lower = 0, .upper = 1, .start = 0.2}};
  problem.objectives = {most(function(
      {0}, [](const auto& u) { return u[0]; }, Shape::Linear))};
  problem.constraints = {
      {.response = {"spike", "mm",
                    curve<Interval>({0}, 0, 360,
                                    [](const auto& u, const auto& angle) {
                                      using T = std::remove_cvref_t<decltype(angle)>;
                                      const T one = constant<T>(1);
                                      const T t = (angle - constant<T>(kSpike)) / constant<T>(1e-3);
                                      return u[0] * angle / constant<T>(360) + one / (one + t * t);
                                    })},
       .upper = limit}};
  return problem;
}

TEST_CASE("a proof finds a limit broken where the search sees none, and reports the place",
          "[verdict]") {
  const Problem problem = with_a_spike(1);
  CHECK(judge(problem, {0.2}, false).limits[0].met);
  const Assessment a = judge(problem, {0.2}, true);
  CHECK(a.verdict == Verdict::Failed);
  CHECK_FALSE(a.limits[0].met);
  CHECK_FALSE(a.limits[0].proved);
  CHECK(a.limits[0].value > 1);
  CHECK(*a.limits[0].worst_angle == Approx(kSpike).margin(0.01));
}

TEST_CASE("the highest value of a limit that is met is proved too", "[verdict]") {
  const Assessment a = judge(with_a_spike(10), {0.2}, true);
  CHECK(a.limits[0].met);
  CHECK(a.limits[0].proved);
  CHECK(a.limits[0].value == Approx(1 + 0.2 * kSpike / 360).epsilon(1e-7));
  CHECK(*a.limits[0].worst_angle == Approx(kSpike).margin(1e-5));
}

TEST_CASE("an objective over the cycle comes with its angle and proved bounds", "[verdict]") {
  Problem problem = over_cycle(-4, 4, true);
  const auto measure = problem.constraints[0].response.measure;
  const auto at = [&](Part part, Sense sense) {
    problem.objectives = {{{"cost", "N", measure}, sense, part, {}}};
    return objective_report(problem, scales(problem, problem.start()), Point{1.5, -0.5},
                            true);  // between -2 and 1
  };
  const ObjectiveReport highest = at(Part::Highest, Sense::Minimize);
  CHECK(highest.value == Approx(1).epsilon(1e-15));
  CHECK(*highest.angle == Approx(kPi / 2).epsilon(1e-9));
  CHECK(highest.proved.lower <= 1);
  CHECK(highest.proved.upper >= 1);
  CHECK(highest.proved.upper <= 1 + 1e-8);
  const ObjectiveReport lowest = at(Part::Lowest, Sense::Maximize);
  CHECK(lowest.value == Approx(-2).epsilon(1e-15));
  CHECK(*lowest.angle == Approx(3 * kPi / 2).epsilon(1e-9));
  CHECK(lowest.proved.lower >= -2 - 1e-8);
  CHECK(lowest.proved.lower <= -2);
  CHECK(lowest.proved.upper >= -2);
  const ObjectiveReport magnitude = at(Part::Magnitude, Sense::Minimize);
  CHECK(magnitude.value == Approx(2).epsilon(1e-15));
  CHECK(*magnitude.angle == Approx(3 * kPi / 2).epsilon(1e-9));
  CHECK(magnitude.proved.upper >= 2);
  CHECK(magnitude.proved.upper <= 2 + 1e-8);
}

namespace {

/// Assessments of one problem, from best to worst; within one class none is better.
std::vector<std::vector<Assessment>> ranks(const Problem& problem) {
  const auto at = [&](const Point& x) { return judge(problem, x, false); };
  const auto with = [&](double objective, std::vector<double> margins) {
    Assessment a = at({1, 0.5});
    a.objective.value = objective;
    a.limits.resize(margins.size(), a.limits.front());
    for (std::size_t i = 0; i < margins.size(); ++i) a.limits[i].margin = margins[i];
    return a;
  };
  return {
      {with(-kInfinity, {0}), with(kInfinity, {0}), with(kNan, {0}), with(kNan, {1}),
       with(1, {kNan}), with(1, {0, kNan}), with(1, {-1, kNan}), with(kNan, {-1}),
       at({kNan, kNan})},                                       // not numbers: the last
      {with(0.25, {-2}), with(7, {-2, 0}), with(7, {-1, -2})},  // passed by 2
      {with(0.25, {-1}), with(-9, {-1, 1})},                    // passed by 1
      {with(9, {0}), with(9, {3})},                             // feasible, cost 9
      {at({1.5, 0.5}), with(0.5, {1, 1})},                      // 0.5
      {with(-3, {-1e-6}), with(-3, {0, 0})},                    // -3, within the tolerance 2e-6
  };
}

}  // namespace

TEST_CASE("better is a strict weak order, and what is not a number comes last", "[verdict]") {
  Problem problem = projection();
  const auto classes = ranks(problem);
  struct Ranked {
    std::size_t rank;
    const Assessment* assessment;
  };
  std::vector<Ranked> all;
  for (std::size_t k = 0; k < classes.size(); ++k) {
    for (const Assessment& a : classes[k]) all.push_back({k, &a});
  }
  const auto words = [](const Ranked& r) {
    return "rank " + std::to_string(r.rank) + " of cost " +
           std::to_string(r.assessment->objective.value) + " and violation " +
           std::to_string(worst_violation(r.assessment->limits));
  };
  Names wrong;
  for (const Ranked& a : all) {
    for (const Ranked& b : all) {
      if (better(problem, *a.assessment, *b.assessment) == (a.rank > b.rank)) continue;
      wrong.push_back(words(a) + " before " + words(b));
    }
  }
  CHECK(wrong == Names{});
}

TEST_CASE("better is a strict weak order by its axioms", "[verdict]") {
  for (const Sense sense : {Sense::Minimize, Sense::Maximize}) {
    Problem problem = projection();
    problem.objectives[0].sense = sense;
    std::vector<Assessment> all{Assessment{}};
    for (const auto& rank : ranks(problem)) all.insert(all.end(), rank.begin(), rank.end());
    const auto before = [&](std::size_t i, std::size_t j) {
      return better(problem, all[i], all[j]);
    };
    const auto equal = [&](std::size_t i, std::size_t j) { return !before(i, j) && !before(j, i); };
    bool holds = true;
    for (std::size_t i = 0; i < all.size(); ++i) {
      holds = holds && !before(i, i);
      for (std::size_t j = 0; j < all.size(); ++j) {
        holds = holds && !(before(i, j) && before(j, i));
        for (std::size_t k = 0; k < all.size(); ++k) {
          holds = holds && (!(before(i, j) && before(j, k)) || before(i, k));
          holds = holds && (!(equal(i, j) && equal(j, k)) || equal(i, k));
        }
      }
    }
    CHECK(holds);
  }
}

TEST_CASE("to maximise, the greater objective is better", "[verdict]") {
  Problem problem = over_cycle(-2, 3, true);
  const Assessment low = judge(problem, {0.5, 0}, false), high = judge(problem, {1, 1}, false);
  CHECK(better(problem, high, low));
  CHECK_FALSE(better(problem, low, high));
}

TEST_CASE("what was never assessed is not feasible", "[verdict]") {
  CHECK_FALSE(is_feasible(Assessment{}));
  const Problem problem = projection();
  CHECK(better(problem, judge(problem, {1, 0.5}), Assessment{}));
  CHECK_FALSE(better(problem, Assessment{}, judge(problem, {1, 0.5})));
}

TEST_CASE("a quasiconvex objective is known to be best of all only where it slopes", "[verdict]") {
  // x^3 over [-1, 1], or as the peak of a curve: level at 0, least at -1.
  const auto cube = [](const auto& u) { return u[0] * u[0] * u[0]; };
  const auto along = [](const auto& u, const auto&) { return u[0] * u[0] * u[0]; };
  Problem problem;
  problem.variables = {{.name = "x", .lower = -1, .upper = 1, .start = 0.5}};
  for (const bool peak : {false, true}) {
    problem.objectives = {least(function({0}, cube, Shape::Quasilinear))};
    if (peak) {
      problem.objectives[0].response.measure =
          curve<Interval>({0}, 0, 1, along, Shape::Quasilinear);
      problem.objectives[0].part = Part::Highest;
    }
    CHECK_FALSE(judge(problem, {0}).global);
    const Assessment best = judge(problem, {-1});
    CHECK(best.verdict == Verdict::Certified);
    CHECK(best.global);
    CHECK(best.variables[0].multiplier == Approx(3).epsilon(1e-9));
  }
}

TEST_CASE("the design of least violation is infeasible, and the limits that push are blamed",
          "[verdict]") {
  // x >= 3 and x <= 1, both counted in units of 1: half way, at 2. "far" does not push.
  const auto x = [] {
    return function(
        {0}, [](const auto& u) { return 1.0 * u[0]; }, Shape::Linear);
  };
  Problem problem;
  problem.variables = {{.name = "x", .lower = 0, .upper = 10, .start = 5},
                       {.name = "y", .lower = 0, .upper = 10, .start = 5}};
  problem.objectives = {least(function(
      {1}, [](const auto& u) { return 1.0 * u[0]; }, Shape::Linear))};
  problem.constraints = {{.response = {"low", "mm", x()}, .lower = 3, .scale = 1},
                         {.response = {"high", "mm", x()}, .upper = 1, .scale = 1},
                         {.response = {"far", "mm", x()}, .upper = 9, .scale = 1}};
  const Scales s = scales(problem, problem.start());
  const Assessment a = assess_least_violation(problem, s, Point{2, 5});
  CHECK(a.verdict == Verdict::Infeasible);
  CHECK(a.blamed == Names{"low", "high"});
  CHECK(a.reason == "low and high contradict one another");
  CHECK(a.limits[0].margin == -1);
  CHECK(a.limits[1].margin == -1);
  CHECK(a.limits[2].margin == 7);
  CHECK(a.global);  // linear limits: nowhere is there a design
  // Elsewhere the conditions do not hold: nothing is claimed.
  const Assessment off = assess_least_violation(problem, s, Point{2.5, 5});
  CHECK(off.verdict == Verdict::Failed);
  CHECK_FALSE(off.global);
  // Of one limit alone it is said that it cannot be met.
  problem.constraints = {
      {.response = {"square", "mm^2", function({0}, [](const auto& u) { return u[0] * u[0]; })},
       .upper = -1}};
  const Assessment alone =
      assess_least_violation(problem, scales(problem, problem.start()), Point{0, 5});
  CHECK(alone.verdict == Verdict::Infeasible);
  CHECK(alone.reason == "square cannot be met");
  CHECK_FALSE(alone.global);
}

TEST_CASE("verdicts have words", "[verdict]") {
  CHECK(to_string(Verdict::Certified) == "certified optimum");
  CHECK(to_string(Verdict::Feasible) == "feasible");
  CHECK(to_string(Verdict::Infeasible) == "infeasible");
  CHECK(to_string(Verdict::Failed) == "failed");
}

TEST_CASE("slopes that are not numbers certify nothing", "[verdict]") {
  // A model with a value and no derivatives, as at the edge of where it is possible.
  class Edge final : public Kernel {
   public:
    explicit Edge(double slope) : slope_(slope) {}
    double value(std::span<const double> u) const override { return u[0]; }
    double gradient(std::span<const double> u, std::span<double> g) const override {
      g[0] = slope_;
      return u[0];
    }
    double hessian(std::span<const double> u, std::span<double> g,
                   std::span<double> h) const override {
      h[0] = kNan;
      return gradient(u, g);
    }

   private:
    double slope_;
  };
  Problem problem;
  problem.variables = {{.name = "x", .lower = -1, .upper = 1, .start = 0}};
  for (const double slope : {kNan, 0.0}) {  // without a slope, and without a second derivative
    INFO("slope " << slope);
    problem.objectives = {least(Function({0}, std::make_shared<Edge>(slope)))};
    const Assessment a = judge(problem, {0.5});
    CHECK(a.verdict == Verdict::Feasible);
    CHECK_FALSE(a.best_possible);
  }
  problem.objectives = {least(function<Interval>(
      {0}, [](const auto& u) { return square(u[0]); }, Shape::Convex))};
  problem.constraints = {
      {.response = {"edge", "mm", Function({0}, std::make_shared<Edge>(kNan))}, .lower = 0.5}};
  CHECK(judge(problem, {0.5}).verdict == Verdict::Feasible);
}

namespace {

/// -1, but for places within 1e-6 of one between those that a search looks at: there it has no
/// value.
class Gap final : public Curve {
 public:
  Function at(Place) const override {
    return function<Interval>({0}, [](const auto& u) { return 0.0 * u[0] - 1.0; });
  }
  std::unique_ptr<Trace> trace(Design) const override { return std::make_unique<Own>(); }
  Shape shape() const override { return Shape::General; }

 private:
  static constexpr double kMiddle = 0.123456, kHalf = 1e-6;
  class Own final : public Trace {
   public:
    std::vector<double> breaks() const override { return {0, 1}; }
    std::array<double, 3> at(Place place) const override {
      const bool is_gap = std::abs(place.angle - kMiddle) <= kHalf;
      return {is_gap ? kNan : -1, 0, 0};
    }
    Bounds enclose(double from, double to) const override {
      const bool is_apart = to < kMiddle - kHalf || from > kMiddle + kHalf;
      return is_apart ? Bounds{-1, -1} : Bounds{};
    }
  };
};

}  // namespace

TEST_CASE("a limit on a curve that has no value at some place is not met", "[verdict]") {
  Problem problem = projection();
  problem.constraints = {{.response = {"gap", "mm", std::make_shared<Gap>()}, .upper = 0}};
  const Assessment a = judge(problem, {2, 1});
  CHECK_FALSE(a.limits[0].met);
  CHECK_FALSE(a.limits[0].proved);
  CHECK(std::isnan(a.limits[0].value));
  CHECK(a.verdict != Verdict::Certified);
  CHECK_FALSE(is_feasible(a));
}

}  // namespace camlaw::optim::verdict_test
