// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>

#include "machines/model/robust_number.h"
#include "numerics/sampling/sobol_points.h"
#include "optim/search/interruptible.h"
#include "optim/search/optimise.h"
#include "problems/statement/bind.h"
#include "problems/tolerance/reliable_search.h"
#include "problems/tolerance/tolerance.h"
#include "tests/problems/complaint.h"

// Robust objectives and limits with a reliability, against closed forms.
namespace camlaw::problems::robust_test {

using Catch::Contains;

namespace {

ProblemStatement read(const std::string& text) { return read_problem(text, "f.toml"); }

/// A formula f in b and c; b is normal with a deviation of 0.2.
std::string machine(const std::string& formula, const std::string& more) {
  return "[machine]\n[machine.parameters.b]\ndefault = 1\nlower = -20\nupper = 20\n"
         "[machine.parameters.c]\ndefault = 2\nlower = -20\nupper = 20\n"
         "[responses.f]\nformula = '" +
         formula +
         "'\n[variation.b]\nstandard_deviation = 0.2\n"
         "[variables.b]\nlower = -9\nupper = 9\n[variables.c]\nlower = -9\nupper = 9\n" +
         more;
}

optim::Function objective_of(const std::string& formula, const std::string& robust) {
  const BoundProblem bound(
      read(machine(formula, "[objective]\nminimize = 'f'\nrobust = '" + robust + "'\n")));
  return bound.problem({}).objectives.front().response.function();
}

}  // namespace

TEST_CASE("What is taken of many parts is read as it is written", "[variation]") {
  CHECK(parse_robust("mean").text() == "mean");
  CHECK(parse_robust("mean + 3 sigma").factor == 3);
  CHECK(parse_robust("mean+2.5sigma").text() == "mean + 2.5 sigma");
  CHECK(parse_robust("mean - sigma").factor == -1);
  CHECK(parse_robust("quantile 0.99").share == 0.99);
  CHECK(parse_robust("quantile 0.99").parts() >= 400);
  for (const char* text : {"", "median", "mean + sigma 3", "mean + -3 sigma", "mean3sigma",
                           "quantile", "mean * 3 sigma", "quantile x"}) {
    INFO(text);
    CHECK_THROWS_WITH(parse_robust(text), Contains("mean + 3 sigma"));
  }
  CHECK_THROWS_WITH(parse_robust("quantile 0.9999"), Contains("must be between 0.001 and 0.999"));
  const std::string still =
      "[machine]\n[machine.parameters.b]\ndefault = 1\nlower = 0\nupper = 2\n"
      "[responses.f]\nformula = 'b^2'\n[variables.b]\nlower = 0\nupper = 2\n";
  CHECK_THAT(testing::complaint(still + "[objective]\nminimize = 'f'\nrobust = 'mean'\n"),
             Contains("objective.robust") && Contains("no variation is stated"));
  CHECK_THAT(testing::complaint(still + "[objective]\nminimize = 'f'\n[[constraints]]\n"
                                        "response = 'f'\nupper = 1\nreliability = 0.9\n"),
             Contains("reliability") && Contains("no variation is stated"));
}

TEST_CASE("Mean and deviation of a linear response are the closed form", "[variation]") {
  // f = 3 b + c: the mean is 3 b + c, the deviation 0.6.
  const optim::Function f = objective_of("3 * b + c", "mean + 3 sigma");
  const std::vector<double> x{1.5, 0.5};
  std::vector<double> g(2), h(3);
  CHECK(f.hessian(x, g, h) == Approx(5 + 1.8).epsilon(0.03));
  CHECK(g[0] == Approx(3).epsilon(1e-9));
  CHECK(g[1] == Approx(1).epsilon(1e-9));
  for (const double bend : h) CHECK(bend == Approx(0).margin(1e-9));
  const optim::Function q = objective_of("3 * b + c", "quantile 0.9");
  CHECK(q.value(x) == Approx(5 + 0.6 * normal_quantile(0.9)).epsilon(0.01));
}

TEST_CASE("Derivatives of robust numbers are those of differences", "[variation]") {
  for (const char* robust : {"mean", "mean + 3 sigma", "mean - 1.5 sigma", "quantile 0.9"}) {
    const optim::Function f = objective_of("exp(0.3 * b) * c^2 + sin(b + c)", robust);
    for (const auto& x : std::vector<std::vector<double>>{{1, 2}, {-2, 0.7}, {0.3, -1.4}}) {
      INFO(robust << " at " << x[0] << ", " << x[1]);
      std::vector<double> g(2), h(3), only(2);
      const double value = f.hessian(x, g, h);
      CHECK(f.value(x) == Approx(value).epsilon(1e-13));
      CHECK(f.gradient(x, only) == Approx(value).epsilon(1e-13));
      for (std::size_t i = 0; i < 2; ++i) {
        constexpr double kStep = 1e-5;
        std::vector<double> up = x, down = x, g_up(2), g_down(2);
        up[i] += kStep;
        down[i] -= kStep;
        const double rise = f.gradient(up, g_up) - f.gradient(down, g_down);
        CHECK(only[i] == Approx(g[i]).epsilon(1e-12));
        CHECK(g[i] == Approx(rise / (2 * kStep)).epsilon(1e-6).margin(1e-8));
        for (std::size_t k = 0; k <= i; ++k) {
          const double bend = (g_up[k] - g_down[k]) / (2 * kStep);
          CHECK(h[optim::packed(i, k)] == Approx(bend).epsilon(1e-5).margin(1e-6));
        }
      }
    }
  }
}

TEST_CASE("What manufacture does not change has no reliability", "[variation]") {
  CHECK_THAT(testing::complaint(machine("c",
                                        "[objective]\nminimize = 'f'\n[[constraints]]\n"
                                        "response = 'f'\nlower = 0\nreliability = 0.9\n")),
             Contains("reliability") && Contains("no variation"));
  CHECK_THAT(testing::complaint(machine("c", "[objective]\nminimize = 'f'\nrobust = 'mean'\n")),
             Contains("robust") && Contains("no variation"));
}

TEST_CASE("A limit on a parameter may have a reliability", "[variation]") {
  // b >= 1 for 90 % of all parts: b = 1 + 0.2 * 1.2816.
  const BoundProblem bound(
      read(machine("b",
                   "[objective]\nminimize = 'f'\nrobust = 'mean'\n"
                   "[[constraints]]\nresponse = 'b'\nlower = 1\nreliability = 0.9\n")));
  const auto found = optim::optimise(bound.space(), {});
  CHECK(found.found.x[0] == Approx(1 + 0.2 * normal_quantile(0.9)).margin(0.02));
}

TEST_CASE("A limit with a reliability leaves out the parts that it may", "[variation]") {
  // c - b >= 0 for 90 % of all parts: c = b + 0.2 * 1.2816; b is held at 1 or above.
  const std::string text =
      machine("c - b",
              "[responses.least]\nformula = 'c'\n[responses.own]\nformula = 'b'\n"
              "[objective]\nminimize = 'least'\n"
              "[[constraints]]\nresponse = 'f'\nlower = 0\nreliability = 0.9\n"
              "[[constraints]]\nresponse = 'own'\nlower = 1\nreliability = 0.5\n");
  const BoundProblem bound(read(text));
  const auto found = optim::optimise(bound.space(), {});
  INFO(found.found.assessment.reason);
  CHECK(found.found.assessment.verdict == optim::Verdict::Feasible);  // an estimate, no proof
  CHECK(found.found.x[1] - found.found.x[0] == Approx(0.2 * normal_quantile(0.9)).margin(0.02));
  CHECK(found.found.x[0] == Approx(1).margin(0.01));
  const ProblemStatement design = bound.at(found.options, found.found.x);
  ToleranceOptions options;
  options.samples = 50000;
  const ToleranceAnswer answer =
      tolerance_of(varied_design(design, variations_of(design)), options);
  REQUIRE(answer.yield);
  CHECK(answer.yield->by_limit[0] == Approx(0.1).margin(0.02));
  CHECK(answer.yield->by_limit[1] == Approx(0.5).margin(0.03));
}

namespace {

/// 3 b + c <= 6 with a reliability, c given: the share is that of a normal value of deviation 0.6.
ProblemStatement with_room(double c, double reliability) {
  ProblemStatement design = read(machine(
      "3 * b + c", fmt::format("[objective]\nminimize = 'f'\nrobust = 'mean + 3 sigma'\n"
                               "[[constraints]]\nresponse = 'f'\nupper = 6\nreliability = {}\n",
                               reliability)));
  set_value(design, "b=0");
  set_value(design, fmt::format("c={:.15g}", c));
  return design;
}

constexpr double kDeviation = 0.6;

}  // namespace

TEST_CASE("What a design reaches of its reliability is the closed form", "[variation]") {
  for (const double reliability : {0.7, 0.98, 0.999}) {
    for (const double index : {0.6, 2.0, 3.2}) {
      const double exact = normal_share(index);
      const ProblemStatement design = with_room(6 - index * kDeviation, reliability);
      int missed = 0;
      for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        const ReachedReliability found = reached_by(design, optim::Deadline({}, nullptr), seed);
        REQUIRE(found.limits.size() == 1);
        const ReachedShare& share = found.limits.front();
        INFO("asked for " << share.wanted << ", exactly " << exact << ", found " << share.share
                          << " between " << share.between.lower << " and " << share.between.upper);
        CHECK(share.wanted == reliability);
        CHECK(share.share == Approx(exact).margin(0.02 * (1 - exact)));
        missed += !(share.between.lower <= exact && exact <= share.between.upper);
        CHECK(share.reach == (exact >= reliability ? IsReached::Yes : IsReached::No));
      }
      CHECK(missed <= 3);  // of 12 at 95 %: more come once in 500 times
    }
  }
}

