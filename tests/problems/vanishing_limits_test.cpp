// SPDX-License-Identifier: MIT
// Limits that stand at their bound whatever the design, where the motion rests: they certify
// nothing there, and their leading coefficients do.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "optim/search/optimise.h"
#include "problems/statement/bind.h"

namespace camlaw::problems::vanishing_limits_test {
namespace {

using optim::Verdict;

optim::Found solved(const std::string& text) {
  return optim::optimise(BoundProblem(read_problem(text, "f.toml")).space()).found;
}

/// The quintic family, alpha from a start, where the motion must not run backwards.
std::string forwards(const std::string& objective, double start) {
  return fmt::format(
      "mechanism = 'law'\n[law]\nname = 'polynomial-5'\n[objective]\n{}\n"
      "[variables.alpha]\nlower = -15\nupper = 10\nstart = {}\n"
      "[[constraints]]\nresponse = 'velocity'\nlower = 0\n",
      objective, start);
}

const optim::LimitReport& limit(const optim::Found& found, const std::string& name) {
  for (const auto& report : found.assessment.limits) {
    if (report.name == name) return report;
  }
  throw std::invalid_argument("no limit " + name);
}

bool is_active(const optim::Found& found, const std::string& name) {
  const auto& active = found.assessment.active;
  return std::find(active.begin(), active.end(), name) != active.end();
}

}  // namespace

TEST_CASE("that a motion must not run backwards holds no design where it could be better",
          "[vanishing]") {
  // s'' = 6 P1 + 0.6 alpha P3: peak velocity falls with alpha, to 1.2 at its bound.
  for (const double start : {0.0, -10.0, 5.0, 9.999}) {
    INFO("start " << start);
    const optim::Found found = solved(forwards("minimize = 'B'", start));
    CHECK(found.assessment.verdict == Verdict::Certified);
    REQUIRE(found.assessment.best_possible);
    CHECK(*found.assessment.best_possible == Approx(1.2).epsilon(1e-6));
    CHECK(found.assessment.objective.value == Approx(1.2).epsilon(1e-9));
    CHECK(limit(found, "velocity").multiplier == 0);
    CHECK_FALSE(is_active(found, "velocity"));
  }
}

TEST_CASE("a law is held by the acceleration of its beginning where its velocity must not turn",
          "[vanishing]") {
  // Mean square velocity grows away from the flat law, until s''(0) = 6 + 0.6 alpha is zero: that
  // is the 3-4-5 polynomial, v = 30 x^2 (1 - x)^2 and its mean square 900 B(5, 5) = 10/7.
  const optim::Found found = solved(forwards("maximize = 'mean_square_velocity'", -8));
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.assessment.objective.value == Approx(10.0 / 7).epsilon(1e-6));
  REQUIRE(found.x.size() == 1);
  CHECK(found.x[0] == Approx(-10).margin(1e-4));
  CHECK(is_active(found, "velocity"));
  CHECK(limit(found, "velocity").at_rest);
  CHECK(limit(found, "velocity").met);
}

TEST_CASE("a displacement between nothing and the stroke holds no design at its rests",
          "[vanishing]") {
  for (const double start : {-9.0, 0.0, 9.0}) {
    const std::string file = fmt::format(
        "mechanism = 'spine-cutter'\n[law]\nname = 'polynomial-5'\n"
        "[variables.alpha]\nlower = -10\nupper = 10\nstart = {}\n"
        "[objective]\nminimize = 'peak cam_pressure_angle'\n",
        start);
    const std::string within =
        "[[constraints]]\nresponse = 'displacement'\nlower = '0 mm'\nupper = '60 mm'\n";
    const optim::Found free = solved(file), held = solved(file + within);
    CHECK(free.assessment.verdict == Verdict::Certified);
    CHECK(held.assessment.verdict == Verdict::Certified);
    CHECK(held.assessment.objective.value == Approx(free.assessment.objective.value).epsilon(1e-7));
    CHECK(limit(held, "displacement").multiplier == 0);
  }
}

TEST_CASE("a free law that must not run backwards is as good as any, and the bound proves it",
          "[vanishing]") {
  // Without that limit constant acceleration and deceleration, C = 4, never run backwards either.
  for (const int degree : {2, 3}) {
    const optim::Found found = solved(fmt::format(
        "mechanism = 'law'\n[law]\nname = 'free'\n[free]\ndegree = {}\nknots = 15\n"
        "[objective]\nminimize = 'C'\n[[constraints]]\nresponse = 'velocity'\nlower = 0\n",
        degree));
    CHECK(found.assessment.verdict == Verdict::Certified);
    CHECK(found.assessment.global);
    REQUIRE(found.assessment.best_possible);
    const double value = found.assessment.objective.value;
    CHECK(*found.assessment.best_possible <= value);
    CHECK(*found.assessment.best_possible == Approx(value).epsilon(1e-6));
    if (degree == 2) CHECK(value == Approx(4).epsilon(1e-7));
    if (degree == 3) CHECK(value > 4);
    CHECK(limit(found, "velocity").multiplier == 0);
  }
}

