// SPDX-License-Identifier: MIT
#include "problems/statement/variation.h"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "machines/model/over_ranges.h"
#include "numerics/sampling/sobol_points.h"
#include "optim/search/optimise.h"
#include "problems/results/recorded_design.h"
#include "problems/statement/bind.h"
#include "problems/tolerance/tolerance.h"
#include "tests/paths.h"
#include "tests/problems/complaint.h"
#include "tests/random_numbers.h"

// What manufacture does to designs, against closed forms and against many parts one by one.
namespace camlaw::problems::variation_test {

using Catch::Contains;

namespace {

ProblemStatement read(const std::string& text) { return read_problem(text, "f.toml"); }

VariedDesign varied(const std::string& text) {
  const ProblemStatement problem = read(text);
  return varied_design(problem, variations_of(problem));
}

/// A machine of formulas in b and c, with a law where `moved`.
std::string machine(const std::string& formulas, bool moved = false) {
  return std::string("[machine]\n") + (moved ? "moved_by = 'law'\n" : "") +
         "[machine.parameters.b]\ndefault = 1\nlower = -20\nupper = 20\n"
         "[machine.parameters.c]\ndefault = 2\nlower = -20\nupper = 20\n" +
         formulas + (moved ? "[law]\nname = 'cosine'\n" : "");
}

std::string cam(const std::string& more) {
  return R"(
mechanism = "disc-cam-roller"
[constants]
stroke = "25 mm"
mass = "1.5 kg"
spring_rate = "8 N/mm"
speed = "300 rpm"
)" + more +
         R"(
[program]
segments = [{name = "rise", angle = 90, law = "modified-sine"}, {name = "high", angle = 70},
            {name = "back", angle = 110, law = "cycloidal"}, {name = "low"}]
)";
}

const std::string kLimits =
    "[[constraints]]\nresponse = 'pressure_angle'\nupper = '{} deg'\nlower = '-40 deg'\n"
    "[[constraints]]\nresponse = 'undercut'\nupper = {}\n"
    "[[constraints]]\nresponse = 'follower_force'\nlower = '{} N'\n";

}  // namespace

TEST_CASE("A variation is read as it is stated", "[variation]") {
  const ProblemStatement problem = read(cam(
      "base_radius = '40 mm'\nroller_radius = '10 mm'\nspring_preload = '200 N'\noffset = '5 mm'\n"
      "[variation.base_radius]\nplus = '0.05 mm'\nminus = 0.02\n"
      "[variation.roller_radius]\nfit = 'h7'\nof_diameter = true\n"
      "[variation.spring_preload]\nstandard_deviation = '5 N'\n"
      "[variation.offset]\nplus = '30 um'\ndistribution = 'normal'\n"));
  const auto& all = variations_of(problem);
  REQUIRE(all.size() == 4);
  const auto off = [&](std::size_t i) { return all[i].at(meant_value(problem, all[i])); };
  CHECK(off(0).lower == -0.02);
  CHECK(off(0).upper == 0.05);
  CHECK_FALSE(off(0).is_normal);
  CHECK(off(0).deviation() == Approx(0.035 / std::sqrt(3.0)));
  CHECK(off(1).lower == Approx(-0.0105));  // of a diameter of 20 mm -0.021
  CHECK(off(1).upper == 0);
  CHECK(off(2).lower == Approx(-15));
  CHECK(off(2).deviation() == Approx(5));
  CHECK(off(2).is_normal);
  CHECK(off(3).middle() == Approx(0.015));
  CHECK(off(3).deviation() == Approx(0.005));
  CHECK_THAT(in_words(problem), Contains("In manufacture base_radius varies by +0.05/-0.02 mm") &&
                                    Contains("diameter h7") && Contains("deviation 5 N"));
}

