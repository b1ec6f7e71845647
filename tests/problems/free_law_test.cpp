// SPDX-License-Identifier: MIT
// The free law in problem files: what the file says, and answers that are known from elsewhere.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <sstream>

#include "kinematics/limits.h"
#include "optim/problem/check_derivatives.h"
#include "optim/search/optimise.h"
#include "problems/statement/bind.h"

namespace camlaw::problems {
namespace {

using Catch::Contains;
using optim::Optimum;
using optim::Verdict;

std::string shipped(const std::string& name) {
  std::ifstream file(std::string(CAMLAW_SOURCE_DIR) + "/problems/free_law/" + name);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

struct Solved {
  BoundProblem bound;
  Optimum optimum;

  double objective() const { return optimum.found.assessment.objective.value; }
  Law<double> law() const { return bound.at(optimum.options, optimum.found.x).laws.front().law(); }
};

Solved solved(const std::string& text) {
  BoundProblem bound(read_problem(text, "f.toml"));
  Optimum optimum = optim::optimise(bound.space());
  return {std::move(bound), std::move(optimum)};
}

Solved globally_solved(const std::string& text) {
  Solved result = solved(text);
  const optim::Assessment& a = result.optimum.found.assessment;
  INFO(a.reason);
  CHECK(a.verdict == Verdict::Certified);
  CHECK(a.global.has_value());
  return result;
}

const std::string kLaw = "mechanism = 'law'\n[law]\nname = 'free'\n";

}  // namespace

TEST_CASE("Least acceleration for a peak velocity is b^2 / (b - 1)", "[free]") {
  const std::string text = shipped("least_acceleration.toml");
  CHECK(globally_solved(text).objective() == Approx(least_acceleration(1.5)).epsilon(1e-7));
  // With knots that miss the places of the jumps the least is approached from above, as 1 / knots^2
  // or better.
  double before = 1;
  for (const int knots : {15, 63, 255}) {
    const auto other =
        globally_solved(replaced(text, "knots = 98", "knots = " + std::to_string(knots)));
    const double above = other.objective() / least_acceleration(1.5) - 1;
    INFO(knots << " knots");
    CHECK(above > 0);
    CHECK(above < before);
    CHECK(above < 1.0 / knots);
    before = above;
  }
  for (const double b : {1.2, 1.8}) {  // thirds no more
    std::ostringstream bound;
    bound << "upper = " << b;
    const Solved other = globally_solved(replaced(text, "upper = 1.5", bound.str()));
    CHECK(other.objective() >= least_acceleration(b) * (1 - 1e-9));
    CHECK(other.objective() == Approx(least_acceleration(b)).epsilon(2e-3));
  }
}

TEST_CASE("Least jerk is 32, at B = 2 and C = 8", "[free]") {
  const Solved least = globally_solved(shipped("least_jerk.toml"));
  CHECK(least.objective() == Approx(32).epsilon(1e-7));
  const auto peak = peaks(least.law());
  CHECK(peak.B() == Approx(2).epsilon(1e-6));
  CHECK(peak.C() == Approx(8).epsilon(1e-6));
}

TEST_CASE("Least acceleration for given velocity and jerk lies on lambda = 1", "[free]") {
  // 1/B + B/C + C/D = 1 solved for C.
  const double b = 1.6, d = 60;
  const double half = (1 - 1 / b) * d / 2;
  const double limit = half - std::sqrt(half * half - b * d);
  CHECK(limit == Approx(5.7217).epsilon(1e-5));
  const std::string text = shipped("least_acceleration_at_jerk.toml");
  const Solved hundred = globally_solved(text);
  CHECK(hundred.objective() > limit);
  CHECK(hundred.objective() < limit * 1.0015);
  const Solved two_hundred = globally_solved(replaced(text, "knots = 100", "knots = 200"));
  CHECK(two_hundred.objective() > limit);
  CHECK(two_hundred.objective() < limit * 1.0003);
  const auto lambda = limit_index(peaks(two_hundred.law()));
  REQUIRE(lambda);
  CHECK(*lambda < 1);
  CHECK(*lambda > 0.9995);
}

TEST_CASE("The table [free] is read as it says", "[free]") {
  const auto law = [](const std::string& table) {
    return read_problem(kLaw + "[free]\n" + table, "f.toml").laws.front();
  };
  CHECK(read_problem(kLaw, "f.toml").variables.size() == 32 + 4 - 6);
  CHECK(law("knots = 10").law().pieces().size() == 11);
  CHECK(law("knots = [0.25, 0.5, 0.75]").law().pieces()[0].end == 0.25);
  CHECK(law("knots = 10").listed().law().ends() == Ends{});
  CHECK(law("degree = 2\nknots = 10").law().ends() == Ends{End::Reversal, End::Reversal});
  CHECK(law("begin = 'G'\nend = 'U'\nknots = 10").law().ends() ==
        Ends{End::Velocity, End::Reversal});
  CHECK(law("begin = 'B'\nend = 2\nknots = 10").law().ends() == Ends{End::Motion, End::Rest});
  CHECK(law("degree = 5\ncontinuity = 2\nknots = 10").arguments.list(0).size() == 6 + 30 - 6);
  CHECK(law("symmetric = true\nknots = 10").arguments.list(0).size() == 4);
  CHECK(law("start = 'modified-sine'\nknots = 10").arguments.list(0) !=
        law("knots = 10").arguments.list(0));
  const auto problem =
      read_problem(kLaw + "[free]\nknots = 4\nmoving_knots = true\nlower = 0\nupper = 1.5\n" +
                       "[variables.\"coefficients[2]\"]\nlower = 0.4\nupper = 0.6\n",
                   "f.toml");
  REQUIRE(problem.variables.size() == 2 + 4);
  CHECK(problem.variables[0].name == "coefficients[2]");
  CHECK(problem.variables[0].lower == 0.4);
  CHECK(problem.variables[1].name == "coefficients[1]");
  CHECK(problem.variables[1].upper == 1.5);
  CHECK(problem.variables[2].name == "knots[1]");
  CHECK(problem.variables[2].lower == Approx(0.2 * 0.55));
  CHECK(problem.variables[2].upper == Approx(0.2 * 1.45));
}

TEST_CASE("Wrong tables [free] are refused with their place", "[free]") {
  const auto complaint = [](const std::string& text) -> std::string {
    try {
      read_problem(text, "f.toml");
      return "accepted";
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  };
  const auto of_table = [&](const std::string& table) {
    return complaint(kLaw + "[free]\n" + table);
  };
  CHECK_THAT(of_table("degre = 3"), Contains("f.toml:5: free.degre") && Contains("degree"));
  CHECK_THAT(of_table("degree = 0"), Contains("f.toml:5: free.degree") && Contains("1"));
  CHECK_THAT(of_table("degree = 26"), Contains("free.degree"));
  CHECK_THAT(of_table("degree = 2.5"), Contains("free.degree"));
  CHECK_THAT(of_table("knots = -1"), Contains("free.knots"));
  CHECK_THAT(of_table("knots = 'many'"), Contains("free.knots") && Contains("even knots"));
  CHECK_THAT(of_table("knots = [0.5, 0.2]"), Contains("free: ") && Contains("does not come after"));
  CHECK_THAT(of_table("continuity = 3"), Contains("free.continuity"));
  CHECK_THAT(of_table("begin = 'X'"),
             Contains("free.begin: 'X' is no end") && Contains("R (rest)"));
  CHECK_THAT(of_table("end = 3"), Contains("free: ") && Contains("end: 3 derivatives"));
  CHECK_THAT(of_table("symmetric = 1"), Contains("free.symmetric") && Contains("true or false"));
  CHECK_THAT(of_table("lower = 2\nupper = 2"), Contains("lower 2 is not below upper 2"));
  CHECK_THAT(of_table("lower = -1000"), Contains("free.lower") && Contains("-100 .. 100"));
  CHECK_THAT(of_table("start = 'no-law'"), Contains("free.start") && Contains("no-law"));
  CHECK_THAT(of_table("knots = 0"), Contains("nothing is free"));
  CHECK_THAT(complaint("mechanism = 'law'\n[law]\nname = 'cosine'\n[free]\nknots = 3\n"),
             Contains("f.toml:4: free: no law of the problem is free"));
  CHECK_THAT(complaint("mechanism = 'law'\nfree = 3\n[law]\nname = 'free'\n"),
             Contains("f.toml:2: free") && Contains("[free]"));
}

TEST_CASE("A free law is one of several to choose from", "[free]") {
  const Solved best = solved(
      "mechanism = 'law'\n[law]\nname = ['modified-trapezoid', 'free']\n"
      "[free]\nknots = 11\n[objective]\nminimize = 'C'\n[[constraints]]\nresponse = 'D'\n"
      "upper = 70\n");
  const optim::Assessment& a = best.optimum.found.assessment;
  CHECK(a.verdict == Verdict::Certified);
  CHECK(best.bound.at(best.optimum.options, best.optimum.found.x).laws.front().family->name ==
        "free");
  CHECK(best.objective() < peaks(find_law("modified-trapezoid").law()).C());
}

TEST_CASE("Derivatives by coefficients and knots are those of differences", "[free]") {
  for (const char* table : {"degree = 3\nknots = 5", "degree = 3\nknots = 5\nmoving_knots = true",
                            "degree = 4\nknots = 4\ncontinuity = 2\nsymmetric = true\n"
                            "moving_knots = true",
                            "degree = 3\nbegin = 'G'\nend = 'G'\nknots = 3\nmoving_knots = true"}) {
    INFO(table);
    const BoundProblem bound(read_problem(
        kLaw + "[free]\n" + table +
            "\n[objective]\nminimize = 'C'\n[[constraints]]\nresponse = 'moment'\nupper = 5\n"
            "[[constraints]]\nresponse = 'displacement'\nlower = 0\n",
        "f.toml"));
    const optim::Problem problem = bound.problem({});
    const auto check = optim::check_derivatives(problem, problem.start());
    INFO(check.worst.response << " " << check.worst.variable << " " << check.worst.second);
    CHECK(check.agrees);
    CHECK(check.shapes.empty());
    CHECK(check.entries > 0);
  }
}

}  // namespace camlaw::problems
