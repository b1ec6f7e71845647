// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <ctime>

#include "machines/model/highest_in_box.h"
#include "optim/cycle/extremes.h"
#include "optim/cycle/scales.h"
#include "optim/search/optimise.h"
#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"
#include "problems/statement/ranges.h"
#include "tests/problems/complaint.h"
#include "tests/random_numbers.h"

// Limits over ranges of parameters, against many evaluations of the file with single values.
namespace camlaw::problems::parameter_ranges_test {

using Catch::Contains;

namespace {

std::string cam(const std::string& constants, const std::string& more = "") {
  return R"(
mechanism = "disc-cam-roller"
[constants]
stroke = "25 mm"
mass = "1.5 kg"
spring_rate = "8 N/mm"
base_radius = "40 mm"
spring_preload = "120 N"
)" + constants +
         R"(
[program]
segments = [{name = "rise", angle = 90, law = "modified-sine"}, {name = "high", angle = 70},
            {name = "back", angle = 110, law = "cycloidal"}, {name = "low"}]
)" + more;
}

ProblemStatement read(const std::string& text) { return read_problem(text, "f.toml"); }

double value_of_peak(const ProblemStatement& problem, const std::string& curve, bool highest) {
  for (const auto& r : evaluate(problem)) {
    if (r.name == curve) return highest ? r.highest : r.lowest;
  }
  FAIL("no response " + curve);
  return 0;
}

const std::string kSpeeds = "[ranges.speed]\nlower = '100 rpm'\nupper = '400 rpm'\n";

}  // namespace

TEST_CASE("The least force over a range of speeds is that of the greatest speed") {
  const ProblemStatement ranged =
      read(cam(kSpeeds,
               "[[constraints]]\nresponse = 'follower_force'\nlower = '0 N'\n"
               "[[constraints]]\nresponse = 'inertia_fraction'\nupper = 2\n"));
  const ProblemStatement fast = read(cam("speed = '400 rpm'\n"));
  const auto limits = standing(ranged);
  REQUIRE(limits.size() == 2);
  CHECK(limits[0].proved);
  CHECK(limits[0].value == Approx(value_of_peak(fast, "follower_force", false)).epsilon(1e-9));
  CHECK(limits[1].value == Approx(value_of_peak(fast, "inertia_fraction", true)).epsilon(1e-9));
  CHECK(words_of(worst_in_ranges(ranged, ranged.constraints[1].response, limits[1].worst_angle)) ==
        "speed = 400 rpm");
  // The least force is that of a dwell here, where the speed does not matter.
  CHECK(worst_in_ranges(ranged, ranged.constraints[0].response, limits[0].worst_angle).empty());
}

TEST_CASE("Limits from both sides are looked at each over the whole range") {
  const ProblemStatement ranged =
      read(cam(kSpeeds + "[ranges.load]\nlower = '0 N'\nupper = '150 N'\n",
               "[[constraints]]\nresponse = 'contact_force'\nlower = '-200 N'\nupper = '900 N'\n"));
  const auto limits = standing(ranged);
  REQUIRE(limits.size() == 2);
  double highest = -1e9, lowest = 1e9;
  for (const char* speed : {"100", "160", "230", "300", "400"}) {
    for (const char* load : {"0", "70", "150"}) {
      const ProblemStatement one =
          read(cam(std::string("speed = '") + speed + " rpm'\nload = '" + load + " N'\n"));
      highest = std::max(highest, value_of_peak(one, "contact_force", true));
      lowest = std::min(lowest, value_of_peak(one, "contact_force", false));
    }
  }
  CHECK(limits[0].value == Approx(highest).epsilon(1e-9));
  CHECK(limits[1].value == Approx(lowest).epsilon(1e-9));
  CHECK(limits[0].proved);
  CHECK(limits[1].proved);
}