TEST_CASE("A variation that says nothing sensible is refused with its place", "[variation]") {
  const auto said = [](const std::string& tables) {
    return testing::complaint(cam("base_radius = '40 mm'\n" + tables));
  };
  CHECK_THAT(said("[variation.base_radius]\n"),
             Contains("variation.base_radius") && Contains("plus, minus or both"));
  CHECK_THAT(said("[variation.base_radios]\nplus = 1\n"), Contains("base_radius"));
  CHECK_THAT(said("[variation.base_radius]\nplus = -1\n"), Contains("below 0"));
  CHECK_THAT(said("[variation.base_radius]\nplus = 0\n"), Contains("both 0"));
  CHECK_THAT(said("[variation.base_radius]\nplus = '1 s'\n"), Contains("base_radius.plus"));
  CHECK_THAT(said("[variation.base_radius]\nminus = '50 mm'\n"), Contains("-10 mm"));
  CHECK_THAT(said("[variation.base_radius]\nplus = 1\nfit = 'h7'\n"), Contains("drop one"));
  CHECK_THAT(said("[variation.base_radius]\nplus = 1\nstandard_deviation = 1\n"),
             Contains("drop one"));
  CHECK_THAT(said("[variation.base_radius]\nfit = 'h77'\n"), Contains("such as h7"));
  CHECK_THAT(said("[variation.speed]\nfit = 'h7'\n"), Contains("a length in mm"));
  CHECK_THAT(said("[variation.base_radius]\nplus = 1\ndistribution = 'even'\n"),
             Contains("normal, uniform"));
  CHECK_THAT(said("[variation.base_radius]\nplus = 1\nof_diameter = true\n"),
             Contains("belongs to a fit"));
  CHECK_THAT(said("[ranges.speed]\nlower = 100\nupper = 200\n[variation.speed]\nplus = 1\n"),
             Contains("has a range"));
  CHECK_THAT(said("[[cases]]\nname = 'a'\nspeed = 100\n[variation.speed]\nplus = 1\n"),
             Contains("load cases set"));
  CHECK_THROWS_WITH(varied(cam("")), Contains("[variation.base_radius]"));
  // The ends of a variable are made too: 1 mm less than 0.5 mm is none.
  CHECK_THAT(said("[variation.roller_radius]\nplus = '1 mm'\nminus = '1 mm'\n"
                  "[variables.roller_radius]\nlower = '0.5 mm'\nupper = '9 mm'\nstart = '5 mm'\n"),
             Contains("variation.roller_radius") && Contains("-0.5 mm"));
}

TEST_CASE("Variations are added one by one, of what has one value", "[variation]") {
  ProblemStatement problem = read(cam("base_radius = '40 mm'\n"));
  problem.ranges = {{find_parameter(problem, "speed").parameter, 100, 200}};
  CHECK_THROWS_WITH(check_may_vary(problem, find_parameter(problem, "speed")),
                    Contains("has a range"));
  std::vector<VariationStatement> all;
  VariationStatement one;
  one.parameter = find_parameter(problem, "base_radius");
  one.plus = one.minus = 1;
  add_variation(all, one);
  CHECK_THROWS_WITH(add_variation(all, one), Contains("stated twice"));
  CHECK(all.size() == 1);
}

