// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "kinematics/peaks.h"
#include "kinematics/program/program.h"
#include "kinematics/transform.h"
#include "numerics/scalar/dual.h"
#include "numerics/scalar/interval.h"

/// Segments that join, pass points, end as stated, run backwards, or do not return.
namespace camlaw::joined_program_test {
namespace {

using Points = std::vector<PassedPoint>;

ProgramSegment rest(const std::string& name, double angle, double at) {
  return {name, angle, at, true};
}
ProgramSegment joining(const std::string& name, double angle, double to, Points points = {}) {
  ProgramSegment segment{name, angle, to};
  segment.points = std::move(points);
  return segment;
}
ProgramSegment move(const std::string& name, double angle, double to, const std::string& law,
                    bool reversed = false) {
  ProgramSegment segment{name, angle, to};
  segment.law = find_law(law);
  segment.reversed = reversed;
  return segment;
}

/// A rise through points between rests.
std::vector<ProgramSegment> through_points(int continuity = 4) {
  ProgramSegment rise = joining("rise", 160, 1, {{50, 0.2}, {70, 0.45}, {120, 0.7}});
  rise.continuity = continuity;
  ProgramSegment back = joining("back", 120, 0);
  back.continuity = continuity;
  return {rise, rest("high", 40, 1), back, rest("low", 40, 0)};
}

Law<double> law_of(const std::vector<ProgramSegment>& segments,
                   Matched matched = Matched::Acceleration) {
  return motion_program(segments, matched).law();
}

std::string refusal(const std::vector<ProgramSegment>& segments, double advance = 0) {
  try {
    motion_program(segments, Matched::Acceleration, advance);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

/// Derivatives 0 to 4 at an angle, from a side.
std::array<double, 5> at(const Law<double>& law, double angle, Side side) {
  return law.derivatives<5>(angle / 360, side);
}

/// The mean square of a derivative over a part of the cycle, by Simpson's rule between breaks.
double mean_square(const Law<double>& law, std::size_t order, double from, double to) {
  double sum = 0;
  for (const auto& piece : law.pieces()) {
    const double a = std::max(from, piece.begin), b = std::min(to, piece.end);
    if (!(b > a)) continue;
    constexpr int kSteps = 200;
    for (int i = 0; i < kSteps; ++i) {
      const double h = (b - a) / kSteps, x = a + i * h;
      const auto square = [&](double place, Side side) {
        return std::pow(law.derivatives<4>(place, side)[order], 2);
      };
      sum += h / 6 *
             (square(x, Side::Right) + 4 * square(x + h / 2, Side::Right) +
              square(std::min(x + h, b), Side::Left));
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("a segment through points is as smooth as it is stated", "[program][joined]") {
  for (const int continuity : {2, 4}) {
    INFO(continuity);
    const Law<double> law = law_of(through_points(continuity),
                                   continuity == 2 ? Matched::Velocity : Matched::Acceleration);
    CHECK(at(law, 50, Side::Left)[0] == Approx(0.2).epsilon(1e-13));
    CHECK(at(law, 70, Side::Left)[0] == Approx(0.45).epsilon(1e-13));
    CHECK(at(law, 120, Side::Right)[0] == Approx(0.7).epsilon(1e-13));
    for (const double angle : {50.0, 70.0, 120.0}) {
      const auto left = at(law, angle, Side::Left), right = at(law, angle, Side::Right);
      double size = 1;
      for (int k = 0; k <= continuity; ++k, size *= 10) {
        CHECK(left[static_cast<std::size_t>(k)] ==
              Approx(right[static_cast<std::size_t>(k)]).margin(1e-10 * size));
      }
    }
    CHECK(at(law, 0, Side::Right)[1] == Approx(0).margin(1e-12));
    CHECK(at(law, 160, Side::Left)[1] == Approx(0).margin(1e-12));
  }
  CHECK(at(law_of(through_points()), 160, Side::Left)[2] == Approx(0).margin(1e-10));
}

TEST_CASE("through points the mean square of jerk is the least", "[program][joined]") {
  const auto segments = through_points();
  const double least = mean_square(law_of(segments), 3, 0, 160.0 / 360);
  const auto found = at(law_of(segments), 70, Side::Right);
  for (const auto& [velocity, acceleration] :
       {std::pair{0.1, 0.0}, {-0.1, 0.0}, {0.0, 1.0}, {0.0, -1.0}}) {
    auto other = segments;
    other[0].points[1].velocity = found[1] + velocity;
    other[0].points[1].acceleration = found[2] + acceleration;
    CHECK(mean_square(law_of(other), 3, 0, 160.0 / 360) > least);
  }
  auto same = segments;
  same[0].points[1].velocity = found[1];
  same[0].points[1].acceleration = found[2];
  CHECK(mean_square(law_of(same), 3, 0, 160.0 / 360) == Approx(least).epsilon(1e-10));
}

TEST_CASE("all pairs of ends of VDI 2143 are polynomials of degree 5", "[program][joined]") {
  struct Letter {
    char name;
    double velocity, acceleration;  // strokes per cycle, and per cycle^2
  };
  constexpr Letter kEnds[] = {{'R', 0, 0}, {'G', 2.5, 0}, {'U', 0, -30}, {'B', 1.5, 20}};
  constexpr double kShare = 100.0 / 360;
  for (const Letter& begin : kEnds) {
    for (const Letter& end : kEnds) {
      INFO(begin.name << "-" << end.name);
      ProgramSegment before = joining("before", 130, 0.2);
      before.velocity = begin.velocity;
      before.acceleration = begin.acceleration;
      ProgramSegment pair = joining("pair", 100, 0.9);
      pair.velocity = end.velocity;
      pair.acceleration = end.acceleration;
      const Law<double> law = law_of({before, pair, joining("after", 130, 0)});
      const auto from = at(law, 130, Side::Right), to = at(law, 230, Side::Left);
      CHECK(from[1] == Approx(begin.velocity).margin(1e-12));
      CHECK(from[2] == Approx(begin.acceleration).margin(1e-10));
      CHECK(to[1] == Approx(end.velocity).margin(1e-12));
      CHECK(to[2] == Approx(end.acceleration).margin(1e-10));
      Member scaled = find_law("boundary-5");
      scaled.arguments.values() = {
          {0.2}, {begin.velocity * kShare}, {begin.acceleration * kShare * kShare},
          {0.9}, {end.velocity * kShare},   {end.acceleration * kShare * kShare},
          {0.5}};
      scaled.arguments.values().resize(scaled.family->parameters.size());
      const Law<double> plain = scaled.law();
      for (const double t : {0.0, 0.2, 0.5, 0.8}) {
        CHECK(law((130 + 100 * t) / 360).s == Approx(plain(t).s).epsilon(1e-12));
      }
    }
  }
}

TEST_CASE("a cycle of nothing but points is closed as smoothly as everywhere",
          "[program][joined]") {
  const Law<double> law = law_of(
      {joining("up", 180, 1, {{60, 0.3}, {120, 0.9}}), joining("down", 180, 0, {{90, 0.4}})});
  const auto begin = at(law, 0, Side::Right), end = at(law, 360, Side::Left);
  for (std::size_t k = 0; k < 5; ++k) CHECK(begin[k] == Approx(end[k]).margin(1e-8));
  const auto left = at(law, 180, Side::Left), right = at(law, 180, Side::Right);
  for (std::size_t k = 0; k < 5; ++k) CHECK(left[k] == Approx(right[k]).margin(1e-8));
}

TEST_CASE("segments that join follow one another over the end of the cycle", "[program][joined]") {
  // The run of joining segments begins at 200 deg and ends at 60 deg of the next cycle.
  const Law<double> law = law_of({joining("out", 60, 0.4), rest("low", 100, 0.4),
                                  move("up", 40, 0.6, "cycloidal"), joining("on", 160, 1)});
  const auto begin = at(law, 0, Side::Right), end = at(law, 360, Side::Left);
  for (std::size_t k = 0; k < 5; ++k) CHECK(begin[k] == Approx(end[k]).margin(1e-8));
  CHECK(at(law, 60, Side::Left)[2] == Approx(0).margin(1e-9));
}

TEST_CASE("a law shapes a segment that joins, and is itself between rests", "[program][joined]") {
  ProgramSegment shaped = move("out", 60, 1, "modified-sine");
  shaped.shapes = true;
  const Law<double> law =
      law_of({rest("low", 60, 0), joining("up", 40, 0.2),
              move("feed", 100, 0.7, "constant-velocity"), shaped, joining("back", 100, 0)});
  for (const double angle : {200.0, 260.0}) {
    const auto left = at(law, angle, Side::Left), right = at(law, angle, Side::Right);
    for (std::size_t k = 0; k < 3; ++k) CHECK(left[k] == Approx(right[k]).margin(1e-8));
  }
  CHECK(at(law, 200, Side::Right)[1] == Approx(0.5 * 360 / 100).epsilon(1e-10));
  // Not the polynomial that would join.
  ProgramSegment plain = joining("out", 60, 1);
  const Law<double> other =
      law_of({rest("low", 60, 0), joining("up", 40, 0.2),
              move("feed", 100, 0.7, "constant-velocity"), plain, joining("back", 100, 0)});
  CHECK(std::abs(law(220.0 / 360).s - other(220.0 / 360).s) > 1e-4);
  ProgramSegment between = move("up", 120, 1, "modified-sine");
  between.shapes = true;
  const Law<double> itself =
      law_of({between, rest("high", 60, 1), move("down", 120, 0, "cycloidal"), rest("low", 60, 0)});
  const Law<double> sine = find_law("modified-sine").law();
  for (int i = 0; i <= 20; ++i) {
    CHECK(itself(i / 60.0).s == Approx(sine(i / 20.0).s).margin(1e-13));
    CHECK(itself(i / 60.0, Side::Left).a == Approx(9 * sine(i / 20.0, Side::Left).a).margin(1e-9));
  }
  // Of a segment that goes nowhere there is nothing to shape, as near it there is almost nothing.
  ProgramSegment level = move("on", 60, 1, "modified-sine");
  level.shapes = true;
  const Law<double> flat = law_of({move("up", 120, 1, "cycloidal"), level,
                                   move("down", 120, 0, "cycloidal"), rest("low", 60, 0)});
  CHECK(flat(150.0 / 360).s == Approx(1).epsilon(1e-14));
  CHECK(flat(140.0 / 360).a == Approx(0).margin(1e-12));
  between.law = find_law("rothbart-8");
  CHECK_THAT(refusal({between, rest("high", 60, 1), move("down", 120, 0, "cycloidal"),
                      rest("low", 60, 0)}),
             Catch::Contains("goes from rest to rest"));
}

TEST_CASE("a law runs backwards as its mirror image", "[program][joined]") {
  constexpr double kUlp = std::numeric_limits<double>::epsilon();
  for (const char* name : {"rothbart-8", "quick-return", "double-harmonic"}) {
    INFO(name);
    const Law<double> law = law_of({move("up", 180, 1, name), move("down", 180, 0, name, true)});
    const auto own = peaks(law_of({move("up", 180, 1, name), move("down", 180, 0, name, true)}));
    for (int i = 1; i < 64; ++i) {
      const double x = i / 128.0;  // exact, as is 1 - x
      const auto up = law(x), down = law(1 - x);
      CHECK(std::abs(up.s - down.s) <= 4 * kUlp);
      CHECK(std::abs(up.v + down.v) <= 4 * kUlp * own.max_velocity());
      CHECK(std::abs(up.a - down.a) <= 4 * kUlp * own.max_acceleration());
    }
    const Law<double> forwards = find_law(name).law(), back = reversed(forwards);
    CHECK(std::abs(peaks(back).max_velocity() - own.max_velocity() / 2) <=
          4 * kUlp * own.max_velocity());
    CHECK(std::abs(peaks(back).max_acceleration() - peaks(forwards).max_acceleration()) <=
          4 * kUlp * peaks(forwards).max_acceleration());
  }
  const std::string why =
      refusal({move("up", 180, 1, "rothbart-8"), move("down", 180, 0, "rothbart-8")});
  CHECK_THAT(why, Catch::Contains("reverse the law of 'down' (reversed = true)"));
}

TEST_CASE("a jump of acceleration names its remedies", "[program][joined]") {
  const std::string why = refusal({move("up", 100, 1, "cosine"), rest("high", 80, 1),
                                   move("down", 100, 0, "cycloidal"), rest("low", 80, 0)});
  CHECK_THAT(why, Catch::Contains("the acceleration jumps") &&
                      Catch::Contains("let one of the two join (law = \"joining\")") &&
                      Catch::Contains("accept the jump with matched = \"velocity\""));
}

TEST_CASE("a motion that advances ends one pitch further", "[program][joined]") {
  const Member feed = motion_program({rest("hold", 120, 0), move("feed", 240, 1, "modified-sine")},
                                     Matched::Acceleration, 1);
  const Law<double> law = feed.law();
  CHECK(law(0.0).s == 0);
  CHECK(law(1.0, Side::Left).s == Approx(1).epsilon(1e-14));
  constexpr int kStations = 8;
  double place = 0;
  for (int i = 0; i < kStations; ++i) place += law(1.0, Side::Left).s - law(0.0).s;
  CHECK(place == Approx(kStations).epsilon(1e-14));
  // Without a rest it never stands, and is as smooth at the end of the cycle as elsewhere.
  const Law<double> flying =
      motion_program({joining("slow", 180, 0.2), joining("fast", 180, 1)}, Matched::Acceleration, 1)
          .law();
  const auto begin = at(flying, 0, Side::Right), end = at(flying, 360, Side::Left);
  CHECK(end[0] - begin[0] == Approx(1).epsilon(1e-13));
  for (std::size_t k = 1; k < 5; ++k) CHECK(begin[k] == Approx(end[k]).margin(1e-8));
  CHECK_THAT(refusal({rest("hold", 120, 0), move("feed", 240, 1, "modified-sine")}, 2),
             Catch::Contains("'hold' rests, but would go from -1 to 0"));
}

TEST_CASE("derivatives by points and ends agree with differences", "[program][joined]") {
  auto segments = through_points();
  segments[0].velocity = 0.0;
  segments[2].points = {{60, 0.6}};
  segments[2].points[0].velocity = -3.0;
  segments[1] = joining("high", 40, 1.02);
  segments[1].acceleration = -20.0;
  const Member program = motion_program(segments, Matched::Acceleration);
  const auto& family = *program.family;
  struct Element {
    const char* name;
    std::size_t element;
  };
  for (const auto& [name, element] : {Element{"rise_points", 1},
                                      {"rise_point_angles", 2},
                                      {"rise_to", 0},
                                      {"rise_velocity", 0},
                                      {"high_acceleration", 0},
                                      {"rise_angle", 0},
                                      {"back_points", 0}}) {
    const std::size_t i = family.parameter(name);
    auto arguments = program.arguments.as<Dual>();
    arguments.values()[i][element].v[0] = 1;
    const Law<Dual> law = family.make(arguments);
    const auto moved = [&](double step) {
      Member other = program;
      other.arguments.values()[i][element] += step;
      return other.law();
    };
    const double h = 1e-5 * std::max(1.0, std::abs(program.arguments.list(i)[element]));
    const Law<double> above = moved(h), below = moved(-h);
    for (const double x : {0.11, 0.27, 0.41, 0.55, 0.7}) {
      INFO(name << " at " << x);
      const auto exact = law(x);
      CHECK(exact.s.v[0] == Approx((above(x).s - below(x).s) / (2 * h)).margin(1e-6));
      CHECK(exact.a.v[0] == Approx((above(x).a - below(x).a) / (2 * h)).margin(1e-3));
    }
  }
}

TEST_CASE("displacement is said to be linear only where every value makes a motion",
          "[program][joined]") {
  const auto is_linear = [](const std::vector<ProgramSegment>& segments, const char* name,
                            Matched matched = Matched::Acceleration) {
    const Member program = motion_program(segments, matched);
    return program.family->parameters[program.family->parameter(name)].linear;
  };
  CHECK(is_linear(through_points(), "rise_points"));
  CHECK(is_linear(through_points(2), "rise_points", Matched::Velocity));
  CHECK(is_linear({move("up", 100, 1, "cycloidal"), move("on", 80, 0.5, "modified-sine"),
                   joining("back", 180, 0)},
                  "up_to"));
  // The levels decide here whether the accelerations meet.
  CHECK_FALSE(
      is_linear({move("up", 120, 1, "rothbart-8"), move("down", 120, 0, "rothbart-8", true),
                 move("up2", 60, 0.25, "rothbart-8"), move("down2", 60, 0, "rothbart-8", true)},
                "up_to"));
  // A rate before a rest is the rest's, and no parameter.
  auto segments = through_points();
  segments[0].velocity = 0.0;
  const Member program = motion_program(segments, Matched::Acceleration);
  CHECK_THROWS_WITH(program.family->parameter("rise_velocity"), Catch::Contains("no parameter"));
}

TEST_CASE("a motion through many points is enclosed closely", "[program][joined]") {
  Points points;
  for (int i = 1; i < 60; ++i) {
    points.push_back({3.0 * i, 0.5 - 0.5 * std::cos(std::numbers::pi * i / 60)});
  }
  const Member program = motion_program(
      {joining("up", 180, 1, points), move("down", 180, 0, "cosine")}, Matched::Acceleration);
  const Law<double> plain = program.law();
  const Law<Interval> enclosing = program.law<Interval>();
  for (const double x : {0.01, 0.123, 0.25, 0.4, 0.49}) {
    const auto exact = plain(x);
    const auto bounds = enclosing(Interval(x));
    CHECK(bounds.a.lower() <= exact.a);
    CHECK(exact.a <= bounds.a.upper());
    CHECK(bounds.a.upper() - bounds.a.lower() < 1e-5 * peaks(plain).max_acceleration());
  }
}

TEST_CASE("what cannot be of a segment is refused in words", "[program][joined]") {
  auto segments = through_points();
  segments[0].points[1].angle = 40;
  CHECK_THAT(refusal(segments), Catch::Contains("point 2 of 'rise' is at 40 deg; it must be "
                                                "between 50 and 160 deg"));
  segments = through_points();
  segments[1].velocity = 1.0;
  CHECK_THAT(refusal(segments), Catch::Contains("'high' rests; points and a velocity"));
  segments = through_points();
  segments[0].continuity = 3;
  CHECK_THAT(refusal(segments), Catch::Contains("the continuity of 'rise' is 2"));
  segments = through_points(2);
  segments[0].points[0].acceleration = 3.0;
  CHECK_THAT(refusal(segments), Catch::Contains("for which no acceleration can be stated"));
  segments = through_points();
  segments[0].reversed = true;
  CHECK_THAT(refusal(segments), Catch::Contains("'rise' has no law that could run backwards"));
}

}  // namespace camlaw::joined_program_test
