// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "numerics/linear/statistics.h"
#include "numerics/sampling/sobol_points.h"
#include "optim/search/optimise.h"
#include "problems/sensitivity/design_numbers.h"
#include "problems/statement/bind.h"
#include "problems/tolerance/reliable_search.h"
#include "problems/tolerance/tolerance.h"
#include "tests/problems/complaint.h"

// Reliabilities and robust objectives over load cases and ranges, against closed forms and against
// the same file with the worst case or the worst corner as constants.
namespace camlaw::problems::robust_cases_test {

using Catch::Contains;

namespace {

constexpr double kDeviation = 0.2;

ProblemStatement read(const std::string& text) { return read_problem(text, "f.toml"); }

/// A formula f in b and e, which are normal with a deviation of 0.2 about 0; c varies; p and q are
/// for cases and ranges.
std::string machine(const std::string& formula, const std::string& more) {
  std::string text = "[machine]\n";
  for (const char* name : {"b", "c", "e", "p", "q"}) {
    text += fmt::format("[machine.parameters.{}]\ndefault = 0\nlower = -20\nupper = 20\n", name);
  }
  return text + "[responses.f]\nformula = '" + formula +
         "'\n[responses.own]\nformula = 'c'\n[variation.b]\nstandard_deviation = 0.2\n"
         "[variation.e]\nstandard_deviation = 0.2\n"
         "[variables.c]\nlower = -9\nupper = 9\n" +
         more;
}

const std::string kUpAndDown =
    "[[cases]]\nname = 'up'\np = 1\n[[cases]]\nname = 'down'\np = -1\nweight = 3\n";

std::string limit(double reliability, const std::string& more = "") {
  return fmt::format("[[constraints]]\nresponse = 'f'\nupper = 6\nreliability = {}\n",
                     reliability) +
         more;
}

const std::string kMost = "[objective]\nmaximize = 'own'\n";

ProblemStatement with(const std::string& text, double c) {
  ProblemStatement design = read(text);
  set_value(design, fmt::format("c={:.15g}", c));
  return design;
}

/// The share of parts that meet all limits, as `camlaw tolerance` tells it.
optim::Yield yield_at(const ProblemStatement& design) {
  ToleranceOptions options;
  options.samples = 50000;
  GridReport grid;
  return yield_of(varied_design(design, variations_of(design)), options, grid);
}

/// What two standard normal values with a correlation have below an index, both at once.
double both_below(double index, double correlation) {
  constexpr int kSteps = 4000;
  constexpr double kFrom = -9;
  const double step = (index - kFrom) / kSteps;
  double sum = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const double x = kFrom + i * step;
    const double density = std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi);
    const double own =
        normal_share((index - correlation * x) / std::sqrt(1 - correlation * correlation));
    sum += (i == 0 || i == kSteps ? 1 : i % 2 == 0 ? 2 : 4) * density * own;
  }
  return sum * step / 3;
}

optim::Function objective_of(const ProblemStatement& problem) {
  return BoundProblem(problem).problem({}).objectives.front().response.function();
}

}  // namespace

TEST_CASE("A part holds a limit with a reliability in all of its cases at once",
          "[variation][cases]") {
  // c + b <= 6 and c - b <= 6: |b| <= 6 - c, which 2 Phi - 1 of all parts hold.
  for (const double reliability : {0.7, 0.98}) {
    const double index = normal_quantile((1 + reliability) / 2);
    const BoundProblem bound(read(machine("c + p * b", kUpAndDown + kMost + limit(reliability))));
    REQUIRE(bound.statement().constraints.size() == 1);
    CHECK(bound.statement().constraints[0].response.name == "worst f");
    optim::Optimum optimum = optim::optimise(bound.space(), {});
    CHECK(search_until_reached(bound, {}, optimum).all());
    CHECK(optimum.found.assessment.verdict == optim::Verdict::Feasible);
    CHECK(6 - optimum.found.x[0] == Approx(kDeviation * index).epsilon(0.03));
    CHECK(6 - optimum.found.x[0] >= kDeviation * index * (1 - 1e-9));
    // In one of the cases alone more of the parts may go there.
    const BoundProblem one(
        read(machine("c + p * b", kUpAndDown + kMost + limit(reliability, "cases = ['down']\n"))));
    CHECK(one.statement().constraints[0].response.name == "down.f");
    optim::Optimum alone = optim::optimise(one.space(), {});
    CHECK(search_until_reached(one, {}, alone).all());
    CHECK(6 - alone.found.x[0] == Approx(kDeviation * normal_quantile(reliability)).epsilon(0.03));
  }
}