TEST_CASE("A limit on a parameter itself holds for all parts", "[variation]") {
  // b is made up to 0.3 more: the greatest that keeps it at 5 or below is 4.7.
  const std::string limits =
      "[variation.b]\nplus = 0.3\nminus = 0.2\n"
      "[variables.b]\nlower = -9\nupper = 9\n"
      "[[constraints]]\nresponse = 'b'\nlower = -5\nupper = 5\n";
  const BoundProblem bound(
      read(machine("[responses.f]\nformula = 'b'\n" + limits + "[objective]\nmaximize = 'f'\n")));
  const auto found = optim::optimise(bound.space(), {});
  INFO(found.found.assessment.reason);
  CHECK(found.found.x[0] == Approx(4.7).epsilon(1e-6));
  const ProblemStatement design = bound.at(found.options, found.found.x);
  for (const WorstPart& worst : worst_parts(varied_design(design, variations_of(design)))) {
    CHECK(worst.name.starts_with("b"));
    CHECK(worst.holds == Holds::Proved);
    if (worst.is_upper) CHECK(worst.value == Approx(5).epsilon(1e-6));
  }
  // As stated b is 4.8: a part of 5.1 breaks the limit.
  ProblemStatement wide = design;
  set_value(wide, "b=4.8");
  const auto worst = worst_parts(varied_design(wide, variations_of(wide)));
  REQUIRE(worst.size() == 2);
  const WorstPart& upper = worst[worst[0].is_upper ? 0 : 1];
  CHECK(upper.value == Approx(5.1).epsilon(1e-12));
  CHECK(upper.holds == Holds::Broken);
}

TEST_CASE("A size that is set has the offsets of its own fit", "[variation]") {
  ProblemStatement problem =
      read(cam("base_radius = '40 mm'\nroller_radius = '10 mm'\n"
               "[variation.roller_radius]\nfit = 'h7'\nof_diameter = true\n"
               "[[constraints]]\nresponse = 'pressure_angle'\nupper = '60 deg'\n"));
  const auto least = [&] {
    for (const ConstraintStatement& limit : problem.constraints) {
      if (limit.response.name != "pressure_angle" || !limit.of_range) continue;
      return limit.of_range->over_ranges->ranges.at(0).lower;
    }
    return 0.0;
  };
  CHECK(least() == Approx(-0.0105));  // of a diameter of 20 mm -0.021
  set_value(problem, "roller_radius=20 mm");
  CHECK(least() == Approx(-0.0125));  // of 40 mm -0.025
}

TEST_CASE("Where a resonance lies inside, the worst part is found and proved there",
          "[variation]") {
  // 1 / sqrt((1 - b^2)^2 + (0.2 b)^2) is highest at b = sqrt(0.98): 1 / (0.2 sqrt(0.99)).
  const double highest = 1 / (0.2 * std::sqrt(0.99));
  const std::string formula =
      "[responses.gain]\nformula = '1 / sqrt((1 - b^2)^2 + 0.04 * b^2)'\n"
      "[variation.b]\nplus = 0.2\nminus = 0.2\n";
  const auto limit = [](double upper) {
    return fmt::format("[[constraints]]\nresponse = 'gain'\nupper = {}\n", upper);
  };
  const auto held = worst_parts(varied(machine(formula + limit(5.1))));
  REQUIRE(held.size() == 1);
  CHECK(held[0].value == Approx(highest).epsilon(1e-9));
  CHECK(held[0].holds == Holds::Proved);
  CHECK(held[0].slack < 1e-3);
  CHECK(held[0].part[0] == Approx(std::sqrt(0.98)).epsilon(1e-5));
  const auto broken = worst_parts(varied(machine(formula + limit(5))));
  CHECK(broken[0].holds == Holds::Broken);
  CHECK(broken[0].part[0] == Approx(std::sqrt(0.98)).epsilon(1e-5));
}

TEST_CASE("A number that breaks a limit between its ends is named", "[variation]") {
  // b alone reaches 1 + 0.2 sin(10 b) = 1.2 inside and 1.19 at no end; c alone moves nothing there,
  // and together they reach no more.
  const std::string text =
      "[responses.wave]\nformula = '1 + 0.2 * sin(10 * b) + 0 * c'\n"
      "[variation.b]\nplus = 0.3\nminus = 0.3\n[variation.c]\nplus = 0.1\nminus = 0.1\n"
      "[[constraints]]\nresponse = 'wave'\nupper = 1.19\n";
  const VariedDesign design = varied(machine(text));
  for (const double off : {-0.3, 0.3}) {
    CHECK(1 + 0.2 * std::sin(10 * (design.meant[0] + off)) < 1.18);
  }
  CHECK(broken_alone(design) == std::vector<std::vector<std::size_t>>{{0}, {}});
}

