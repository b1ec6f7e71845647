// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <set>

#include "kinematics/laws/catalogue.h"
#include "kinematics/peaks.h"
#include "optim/search/optimise.h"
#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"
#include "problems/statement/statement.h"
#include "tests/paths.h"
#include "tests/problems/complaint.h"

/// Motion programs in millimetres, degrees and metres per second.
namespace camlaw::problems::physical_program_test {

using Catch::Contains, testing::complaint;

namespace {

ProblemStatement read(const std::string& segments, const std::string& program = "",
                      const std::string& rest = "", const char* machine = "disc-cam-roller") {
  return read_problem(fmt::format("mechanism = '{}'\n[program]\n{}segments = [{}]\n{}", machine,
                                  program, segments, rest),
                      "f.toml");
}
std::string refusal(const std::string& segments, const std::string& program = "",
                    const std::string& rest = "", const char* machine = "disc-cam-roller") {
  return complaint([&] { read(segments, program, rest, machine); });
}

EvaluatedResponse response(const ProblemStatement& problem, const std::string& name) {
  for (const EvaluatedResponse& r : evaluate(problem)) {
    if (r.name == name) return r;
  }
  throw std::invalid_argument(name);
}

void check_same(const ProblemStatement& a, const ProblemStatement& b) {
  const Law<double> one = a.laws.front().law(), other = b.laws.front().law();
  for (int i = 0; i <= 72; ++i) {
    INFO(i * 5 << " deg");
    CHECK(one(i / 72.0).s == Approx(other(i / 72.0).s).margin(1e-13));
    CHECK(one(i / 72.0).a == Approx(other(i / 72.0).a).margin(1e-9));
  }
}

}  // namespace

TEST_CASE("a modified sine over 120 ms and 20 mm peaks at 0.2933 m/s", "[physical_program]") {
  const ProblemStatement problem = read(
      "{name = 'rise', time = '120 ms', to = '20 mm', law = 'modified sine'}, "
      "{name = 'back', to = 0, law = 'Bestehorn'}",
      "cycle_time = '0.4 s'\n");
  CHECK(constant_of(problem, "stroke") == Approx(20).epsilon(1e-14));
  CHECK(response(problem, "velocity").highest == Approx(0.2933).margin(5e-5));
}

TEST_CASE("lengths, rates and times become those of the normalised motion", "[physical_program]") {
  // 0.3 m/s at a turn of 0.36 s and a stroke of 22 mm, and so on.
  const double velocity = 0.3 * 0.36 / 0.022, acceleration = -12 * 0.36 * 0.36 / 0.022;
  const double slope = -0.1 * 360 / 22, bend = 0.002 * 360 * 360 / 22;
  const ProblemStatement physical = read(
      "{name = 'a', time = '120 ms', to = '22 mm', velocity = '0.3 m/s', acceleration = "
      "'-12 m/s^2', points = [{time = '40 ms', to = '6 mm'}, {angle = '80 deg', by = '1 cm', "
      "velocity = '250 mm/s'}]}, "
      "{name = 'b', angle = 60, by = '-0.5 cm', velocity = '-0.1 mm/deg', acceleration = "
      "'0.002 mm/deg^2'}, {name = 'c', to = '0 mm', law = 'joining'}",
      "cycle_time = '360 ms'\n");
  const ProblemStatement normalised = read(fmt::format(
      "{{name = 'a', angle = 120, to = 1, velocity = {}, acceleration = {}, points = [{{angle = "
      "40, to = {}}}, {{angle = 80, to = {}, velocity = {}}}]}}, {{name = 'b', angle = 60, to = "
      "{}, velocity = {}, acceleration = {}}}, {{name = 'c', to = 0, law = 'joining'}}",
      velocity, acceleration, 6.0 / 22, 16.0 / 22, 0.25 * 0.36 / 0.022, 17.0 / 22, slope, bend));
  check_same(physical, normalised);
}

TEST_CASE("an arm's motion is stated in degrees", "[physical_program]") {
  const ProblemStatement problem = read(
      "{name = 'a', angle = 120, to = '25 deg', velocity = '0.2 deg/deg', points = [{angle = "
      "60, to = '10 deg'}]}, {name = 'b', to = '0 deg', law = 'joining'}",
      "", "", "disc-cam-oscillating-roller");
  CHECK(constant_of(problem, "swing") == Approx(25).epsilon(1e-14));
  CHECK(problem.laws.front().law().derivatives<2>(1 / 3.0)[1] ==
        Approx(0.2 * 360 / 25).epsilon(1e-12));
  const ProblemStatement timed = read(
      "{name = 'a', angle = 120, to = '25 deg', velocity = '30 deg/s'}, {name = 'b', to = "
      "'0 deg', law = 'joining'}",
      "cycle_time = '0.5 s'\n", "", "disc-cam-oscillating-roller");
  CHECK(timed.laws.front().law().derivatives<2>(1 / 3.0)[1] ==
        Approx(30 * 0.5 / 25).epsilon(1e-12));
}

TEST_CASE("the stroke that is stated is what displacements are parts of", "[physical_program]") {
  const char* segments =
      "{name = 'a', angle = 120, to = '10 mm', law = 'MS'}, {name = 'b', to = "
      "'0 mm', law = 'MT'}";
  CHECK(read(segments, "", "[constants]\nstroke = '20 mm'\n").laws.front().law()(1 / 3.0).s ==
        Approx(0.5).epsilon(1e-14));
  CHECK_THAT(refusal(segments, "", "[variables.stroke]\nlower = 10\nupper = 30\n"),
             Contains("program.segments[1].to: stroke varies; write a plain number, in strokes"));
  CHECK_THAT(refusal("{name = 'a', angle = 120, to = '10 mm', law = 'MS'}, {name = 'c', angle = "
                     "60, to = 0.2, law = 'MS'}, {name = 'b', to = 0, law = 'MT'}"),
             Contains("give this one a unit"));
  CHECK_THAT(refusal("{name = 'a', angle = 120, to = '10 kg', law = 'MS'}, {name = 'b', to = 0, "
                     "law = 'MT'}"),
             Contains("'10 kg' is a mass"));
  CHECK_THAT(refusal("{name = 'a', angle = 120, to = '10 mm', velocity = '3 kg'}, {name = 'b', to "
                     "= 0, law = 'joining'}"),
             Contains("'3 kg' is not a velocity; write \"0.3 mm/s\", \"0.3 mm/deg\""));
  // Angles are plain numbers to the unit library; how often they are there is looked at.
  for (const char* wrong : {"velocity = '3 mm'", "velocity = '3 mm/deg^2'",
                            "acceleration = '3 mm/deg'", "acceleration = '3 mm/s'"}) {
    INFO(wrong);
    CHECK_THAT(refusal("{name = 'a', angle = 120, to = '10 mm', " + std::string(wrong) +
                           "}, {name = 'b', to = 0, law = 'joining'}",
                       "cycle_time = '1 s'\n"),
               Contains("is not a") && Contains("; write "));
  }
  const auto speed = [](const char* velocity) {
    return read("{name = 'a', angle = 120, to = '10 mm', velocity = '" + std::string(velocity) +
                "'}, {name = 'b', to = 0, law = 'joining'}")
        .laws.front()
        .law()
        .derivatives<2>(1 / 3.0)[1];
  };
  CHECK(speed("0.05 mm/deg") == Approx(0.05 * 36).epsilon(1e-12));
  CHECK(speed("0.005 cm/degree") == Approx(0.05 * 36).epsilon(1e-12));
  CHECK(speed("2 mm/rad") == Approx(2 * 2 * std::numbers::pi / 10).epsilon(1e-12));
  CHECK_THAT(refusal("{name = 'a', angle = 120, to = '10 mm', velocity = '0.3 m/s'}, {name = 'b', "
                     "to = 0, law = 'joining'}"),
             Contains("the program has times, which need the time of a turn"));
}

TEST_CASE("the highest displacement is found along the whole program", "[physical_program]") {
  const ProblemStatement chain = read(
      "{name = 'a', angle = 150, to = '10 mm', law = 'joining', points = [{angle = 30, by = '5 "
      "mm'}, {angle = 60, by = '5 mm'}, {angle = 90, by = '5 mm'}]}, {name = 'b', by = '-10 "
      "mm', law = 'joining'}");
  CHECK(constant_of(chain, "stroke") == Approx(15).epsilon(1e-14));
  const ProblemStatement back = read(
      "{name = 'a', angle = 100, to = '22 mm', law = 'MS'}, {name = 'b', angle = 100, law = "
      "'MS'}, {name = 'c', angle = 80, by = '10 mm', law = 'MS'}, {name = 'd', law = 'MS'}");
  CHECK(constant_of(back, "stroke") == Approx(22).epsilon(1e-14));
  CHECK(back.laws.front().law()(280.0 / 360).s == Approx(10.0 / 22).epsilon(1e-12));
  // Steps that add up to nothing but rounding.
  CHECK(
      refusal("{name = 'a', angle = 100, by = '0.1 mm', law = 'MS'}, {name = 'b', angle = 100, by "
              "= '0.7 mm', law = 'MS'}, {name = 'c', angle = 80, by = '-0.8 mm', law = 'MS'}, "
              "{name = 'low'}") == "accepted");
  ProblemStatement set = back;
  CHECK_THAT(complaint([&] { set_value(set, "stroke=44 mm"); }),
             Contains("stroke: the motion is stated in mm; change it in the file"));
}

TEST_CASE("a tolerance of a point is a variable, and none of zero width", "[physical_program]") {
  const auto with = [](const std::string& tolerance) {
    return read(
        "{name = 'a', angle = 140, to = '20 mm', law = 'joining', points = [{angle = 50, "
        "to = '6 mm'" +
            tolerance +
            "}]}, {name = 'b', angle = 40}, {name = 'c', angle = "
            "120, to = 0, law = 'joining'}, {name = 'd'}",
        "", "[objective]\nminimize = 'peak acceleration'\n");
  };
  const ProblemStatement exact = with(""), zero = with(", tolerance = '0 mm'"),
                         slack = with(", tolerance = '0.2 mm'");
  CHECK(zero.variables.empty());
  check_same(exact, zero);
  REQUIRE(slack.variables.size() == 1);
  CHECK(slack.variables[0].name == "a_points[1]");
  CHECK(slack.variables[0].lower == Approx(5.8 / 20).epsilon(1e-13));
  CHECK(slack.variables[0].upper == Approx(6.2 / 20).epsilon(1e-13));
  CHECK_THAT(complaint([&] { with(", tolerance = '-1 mm'"); }), Contains("must not be below 0"));
  CHECK_THAT(
      refusal("{name = 'a', angle = 140, to = '20 mm', law = 'MS'}, {name = 'h', angle = 20, "
              "tolerance = '1 mm'}, {name = 'c', to = 0, law = 'joining'}"),
      Contains("a dwell stays where the segment before it ends"));
  CHECK_THAT(refusal("{name = 'a', angle = 140, to = '20 mm', law = 'MS'}, {name = 'c', to = 0, "
                     "tolerance = '1 mm', law = 'joining'}"),
             Contains("its end has no tolerance"));
}

TEST_CASE("a free segment has ends of its own", "[physical_program]") {
  const ProblemStatement problem = read(
      "{name = 'a', angle = 180, law = 'free', end = 'U'}, {name = 'b', law = 'free', begin = "
      "'U'}",
      "matched = 'velocity'\n");
  const Law<double> law = problem.laws.front().law();
  CHECK(std::abs(law.derivatives<3>(0.5, Side::Left)[2]) > 1);
  CHECK(law.derivatives<3>(0.0)[2] == Approx(0).margin(1e-10));
  // A free segment that comes out of a constant velocity.
  const ProblemStatement joins = read(
      "{name = 'low', angle = 60}, {name = 'up', angle = 60, to = 0.2, law = 'joining'}, {name = "
      "'feed', angle = 90, to = 0.6, law = 'constant-velocity'}, {name = 'out', angle = 60, to = "
      "1, law = 'free', joining = true}, {name = 'back', to = 0, law = 'joining'}");
  CHECK(joins.laws.front().law().derivatives<3>(210.0 / 360, Side::Right)[1] ==
        Approx(0.4 * 4).epsilon(1e-10));
  CHECK(joins.laws.front().law().derivatives<3>(210.0 / 360, Side::Right)[2] ==
        Approx(0).margin(1e-8));
  CHECK_THAT(refusal("{name = 'a', angle = 180, joining = true}, {name = 'b', law = 'MS'}"),
             Contains("it is for a segment with a law"));
  CHECK_THAT(refusal("{name = 'a', angle = 180, law = 'MS', end = 'U'}, {name = 'b', law = 'MS'}"),
             Contains("it is for a segment whose law is \"free\""));
}

TEST_CASE("the film feed's crossover is where both peaks of its torque are equal",
          "[physical_program]") {
  const BoundProblem bound(read_problem_file(testing::source("problems/motions/film_feed.toml")));
  const optim::Optimum best = optim::optimise(bound.space(), {});
  // K C / (2 c) + P = K C / (2 (1 - c)) - P with K = J p / r over the feed's time squared, P = F r.
  const double time = 200.0 / 360 * 60 / 150;
  const double half = 0.004 * 0.038 / 0.03 / (time * time) * 4.888124 / 2, pull = 25 * 0.03;
  const auto surplus = [&](double c) { return half / (1 - c) - half / c - 2 * pull; };
  double low = 0.5, high = 0.999;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (surplus(middle) < 0 ? low : high) = middle;
  }
  CHECK(bound.statement().laws[best.options.front()].label().find("modified-trapezoid") !=
        std::string::npos);
  CHECK(best.found.x.front() == Approx(low).epsilon(1e-5));
  CHECK(best.found.assessment.objective.value == Approx(half / low + pull).epsilon(1e-6));
}