TEST_CASE("A force in a dwell, which a range does not change, is proved soon") {
  const ProblemStatement ranged =
      read(cam("speed = '300 rpm'\n[ranges.roller_radius]\nlower = '5 mm'\nupper = '20 mm'\n",
               "[[constraints]]\nresponse = 'contact_force'\nlower = '119.988 N'\n"
               "upper = '400 N'\n"));
  std::vector<optim::LimitReport> limits;
  const std::clock_t begin = std::clock();
  limits = standing(ranged);
  CHECK(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC < 5);  // 0.3 s
  REQUIRE(limits.size() == 2);
  for (const auto& one : limits) {
    INFO(one.value);
    CHECK(one.met);
    CHECK(one.proved);
  }
}

TEST_CASE("A worst value inside the range is found and proved there") {
  // f = a v - v^2 at the place v of the law: the worst a lies at an end, the worst b at b = v.
  const std::string machine =
      "[machine]\nmoved_by = 'law'\n"
      "[machine.parameters.b]\ndefault = 1\nlower = -5\nupper = 5\n"
      "[machine.parameters.c]\ndefault = 2\nlower = 0\nupper = 9\n"
      "[responses.f]\nformula = 'c - (b - 1.3)^2 + 0.1 * v * b'\n"
      "[responses.g]\nformula = 'c - (b - 1.3)^2'\n";
  const ProblemStatement problem = read(
      machine +
      "[law]\nname = 'cosine'\n[ranges.b]\nlower = -1\nupper = 4\n"
      "[[constraints]]\nresponse = 'f'\nupper = 5\n[[constraints]]\nresponse = 'g'\nupper = 5\n"
      "lower = -20\n");
  const auto limits = standing(problem);
  REQUIRE(limits.size() == 3);
  const double v = std::acos(-1.0) / 2;  // at the middle of the rise
  const double b = 1.3 + 0.05 * v;
  CHECK(limits[0].value == Approx(2 - (b - 1.3) * (b - 1.3) + 0.1 * v * b).epsilon(1e-10));
  CHECK(limits[0].proved);
  const auto worst =
      worst_in_ranges(problem, problem.constraints[0].response, limits[0].worst_angle);
  CHECK_THAT(words_of(worst), Contains("b = 1.37"));
  CHECK(limits[1].value == Approx(2).epsilon(1e-10));
  CHECK(limits[1].proved);
  CHECK(limits[2].value == Approx(2 - 2.7 * 2.7).epsilon(1e-10));
  CHECK(limits[2].proved);
}

TEST_CASE("A design for a range of speeds is certified, and holds at each speed") {
  const std::string asked =
      "[variables.spring_preload]\nlower = '0 N'\nupper = '900 N'\n"
      "[variables.spring_rate]\nlower = '2 N/mm'\nupper = '30 N/mm'\n"
      "[objective]\nminimize = 'peak contact_force'\n"
      "[[constraints]]\nresponse = 'follower_force'\nlower = '5 N'\n";
  std::string text = cam(kSpeeds, asked);
  for (const std::string line : {"spring_preload = \"120 N\"\n", "spring_rate = \"8 N/mm\"\n"}) {
    text.erase(text.find(line), line.size());
  }
  const BoundProblem bound(read(text));
  const auto found = optim::optimise(bound.space(), {});
  INFO(found.found.assessment.reason);
  REQUIRE(found.found.assessment.verdict == optim::Verdict::Certified);
  const ProblemStatement design = bound.at(found.options, found.found.x);
  double highest = 0, lowest = 1e9;
  for (int speed = 100; speed <= 400; speed += 15) {
    ProblemStatement one = read(cam("speed = '" + std::to_string(speed) + " rpm'\n"));
    set_value(one, fmt::format("spring_preload={:.17g}", constant_of(design, "spring_preload")));
    set_value(one, fmt::format("spring_rate={:.17g}", constant_of(design, "spring_rate")));
    highest = std::max(highest, value_of_peak(one, "contact_force", true));
    lowest = std::min(lowest, value_of_peak(one, "follower_force", false));
  }
  CHECK(lowest >= 5 - 1e-4);
  CHECK(found.found.assessment.objective.value >= highest - 1e-6);
  CHECK(found.found.assessment.objective.value == Approx(highest).epsilon(1e-6));
}