TEST_CASE("The yield of linear limits with normal variation is the closed form", "[variation]") {
  // b + 2 c is normal about 5 with the deviation sqrt(0.3^2 + 0.2^2).
  const VariedDesign design = varied(
      machine("[responses.total]\nformula = 'b + 2 * c'\n[variation.b]\nstandard_deviation = 0.3\n"
              "[variation.c]\nstandard_deviation = 0.1\n"
              "[[constraints]]\nresponse = 'total'\nupper = 5.5\n"));
  const ToleranceAnswer answer = tolerance_of(design, {.samples = 100000});
  const double deviation = std::sqrt(0.09 + 0.04), exact = normal_share(-0.5 / deviation);
  REQUIRE(answer.yield);
  CHECK(std::abs(answer.yield->failing - exact) <= 5 * answer.yield->error + 1e-6);
  CHECK(answer.yield->error < 1e-3);
  CHECK(*answer.yield->indices[0] == Approx(0.5 / deviation).epsilon(1e-4));
  REQUIRE(answer.limits.size() == 1);
  CHECK(answer.limits[0].slopes[0] == Approx(1).epsilon(1e-12));
  CHECK(answer.limits[0].slopes[1] == Approx(2).epsilon(1e-12));
  // b from 0.1 to 1.9, c from 1.7 to 2.3: 1.9 + 4.6; c alone reaches 5.6, b alone 5.9.
  CHECK(answer.worst[0].value == Approx(6.5).epsilon(1e-12));
  CHECK(answer.worst[0].holds == Holds::Broken);
  CHECK(answer.factors[0].factor == Approx(0.5 / 1.5).epsilon(2e-3));
  CHECK(answer.factors[0].proved);
  CHECK(answer.broken_alone == std::vector<std::vector<std::size_t>>{{0}, {0}});
}

TEST_CASE("A limit is held for all parts in a search", "[variation]") {
  // p - b v >= 0 with v up to pi / 2 and b from 0.8 to 1.3, p made 0.05 less: the least p.
  const std::string text =
      "[machine]\nmoved_by = 'law'\n[machine.parameters.b]\ndefault = 1\nlower = -5\nupper = 5\n"
      "[machine.parameters.p]\ndefault = 0\nlower = -10\nupper = 10\n"
      "[responses.f]\nformula = 'p - b * v'\n[responses.least]\nformula = 'p'\n"
      "[law]\nname = 'cosine'\n[variation.b]\nplus = 0.3\nminus = 0.2\n"
      "[variation.p]\nplus = 0.01\nminus = 0.05\n"
      "[variables.p]\nlower = -9\nupper = 9\nstart = 5\n[objective]\nminimize = 'least'\n"
      "[[constraints]]\nresponse = 'f'\nlower = 0\n";
  const BoundProblem bound(read(text));
  const auto found = optim::optimise(bound.space(), {});
  INFO(found.found.assessment.reason);
  CHECK(found.found.assessment.verdict == optim::Verdict::Certified);
  CHECK(found.found.x[0] == Approx(1.3 * std::acos(-1.0) / 2 + 0.05).epsilon(1e-7));
  // The worst of the objective is sought too: p made greatest.
  CHECK(found.found.assessment.objective.value == Approx(found.found.x[0] + 0.01).epsilon(1e-9));
  const ProblemStatement design = bound.at(found.options, found.found.x);
  const auto worst = worst_parts(varied_design(design, variations_of(design)));
  REQUIRE(worst.size() == 1);
  CHECK(worst[0].holds == Holds::Proved);
  CHECK(worst[0].margin == Approx(0).margin(1e-5));
}