TEST_CASE("what belongs to other segments is refused", "[physical_program]") {
  CHECK_THAT(
      refusal("{name = 'a', angle = 180, law = ['joining', 'MS']}, {name = 'b', law = 'MS'}"),
      Contains("joining is not among laws to choose from"));
  CHECK_THAT(
      refusal("{name = 'a', angle = 180, law = 'MS', continuity = 2}, {name = 'b', law = 'MS'}"),
      Contains("the law of this one sets its continuity"));
  CHECK_THAT(refusal("{name = 'a', angle = 180, law = 'MS'}, {name = 'b', law = 'MS'}", "",
                     "[free]\nknots = 8\n"),
             Contains("free: no segment's law is free; write law = \"free\" in a segment"));
  CHECK_THAT(refusal("{name = 'a', angle = 180, law = 'MS'}, {name = 'b', law = 'MS'}", "",
                     "[ranges.a_angle]\nlower = 90\nupper = 100\n"),
             Contains("it is a parameter of the program, and only the machine's are accepted"));
}

TEST_CASE("a law that does not fit among the ones to choose from is said to be one of them",
          "[physical_program]") {
  const std::string fits = "{name = 'low', angle = 60}, {name = 'rise', angle = 120, law = ",
                    rest = "}, {name = 'back', law = 'MS'}";
  CHECK_THAT(refusal(fits + "['constant-velocity', 'MS']" + rest),
             Contains("law 'program rise=constant-velocity back=modified-sine': where 'low' meets "
                      "'rise', at 60 deg, the velocity jumps") &&
                 Contains("it is one of 2 programs that the segments' laws make") &&
                 Contains("law = \"ends R-R, continuity >= 2\""));
  // Where there is no choice, or none of it fits, the choice is not at fault.
  CHECK_THAT(refusal(fits + "'constant-velocity'" + rest), !Contains("it is one of"));
  CHECK_THAT(refusal(fits + "['constant-velocity', 'parabolic']" + rest),
             !Contains("it is one of"));
}

