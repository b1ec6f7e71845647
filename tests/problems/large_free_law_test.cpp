// SPDX-License-Identifier: MIT
// Free laws of many knots: linear problems whose multipliers are found by the solver that knows
// them, and judged by the verdict.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "optim/cycle/scales.h"
#include "optim/search/optimise.h"
#include "optim/search/told.h"
#include "optim/verdict/verdict.h"
#include "problems/statement/bind.h"

namespace camlaw::problems::large_free_law_test {
namespace {

using optim::Optimum;
using optim::Verdict;

std::string law(const std::string& rest) {
  return "mechanism = 'law'\n[law]\nname = 'free'\n[free]\n" + rest;
}

std::string limit(const std::string& response, const std::string& rest) {
  return "[[constraints]]\nresponse = '" + response + "'\n" + rest + "\n";
}

Optimum solved(const std::string& text) {
  return optim::optimise(BoundProblem(read_problem(text, "f.toml")).space());
}

/// The optimum, which must be certified and global.
double global_value(const Optimum& optimum) {
  const optim::Assessment& a = optimum.found.assessment;
  INFO(a.reason);
  CHECK(a.verdict == Verdict::Certified);
  CHECK(a.global.has_value());
  return a.objective.value;
}

/// The same design judged without its search.
optim::Assessment judged_alone(const Optimum& optimum) {
  const optim::Problem& problem = optimum.problem;
  const std::vector<double>& x = optimum.found.x;
  const optim::Scales scales = optim::scales(problem, x);
  return optim::assess(problem, scales, x, true, optim::teller_at(problem, scales, x));
}

}  // namespace

TEST_CASE("Free laws of high degree and many knots are certified", "[free][large]") {
  const Optimum optimum = solved(law("degree = 5\nknots = 290\nbegin = 'R'\nend = 'R'\n"
                                     "[objective]\nminimize = 'C_v'\n") +
                                 limit("acceleration", "upper = 6.5\nlower = -6.5"));
  const double peak = global_value(optimum);
  // Without a limit on the jerk the velocity is a trapezium: C - C^2 / a = 1.
  const double limit_of_all = 0.5 * (6.5 - std::sqrt(6.5 * 6.5 - 4 * 6.5));
  CHECK(peak > limit_of_all);
  CHECK(peak < 1.005 * limit_of_all);
  const optim::Assessment again = judged_alone(optimum);
  CHECK(again.verdict == Verdict::Certified);
  CHECK(again.global.has_value());
}

TEST_CASE("Free segments of a program are certified though most of their room is idle",
          "[free][large]") {
  const Optimum optimum = solved(
      "[machine]\nname = 'p'\nmoved_by = 'program'\n"
      "[responses.vel]\nformula = 'v'\n[responses.acc]\nformula = 'a'\n"
      "[responses.mix]\nformula = '9.7*s + 1.7*v + 2*a'\n"
      "[[program.segments]]\nname = 's0'\nangle = '60 deg'\nlaw = 'free'\nto = 1.0\n"
      "[[program.segments]]\nname = 's1'\nlaw = 'free'\nto = 0.0\n"
      "[free]\ndegree = 5\nknots = 60\n"
      "[objective]\nminimize = 'highest mix'\nfrom = '183 deg'\nto = '323 deg'\n" +
      limit("vel", "from = '77 deg'\nto = '115 deg'\nupper = 7.6") +
      limit("acc", "from = '15 deg'\nto = '72 deg'\nupper = 208\nlower = -234") +
      limit("mix", "from = '295 deg'\nto = '328 deg'\nupper = 278\nlower = -286"));
  global_value(optimum);
}

TEST_CASE("Linear limits that contradict one another by a little are called infeasible",
          "[free][large]") {
  // By another solver the least peak acceleration at these jerks is 1 % more than 5.06.
  const std::string knots = GENERATE("degree = 4\nknots = 30", "degree = 4\nknots = 120");
  const Optimum optimum = solved(
      law(knots + "\n[objective]\nminimize = 'highest displacement'\nfrom = 0.3\nto = 0.6\n") +
      limit("velocity", "upper = 1.6") + limit("acceleration", "upper = 5.0\nlower = -5.0") +
      limit("jerk", "upper = 90\nlower = -90"));
  const optim::Assessment& a = optimum.found.assessment;
  INFO(a.reason);
  CHECK(a.verdict == Verdict::Infeasible);
  CHECK(a.global.has_value());
}

TEST_CASE("An optimum of zero is certified: a magnitude is not below it", "[free][large]") {
  const std::string knots = GENERATE("knots = 60", "knots = 340");
  const Optimum optimum = solved(law("degree = 4\n" + knots +
                                     "\nbegin = 'G'\nend = 'B'\n"
                                     "[objective]\nminimize = 'C_j'\n") +
                                 limit("velocity", "upper = 2.9"));
  CHECK(std::abs(global_value(optimum)) < 1e-5);
  REQUIRE(optimum.found.assessment.best_possible.has_value());
  CHECK(*optimum.found.assessment.best_possible >= 0);
  CHECK(judged_alone(optimum).verdict == Verdict::Certified);
}

TEST_CASE("Linear problems that one method leaves are certified by another, alone as well",
          "[free][large]") {
  const std::string machine =
      "[machine]\nname = 'p'\nmoved_by = 'law'\n"
      "[machine.parameters.k]\ndefault = 0.5\nlower = -100\nupper = 100\n"
      "[responses.jer]\nformula = '0.01*j'\n"
      "[responses.mix]\nformula = '0.34 + s - 0.099*v + 0.02*a - k'\n"
      "[law]\nname = 'free'\n[variables.k]\nlower = -1.0\nupper = 2.0\n"
      "[objective]\nminimize = 'peak jer'\n" +
      limit("jer", "from = 0.3333333333333333\nto = 0.8333333333333333\nlower = 0.0");
  struct Case {
    std::string rest;
    double least;
  };
  // The first leaves a vertex far from the optimum. In the second the jerk is zero wherever it is
  // limited from below by zero: a tolerance of its size would be below rounding.
  const Case one = GENERATE(Case{"[free]\ndegree = 3\nknots = 14\nbegin = 'U'\n" +
                                     limit("mix", "from = 0.25\nto = 0.35\nlower = -0.05478"),
                                 0.47651211},
                            Case{"[free]\ndegree = 3\nknots = 5\nbegin = 'U'\n", 0.51652174});
  const Optimum optimum = solved(machine + one.rest);
  CHECK(global_value(optimum) == Approx(one.least).epsilon(1e-7));
  CHECK(judged_alone(optimum).verdict == Verdict::Certified);
}

TEST_CASE("Prices of large free laws are what the objective gains", "[free][large]") {
  struct Sought {
    const char* objective;
    double sign;  // of the gain
  };
  const Sought sought =
      GENERATE(Sought{"minimize = 'C_a'", -1.0}, Sought{"minimize = 'highest acceleration'", -1.0},
               Sought{"maximize = 'lowest acceleration'", 1.0});
  INFO(sought.objective);
  const auto at = [&](double bound) {
    return solved(law("degree = 3\nknots = 80\n[objective]\n") + sought.objective + "\n" +
                  limit("velocity", "upper = " + std::to_string(bound)) +
                  limit("jerk", "upper = 60\nlower = -60"));
  };
  // The least is convex in the bound: its slope at the bound lies between those beside it.
  constexpr double kStep = 1e-3;
  const Optimum optimum = at(1.6);
  const double here = sought.sign * global_value(optimum);
  const double more = (sought.sign * global_value(at(1.6 + kStep)) - here) / kStep;
  const double less = (here - sought.sign * global_value(at(1.6 - kStep))) / kStep;
  const double price = optimum.found.assessment.limits[0].multiplier;
  CHECK(price > 0.999 * more);
  CHECK(price < 1.001 * less);
  CHECK(more > 1);
}

TEST_CASE("What is proved of a peak holds for the spline that its coefficients say",
          "[free][large]") {
  // Third differences of 290 knots lose eight digits. Of degree 4 they are the jerk at the knots.
  const BoundProblem bound(
      read_problem(law("degree = 4\nknots = 290\nbegin = 'U'\nend = 'G'\n"
                       "[objective]\nminimize = 'highest jerk'\ntolerance = 1e-9\n") +
                       limit("acceleration", "upper = 5.7"),
                   "f.toml"));
  const Optimum optimum = optim::optimise(bound.space());
  const Member member = bound.at(optimum.options, optimum.found.x).laws.front().listed();
  const std::vector<double> inner = member.arguments.list(1), all = member.arguments.list(2);
  std::vector<long double> knots(5, 0.0L), c(all.begin(), all.end());
  knots.insert(knots.end(), inner.begin(), inner.end());
  knots.insert(knots.end(), 5, 1.0L);
  for (std::size_t order = 1; order <= 3; ++order) {
    const std::size_t degree = 5 - order;
    for (std::size_t i = 0; i + 1 < c.size(); ++i) {
      c[i] = static_cast<long double>(degree) * (c[i + 1] - c[i]) /
             (knots[i + order + degree] - knots[i + order]);
    }
    c.pop_back();
  }
  const auto highest = static_cast<double>(*std::max_element(c.begin(), c.end()));
  const optim::Assessment& a = optimum.found.assessment;
  CHECK(highest == Approx(-3).epsilon(1e-6));
  CHECK(a.objective.proved.lower <= highest);
  CHECK(a.objective.proved.upper >= highest);
  CHECK(a.objective.proved.upper - a.objective.proved.lower < 1e-6);
}

TEST_CASE("Limits that can be met are not called contradictory where multipliers do not add up",
          "[free][large]") {
  // A simplex method that ends at a corner of the box leaves one row of the violation's own.
  const double peak = global_value(solved(law("degree = 7\nknots = 20\nend = 'B'\n"
                                              "[objective]\nminimize = 'C_a'\n") +
                                          limit("C_v", "upper = 1.6")));
  CHECK(peak == Approx(2.177809).epsilon(1e-6));
  const double jerk = global_value(
      solved(law("degree = 8\nknots = 20\nbegin = 2\nend = 1\n[objective]\nminimize = 'C_j'\n") +
             limit("acceleration", "lower = -12.36")));
  CHECK(jerk == Approx(20.65413).epsilon(1e-6));
}

TEST_CASE("Where the limits' rows are many and nearly alike, the first method's answer is proved",
          "[free][large]") {
  const Optimum optimum =
      solved(law("degree = 7\nknots = 50\ncontinuity = 2\nbegin = 1\nend = 3\n"
                 "[objective]\nminimize = 'C_v'\n") +
             limit("acceleration", "lower = -3.142") + limit("C_a", "upper = 12.96"));
  CHECK(global_value(optimum) > 1.3857);
  CHECK(optimum.found.solver == "interior");
  CHECK(optimum.found.solves < 50);  // some 40: no other method took over
}

}  // namespace camlaw::problems::large_free_law_test
