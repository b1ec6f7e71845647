// SPDX-License-Identifier: MIT
// Knots of a free law that are found where they gain, against limits that are known.
#include "problems/refinement/refined_knots.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "optim/search/optimise.h"
#include "optim/verdict/verdict.h"
#include "problems/statement/auto_knots.h"
#include "problems/statement/bind.h"
#include "tests/problems/complaint.h"

namespace camlaw::problems::refined_knots_test {
namespace {

using Catch::Contains;
using optim::Verdict;
using testing::complaint;

std::string law(const std::string& free, const std::string& rest) {
  return "mechanism = 'law'\n[law]\nname = 'free'\n[free]\n" + free + rest;
}

const std::string kJerkLimit =
    "[objective]\nminimize = 'C_a'\n[[constraints]]\nresponse = 'C_v'\nupper = 1.6\n"
    "[[constraints]]\nresponse = 'C_j'\nupper = 60\n";

ProblemStatement read(const std::string& text) { return read_problem(text, "f.toml"); }

optim::Optimum solved(const ProblemStatement& problem, Begin begin = Begin::AsStated) {
  optim::OptimiseOptions how;
  if (begin == Begin::AtStart) how.starts = 1;
  return optim::optimise(BoundProblem(problem).space(), how);
}

const auto kNever = [] { return false; };

bool is_symmetric(const std::vector<double>& knots) {
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (std::abs(knots[i] + knots[knots.size() - 1 - i] - 1) > 1e-12) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("Fewer than a hundred knots where they gain do what a thousand even ones do",
          "[free][knots]") {
  ProblemStatement problem = read(law("degree = 3\nknots = 'auto'\n", kJerkLimit));
  REQUIRE(problem.finds_knots);
  const RefinedKnots found = refine_knots(problem, solved, kNever);
  CHECK(found.knots.size() < 100);
  CHECK(std::is_sorted(found.knots.begin(), found.knots.end()));
  CHECK_FALSE(problem.finds_knots);
  const optim::Assessment a = solved(problem).found.assessment;
  CHECK(a.verdict == Verdict::Certified);
  // Short spans make the slopes of the jerk so large that rounding leaves the bound this open.
  REQUIRE(a.best_possible);
  CHECK(*a.best_possible > a.objective.value * (1 - 2e-5));
  // 1000 even knots give 5.721736, and 100 give 5.728808.
  CHECK(a.objective.value == Approx(5.7217).epsilon(2e-5));
  CHECK(a.objective.value == Approx(found.optimum.found.assessment.objective.value).epsilon(1e-9));
  // A spline among more knots is never worse.
  for (std::size_t i = 1; i < found.rounds.size(); ++i) {
    CHECK(found.rounds[i].knots > found.rounds[i - 1].knots);
    CHECK(found.rounds[i].objective <= found.rounds[i - 1].objective * (1 + 1e-7));
  }
}

TEST_CASE("Knots of a symmetric law are symmetric", "[free][knots]") {
  ProblemStatement problem =
      read(law("degree = 4\nknots = 'auto'\nsymmetric = true\n", kJerkLimit));
  const RefinedKnots found = refine_knots(problem, solved, kNever);
  CHECK(found.rounds.size() > 2);
  CHECK(is_symmetric(found.knots));
  CHECK(found.rounds.back().verdict == Verdict::Certified);
}

TEST_CASE("A search for knots ends when it is told to, with knots that were solved",
          "[free][knots]") {
  ProblemStatement problem = read(law("knots = 'auto'\n", kJerkLimit));
  const RefinedKnots found = refine_knots(problem, solved, [] { return true; });
  CHECK(found.rounds.size() == 1);
  CHECK(found.knots.size() == found.rounds.front().knots);
  CHECK(found.ended == "the search was ended");
  CHECK_FALSE(found.left.has_value());
}

TEST_CASE("A round that leads to nothing better leaves the one before", "[free][knots]") {
  ProblemStatement problem = read(law("knots = 'auto'\n", kJerkLimit));
  int round = 0;
  const auto search = [&](const ProblemStatement& own, Begin begin) {
    optim::Optimum optimum = solved(own, begin);
    if (++round >= 3) optimum.found.assessment.objective.value *= 1.01;
    return optimum;
  };
  const RefinedKnots found = refine_knots(problem, search, kNever);
  REQUIRE(found.rounds.size() == 3);
  CHECK(found.knots.size() == found.rounds[1].knots);
  CHECK(found.optimum.found.assessment.objective.value == found.rounds[1].objective);
  CHECK_THAT(found.ended, Contains("nothing better"));
  CHECK(solved(problem).found.assessment.objective.value ==
        Approx(found.rounds[1].objective).epsilon(1e-9));
}

TEST_CASE("What a time limit leaves of the rounds is the answer", "[free][knots]") {
  ProblemStatement problem = read(law("knots = 'auto'\n", kJerkLimit));
  double clock = 0;  // as if each look at it took half of what is allowed
  optim::OptimiseOptions how;
  how.time_limit = 1000;
  const RefinedKnots found = find_knots(problem, how, 1, [&] { return clock += 300; });
  CHECK(found.ended == "the search was ended");
  CHECK(found.rounds.size() < 4);
  CHECK(found.optimum.found.assessment.verdict == Verdict::Certified);
}

TEST_CASE("Each round begins where the one before has ended", "[free][knots]") {
  ProblemStatement problem = read(law("degree = 3\nknots = 'auto'\n", kJerkLimit));
  double before = 0;
  int rounds = 0;
  const auto search = [&](const ProblemStatement& own, Begin begin) {
    CHECK((begin == Begin::AsStated) == (rounds == 0));
    const optim::Problem bound = BoundProblem(own).space().problem({});
    const double there = optim::assess_in_haste(bound, bound.start()).objective.value;
    if (rounds++ > 0) CHECK(there == Approx(before).epsilon(1e-9));
    optim::Optimum optimum = solved(own, begin);
    before = optimum.found.assessment.objective.value;
    return optimum;
  };
  refine_knots(problem, search, kNever);
  CHECK(rounds > 3);
}

TEST_CASE("Rounds that repeat one another at half the size are carried out at once",
          "[free][knots]") {
  ProblemStatement problem =
      read(law("degree = 5\nsymmetric = true\nknots = 'auto'\nbegin = 'U'\nend = 'U'\n",
               "[objective]\nminimize = 'C_Mdyn'\n"));
  int rounds = 0;
  const RefinedKnots found = refine_knots(problem, solved, [&] { return ++rounds == 4; });
  REQUIRE(found.rounds.size() == 4);
  // Round by round, the first span would be an eighth of 1/40.
  CHECK(found.knots.front() == Approx(1.0 / 40 / 128).epsilon(1e-12));
  CHECK(is_symmetric(found.knots));
  CHECK(found.rounds.back().verdict == Verdict::Certified);
}

TEST_CASE("A free law comes near what theory knows of all laws, and the answer is global",
          "[free][knots][heavy]") {
  ProblemStatement problem = read(law("degree = 5\nknots = 'auto'\nbegin = 'U'\nend = 'U'\n",
                                      "[objective]\nminimize = 'C_Mdyn'\n"));
  const RefinedKnots found = refine_knots(problem, solved, kNever);
  const optim::Assessment& a = found.optimum.found.assessment;
  CHECK(a.verdict == Verdict::Certified);
  CHECK(a.objective.value > 2.25);
  CHECK(a.objective.value < 2.25 * (1 + 1e-4));
  REQUIRE(a.global);
  CHECK_THAT(*a.global, Contains("no design below 2.25") && Contains("no law from rest to rest"));
  CHECK_THAT(found.ended, Contains("no law can beat"));
  CHECK(found.optimum.found.starts == 1);
  CHECK(found.rounds.size() < 12);  // towards the ends rounds that repeat one another are one
  for (std::size_t i = 0; i <= found.knots.size(); ++i) {
    const double from = i == 0 ? 0 : found.knots[i - 1];
    const double to = i == found.knots.size() ? 1 : found.knots[i];
    CHECK(to - from >= (1 - 1e-9) / 65536);
  }
}

TEST_CASE("What theory knows counts the limits that are stated, and only between rests",
          "[free][knots]") {
  const auto limit = [](const std::string& free, const std::string& rest) {
    const ProblemStatement problem = read(law(free, rest));
    return BoundProblem(problem).space().problem({}).objective().limit;
  };
  const auto acceleration = limit("knots = 40\n", kJerkLimit);
  REQUIRE(acceleration);
  CHECK(acceleration->value == Approx(5.7216).epsilon(1e-4));
  CHECK_THAT(acceleration->why, Contains("C_v of at most 1.6") && Contains("C_j of at most 60"));
  CHECK_FALSE(limit("knots = 40\nbegin = 'G'\n", kJerkLimit));
  const auto moment = limit("begin = 'U'\nend = 'U'\n",
                            "[objective]\nminimize = 'C_Mdyn'\n[[constraints]]\nresponse = 'C_v'\n"
                            "upper = 1.2\n");
  REQUIRE(moment);
  CHECK(moment->value == Approx(1.2 * 1.2 * 1.2 / 0.6).epsilon(1e-9));
  CHECK_FALSE(limit("knots = 40\n", "[objective]\nminimize = 'mean_square_jerk'\n"));
}

TEST_CASE("A start among other knots is left out", "[free][knots]") {
  ProblemStatement problem = read(law("knots = 'auto'\n", kJerkLimit));
  set_values(problem, std::vector<std::string>{"coefficients[2]=0.001"});
  const RefinedKnots found = refine_knots(problem, solved, [] { return true; });
  CHECK(found.optimum.found.assessment.verdict == Verdict::Certified);
  for (const std::string& setting : problem.settings)
    CHECK_THAT(setting, !Contains("coefficients"));
}

TEST_CASE("Limits that few knots cannot meet get more of them", "[free][knots]") {
  ProblemStatement problem = read(
      law("degree = 3\nknots = 'auto'\n",
          "[objective]\nminimize = 'highest jerk'\n[[constraints]]\nresponse = 'C_v'\nupper = 1.6\n"
          "[[constraints]]\nresponse = 'C_j'\nupper = 60\n[[constraints]]\nresponse = 'C_a'\n"
          "upper = 5.7222\n"));
  const RefinedKnots found = refine_knots(problem, solved, kNever);
  CHECK(found.rounds.front().verdict == Verdict::Infeasible);
  CHECK(found.optimum.found.assessment.verdict == Verdict::Certified);
}

TEST_CASE("Where no law meets the limits more knots are tried in vain", "[free][knots]") {
  ProblemStatement problem =
      read(law("knots = 'auto'\n",
               "[objective]\nminimize = 'C_a'\n[[constraints]]\nresponse = 'C_v'\nupper = 0.9\n"));
  const RefinedKnots found = refine_knots(problem, solved, kNever);
  CHECK(found.rounds.size() > 3);
  CHECK_FALSE(found.left.has_value());
  CHECK(found.optimum.found.assessment.verdict == Verdict::Infeasible);
  CHECK_THAT(found.ended, Contains("no design within the limits"));
}

TEST_CASE("Knots that cannot be found are refused by what stands in the way", "[free][knots]") {
  CHECK_THAT(complaint([] { read(law("knots = 'auto'\nmoving_knots = true\n", kJerkLimit)); }),
             Contains("knots that move are not found by adding more"));
  CHECK_THAT(complaint([] { read(law("knots = 'many'\n", kJerkLimit)); }), Contains("\"auto\""));
  ProblemStatement chosen =
      read("mechanism = 'law'\n[law]\nname = ['free', 'cycloidal']\n[free]\nknots = 'auto'\n" +
           kJerkLimit);
  CHECK_THAT(complaint([&] { refine_knots(chosen, solved, kNever); }),
             Contains("f.toml") && Contains("needs one law"));
  const ProblemStatement front = read(law("knots = 'auto'\n", kJerkLimit));
  CHECK_THAT(complaint([&] { refuse_auto_knots(front, "a front"); }), Contains("a front"));
  const ProblemStatement stated = read(law("knots = 40\n", kJerkLimit));
  CHECK_NOTHROW(refuse_auto_knots(stated, "a front"));
}

TEST_CASE("What is set of the table [free] is what a file states", "[free][restated]") {
  const auto same = [](ProblemStatement set, const ProblemStatement& written) {
    const optim::Problem a = BoundProblem(set).problem({}), b = BoundProblem(written).problem({});
    REQUIRE(a.variables.size() == b.variables.size());
    for (std::size_t i = 0; i < a.variables.size(); ++i) {
      CHECK(a.variables[i].lower == b.variables[i].lower);
      CHECK(a.variables[i].start == b.variables[i].start);
      CHECK(a.variables[i].scale == b.variables[i].scale);
    }
    CHECK(solved(set).found.x == solved(written).found.x);
  };
  const auto set = [](const std::vector<std::string>& settings, const std::string& free) {
    ProblemStatement problem = read(law(free, kJerkLimit));
    set_values(problem, settings);
    return problem;
  };
  same(set({"free.knots=50"}, "knots = 20\n"), read(law("knots = 50\n", kJerkLimit)));
  same(set({"free.knots=[0.25, 0.5, 0.6]", "free.degree=5"}, ""),
       read(law("knots = [0.25, 0.5, 0.6]\ndegree = 5\n", kJerkLimit)));
  same(set({"free.begin=U", "free.lower=-0.5"}, "knots = 30\n"),
       read(law("knots = 30\nbegin = 'U'\nlower = -0.5\n", kJerkLimit)));
  CHECK(set({"free.knots=auto"}, "knots = 30\n").finds_knots);
  CHECK_THAT(complaint([&] { set({"free.knoten=50"}, "knots = 20\n"); }),
             Contains("free.knoten=50") && Contains("knots"));
  CHECK_THAT(complaint([&] { set({"free.degree=1"}, "knots = 20\n"); }), Contains("free.degree=1"));
}

}  // namespace camlaw::problems::refined_knots_test