TEST_CASE("The derivatives of a highest value are those at its worst place") {
  const std::string machine =
      "[machine]\n[machine.parameters.b]\ndefault = 1\nlower = -5\nupper = 5\n"
      "[machine.parameters.c]\ndefault = 2\nlower = 0\nupper = 9\n"
      "[responses.g]\nformula = 'c^2 - (b - 0.5 * c)^2 + 0.3 * b'\n"
      "[variables.c]\nlower = 0\nupper = 9\nstart = 2\n[ranges.b]\nlower = -1\nupper = 4\n"
      "[objective]\nminimize = 'g'\n";
  const optim::Problem problem = BoundProblem(read(machine)).problem({});
  const optim::Function& f = problem.objectives.front().response.function();
  const auto closed = [](double c) {  // the worst b is c / 2 + 0.15, up to 4
    const double b = std::min(4.0, 0.5 * c + 0.15);
    return c * c - (b - 0.5 * c) * (b - 0.5 * c) + 0.3 * b;
  };
  for (const double c : {0.5, 2.0, 5.0, 7.0, 8.5}) {
    const std::vector<double> x{c};
    std::vector<double> g(1), h(1);
    CHECK(f.hessian(x, g, h) == Approx(closed(c)).epsilon(1e-12));
    const double d = 1e-5;
    CHECK(g[0] == Approx((closed(c + d) - closed(c - d)) / (2 * d)).epsilon(1e-7));
    CHECK(h[0] ==
          Approx((closed(c + 1e-3) - 2 * closed(c) + closed(c - 1e-3)) / 1e-6).epsilon(1e-6));
    const optim::Bounds bounds = f.enclose(x);
    CHECK(bounds.lower <= closed(c) + 1e-12);
    CHECK(bounds.upper >= closed(c) - 1e-12);
    CHECK(bounds.upper - bounds.lower < 1e-5);
  }
}

TEST_CASE("Bounds over a box hold the highest value and close on it") {
  const auto f = [](double a, double b) { return std::sin(3 * a) * std::cos(b) - 0.1 * a * a; };
  const Box box{{-1, 1}, {-2, 0.5}};
  double highest = -10;
  for (int i = 0; i <= 400; ++i) {
    for (int k = 0; k <= 400; ++k) {
      highest = std::max(highest, f(-1 + 2.0 * i / 400, -2 + 2.5 * k / 400));
    }
  }
  const auto over = [&](const Box& b) {
    const Interval p(b[0].lower, b[0].upper), q(b[1].lower, b[1].upper);
    const Interval value = sin(Interval(3.0) * p) * cos(q) - Interval(0.1) * p * p;
    const Interval by_p = Interval(3.0) * cos(Interval(3.0) * p) * cos(q) - Interval(0.2) * p;
    const Interval by_q = -sin(Interval(3.0) * p) * sin(q);
    return OverBox{{value.lower(), value.upper()},
                   {{by_p.lower(), by_p.upper()}, {by_q.lower(), by_q.upper()}}};
  };
  const auto at = [&](const Point& p) {
    const double value = f(p[0], p[1]);
    return optim::Bounds{value - 1e-14, value + 1e-14};
  };
  const optim::Bounds bounds = highest_within(box, {30, 100000}, at, over).value;
  CHECK(bounds.lower <= highest + 1e-4);
  CHECK(bounds.upper >= highest);
  CHECK(bounds.upper - bounds.lower < 1e-6);
}

TEST_CASE(
    "A place of a range without a value is found, however narrow, and no limit is met there") {
  // Not a number within 0.32 rpm of 333.3 rpm, where the follower is low: a curve, and its peak.
  const std::string beside =
      "[responses.beside]\nunit = '1'\nformula = 'sqrt((speed / (1 rpm) - 333.3)^2 + displacement "
      "/ "
      "(10 mm) - 0.1)'\n";
  for (const char* const limit : {"upper = 1000", "lower = 0"}) {
    INFO(limit);
    const ProblemStatement ranged =
        read(cam(kSpeeds, beside + "[[constraints]]\nresponse = 'beside'\n" + limit + "\n"));
    const auto limits = standing(ranged);
    REQUIRE(limits.size() == 1);
    CHECK(std::isnan(limits[0].value));
    CHECK_FALSE(limits[0].met);
    REQUIRE(limits[0].worst_angle.has_value());
    const double angle = *limits[0].worst_angle;
    CHECK((angle < 40 || angle > 230));
    const std::vector<PlaceInRange> worst =
        worst_in_ranges(ranged, ranged.constraints[0].response, limits[0].worst_angle);
    REQUIRE(worst.size() == 1);
    CHECK(std::abs(worst[0].value - 333.3) < 0.32);
  }
}