TEST_CASE("A design that stands exactly at its reliability is not called safe", "[variation]") {
  for (const double reliability : {0.9, 0.999}) {
    const ProblemStatement design =
        with_room(6 - kDeviation * normal_quantile(reliability), reliability);
    int safe = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      const ReachedReliability found = reached_by(design, optim::Deadline({}, nullptr), seed);
      safe += found.limits.front().reach == IsReached::Yes;
      CHECK(found.all() == (found.limits.front().reach == IsReached::Yes));
    }
    INFO(reliability << ": " << safe << " of 40");
    CHECK(safe <= 4);  // 2.5 % on this side of a 95 % interval: one
  }
}

TEST_CASE("A verdict does not say that a reliability is met which is not reached", "[variation]") {
  // 99.87 % where 99.9 % are asked for.
  const ProblemStatement design = with_room(6 - 3.0 * kDeviation, 0.999);
  const ReachedReliability found = reached_by(design);
  CHECK(found.limits.front().reach == IsReached::No);
  optim::Assessment assessment;
  assessment.verdict = optim::Verdict::Feasible;
  assessment.objective.value = 1;
  assessment.limits.resize(1);
  assessment.limits.front().met = true;
  assessment.limits.front().tolerance = 1e-6;
  hold_to(found, assessment);
  CHECK(assessment.verdict == optim::Verdict::Failed);
  CHECK_FALSE(assessment.limits.front().met);
  CHECK_THAT(assessment.reason, Contains("does not reach its reliability") && Contains("99.9 %"));
}