TEST_CASE("Derivatives of a highest value about a variable are those at the worst part",
          "[variation]") {
  const std::string text =
      "[machine]\n[machine.parameters.b]\ndefault = 1\nlower = -9\nupper = 9\n"
      "[machine.parameters.c]\ndefault = 2\nlower = -9\nupper = 9\n"
      "[responses.g]\nformula = 'c^2 - (b - 0.5 * c)^2 + 0.3 * b'\n"
      "[variables.b]\nlower = -5\nupper = 5\n[variables.c]\nlower = 0\nupper = 9\n"
      "[variation.b]\nplus = 0.5\nminus = 0.25\n[objective]\nminimize = 'g'\n";
  const optim::Problem problem = BoundProblem(read(text)).problem({});
  const optim::Function& f = problem.objectives.front().response.function();
  const auto closed = [](double b, double c) {  // highest at c / 2 + 0.15, within the offsets
    const double at = std::clamp(0.5 * c + 0.15, b - 0.25, b + 0.5);
    return c * c - (at - 0.5 * c) * (at - 0.5 * c) + 0.3 * at;
  };
  for (const auto& x :
       std::vector<std::vector<double>>{{1, 2}, {1, 4}, {3, 2}, {-1, 7}, {2, 3.9}}) {
    std::vector<double> g(2), h(3);
    INFO(x[0] << ", " << x[1]);
    CHECK(f.hessian(x, g, h) == Approx(closed(x[0], x[1])).epsilon(1e-12));
    const double d = 1e-5, e = 1e-3;
    CHECK(g[0] == Approx((closed(x[0] + d, x[1]) - closed(x[0] - d, x[1])) / (2 * d)).margin(1e-6));
    CHECK(g[1] == Approx((closed(x[0], x[1] + d) - closed(x[0], x[1] - d)) / (2 * d)).margin(1e-6));
    const double cross = (closed(x[0] + e, x[1] + e) - closed(x[0] + e, x[1] - e) -
                          closed(x[0] - e, x[1] + e) + closed(x[0] - e, x[1] - e)) /
                         (4 * e * e);
    CHECK(h[1] == Approx(cross).margin(1e-5));
    const optim::Bounds bounds = f.enclose(x);
    CHECK(bounds.lower <= closed(x[0], x[1]) + 1e-12);
    CHECK(bounds.upper >= closed(x[0], x[1]) - 1e-12);
    CHECK(bounds.upper - bounds.lower < 1e-5);
    // Over a box of designs the bounds hold each of them.
    const std::vector<optim::Bounds> box{{x[0] - 0.1, x[0] + 0.1}, {x[1] - 0.1, x[1] + 0.1}};
    const optim::BoxRange range = f.range(box);
    for (const double p : {-0.1, 0.0, 0.07, 0.1}) {
      for (const double q : {-0.1, 0.03, 0.1}) {
        CHECK(range.value.lower <= closed(x[0] + p, x[1] + q) + 1e-12);
        CHECK(range.value.upper >= closed(x[0] + p, x[1] + q) - 1e-12);
      }
    }
  }
}