TEST_CASE("Of a number the place of a range without a value is found too") {
  // Beside it, a root of which the range touches no such place is proved.
  for (const double beside : {333.3, 40.0}) {
    INFO(beside);
    const ProblemStatement ranged = read(cam(
        kSpeeds, fmt::format("[responses.beside]\nunit = '1'\nformula = 'sqrt((speed / (1 rpm) - "
                             "{})^2 - 0.1)'\n[[constraints]]\nresponse = 'beside'\nupper = 1000\n",
                             beside)));
    const auto limits = standing(ranged);
    REQUIRE(limits.size() == 1);
    const bool has_gap = beside > 100;
    CHECK(std::isnan(limits[0].value) == has_gap);
    CHECK(limits[0].met == !has_gap);
    CHECK(limits[0].proved == !has_gap);
  }
}

TEST_CASE("From a place of a range the path uphill ends at a top, whatever waves lie beyond") {
  const optim::Bounds range{1, 5};
  for (const double w : {0.3, 2.0, 9.0, 31.0, 83.0}) {
    const auto wave = [&](double x) {
      return Rise{std::sin(w * x) - 0.02 * x, w * std::cos(w * x) - 0.02};
    };
    double best = 1;
    for (int i = 0; i <= 8; ++i) {
      const double place = 1 + 0.5 * i;
      if (wave(place).value > wave(best).value) best = place;
    }
    INFO("w " << w << " from " << best);
    const Rise here = wave(best);
    const bool is_end = (best == 5 && here.slope > 0) || (best == 1 && here.slope < 0);
    CHECK(is_top({best}, {range}, {here.slope}) == is_end);
    if (is_end) continue;
    const auto top = top_along(best, here, range, wave);
    REQUIRE(top);
    CHECK(wave(*top).value >= here.value);
    CHECK(std::abs(wave(*top).slope) <= 1e-9 * w);
    CHECK(-w * w * std::sin(w * *top) < 0);  // bent downwards
    CHECK(std::abs(*top - best) <= 0.5);
  }
}

TEST_CASE("The largest size of a curve over a range counts both signs") {
  // p + b v with b from -3 to 1 and v up to pi / 2: the size is least where p is as far from 0.
  const std::string machine =
      "[machine]\nmoved_by = 'law'\n[machine.parameters.b]\ndefault = 0\nlower = -5\nupper = 5\n"
      "[machine.parameters.p]\ndefault = 0\nlower = -9\nupper = 9\n"
      "[responses.f]\nformula = 'p + b * v'\n"
      "[law]\nname = 'cosine'\n[ranges.b]\nlower = -3\nupper = 1\n"
      "[variables.p]\nlower = -9\nupper = 9\nstart = 5\n[objective]\nminimize = 'peak f'\n";
  const auto found = optim::optimise(BoundProblem(read(machine)).space(), {});
  const double v = std::acos(-1.0) / 2;
  INFO(found.found.assessment.reason);
  CHECK(found.found.assessment.verdict == optim::Verdict::Certified);
  CHECK(found.found.x[0] == Approx(v).epsilon(1e-8));  // p + v = 3 v - p
  CHECK(found.found.assessment.objective.value == Approx(2 * v).epsilon(1e-8));
}