TEST_CASE("What is reached in two cases is the bivariate normal share", "[variation][cases]") {
  // b and 0.6 b + 0.8 e: normal values with a correlation of 0.6.
  CHECK(both_below(0, 0.6) == Approx(0.25 + std::asin(0.6) / (2 * std::numbers::pi)).epsilon(1e-9));
  const std::string text = machine("c + p * b + q * e",
                                   "[[cases]]\nname = 'one'\np = 1\nq = 0\n"
                                   "[[cases]]\nname = 'two'\np = 0.6\nq = 0.8\n" +
                                       kMost + limit(0.9));
  for (const double index : {0.0, 1.0, 2.0, 3.0}) {
    const ProblemStatement design = with(text, 6 - index * kDeviation);
    const double exact = both_below(index, 0.6);
    const ReachedReliability found = reached_by(design);
    REQUIRE(found.limits.size() == 1);
    const ReachedShare& share = found.limits.front();
    INFO(index << ": exactly " << exact << ", found " << share.share);
    CHECK(share.name == "worst f");
    CHECK(share.share == Approx(exact).margin(0.03 * (1 - exact)));
    CHECK(share.between.lower <= exact);
    CHECK(share.between.upper >= exact);
    CHECK(share.reach == (exact >= 0.9 ? IsReached::Yes : IsReached::No));
    // So many are told as the yield, and each case by itself.
    const optim::Yield yield = yield_at(design);
    CHECK(1 - yield.failing == Approx(exact).margin(0.03 * (1 - exact)));
    REQUIRE(yield.by_limit.size() == 2);
    for (const double own : yield.by_limit) {
      CHECK(own == Approx(1 - normal_share(index)).margin(0.03 * (1 - normal_share(index))));
    }
  }
}

TEST_CASE("Limits of one response and of several cases are each judged by what they are of",
          "[variation][cases]") {
  const std::string text =
      machine("c + p * b", kUpAndDown + kMost +
                               "[responses.g]\nformula = 'c + e'\n[[constraints]]\n"
                               "response = 'g'\nupper = 6\nreliability = 0.6\n" +
                               limit(0.9) +
                               "[[constraints]]\nresponse = 'f'\nlower = 0\nreliability = 0.99\n");
  const ReachedReliability found = reached_by(with(text, 6 - 1.5 * kDeviation));
  REQUIRE(found.limits.size() == 3);
  CHECK(found.limits[0].name == "g");
  CHECK(found.limits[0].share == Approx(normal_share(1.5)).margin(0.003));
  CHECK(found.limits[1].name == "worst f");
  CHECK(found.limits[1].share == Approx(2 * normal_share(1.5) - 1).margin(0.004));
  CHECK(found.limits[1].reach == IsReached::No);
  CHECK(found.limits[2].share > 0.9999);
  CHECK(found.limits[2].reach == IsReached::Yes);
  for (std::size_t i = 0; i < 3; ++i) CHECK(found.limits[i].limit == i);
}

TEST_CASE("A robust objective over cases is of the worst, the mean or the one case of each part",
          "[variation][cases]") {
  struct Sought {
    const char* cases;
    double mean, deviation;
  };
  // c + |b|; by the weights 1 and 3 of the cases c - b / 2; c - b.
  const double folded = std::sqrt(2 / std::numbers::pi);
  for (const Sought& sought :
       {Sought{"worst", kDeviation * folded, kDeviation * std::sqrt(1 - folded * folded)},
        Sought{"mean", 0, kDeviation / 2}, Sought{"down", 0, kDeviation}}) {
    INFO(sought.cases);
    const ProblemStatement design =
        with(machine("c + p * b", kUpAndDown +
                                      "[objective]\nminimize = 'f'\nrobust = "
                                      "'mean + 2 sigma'\ncases = '" +
                                      std::string(sought.cases) + "'\n"),
             1);
    const double exact = 1 + sought.mean + 2 * sought.deviation;
    const optim::Function f = objective_of(design);
    std::vector<double> g(1), h(1);
    CHECK(f.value(std::vector<double>{1}) == Approx(exact).margin(0.03));
    CHECK(f.hessian(std::vector<double>{1}, g, h) == Approx(exact).margin(0.03));
    CHECK(g[0] == Approx(1).epsilon(1e-9));
    CHECK(h[0] == Approx(0).margin(1e-9));
    const ReachedReliability found = reached_by(design);
    REQUIRE(found.objective);
    CHECK(found.objective->value == Approx(exact).margin(0.01));
    CHECK(found.objective->between.lower <= exact);
    CHECK(found.objective->between.upper >= exact);
    CHECK_THAT(found.objective->name, Contains("mean + 2 sigma"));
  }
}