TEST_CASE("A robust objective is told over parts that the search did not have", "[variation]") {
  const ReachedReliability found = reached_by(with_room(1, 0.9));
  REQUIRE(found.objective);
  const double exact = 1 + 3 * kDeviation;
  CHECK(found.objective->value == Approx(exact).margin(0.02));
  CHECK(found.objective->between.lower <= exact);
  CHECK(found.objective->between.upper >= exact);
  CHECK(found.objective->samples >= 2048);
}

TEST_CASE("A robust objective is told where the second variation alone changes it", "[variation]") {
  const ProblemStatement design =
      read(machine("c^2 + 0 * b",
                   "[variation.c]\nstandard_deviation = 0.1\n"
                   "[responses.g]\nformula = 'c'\n"
                   "[objective]\nminimize = 'g'\nrobust = 'mean + sigma'\n"));
  const ReachedReliability found = reached_by(design);
  REQUIRE(found.objective);
  CHECK(found.objective->value == Approx(2.1).margin(0.005));
}

TEST_CASE("A number over many parts ends at the deadline of whoever asks for it", "[variation]") {
  for (const char* robust : {"mean + 3 sigma", "quantile 0.9"}) {
    const optim::Function f = objective_of("exp(0.3 * b) * c^2 + sin(b + c)", robust);
    const std::vector<double> x{1, 2};
    std::vector<double> g(2), h(3);
    const double value = f.hessian(x, g, h);
    const std::atomic<bool> stop = true;
    const optim::Deadline passed({}, &stop);
    {
      const optim::DeadlineScope scope(passed);
      CHECK_THROWS_AS(f.value(std::vector<double>{2, 1}), optim::Interrupted);
      CHECK_THROWS_AS(f.gradient(x, g), optim::Interrupted);
      CHECK_THROWS_AS(f.hessian(x, g, h), optim::Interrupted);
    }
    CHECK(f.gradient(x, g) == Approx(value).epsilon(1e-13));
    // A problem that is to end by a deadline sets it.
    optim::Problem problem;
    problem.variables = {{.name = "b", .start = 1}, {.name = "c", .start = 2}};
    problem.objectives = {{optim::Response{"f", "1", f}, optim::Sense::Minimize}};
    std::atomic<bool> later = false;
    const optim::Problem ending = optim::interruptible(problem, optim::Deadline({}, &later));
    const optim::Function its = ending.objectives.front().response.function();
    CHECK(its.value(x) == Approx(value).epsilon(1e-13));
    later = true;
    CHECK_THROWS_AS(its.value(x), optim::Interrupted);
  }
}