TEST_CASE("Rooms on a grid are those of a search at each part, within their slack", "[variation]") {
  const std::string sizes =
      "base_radius = '42 mm'\nroller_radius = '10 mm'\nspring_preload = '260 N'\n";
  double angle = 0, undercut = 0, force = 0;
  for (const EvaluatedResponse& r : evaluate(read(cam(sizes)))) {
    if (r.name == "pressure_angle") angle = r.highest;
    if (r.name == "undercut") undercut = r.highest;
    if (r.name == "follower_force") force = r.lowest;
  }
  const VariedDesign design =
      varied(cam(sizes + "[variation.base_radius]\nplus = '1 mm'\nminus = '1 mm'\n"
                         "[variation.roller_radius]\nplus = '0.5 mm'\nminus = '0.5 mm'\n"
                         "[variation.spring_preload]\nstandard_deviation = '20 N'\n") +
             fmt::format(fmt::runtime(kLimits), angle, undercut, force));
  const GridRooms rooms = grid_rooms(design);
  CHECK(rooms.report.without_grid == 0);
  CHECK(rooms.report.places > 0);
  CHECK(rooms.report.left < 0.9);
  const auto searched = optim::searched_rooms(design.problem, design.meant);
  const std::size_t limits = rooms.rows->limits();
  REQUIRE(searched->limits() == limits);
  camlaw::testing::Random random(5);
  constexpr std::size_t kParts = 61;
  std::vector<double> parts;
  for (std::size_t k = 0; k < kParts; ++k) {
    parts.insert(parts.end(), {42 + random(-1, 1), 10 + random(-0.5, 0.5), 260 + random(-90, 90)});
  }
  std::vector<double> fast(limits * kParts), slow(limits * kParts);
  rooms.rows->room(parts, kParts, fast);
  searched->room(parts, kParts, slow);
  const std::vector<double> slack = rooms.rows->slack();
  std::size_t broken = 0;
  for (std::size_t i = 0; i < limits; ++i) {
    for (std::size_t k = 0; k < kParts; ++k) {
      const double quick = fast[i * kParts + k], exact = slow[i * kParts + k];
      INFO("limit " << i << ", part " << k << ": " << quick << ", searched " << exact << ", slack "
                    << slack[i]);
      CHECK(quick >= exact - 1e-7);  // nothing between the places of the grid is worse
      broken += exact < 0;
      // Where no part of the box breaks a limit its room may be anything above 0.
      if (exact < 0) CHECK(quick <= exact + slack[i] + 1e-9);
      if (exact >= slack[i]) CHECK(quick >= 0);
    }
  }
  CHECK(broken > limits * kParts / 10);
  CHECK(broken < limits * kParts * 9 / 10);
}

namespace {

/// What the limits of random designs turned out to be.
struct Agreement {
  int proved = 0, broken = 0, estimated = 0;
};

/// Whether what is proved of the parts of random designs agrees with what samples of them show.
Agreement proof_against_samples(unsigned seed, int designs, std::size_t samples) {
  camlaw::testing::Random random(seed);
  Agreement found;
  for (int trial = 0; trial < designs; ++trial) {
    const double base = random(30, 60), roller = random(6, 14), preload = random(100, 500);
    const VariedDesign design = varied(cam(
        fmt::format("base_radius = {}\nroller_radius = {}\nspring_preload = {}\n"
                    "[variation.base_radius]\nplus = {}\nminus = {}\n"
                    "[variation.roller_radius]\nplus = {}\nminus = {}\n"
                    "[variation.spring_preload]\nplus = {}\nminus = {}\n",
                    base, roller, preload, random(0, 2), random(0.01, 2), random(0, 1),
                    random(0.01, 1), random(0, 50), random(1, 50)) +
        fmt::format(fmt::runtime(kLimits), random(20, 35), random(0.3, 0.95), random(-100, 100))));
    ToleranceOptions options;
    options.samples = samples;
    options.factors = false;
    const ToleranceAnswer answer = tolerance_of(design, options);
    REQUIRE(answer.yield);
    for (const WorstPart& worst : answer.worst) {
      const double share = answer.yield->by_limit[worst.limit];
      INFO("trial " << trial << ", " << worst.name << ": " << to_string(worst.holds) << ", "
                    << share << " fail");
      if (worst.holds != Holds::Broken) continue;
      ++found.broken;
      // The part that is named breaks it.
      std::vector<double> part = worst.part, room(answer.limits.size());
      for (std::size_t i = 0; i < part.size(); ++i) {
        if (std::isnan(part[i])) part[i] = design.meant[i];
      }
      optim::searched_rooms(design.problem, design.meant)->room(part, 1, room);
      CHECK(!(room[worst.limit] >= 0));
    }
    for (std::size_t i = 0; i < answer.limits.size(); ++i) {
      const bool holds =
          std::all_of(answer.worst.begin(), answer.worst.end(),
                      [&](const WorstPart& w) { return w.limit != i || w.holds == Holds::Proved; });
      if (!holds) {
        found.estimated += answer.yield->by_limit[i] > 0;
        continue;
      }
      ++found.proved;
      CHECK(answer.yield->by_limit[i] == 0);
    }
    // No sample is worse than the worst.
    for (const optim::Spread& s : answer.spreads.spreads) {
      if (!s.is_margin || !s.possible) continue;
      double least = 1e300;
      for (const WorstPart& w : answer.worst) {
        if (w.name == s.name) least = std::min(least, w.margin);
      }
      CHECK(s.lowest >= least - 1e-6 * (1 + std::abs(least)));
    }
  }
  return found;
}

}  // namespace

