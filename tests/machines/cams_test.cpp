// SPDX-License-Identifier: MIT
// Cams as problem files see them: answers compared with closed forms and searches of their own.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "kinematics/peaks.h"
#include "kinematics/program/program.h"
#include "machines/cams/oscillating_roller_cam.h"
#include "optim/search/optimise.h"
#include "problems/statement/bind.h"
#include "tests/paths.h"
#include "tests/problems/complaint.h"

namespace camlaw::problems::cams_test {
namespace {

using optim::Found;
using optim::Verdict;
constexpr double kPi = std::numbers::pi;

Found solved(const std::string& name) {
  const BoundProblem bound(read_problem_file(testing::source("problems/cams/") + name));
  return optim::optimise(bound.space()).found;
}

/// The least of f(x) over many places of a law.
template <class F>
double least_over(const F& f, int count = 20000) {
  double least = 1e300;
  for (int i = 0; i <= count; ++i) least = std::min(least, f(static_cast<double>(i) / count));
  return least;
}

using testing::complaint;

/// A cam's file with these segments.
std::string with_segments(const std::string& segments, const std::string& head = "") {
  return "mechanism = 'disc-cam-flat'\n[program]\n" + head + "segments = [" + segments + "]\n";
}

}  // namespace

TEST_CASE("a flat face asks for the base circle that its least curvature leaves", "[cams]") {
  const double beta = 100 * kPi / 180, other = 120 * kPi / 180;
  const Law<double> rise = find_law("poly-3-4-5").law(), back = find_law("cycloidal").law();
  const double least = std::min(
      least_over([&](double x) { return 20 * (rise(x).s + rise(x).a / (beta * beta)); }),
      least_over([&](double x) { return 20 * (1 - back(x).s - back(x).a / (other * other)); }));
  const Found found = solved("flat_least_base.toml");
  CHECK(found.x.at(0) == Approx(5 - least).epsilon(1e-6));
  CHECK(found.assessment.global);
}

TEST_CASE("a rise at constant velocity between rests takes an infinite force", "[cams][pulse]") {
  const auto measured = [](const std::string& law) {
    std::map<std::string, double> values;
    for (const EvaluatedResponse& r : evaluate(read_problem(
             with_segments("{ angle = '120 deg', law = '" + law +
                               "' }, { angle = '60 deg' }, { angle = '90 deg', law = 'cycloidal' "
                               "}, {}",
                           "matched = 'displacement'\n"),
             "f.toml"))) {
      values[r.name] = r.is_curve ? r.highest : r.value;
    }
    return values;
  };
  auto jumping = measured("constant-velocity"), smooth = measured("cycloidal");
  for (const char* name : {"acceleration", "drive_torque"}) {
    CHECK(std::isinf(jumping.at(name)));
    CHECK(std::isfinite(smooth.at(name)));
  }
  CHECK(std::isnan(jumping.at("torque_rms")));
  CHECK(std::isfinite(smooth.at("torque_rms")));
  CHECK(std::isfinite(jumping.at("velocity")));
}

TEST_CASE("a roller's base circle is the one at which the rise stands at 30 degrees", "[cams]") {
  const double beta = 80 * kPi / 180, slope = std::tan(kPi / 6);
  const Law<double> rise = find_law("cycloidal").law();
  const double prime =
      -least_over([&](double x) { return 30 * rise(x).s - 30 * rise(x).v / beta / slope; });
  const Found found = solved("roller_least_base.toml");
  CHECK(found.x.at(0) + 8 == Approx(prime).epsilon(1e-6));
  CHECK(found.assessment.limits.at(0).margin == Approx(0).margin(1e-9));
}

TEST_CASE("rise and return of an end cam share what is left in halves", "[cams]") {
  const Found found = solved("end_rise_share.toml");
  const double Cv = peaks(find_law("modified-sine").law()).max_velocity();
  const double beta = 140 * kPi / 180;
  CHECK(found.x.at(1) == Approx(140).epsilon(1e-6));
  CHECK(found.x.at(0) == Approx(25 * Cv / (beta * std::tan(kPi / 6))).epsilon(1e-7));
}

TEST_CASE("no arm and pivot on a grid have a smaller pressure angle", "[cams]") {
  const Found found = solved("oscillating_least_peak_angle.toml");
  const Law<double> law = motion_program({{"rise", 110, 1, false, find_law("cycloidal")},
                                          {"high", 50, 1, true, {}},
                                          {"return", 110, 0, false, find_law("cycloidal")},
                                          {"low", 90, 0, true, {}}},
                                         Matched::Acceleration)
                              .law();
  const auto recorded = [](const auto& formula) {
    return Formula::record(6, [&](std::span<const Expression> u) -> Expression {
      OscillatingRollerCam cam;
      cam.swing = 25 * kPi / 180;
      cam.base_radius = 0.04;
      cam.arm_length = u[0], cam.pivot_distance = u[1];
      return formula(cam, cam.over_angle(Motion<Expression>{u[2], u[3], u[4], u[5]}));
    });
  };
  const Formula pressure_angle =
      recorded([](const auto& cam, const auto& f) { return cam.pressure_angle(f); });
  const Formula undercut = recorded([](const auto& cam, const auto& f) {
    return cam.roller().undercut(cam.pitch_curve(f).curvature());
  });
  double least = 1e300;
  for (double arm = 0.06; arm <= 0.1201; arm += 0.005) {
    for (double pivot = 0.08; pivot <= 0.1401; pivot += 0.00025) {
      // Base radius and roller make a triangle with arm and pivot.
      if (!(0.05 < arm + pivot && 0.05 > std::abs(arm - pivot))) continue;
      double peak = 0;
      for (int i = 0; i < 360; ++i) {
        const Motion<double> m = law(i / 360.0);
        const std::array<double, 6> u{arm, pivot, m.s, m.v, m.a, m.j};
        const std::span<const double> at(u);
        peak = std::max(peak, std::abs(pressure_angle(at)));
        if (undercut(at) > 0.7) peak = 1e300;
      }
      least = std::min(least, peak);
    }
  }
  const double ours = found.assessment.objective.value * kPi / 180;
  CHECK(least >= ours * (1 - 1e-3));
  CHECK(least <= ours * (1 + 5e-3));
}

TEST_CASE("a law of the cam is chosen among those of its segments", "[cams]") {
  const std::string file = with_segments(
      "{name = 'rise', angle = 120, law = ['cycloidal', 'poly-3-4-5', 'modified-sine']},"
      "{name = 'back', law = ['cycloidal', 'modified-trapezoid']}");
  const ProblemStatement problem =
      read_problem(file +
                       "[variables.base_radius]\nlower = 1\nupper = 200\n"
                       "[objective]\nminimize = 'base_radius'\n"
                       "[[constraints]]\nresponse = 'profile_radius'\nlower = 5\n",
                   "f.toml");
  CHECK(problem.laws.size() == 6);
  const optim::Optimum optimum = optim::optimise(BoundProblem(problem).space());
  CHECK(optimum.combinations == 6);
  CHECK(optimum.found.assessment.verdict == Verdict::Certified);
  for (const Member& law : problem.laws) {
    const Law<double> program = law.law();
    const double turn = 2 * kPi;
    const double least =
        least_over([&](double x) { return 20 * (program(x).s + program(x).a / (turn * turn)); });
    CHECK(optimum.found.x.at(0) <= 5 - least + 1e-3);
  }
}

TEST_CASE("segments may be stated in time", "[cams]") {
  const auto angles = read_problem(with_segments("{name = 'rise', angle = 120, law = 'cycloidal'},"
                                                 "{name = 'back', law = 'cycloidal'}"),
                                   "f.toml");
  const auto times =
      read_problem(with_segments("{name = 'rise', time = '50 ms', law = 'cycloidal'},"
                                 "{name = 'back', law = 'cycloidal'}",
                                 "cycle_time = '0.15 s'\n"),
                   "f.toml");
  CHECK(times.laws.at(0).law()(0.2).s == Approx(angles.laws.at(0).law()(0.2).s).epsilon(1e-12));
}

TEST_CASE("what is not a program is refused with its line", "[cams]") {
  struct Case {
    std::string text, part;
  };
  const std::string rise = "{name = 'rise', angle = 120, law = 'cycloidal'},";
  const std::vector<Case> cases = {
      {"mechanism = 'disc-cam-flat'\n", "program is missing"},
      {"mechanism = 'disc-cam-flat'\n[law]\nname = 'cosine'\n",
       "f.toml:2: law: disc-cam-flat takes no law; it needs [program]"},
      {"mechanism = 'spine-cutter'\n[law]\nname = 'cosine'\n[program]\n",
       "spine-cutter takes no program; it needs [law]"},
      {with_segments(rise + "{name = 'back', law = 'cosine'}"), "the acceleration jumps"},
      {with_segments(rise + "{name = 'back', angle = 200, law = 'cycloidal'}"),
       "the angles add up to 320 deg"},
      {with_segments(rise + "{name = 'dwell'}, {name = 'back', law = 'cycloidal'}"),
       "angle is missing; only the last segment may leave it out"},
      {with_segments(rise + "{name = 'high', angle = 240}, {name = 'back', law = 'cycloidal'}"),
       "add up to 360 deg; they must add up to less than 360 deg"},
      {with_segments(rise + "{name = 'back', law = 'cycloidale'}"), "cycloidal"},
      {with_segments(rise + "{name = 'back', to = 0}"), "needs a law"},
      {with_segments(rise + "{name = 'back', time = '1 s', law = 'cycloidal'}"), "cycle_time"},
      {with_segments(rise + "{name = 'back', angel = 240, law = 'cycloidal'}"), "angle"},
      {with_segments(rise + "{name = 'back', angle = '40 mm', law = 'cycloidal'}"), "angle"},
      {with_segments("{name = 'back', law = 'cycloidal'}"), "at least two segments"},
      {with_segments(rise + "{name = 'back', law = 'cycloidal'}", "matched = 'jerk'\n"),
       "use displacement, velocity or acceleration"},
  };
  for (const Case& c : cases) {
    const std::string message = complaint(c.text);
    INFO(c.text << "\n  says: " << message);
    CHECK(message.starts_with("f.toml"));
    CHECK(message.find(c.part) != std::string::npos);
  }
}

}  // namespace camlaw::problems::cams_test