TEST_CASE("With ranges a part holds a limit at every value of them", "[variation][ranges]") {
  // c + p b for p from -1 to 2: the worst is c + 2 b of a part with b above 0, else c - b.
  const double reliability = 0.9;
  const std::string range = "[ranges.p]\nlower = -1\nupper = 2\n";
  const auto share = [&](double room) {
    return normal_share(room / 2 / kDeviation) - normal_share(-room / kDeviation);
  };
  double low = 0, high = 2;
  while (high - low > 1e-12)
    (share((low + high) / 2) < reliability ? low : high) = (low + high) / 2;
  const std::string text = machine("c + p * b", range + kMost + limit(reliability));
  const BoundProblem bound(read(text));
  optim::Optimum optimum = optim::optimise(bound.space(), {});
  CHECK(search_until_reached(bound, {}, optimum).all());
  CHECK(6 - optimum.found.x[0] == Approx(high).epsilon(0.03));
  for (const double room : {0.2, 0.5, 1.0}) {
    const ProblemStatement design = with(text, 6 - room);
    // The likeliest failure that is found first is one of two, so that samples tell less.
    const double exact = share(room);
    const ReachedShare found = reached_by(design).limits.at(0);
    CHECK(found.share == Approx(exact).margin(0.15 * (1 - exact)));
    CHECK(found.between.lower <= exact);
    CHECK(found.between.upper >= exact);
    const optim::Yield yield = yield_at(design);
    CHECK(1 - yield.failing == Approx(exact).margin(0.15 * (1 - exact)));
    CHECK(yield.failing_between.lower <= 1 - exact);
    CHECK(yield.failing_between.upper >= 1 - exact);
  }
}

TEST_CASE("Inside a range the worst place of each part is found", "[variation][ranges]") {
  // c + b - (p - b)^2 is c + b at the worst: p = b, which differs from part to part.
  const std::string range = "[ranges.p]\nlower = -3\nupper = 3\n";
  const ProblemStatement design =
      with(machine("c + b - (p - b)^2",
                   range + "[objective]\nminimize = 'f'\nrobust = 'quantile 0.9'\n"),
           2);
  const optim::Function f = objective_of(design);
  const double exact = 2 + kDeviation * normal_quantile(0.9);
  CHECK(f.value(std::vector<double>{2}) == Approx(exact).margin(0.02));
  CHECK(reached_by(design).objective->value == Approx(exact).margin(0.01));
}

TEST_CASE("Cases and ranges count for each part together", "[variation][cases][ranges]") {
  // Cases p = 1 and -1, q from 1 to 2: c + 2 |b|.
  const std::string both = kUpAndDown + "[ranges.q]\nlower = 1\nupper = 2\n";
  const std::string text = machine("c + p * q * b", both + kMost + limit(0.95));
  for (const double index : {1.0, 1.8, 2.5}) {
    const ProblemStatement design = with(text, 6 - 2 * index * kDeviation);
    const double exact = 2 * normal_share(index) - 1;
    const ReachedShare found = reached_by(design).limits.at(0);
    CHECK(found.share == Approx(exact).margin(0.03 * (1 - exact)));
    CHECK(1 - yield_at(design).failing == Approx(exact).margin(0.03 * (1 - exact)));
  }
  const double folded = std::sqrt(2 / std::numbers::pi);
  for (const char* cases : {"worst", "mean"}) {
    const ProblemStatement design =
        with(machine("c + p * q * b", both + fmt::format("[objective]\nminimize = 'f'\n"
                                                         "robust = 'mean'\ncases = '{}'\n",
                                                         cases)),
             1);
    // Of the mean by 1 and 3: for b > 0 (2 b - 3 b) / 4, for b < 0 (b - 6 b) / 4, that is -b/4 and
    // -5 b / 4.
    const double exact = std::string(cases) == "worst"
                             ? 1 + 2 * kDeviation * folded
                             : 1 + (1.25 - 0.25) / 2 * kDeviation * folded;
    INFO(cases);
    CHECK(reached_by(design).objective->value == Approx(exact).margin(0.01));
  }
}

