// SPDX-License-Identifier: MIT
#include "kinematics/program/program.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "kinematics/peaks.h"
#include "numerics/scalar/dual.h"

namespace camlaw::program_test {
namespace {

ProgramSegment move(const std::string& name, double angle, double to, const std::string& law) {
  return {name, angle, to, false, find_law(law)};
}
ProgramSegment rest(const std::string& name, double angle, double at) {
  return {name, angle, at, true, {}};
}

/// Rise in 120 deg, rest, return in 90 deg, rest.
std::vector<ProgramSegment> usual(const std::string& rise = "cycloidal",
                                  const std::string& back = "poly-4-5-6-7") {
  return {move("rise", 120, 1, rise), rest("high", 60, 1), move("back", 90, 0, back),
          rest("low", 90, 0)};
}

std::string refusal(const std::vector<ProgramSegment>& segments,
                    Matched matched = Matched::Acceleration) {
  try {
    motion_program(segments, matched);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a program is its segments' laws, stretched over the cycle", "[program]") {
  const Law<double> program = motion_program(usual(), Matched::Acceleration).law();
  const Law<double> rise = find_law("cycloidal").law(), back = find_law("poly-4-5-6-7").law();
  for (const double x : {0.0, 0.1, 0.37, 0.5, 0.93, 1.0}) {
    const auto up = program(x / 3, Side::Left), law = rise(x, Side::Left);
    CHECK(up.s == Approx(law.s).margin(1e-14));
    CHECK(up.v == Approx(3 * law.v).margin(1e-12));
    CHECK(up.a == Approx(9 * law.a).margin(1e-11));
    CHECK(up.j == Approx(27 * law.j).margin(1e-10));
    const auto down = program(0.5 + x / 4, Side::Left), other = back(x, Side::Left);
    if (x > 0) CHECK(down.s == Approx(1 - other.s).margin(1e-13));
    if (x > 0) CHECK(down.a == Approx(-16 * other.a).margin(1e-11));
  }
  CHECK(program(0.4).s == 1);
  CHECK(program(0.4).v == 0);
  CHECK(program(0.9).s == Approx(0).margin(1e-14));
  CHECK(peaks(program).max_velocity() == Approx(4 * peaks(back).max_velocity()).epsilon(1e-12));
}

TEST_CASE("segments that do not meet are named with the jump", "[program]") {
  // The cosine begins with pi^2 / 2, nine times that over a third of the cycle.
  const std::string why = refusal(usual("cosine"));
  CHECK(
      contains(why, "where 'low' meets 'rise', at 0 deg, the acceleration jumps from 0 to 44.41"));
  CHECK(refusal(usual("cosine"), Matched::Velocity).empty());
  // The modified sine ends with an acceleration of rounding, which is printed as 0.
  CHECK(contains(refusal({move("up", 120, 1, "modified-sine"), move("down", 120, 0, "cosine"),
                          rest("low", 120, 0)}),
                 "where 'up' meets 'down', at 120 deg, the acceleration jumps from 0 to -44.41"));
  // Rise and return in 180 deg each without a rest: there the cosine's accelerations meet.
  CHECK(refusal({move("up", 180, 1, "cosine"), move("down", 180, 0, "cosine")}).empty());
  CHECK(contains(refusal({move("up", 180, 1, "constant-velocity"), rest("high", 20, 1),
                          move("down", 160, 0, "cycloidal")},
                         Matched::Acceleration),
                 "velocity jumps"));
}

TEST_CASE("a segment that joins meets its neighbours in velocity and acceleration", "[program]") {
  // Rest, run up, constant velocity, run out, rest, and back.
  const std::vector<ProgramSegment> segments{rest("low", 60, 0),
                                             {"up", 40, 0.2, false, {}},
                                             move("feed", 100, 0.8, "constant-velocity"),
                                             {"out", 40, 1, false, {}},
                                             move("back", 120, 0, "modified-sine")};
  const Law<double> program = motion_program(segments, Matched::Acceleration).law();
  const double speed = 0.6 / (100.0 / 360);
  for (const double angle : {60.0, 100.0, 200.0, 240.0}) {
    INFO(angle);
    const auto left = program(angle / 360, Side::Left), right = program(angle / 360, Side::Right);
    CHECK(left.s == Approx(right.s).margin(1e-12));
    CHECK(left.v == Approx(right.v).margin(1e-10));
    CHECK(left.a == Approx(right.a).margin(1e-8));
  }
  CHECK(program(100.0 / 360).v == Approx(speed).epsilon(1e-12));
  CHECK(program(150.0 / 360).s == Approx(0.5).epsilon(1e-12));
}

TEST_CASE("a program's parameters are its angles, its levels and its laws'", "[program]") {
  auto segments = usual("polynomial-5 alpha=-3");
  segments[0].law = [] {
    Member member{&find_family("polynomial-5"), find_family("polynomial-5").defaults()};
    set_argument(member, "alpha=-10");
    return member;
  }();
  const Member program = motion_program(segments, Matched::Velocity);
  std::vector<std::string> names;
  for (const Parameter& p : program.family->parameters) names.push_back(p.name);
  CHECK(names == std::vector<std::string>{"rise_angle", "rise_to", "rise_alpha", "rise_crossover",
                                          "high_angle", "back_angle", "back_crossover"});
  // alpha = -10 is the 3-4-5.
  CHECK(program.law()(0.1).s == Approx(find_law("poly-3-4-5").law()(0.3).s).epsilon(1e-12));
}

TEST_CASE("a program is told in the words of its arguments", "[program]") {
  Member program = motion_program(usual(), Matched::Acceleration);
  const std::size_t rise = program.family->parameter("rise_angle");
  program.arguments.values()[rise] = {127};
  const Member told = program.listed();
  CHECK(contains(program.family->formula, "rise 120 deg"));
  CHECK(contains(told.family->formula, "rise 127 deg"));
  CHECK(contains(told.family->formula, "low 83 deg"));
  CHECK(told.name() == program.name());
  CHECK(told.law()(0.3).s == Approx(program.law()(0.3).s).epsilon(1e-12));
}

TEST_CASE("derivatives by a program's parameters agree with differences", "[program]") {
  const Member program = motion_program(usual(), Matched::Acceleration);
  const auto& family = *program.family;
  for (const std::string name : {"rise_angle", "rise_to", "high_angle", "back_angle"}) {
    const std::size_t i = family.parameter(name);
    auto arguments = program.arguments.as<Dual>();
    arguments.values()[i][0].v[0] = 1;
    const Law<Dual> law = family.make(arguments);
    const auto moved = [&](double step) {
      Member other = program;
      other.arguments.values()[i][0] += step;
      return other.law();
    };
    const double h = 1e-4 * program.arguments.list(i).front();
    const Law<double> above = moved(h), below = moved(-h);
    for (const double x : {0.11, 0.27, 0.41, 0.55, 0.7, 0.88}) {
      INFO(name << " at " << x);
      const auto exact = law(x);
      CHECK(exact.s.v[0] == Approx((above(x).s - below(x).s) / (2 * h)).margin(1e-6));
      CHECK(exact.v.v[0] == Approx((above(x).v - below(x).v) / (2 * h)).margin(1e-5));
    }
  }
}

TEST_CASE("what is not a program is refused in words", "[program]") {
  auto segments = usual();
  segments[3].angle = 80;
  CHECK(contains(refusal(segments), "the angles add up to 350 deg, not 360"));
  segments = usual();
  segments[1].name = "rise";
  CHECK(contains(refusal(segments), "two segments are called 'rise'"));
  segments = usual();
  segments[1].name = "High";
  CHECK(contains(refusal(segments), "'High' is not a segment's name"));
  segments = usual();
  segments[2].angle = -90;
  CHECK(contains(refusal(segments), "'back' must be above 0"));
  segments = usual();
  segments[2].to = 1;
  CHECK(contains(refusal(segments), "'back' moves, but begins and ends at 1"));
  // A return without a law rests where the rise has ended.
  CHECK(contains(refusal({move("rise", 120, 1, "cycloidal"), rest("back", 240, 1)}),
                 "'rise' moves, but begins and ends at 1: the last segment ends at 1, and nothing "
                 "brings the follower back (rise goes to 1, back has no law and rests at 1)"));
  CHECK(
      contains(refusal({rest("low", 60, 0), move("rise", 120, 1, "cycloidal"), rest("on", 180, 1)}),
               "'low' rests, but would go from 1 to 0: the last segment ends at 1, and nothing "
               "brings the follower back"));
  segments = usual();
  segments[3].to = 0.5;
  CHECK(contains(refusal(segments), "would go from"));
  CHECK(contains(refusal({rest("low", 360, 0)}), "at least two"));
}

TEST_CASE("angles that leave nothing to the last segment make no law", "[program]") {
  const Member program = motion_program(usual(), Matched::Acceleration);
  Member full = program;
  full.arguments.values()[program.family->parameter("rise_angle")][0] = 215;
  CHECK_THROWS_WITH(full.law(), Catch::Contains("no angle is left for 'low'"));
}

}  // namespace camlaw::program_test