TEST_CASE("Load cases within ranges are looked at over the ranges in each case") {
  const std::string limits =
      "[[constraints]]\nresponse = 'follower_force'\nlower = '0 N'\n[objective]\nminimize = "
      "'peak contact_force'\n[variables.roller_radius]\nlower = '8 mm'\nupper = '12 mm'\n";
  const ProblemStatement problem = read(
      cam(kSpeeds + "[[cases]]\nname = 'light'\nload = '10 N'\n[[cases]]\nname = 'heavy'\nload = "
                    "'90 N'\n",
          limits));
  REQUIRE(problem.constraints.size() >= 2);
  CHECK(problem.constraints[0].response.name == "light.follower_force");
  const auto stand = standing(problem);
  const ProblemStatement a = read(cam("speed = '400 rpm'\nload = '10 N'\n"));
  CHECK(stand[0].value == Approx(value_of_peak(a, "follower_force", false)).epsilon(1e-9));
  CHECK(stand[0].proved);
  const ProblemStatement b = read(cam("speed = '400 rpm'\nload = '90 N'\n"));
  const optim::Problem bound = BoundProblem(problem).problem({});
  const std::vector<double> x{constant_of(problem, "roller_radius")};
  CHECK(optim::objective_value(bound.objective(), x) ==
        Approx(value_of_peak(b, "contact_force", true)).epsilon(1e-9));
}

TEST_CASE("The ends of a range are set beside the file") {
  ProblemStatement problem =
      read(cam(kSpeeds, "[[constraints]]\nresponse = 'inertia_fraction'\nupper = 2\n"));
  set_value(problem, "speed.upper=300 rpm");
  const ProblemStatement fast = read(cam("speed = '300 rpm'\n"));
  CHECK(standing(problem)[0].value ==
        Approx(value_of_peak(fast, "inertia_fraction", true)).epsilon(1e-9));
  CHECK_THROWS_WITH(set_value(problem, "speed=100 rpm"), Contains("speed.upper"));
  CHECK_THROWS_WITH(set_value(problem, "speed.upper=50 rpm"), Contains("below upper"));
}

TEST_CASE("A range that reaches a pole leaves no highest value") {
  const std::string machine =
      "[machine]\n[machine.parameters.p]\ndefault = 1\nlower = -9\nupper = 9\n"
      "[machine.parameters.q]\ndefault = 4\nlower = -9\nupper = 9\n"
      "[responses.f]\nformula = '1 / (p - q)^2 + 0.01 * q'\n[ranges.p]\nlower = 0\nupper = 3\n"
      "[variables.q]\nlower = 0.5\nupper = 6\nstart = 1.3\n[objective]\nminimize = 'f'\n";
  const optim::Problem problem = BoundProblem(read(machine)).problem({});
  const optim::Function& f = problem.objectives.front().response.function();
  CHECK(std::isnan(f.value(std::vector<double>{1.3})));
  CHECK(f.value(std::vector<double>{4}) == Approx(1.04));
  const auto found = optim::optimise(BoundProblem(read(machine)).space(), {});
  INFO(found.found.assessment.reason);
  CHECK(found.found.x[0] == Approx(6).epsilon(1e-7));
  CHECK(found.found.assessment.objective.value == Approx(1.0 / 9 + 0.06).epsilon(1e-9));
}

TEST_CASE("The bound of a largest size over a range is set on both sides") {
  ProblemStatement problem =
      read(cam(kSpeeds, "[[constraints]]\nresponse = 'peak acceleration'\nupper = '400 m/s2'\n"));
  set_value(problem, "peak acceleration.upper=90 m/s2");
  REQUIRE(problem.constraints.size() == 2);
  CHECK(*problem.constraints[0].upper == 90);
  CHECK(*problem.constraints[1].lower == -90);
  CHECK_THROWS_WITH(set_value(problem, "peak acceleration.upper=-5"), Contains("above 0"));
}