TEST_CASE("Proof and sampling never contradict each other", "[variation][heavy]") {
  const Agreement found = proof_against_samples(11, 16, 512);
  CHECK(found.proved > 3);
  CHECK(found.broken > 3);
  CHECK(found.estimated > 3);
}

TEST_CASE("Proof and sampling do not contradict each other at a few designs", "[variation]") {
  const Agreement found = proof_against_samples(12, 4, 64);
  CHECK(found.proved > 0);
  CHECK(found.broken > 0);
}

TEST_CASE("A law that varies is searched, and nothing is said to be proved of it", "[variation]") {
  const VariedDesign design = varied(R"(
mechanism = "disc-cam-roller"
[constants]
stroke = "25 mm"
base_radius = "40 mm"
[program]
segments = [{name = "rise", angle = 90, law = "modified-sine"}, {name = "high", angle = 70},
            {name = "back", angle = 110, law = "cycloidal"}, {name = "low"}]
[variation.rise_angle]
plus = "2 deg"
minus = "2 deg"
[[constraints]]
response = "pressure_angle"
upper = "45 deg"
)");
  const auto worst = worst_parts(design);
  REQUIRE(worst.size() == 1);
  CHECK(worst[0].holds == Holds::NotProved);
  CHECK_THAT(worst[0].why_not, Contains("the law"));
  CHECK(worst[0].part[0] == Approx(88));
}

TEST_CASE("A part that passes a limit is found in whatever unit its variation is listed",
          "[variation]") {
  // A clamp with 95 N over a gap of +-10 um and 10 N/um: at worst -5 N, and 97.5 % of all parts
  // hold.
  const auto clamp = [](const char* unit, double length) {
    return fmt::format(
        "[machine]\n[machine.parameters.gap]\nunit = '{}'\ndefault = 0\n"
        "[machine.parameters.force]\nunit = 'N'\ndefault = 95\n"
        "[machine.parameters.stiffness]\nunit = 'N/m'\ndefault = 1e7\nlower = 0\n"
        "[responses.grip]\nformula = 'force - stiffness * gap'\nunit = 'N'\n"
        "[variation.gap]\nplus = {}\nminus = {}\n"
        "[variables.force]\nlower = 0\nupper = 1000\n[objective]\nminimize = 'force'\n"
        "[[constraints]]\nresponse = 'grip'\nlower = 0\n",
        unit, length, length);
  };
  for (const auto& [unit, length] : {std::pair{"m", 1e-5}, {"mm", 1e-2}, {"um", 10.0}}) {
    INFO(unit);
    ProblemStatement design = read(clamp(unit, length));
    set_value(design, "force=95 N");
    const VariedDesign parts = varied_design(design, variations_of(design));
    const auto worst = worst_parts(parts);
    REQUIRE(worst.size() == 1);
    CHECK(worst[0].holds == Holds::Broken);
    CHECK(worst[0].value == Approx(-5).epsilon(1e-6));
    const ToleranceAnswer answer = tolerance_of(parts, {.samples = 4096});
    REQUIRE(answer.yield);
    CHECK(answer.yield->failing == Approx(0.025).margin(2e-3));
  }
}