TEST_CASE("a force that vanishes at rest has a tolerance of the forces that act, in every box",
          "[vanishing]") {
  const auto cam = [](const char* lower, const char* upper) {
    return fmt::format(
        "mechanism = 'disc-cam-roller'\n[constants]\nstroke = '20 mm'\nmass = '1 kg'\n"
        "spring_rate = '5 N/mm'\nspring_preload = '50 N'\n"
        "[[program.segments]]\nname = 'rise'\nangle = '120 deg'\nlaw = 'cycloidal'\n"
        "[[program.segments]]\nname = 'high'\nangle = '60 deg'\n"
        "[[program.segments]]\nname = 'return'\nangle = '120 deg'\nlaw = 'cycloidal'\n"
        "[[program.segments]]\nname = 'low'\n"
        "[variables.speed]\nlower = '{}'\nupper = '{}'\nstart = '{}'\n"
        "[objective]\nmaximize = 'speed'\n"
        "[[constraints]]\nresponse = 'follower_force'\nlower = '0 N'\n",
        lower, upper, lower);
  };
  const optim::Found slow = solved(cam("100 rpm", "2000 rpm"));
  REQUIRE(slow.assessment.verdict == Verdict::Certified);
  const double leaves = slow.assessment.objective.value;
  CHECK(solved(cam("100 rpm", "1000000 rpm")).assessment.objective.value ==
        Approx(leaves).epsilon(1e-6));
  for (const char* upper : {"2000 rpm", "1000000 rpm"}) {
    const auto beyond = fmt::format("{} rpm", leaves * 1.01);
    CHECK(solved(cam(beyond.c_str(), upper)).assessment.verdict == Verdict::Infeasible);
  }
}

TEST_CASE("where no design of a box can be made the answer is infeasible and says why",
          "[vanishing]") {
  const std::string file =
      "mechanism = 'disc-cam-roller'\n[constants]\nstroke = '30 mm'\nroller_radius = '25 mm'\n"
      "speed = '200 rpm'\n"
      "[[program.segments]]\nname = 'rise'\nangle = '40 deg'\nlaw = 'cycloidal'\n"
      "[[program.segments]]\nname = 'high'\nangle = '60 deg'\n"
      "[[program.segments]]\nname = 'return'\nangle = '100 deg'\nlaw = 'modified-sine'\n"
      "[[program.segments]]\nname = 'low'\n"
      "[objective]\nminimize = 'peak_stress'\n"
      "[variables.base_radius]\nlower = '10 mm'\nstart = '20 mm'\n";
  const optim::Found none = solved(file + "upper = '30 mm'\n");
  INFO(none.assessment.reason);
  CHECK(none.assessment.verdict == Verdict::Infeasible);
  CHECK(none.assessment.reason.find("undercut") != std::string::npos);
  CHECK(none.assessment.blamed ==
        std::vector<std::string>{"undercut", "upper bound of base_radius"});
  const optim::Found some = solved(file + "upper = '300 mm'\n");
  CHECK(some.assessment.verdict == Verdict::Certified);
}

TEST_CASE("a limit that a dwell violates whatever the design is blamed alone, with the place",
          "[limits]") {
  // In the dwells the pressure angle is 0, whatever the cam.
  const auto cam = [](const std::string& lower) {
    return solved(
        "mechanism = 'disc-cam-roller'\n[constants]\nstroke = '30 mm'\n"
        "[[program.segments]]\nname = 'rise'\nangle = '90 deg'\nlaw = 'cycloidal'\n"
        "[[program.segments]]\nname = 'high'\nangle = '60 deg'\n"
        "[[program.segments]]\nname = 'return'\nangle = '100 deg'\nlaw = 'modified-sine'\n"
        "[[program.segments]]\nname = 'low'\n"
        "[objective]\nminimize = 'base_radius'\n"
        "[variables.base_radius]\nlower = '10 mm'\nstart = '40 mm'\nupper = '120 mm'\n"
        "[[constraints]]\nresponse = 'pressure_angle'\nupper = '28 deg'\nlower = '-35 deg'\n"
        "[[constraints]]\nresponse = 'pressure_angle'\nlower = '" +
        lower + "'\n");
  };
  const optim::Assessment none = cam("30 deg").assessment;
  CHECK(none.verdict == Verdict::Infeasible);
  CHECK(none.blamed == std::vector<std::string>{"pressure_angle (2)"});
  CHECK_THAT(none.reason, Catch::Contains("pressure_angle (2) cannot be met: at ") &&
                              Catch::Contains("whatever the variables"));
  CHECK(none.global);
  CHECK(cam("-30 deg").assessment.verdict == Verdict::Certified);
}

TEST_CASE("the end of a window is judged from within", "[limits]") {
  // The parabolic rise decelerates up to 90 deg; the dwell behind it has no acceleration, and is
  // not in the window.
  const optim::Assessment found =
      solved(
          "mechanism = 'disc-cam-roller'\n[constants]\nstroke = '30 mm'\nspeed = '100 rpm'\n"
          "[program]\nmatched = 'velocity'\n[[program.segments]]\nname = 'rise'\nangle = '90 "
          "deg'\nlaw = 'parabolic'\n"
          "[[program.segments]]\nname = 'high'\nangle = '60 deg'\n"
          "[[program.segments]]\nname = 'return'\nangle = '100 deg'\nlaw = 'modified-sine'\n"
          "[[program.segments]]\nname = 'low'\n"
          "[objective]\nminimize = 'base_radius'\n"
          "[variables.base_radius]\nlower = '10 mm'\nstart = '40 mm'\nupper = '120 mm'\n"
          "[[constraints]]\nresponse = 'pressure_angle'\nupper = '30 deg'\n"
          "[[constraints]]\nresponse = 'acceleration'\nfrom = '50 deg'\nto = '90 deg'\n"
          "upper = '-1 m/s2'\n")
          .assessment;
  INFO(found.reason);
  CHECK(found.verdict == Verdict::Certified);
}

}  // namespace camlaw::problems::vanishing_limits_test