TEST_CASE("A mean over cases within ranges is that of the largest scales") {
  const std::string cases =
      "[[cases]]\nname = 'light'\nload = '10 N'\n[[cases]]\nname = 'heavy'\nload = '90 N'\n"
      "weight = 3\n";
  const ProblemStatement problem =
      read(cam(kSpeeds + cases,
               "[objective]\nminimize = 'peak contact_force'\ncases = 'mean'\n"
               "[variables.roller_radius]\nlower = '8 mm'\nupper = '12 mm'\n"));
  const optim::Problem bound = BoundProblem(problem).problem({});
  const std::vector<double> x{constant_of(problem, "roller_radius")};
  const ProblemStatement light = read(cam("speed = '400 rpm'\nload = '10 N'\n"));
  const ProblemStatement heavy = read(cam("speed = '400 rpm'\nload = '90 N'\n"));
  const double expected = (value_of_peak(light, "contact_force", true) +
                           3 * value_of_peak(heavy, "contact_force", true)) /
                          4;
  CHECK(optim::objective_value(bound.objective(), x) == Approx(expected).epsilon(1e-9));
}

TEST_CASE("The worst of cases within ranges is certified") {
  const std::string machine =
      "[machine]\nmoved_by = 'law'\n[machine.parameters.p]\ndefault = 1\n"
      "[machine.parameters.c]\ndefault = 1\n[machine.parameters.q]\ndefault = 1\n"
      "[responses.f]\nformula = 'p * c * s + (q - 1)^2'\n[law]\nname = 'polynomial-5'\n"
      "[ranges.p]\nlower = 1\nupper = 2\n[[cases]]\nname = 'light'\nc = 1\n[[cases]]\nname = "
      "'heavy'\nc = 3\n[variables.q]\nlower = -2\nupper = 4\nstart = 3\n"
      "[objective]\nminimize = 'highest f'\n";
  const auto found = optim::optimise(BoundProblem(read(machine)).space(), {});
  INFO(found.found.assessment.reason);
  CHECK(found.found.assessment.verdict == optim::Verdict::Certified);
  CHECK(found.found.assessment.objective.value == Approx(6).epsilon(1e-9));
}