TEST_CASE("The worst part is found where it lies within, though a corner is a top as well",
          "[variation]") {
  // c (1 + sin^2(2.85 b)) is 2 at most, at b = 0.5512 and c = 1; the corner b = -1.5 has 1.82.
  const std::string text =
      "[machine]\n[machine.parameters.b]\ndefault = -0.25\nlower = -20\nupper = 20\n"
      "[machine.parameters.c]\ndefault = 0\nlower = -20\nupper = 20\n"
      "[machine.parameters.d]\ndefault = 1.9\nlower = -20\nupper = 20\n"
      "[responses.g]\nformula = 'd - c * (1 + sin(2.85 * b)^2)'\n"
      "[variation.b]\nplus = 1.25\nminus = 1.25\n[variation.c]\nplus = 1\n"
      "[variables.d]\nlower = -5\nupper = 5\nstart = 1.9\n[objective]\nminimize = 'd'\n"
      "[[constraints]]\nresponse = 'g'\nlower = 0\n";
  const auto worst = worst_parts(varied(text));
  REQUIRE(worst.size() == 1);
  CHECK(worst[0].value == Approx(-0.1).epsilon(1e-9));
  CHECK(worst[0].holds == Holds::Broken);
  CHECK(std::abs(worst[0].part[0]) == Approx(std::asin(1) / 2.85).epsilon(1e-6));
  CHECK(worst[0].part[1] == 1);
  const optim::Assessment found =
      optim::optimise(BoundProblem(read(text)).space()).found.assessment;
  CHECK(found.verdict == optim::Verdict::Certified);
  CHECK(found.objective.value == Approx(2).epsilon(1e-6));
}

TEST_CASE("What is printed of the worst part lies within what is proved of it", "[variation]") {
  // Waves too narrow for the search's grid: the proof comes upon them.
  for (const double waves : {2.0, 3.7, 5.3, 7.1, 9.9, 13.0}) {
    const std::string text = fmt::format(
        "[machine]\n[machine.parameters.b]\ndefault = 0.1\nlower = -20\nupper = 20\n"
        "[machine.parameters.c]\ndefault = 0\nlower = -20\nupper = 20\n"
        "[responses.g]\nformula = '(1 + c) * sin({} * b)^2 - 0.1 * b'\n"
        "[variation.b]\nplus = 1.9\nminus = 1.3\n[variation.c]\nplus = 1\nminus = 0.5\n"
        "[[constraints]]\nresponse = 'g'\nupper = 3\n",
        waves);
    double most = -1e9;
    for (int i = 0; i <= 200000; ++i) {
      const double b = -1.2 + 3.2 * i / 200000;
      most = std::max(most, 2 * std::sin(waves * b) * std::sin(waves * b) - 0.1 * b);
    }
    INFO(waves);
    const auto worst = worst_parts(varied(text));
    REQUIRE(worst.size() == 1);
    CHECK(worst[0].value == Approx(most).epsilon(1e-6));
    CHECK(worst[0].holds == Holds::Proved);
    CHECK(worst[0].slack < 1e-3);
  }
}

TEST_CASE("A limit that is proved to hold bounds the worst part", "[variation]") {
  // Of the contact force of several load cases no extreme is enclosed, but that it is above 0.
  const ProblemStatement design =
      read_problem_file(testing::source("problems/cams/load_cases.toml"));
  VariationStatement radius;
  radius.parameter = find_parameter(design, "base_radius");
  radius.plus = radius.minus = 0.05;
  int proved = 0;
  for (const WorstPart& worst : worst_parts(varied_design(design, {radius}))) {
    INFO(worst.name);
    if (worst.holds != Holds::Proved) continue;
    ++proved;
    CHECK(worst.slack <= std::max(worst.margin + worst.tolerance, 0.0));
  }
  CHECK(proved >= 5);
}

}  // namespace camlaw::problems::variation_test