namespace {

/// The largest c such that 3 b + c <= 6 for a share of all parts: 6 - 0.6 * quantile, b at 0.
BoundProblem most_within(double reliability) {
  return BoundProblem(read(machine(
      "3 * b + c", fmt::format("[responses.most]\nformula = 'c + 3 * b'\n"
                               "[objective]\nmaximize = 'most'\nrobust = 'mean'\n"
                               "[[constraints]]\nresponse = 'f'\nupper = 6\nreliability = {}\n",
                               reliability))));
}

}  // namespace

TEST_CASE("Further searches for a reliability are told, and end on a stop", "[variation]") {
  const BoundProblem bound = most_within(0.9);
  const optim::Optimum first = optim::optimise(bound.space(), {});
  std::vector<std::string> stages;
  std::size_t heard = 0;
  optim::OptimiseOptions options;
  options.progress = [&](const optim::Progress&) { ++heard; };
  optim::Optimum optimum = first;
  CHECK(search_until_reached(bound, options, optimum, [&](const auto& s) {
          stages.push_back(s);
        }).all());
  REQUIRE(stages.size() >= 3);
  CHECK_THAT(stages[0], Contains("judged"));
  CHECK(stages[1] == "reliability, round 1");
  CHECK_THAT(stages[2], Contains("reliability, round 1") && Contains("judged"));
  CHECK(heard > 0);
  // Stopped as the further search begins: what was found and judged before it stands.
  std::atomic<bool> stop = false;
  options.stop = &stop;
  optimum = first;
  const ReachedReliability found = search_until_reached(
      bound, options, optimum,
      [&](const auto& stage) { stop = stop || stage == "reliability, round 1"; });
  CHECK(found.cut_short.empty());
  CHECK_FALSE(found.all());
  CHECK(found.limits.front().reach != IsReached::Yes);
  CHECK(optimum.found.x == first.found.x);
  CHECK(optimum.found.assessment.verdict == optim::Verdict::Failed);
  CHECK_THAT(optimum.found.assessment.reason,
             Contains("stopped before a design was found that reaches every reliability") &&
                 Contains("of all parts hold it"));
  // Stopped before anything is judged: that is said, of the objective too.
  optimum = first;
  const ReachedReliability none = search_until_reached(bound, options, optimum);
  CHECK(none.cut_short == "stopped");
  CHECK(optimum.found.assessment.verdict == optim::Verdict::Failed);
  CHECK_THAT(optimum.found.assessment.reason, Contains("was not calculated: stopped"));
}