TEST_CASE("What is proved over ranges never contradicts points drawn inside them") {
  struct Ranged {
    const char *name, *unit;
    double least, most, widest;  ///< from where to where it begins, and how wide it is at most
  };
  const Ranged parameters[] = {{"speed", "rpm", 60, 350, 250},
                               {"load", "N", 0, 150, 200},
                               {"mass", "kg", 0.5, 2, 1.5},
                               {"base_radius", "mm", 32, 60, 6},
                               {"spring_preload", "N", 60, 300, 150}};
  const auto text = [](const std::string& constants, const std::string& more) {
    return "mechanism = 'disc-cam-roller'\n[constants]\nstroke = '25 mm'\nspring_rate = '8 "
           "N/mm'\n" +
           constants +
           "[program]\nsegments = [{name = 'rise', angle = 90, law = 'modified-sine'}, {name = "
           "'high', angle = 70}, {name = 'back', angle = 110, law = 'cycloidal'}, {name = "
           "'low'}]\n" +
           more;
  };
  camlaw::testing::Random random(26);
  int proved = 0, broken = 0;
  for (int trial = 0; trial < 6; ++trial) {
    const std::string limits = fmt::format(
        "[[constraints]]\nresponse = 'follower_force'\nlower = '{} N'\n"
        "[[constraints]]\nresponse = 'contact_stress'\nupper = '{} MPa'\n"
        "[[constraints]]\nresponse = 'pressure_angle'\nupper = '{} deg'\n"
        "[[constraints]]\nresponse = 'drive_torque'\nlower = '{} N m'\n",
        random(-100, 200), random(300, 900), random(22, 36), random(-15, -1));
    const std::size_t first = static_cast<std::size_t>(trial) % 5, second = (first + 2) % 5;
    std::string constants, ranges;
    std::vector<std::pair<double, double>> ends;
    for (std::size_t i = 0; i < 5; ++i) {
      const Ranged& p = parameters[i];
      const double low = random(p.least, p.most), high = low + random(0.2, 1) * p.widest;
      ends.emplace_back(low, high);
      if (i == first || i == second) {
        ranges += fmt::format("[ranges.{}]\nlower = '{} {}'\nupper = '{} {}'\n", p.name, low,
                              p.unit, high, p.unit);
      } else {
        constants += fmt::format("{} = '{} {}'\n", p.name, low, p.unit);
      }
    }
    const auto at = [&](double one, double other) {
      return standing(
          read(text(constants + fmt::format("{} = {:.17g}\n{} = {:.17g}\n", parameters[first].name,
                                            one, parameters[second].name, other),
                    limits)));
    };
    const ProblemStatement ranged = read(text(constants, limits + ranges));
    const auto over = standing(ranged);
    REQUIRE(over.size() >= 4);  // a stress brings a limit on the force that it needs
    // Where a limit is said to be at its worst it has that value.
    for (std::size_t i = 0; i < over.size(); ++i) {
      proved += over[i].proved && over[i].met;
      if (over[i].met || !std::isfinite(over[i].value)) continue;
      ++broken;
      double one = ends[first].first, other = ends[second].first;
      for (const PlaceInRange& place :
           worst_in_ranges(ranged, ranged.constraints[i].response, over[i].worst_angle)) {
        if (place.parameter == parameters[first].name) one = place.value;
        if (place.parameter == parameters[second].name) other = place.value;
      }
      const auto there = at(one, other);
      INFO("trial " << trial << ", " << over[i].name << " at " << one << ", " << other);
      CHECK_FALSE(there[i].met);
      CHECK(there[i].value == Approx(over[i].value).epsilon(1e-6));
    }
    for (int point = 0; point < 24; ++point) {
      const auto inside = [&](std::size_t i) {
        const auto [low, high] = ends[i];
        return point < 4 ? ((point >> (i == first)) % 2 == 0 ? low : high) : random(low, high);
      };
      const double one = inside(first), other = inside(second);
      const auto drawn = at(one, other);
      REQUIRE(drawn.size() == over.size());
      for (std::size_t i = 0; i < over.size(); ++i) {
        if (!std::isfinite(over[i].value)) continue;
        INFO("trial " << trial << ", " << over[i].name << " at " << one << ", " << other << ": "
                      << drawn[i].value << ", over the ranges " << over[i].value);
        const double off = 1e-7 * (1 + std::abs(over[i].value));
        CHECK(drawn[i].margin >= over[i].margin - off);
        if (over[i].proved && over[i].met) CHECK(drawn[i].met);
      }
    }
  }
  CHECK(proved > 3);
  CHECK(broken > 3);
}

TEST_CASE("What cannot be a range is refused by name") {
  const auto complaint = [](const std::string& more) {
    return camlaw::testing::complaint(cam(more));
  };
  CHECK_THAT(complaint("[ranges.speed]\nlower = '100 rpm'\n"), Contains("upper is missing"));
  CHECK_THAT(complaint("[ranges.speed]\nlower = '400 rpm'\nupper = '100 rpm'\n"),
             Contains("not below"));
  CHECK_THAT(complaint("[ranges.speeed]\nlower = '1 rpm'\nupper = '2 rpm'\n"), Contains("speed"));
  CHECK_THAT(complaint("[ranges.speed]\nlower = '-1 rpm'\nupper = '2 rpm'\n"), Contains("speed"));
  CHECK_THAT(
      complaint("[[cases]]\nname = 'light'\nspeed = 1\n[ranges.speed]\nlower = 1\nupper = 2\n"),
      Contains("load cases set speed"));
}

TEST_CASE("A limit over ranges that is not proved is not said to be one over parts") {
  const ProblemStatement problem =
      read(cam(kSpeeds,
               "[variables.roller_radius]\nlower = '6 mm'\nupper = '12 mm'\n"
               "[objective]\nminimize = 'roller_radius'\n"
               "[[constraints]]\nresponse = 'torque_rms'\nupper = '500 N m'\n"));
  const auto found = optim::optimise(BoundProblem(problem).space()).found.assessment;
  CHECK(found.verdict == optim::Verdict::Feasible);
  CHECK_THAT(found.reason, Contains("torque_rms is met, but not proved") &&
                               Contains("an estimate") && !Contains("parts"));
}

}  // namespace camlaw::problems::parameter_ranges_test