TEST_CASE("laws of a class that do not fit in a segment are left out by name",
          "[physical_program]") {
  const auto with = [](const std::string& rise, const std::string& back) {
    return read_problem(
        "mechanism = 'disc-cam-roller'\n[program]\nsegments = [{name = 'low', angle = 60}, {name = "
        "'rise', angle = 120, law = " +
            rise + "}, {name = 'high', angle = 60}, {name = 'back', law = " + back + "}]\n",
        "f.toml");
  };
  const auto names = [](const ProblemStatement& problem) {
    std::set<std::string> all;
    for (const LeftOut& left : problem.left_out) all.insert(left.what);
    return all;
  };
  const ProblemStatement one = with("'all'", "'MS'");
  CHECK(one.laws.size() > 20);
  REQUIRE(!one.left_out.empty());
  CHECK(names(one).contains("rise = constant-velocity"));
  for (const LeftOut& left : one.left_out) CHECK_THAT(left.why, Contains("'rise'"));
  // Each as it is where it is named alone.
  for (const Family& family : catalogue()) {
    std::string law = family.name.substr(0, family.name.find(' '));
    const bool is_left = names(one).contains("rise = " + family.name);
    INFO(family.name);
    if (is_left) CHECK_THROWS_AS(with("'" + law + "'", "'MS'"), std::invalid_argument);
  }
  CHECK_THAT(in_words(one),
             Contains("Left out because it does not fit: rise = constant-velocity: "));
  // In both segments: those that fit nowhere are told once for each.
  const ProblemStatement both = with("'all'", "'all'");
  CHECK(both.laws.size() == one.laws.size() * one.laws.size());
  CHECK(both.left_out.size() == 2 * one.left_out.size());
  CHECK(names(both).contains("back = constant-velocity"));
  // A law that is named is not left out, be it beside a class.
  CHECK_THAT(complaint([&] { with("['constant-velocity', 'ends R-R']", "'MS'"); }),
             Contains("name only laws that fit"));
  CHECK_THAT(complaint([&] { with("'all'", "'constant-velocity'"); }),
             Contains("velocity jumps") && !Contains("it is one of"));
  CHECK(with("'ends R-R, continuity >= 2'", "'MS'").left_out.empty());
  // What is set is as what is stated.
  ProblemStatement set = with("'MS'", "'MS'");
  set_value(set, "rise.law=all");
  CHECK(set.laws.size() == one.laws.size());
  CHECK(names(set) == names(one));
}