TEST_CASE("A robust objective that was not worked out says why", "[variation]") {
  const ProblemStatement design =
      read(machine("3 * b + c", "[objective]\nminimize = 'f'\nrobust = 'mean'\n"));
  const std::atomic<bool> stop = true;
  const ReachedReliability found = reached_by(design, optim::Deadline({}, &stop));
  REQUIRE(found.objective);
  CHECK(found.objective->cut_short == "stopped");
  CHECK(found.objective->name.starts_with("f"));
  CHECK(found.all());  // no limit is open
}

TEST_CASE("Where few parts promise too much a search goes on until the reliability is reached",
          "[variation]") {
  // f = sum a_i b_i + c <= 20 in several b, of the deviation 0.2 each: c follows from the quantile.
  // Of these three the parts of the search promised more than was reached, several times over.
  struct Many {
    double reliability;
    std::vector<double> by;
  };
  for (const Many& many : {Many{0.7, {3, 2.7, 2.4, 2.1, 1.8, 1.5, 1.2, 0.9}},
                           Many{0.998, {2.085, 1.583}}, Many{0.995, {2.5, -1.25, 0.5, 1, -3}}}) {
    std::string parameters = "[machine.parameters.c]\ndefault = 2\nlower = -90\nupper = 90\n",
                formula = "c", variations;
    double squares = 0, sum = 0;
    for (std::size_t i = 0; i < many.by.size(); ++i) {
      parameters +=
          fmt::format("[machine.parameters.b{}]\ndefault = 1\nlower = -20\nupper = 20\n", i);
      formula += fmt::format(" + ({}) * b{}", many.by[i], i);
      variations += fmt::format("[variation.b{}]\nstandard_deviation = 0.2\n", i);
      squares += many.by[i] * many.by[i];
      sum += many.by[i];
    }
    const BoundProblem bound(
        read("[machine]\n" + parameters + "[responses.f]\nformula = '" + formula +
             "'\n[responses.own]\nformula = 'c'\n" + variations +
             "[variables.c]\nlower = -80\nupper = 80\n[objective]\nmaximize = 'own'\n" +
             fmt::format("[[constraints]]\nresponse = 'f'\nupper = 20\nreliability = {}\n",
                         many.reliability)));
    optim::Optimum optimum = optim::optimise(bound.space(), {});
    const ReachedReliability found = search_until_reached(bound, {}, optimum);
    const double exact = normal_share((20 - sum - optimum.found.x[0]) / (0.2 * std::sqrt(squares)));
    INFO(many.reliability << " asked for, " << exact << " exactly, at least "
                          << found.limits.front().between.lower);
    CHECK(found.all());
    CHECK(exact >= many.reliability);
    CHECK(1 - exact >= 0.5 * (1 - many.reliability));  // and gives not much away
  }
}

TEST_CASE("A search goes on until its reliabilities are reached by other parts", "[variation]") {
  for (const double reliability : {0.9, 0.99}) {
    const BoundProblem bound = most_within(reliability);
    optim::Optimum optimum = optim::optimise(bound.space(), {});
    const auto reached_at = [](const optim::Optimum& o) {
      return normal_share((6 - 3 * o.found.x[0] - o.found.x[1]) / kDeviation);
    };
    const double at_first = reached_at(optimum);
    const ReachedReliability found = search_until_reached(bound, {}, optimum);
    INFO(reliability << ": " << at_first << ", then " << reached_at(optimum));
    CHECK(found.all());
    CHECK(optimum.found.assessment.verdict == optim::Verdict::Feasible);
    CHECK(reached_at(optimum) >= reliability);
    CHECK(1 - reached_at(optimum) >= 0.85 * (1 - reliability));  // and gives little away
  }
}

}  // namespace camlaw::problems::robust_test