TEST_CASE("What is set in a case or a range counts in a limit with a reliability",
          "[variation][cases][ranges]") {
  const std::string text = machine(
      "c + p * q * b", kUpAndDown + "[ranges.q]\nlower = 1\nupper = 2\n" + kMost + limit(0.9));
  ProblemStatement design = with(text, 6 - 2 * kDeviation);
  const auto share = [&] { return reached_by(design).limits.at(0).share; };
  CHECK(share() == Approx(2 * normal_share(1) - 1).margin(0.005));
  set_value(design, "q.upper=4");
  CHECK(share() == Approx(2 * normal_share(0.5) - 1).margin(0.005));
  set_value(design, "down.p=0");
  CHECK(share() == Approx(normal_share(0.5)).margin(0.005));
  for (const char* name : {"f.upper", "worst f.upper"}) {
    set_value(design, fmt::format("{}={}", name, 6 + 2 * kDeviation));
    CHECK(share() == Approx(normal_share(1)).margin(0.005));
    set_value(design, fmt::format("{}=6", name));
  }
  // Its numbers at one part and one value are those of each case.
  const auto numbers = design_numbers(design, design_parameters(design));
  std::vector<std::string> names;
  for (const DesignNumber& number : numbers) names.push_back(number.name);
  CHECK_THAT(names, Catch::VectorContains(std::string("up.f")) &&
                        Catch::VectorContains(std::string("down.f")));
}

namespace {

/// A cam as in problems/cams/robust_force.toml.
std::string cam(const std::string& constants, const std::string& more) {
  return "mechanism = 'disc-cam-roller'\n[constants]\nstroke = '25 mm'\nbase_radius = '40 mm'\n"
         "roller_radius = '10 mm'\nmass = '1.5 kg'\n" +
         constants +
         "[variation.spring_preload]\nstandard_deviation = '8 N'\n"
         "[variation.mass]\nplus = '0.05 kg'\nminus = '0.05 kg'\n"
         "[[program.segments]]\nname = 'rise'\nangle = '90 deg'\nlaw = 'modified-sine'\n"
         "[[program.segments]]\nname = 'high'\nangle = '70 deg'\n"
         "[[program.segments]]\nname = 'return'\nangle = '110 deg'\nlaw = 'cycloidal'\n"
         "[[program.segments]]\nname = 'low'\n"
         "[variables.spring_preload]\nlower = '50 N'\nupper = '900 N'\nstart = '400 N'\n"
         "[variables.spring_rate]\nlower = '2 N/mm'\nupper = '30 N/mm'\nstart = '10 N/mm'\n"
         "[objective]\nminimize = 'peak contact_force'\nrobust = 'mean + 3 sigma'\n"
         "[[constraints]]\nresponse = 'follower_force'\nlower = '12 N'\nreliability = 0.9\n" +
         more;
}

}  // namespace

TEST_CASE("A range whose corner is the worst, or a case that is, is that machine",
          "[variation][cases][ranges]") {
  // The faster, the less force is left, and the more there is at its most.
  const BoundProblem fixed(read(cam("speed = '300 rpm'\n", "")));
  const optim::Problem exact = fixed.problem({});
  for (const char* more : {"[ranges.speed]\nlower = '200 rpm'\nupper = '300 rpm'\n",
                           "[[cases]]\nname = 'slow'\nspeed = '200 rpm'\n"
                           "[[cases]]\nname = 'fast'\nspeed = '300 rpm'\n"}) {
    INFO(more);
    const BoundProblem over(read(cam("", more)));
    const optim::Problem problem = over.problem({});
    for (const std::vector<double>& x :
         std::vector<std::vector<double>>{{400, 10}, {150, 25}, {700, 4}}) {
      const auto compare = [&](const optim::Function& a, const optim::Function& b) {
        REQUIRE(a.inputs() == b.inputs());
        std::vector<double> of_a(2), of_b(2);
        CHECK(a.gradient(x, of_a) == Approx(b.gradient(x, of_b)).epsilon(1e-9));
        for (std::size_t i = 0; i < 2; ++i) {
          CHECK(of_a[i] == Approx(of_b[i]).epsilon(1e-6).margin(1e-8));
        }
      };
      compare(problem.objectives[0].response.function(), exact.objectives[0].response.function());
      const auto of_force = [&](const optim::Problem& of) -> const optim::Constraint& {
        return *std::find_if(of.constraints.begin(), of.constraints.end(), [](const auto& c) {
          return c.response.name.find("follower_force") != std::string::npos &&
                 !c.response.is_curve();
        });
      };
      compare(of_force(problem).response.function(), of_force(exact).response.function());
    }
  }
}

TEST_CASE("A limit with a reliability in a case that is not there is refused",
          "[variation][cases]") {
  CHECK_THAT(testing::complaint(
                 machine("c + p * b", kUpAndDown + kMost + limit(0.9, "cases = ['dwon']\n"))),
             Contains("there is no case 'dwon'") && Contains("down"));
}

}  // namespace camlaw::problems::robust_cases_test