TEST_CASE("classes of laws that fit with some of the others are told as combinations",
          "[physical_program]") {
  // Laws that meet without a dwell between them: those of the same kind of end go together.
  const ProblemStatement meets = read_problem(
      "mechanism = 'disc-cam-roller'\n[program]\nsegments = [{name = 'low', angle = 60}, {name = "
      "'start', angle = 60, to = 0.3, law = 'all'}, {name = 'go', angle = 60, to = 1, law = "
      "'all'}, "
      "{name = 'high', angle = 60}, {name = 'back', law = 'MS'}]\n",
      "f.toml");
  CHECK(meets.laws.size() > 100);
  REQUIRE(!meets.left_out.empty());
}

TEST_CASE("beside the free law no law of a class shares its coefficients", "[physical_program]") {
  const std::string knots = "[free]\ndegree = 3\nknots = 8\n";
  const auto with = [](const std::string& laws, const std::string& more) {
    return read_problem(
        "mechanism = 'disc-cam-roller'\n[program]\nsegments = [{name = 'rise', angle = 150, law "
        "= " +
            laws + "}, {name = 'back', law = 'MS'}]\n" + more,
        "f.toml");
  };
  for (const char* laws : {"['free', 'all']", "['all', 'free']"}) {
    INFO(laws);
    const ProblemStatement problem = with(laws, knots);
    CHECK(problem.laws.size() == with("'all'", "").laws.size());  // one more, and one less
    CHECK(problem.variables.size() == with("'free'", knots).variables.size());
  }
  CHECK_THAT(complaint([&] { with("['free', 'b-spline']", knots); }),
             Contains("b-spline has the coefficients that the free law varies"));
  const std::string law = "mechanism = 'law'\n[law]\nname = ";
  CHECK(read_problem(law + "['free', 'all']\n", "f.toml").laws.size() ==
        read_problem(law + "'all'\n", "f.toml").laws.size());
}

TEST_CASE("a motion that advances is not for a cam", "[physical_program]") {
  CHECK_THAT(refusal("{name = 'a', angle = 180, law = 'MS'}, {name = 'b'}", "advance = 1\n"),
             Contains("the motion of disc-cam-roller returns to where it began"));
}

}  // namespace camlaw::problems::physical_program_test
