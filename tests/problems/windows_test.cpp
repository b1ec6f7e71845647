// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "optim/cycle/extremes.h"
#include "optim/problem/check_derivatives.h"
#include "optim/search/optimise.h"
#include "problems/statement/bind.h"
#include "problems/statement/statement.h"
#include "tests/problems/complaint.h"

/// Limits and objectives over a part of the cycle.
namespace camlaw::problems::windows_test {

using Catch::Contains, testing::complaint;

namespace {

std::string cam(const std::string& rest) {
  return "mechanism = 'disc-cam-roller'\n[constants]\nstroke = '30 mm'\nroller_radius = '8 mm'\n"
         "[[program.segments]]\nname = 'rise'\nangle = '80 deg'\nlaw = 'cycloidal'\n"
         "[[program.segments]]\nname = 'high'\nangle = '60 deg'\n"
         "[[program.segments]]\nname = 'return'\nangle = '100 deg'\nlaw = 'modified-sine'\n"
         "[[program.segments]]\nname = 'low'\n" +
         rest;
}

const std::string kVaries = "[variables.base_radius]\nlower = 10\nupper = 200\nstart = 60\n";
const std::string kBase = kVaries + "[objective]\nminimize = 'base_radius'\n";

/// The greatest size of a curve from one place to another, at many places.
double sampled(const optim::Trace& trace, double from, double to) {
  double most = 0;
  constexpr int kSteps = 20000;
  for (int i = 0; i <= kSteps; ++i) {
    most = std::max(most, std::abs(trace.at({from + (to - from) * i / kSteps, i > 0})[0]));
  }
  return most;
}

optim::Optimum best(const std::string& text) {
  const BoundProblem bound(read_problem(text, "f.toml"));
  return optim::optimise(bound.problem({}), {});
}

}  // namespace

TEST_CASE("a peak over a window is the greatest within it", "[windows]") {
  for (const auto& [window, from, to] : std::vector<std::tuple<const char*, double, double>>{
           {"over = 'rise'", 0, 80},
           {"over = 'return'", 140, 240},
           {"from = '20 deg'\nto = '30 deg'", 20, 30},
           {"to = '35 deg'", 0, 35},
           {"from = 230", 230, 360}}) {
    INFO(window);
    const auto peak_of = [](const std::string& part) {
      const BoundProblem bound(read_problem(
          cam(kVaries + "[objective]\nminimize = 'peak pressure_angle'\n" + part), "f.toml"));
      return bound.problem({}).objective().response.curve().trace(std::vector{60.0});
    };
    const auto trace = peak_of(window), all = peak_of("");
    CHECK(trace->breaks().front() == Approx(from).margin(1e-12));
    CHECK(trace->breaks().back() == Approx(to).margin(1e-12));
    CHECK(std::abs(optim::extreme_of(*trace, optim::Part::Magnitude).value) ==
          Approx(sampled(*all, from, to)).epsilon(1e-6));
  }
}

TEST_CASE("a limit over a segment leaves the others alone", "[windows]") {
  const auto limit = [](const char* window, double upper) {
    return fmt::format("[[constraints]]\nresponse = 'peak pressure_angle'\n{}\nupper = {}\n",
                       window, upper);
  };
  const auto base = [](const optim::Optimum& found) { return found.found.x.front(); };
  const auto rise = best(cam(kBase + limit("over = 'rise'", 25)));
  const auto both = best(cam(kBase + limit("over = 'rise'", 25) + limit("over = 'return'", 20)));
  const auto back = best(cam(kBase + limit("over = 'return'", 20)));
  CHECK(rise.found.assessment.verdict == optim::Verdict::Certified);
  CHECK(rise.found.assessment.limits.front().name == "peak pressure_angle over rise");
  CHECK(base(both) == Approx(std::max(base(rise), base(back))).epsilon(1e-9));
  CHECK(std::min(base(rise), base(back)) < 0.98 * base(both));
}

TEST_CASE("a window over a segment moves with it", "[windows]") {
  // Of the rise's angle the pressure angle in the rise depends, and its window.
  const BoundProblem bound(read_problem(
      cam("[variables.rise_angle]\nlower = 60\nupper = 130\n[variables.high_angle]\nlower = 30\n"
          "upper = 90\n[objective]\nminimize = 'peak velocity'\nover = 'return'\n"),
      "f.toml"));
  const auto problem = bound.problem({});
  for (const std::vector<double>& x : {std::vector{70.0, 50.0}, {110.0, 40.0}}) {
    const auto trace = problem.objective().response.curve().trace(x);
    CHECK(trace->breaks().front() == Approx(x[0] + x[1]).epsilon(1e-12));
    CHECK(trace->breaks().back() == Approx(x[0] + x[1] + 100).epsilon(1e-12));
  }
  // An end of a window over a segment is tied to the joint, that of a fixed window is not.
  const std::vector<double> x{80.0, 60.0};
  const auto& curve = problem.objective().response.curve();
  CHECK(curve.tied({140.0, false}, x).joint >= 0);
  const BoundProblem fixed(read_problem(
      cam("[variables.rise_angle]\nlower = 60\nupper = 130\n[objective]\nminimize = 'peak "
          "velocity'\nfrom = 80\nto = 200\n"),
      "f.toml"));
  const std::vector<double> y{80.0};
  CHECK(fixed.problem({}).objective().response.curve().tied({80.0, false}, y).joint < 0);
}

TEST_CASE("a curve over a turn that no motion makes has windows by places", "[windows]") {
  const std::string geneva =
      "mechanism = 'geneva'\n[constants]\nslots = 5\n"
      "[variables.speed]\nlower = 10\nupper = 200\nstart = 60\n";
  const auto peak_of = [&](const std::string& part) {
    const BoundProblem bound(
        read_problem(geneva + "[objective]\nminimize = 'highest drive_torque'\n" + part, "f.toml"));
    return bound.problem({}).objective().response.curve().trace(std::vector{60.0});
  };
  const auto all = peak_of("");
  // The engagement of five slots lasts 108 deg: a window within it, one across its end, one beyond.
  for (const auto& [from, to] :
       {std::pair(10.0, 25.0), std::pair(60.0, 200.0), std::pair(150.0, 300.0)}) {
    INFO(from << " .. " << to);
    const auto trace = peak_of(fmt::format("from = '{} deg'\nto = '{} deg'\n", from, to));
    CHECK(trace->breaks().front() == from);
    CHECK(trace->breaks().back() == to);
    double most = -1e300;
    for (int i = 0; i <= 20000; ++i) {
      most = std::max(most, all->at({from + (to - from) * i / 20000, i > 0})[0]);
    }
    CHECK(optim::extreme_of(*trace, optim::Part::Highest).value == Approx(most).margin(1e-6));
  }
  // The torque is limited to 90 N m: where the pin enters, or all round.
  const auto fastest = [&](const char* window) {
    const optim::Optimum optimum =
        best(geneva +
             "[objective]\nmaximize = 'speed'\n[[constraints]]\nresponse = 'drive_torque'\n"
             "upper = '90 N m'\n" +
             window);
    CHECK(optimum.found.assessment.verdict == optim::Verdict::Certified);
    CHECK(optimum.found.assessment.limits[0].proved);
    return optimum.found.x[0];
  };
  CHECK(fastest("to = 20\n") > 1.05 * fastest(""));
  const auto trace_at = [&](double speed) {
    const BoundProblem bound(read_problem(
        geneva + "[objective]\nminimize = 'highest drive_torque'\nto = 20\n", "f.toml"));
    return bound.problem({}).objective().response.curve().trace(std::vector{speed});
  };
  CHECK(optim::extreme_of(*trace_at(fastest("to = 20\n")), optim::Part::Highest).value ==
        Approx(90).epsilon(1e-7));
  CHECK_THAT(complaint([&] {
               read_problem(geneva +
                                "[[constraints]]\nresponse = 'drive_torque'\nupper = 40\n"
                                "over = 'rise'\n",
                            "f.toml");
             }),
             Contains("geneva has no motion program") && Contains("write from and to"));
}

namespace {

/// Two cams on a shaft, and a curve over its turn that holds a displacement of each.
std::string on_shaft(const std::string& phase, const std::string& rest) {
  const auto one = [](const std::string& name, const char* law, int rise,
                      const std::string& constants) {
    return fmt::format(
        "[cams.{0}]\nmechanism = 'disc-cam-roller'\n[cams.{0}.constants]\n"
        "base_radius = 60\nroller_radius = 8\nspring_rate = 4\nspring_preload = 80\n"
        "{3}[[cams.{0}.program.segments]]\nname = 'rise'\nangle = {2}\nlaw = '{1}'\n"
        "[[cams.{0}.program.segments]]\nname = 'high'\nangle = 40\n"
        "[[cams.{0}.program.segments]]\nname = 'return'\nangle = 110\nlaw = '{1}'\n"
        "[[cams.{0}.program.segments]]\nname = 'low'\n",
        name, law, rise, constants);
  };
  return "[constants]\nspeed = 200\n" + one("a", "cycloidal", 90, "") +
         one("b", "modified-sine", 70, phase) +
         "[responses.lead]\nunit = 'mm'\nformula = 'a.displacement - 0.5 * b.displacement'\n" +
         rest;
}

}  // namespace

TEST_CASE("a segment of a cam is a window on the turn of its shaft, also across the turn's end",
          "[windows][shaft]") {
  for (const char* curve : {"lead", "shaft_torque"}) {
    for (const double phase : {0.0, 77.0, -30.0, 250.0, 300.0, 330.0, -360.0}) {
      const auto whole_and = [&](const std::string& window) {
        const BoundProblem bound(read_problem(
            on_shaft(fmt::format("phase = {}\n", phase),
                     fmt::format("[cams.a.variables.mass]\nlower = 1\nupper = 9\nstart = 2\n"
                                 "[objective]\nminimize = 'highest {}'\n{}",
                                 curve, window)),
            "f.toml"));
        return bound.problem({}).objective().response.curve().trace(std::vector{2.0});
      };
      const auto all = whole_and("");
      for (const auto& [segment, begin, length] :
           {std::tuple("rise", 0.0, 70.0), std::tuple("high", 70.0, 40.0),
            std::tuple("return", 110.0, 110.0), std::tuple("low", 220.0, 140.0)}) {
        INFO(curve << " at " << phase << " over " << segment);
        const auto trace = whole_and(fmt::format("over = 'b.{}'\n", segment));
        const double from = std::fmod(phase + begin + 720, 360);
        CHECK(trace->breaks().front() == Approx(from).margin(1e-9));
        CHECK(trace->breaks().back() == Approx(from + length).margin(1e-9));
        double highest = -1e300, lowest = 1e300;
        for (int i = 0; i <= 20000; ++i) {
          const double angle = std::fmod(from + length * i / 20000, 360);
          const double value = all->at({angle, i == 20000 && angle > 0})[0];
          highest = std::max(highest, value), lowest = std::min(lowest, value);
        }
        const double size = std::abs(highest) + std::abs(lowest);
        CHECK(optim::extreme_of(*trace, optim::Part::Highest).value ==
              Approx(highest).margin(1e-5 * size));
        CHECK(optim::extreme_of(*trace, optim::Part::Lowest).value ==
              Approx(lowest).margin(1e-5 * size));
        const auto proved = optim::proved_highest(*trace, 1, std::max(size, 1.0));
        CHECK(proved.proved);
        CHECK(proved.peak.value >= highest - 1e-9 * size);
      }
    }
  }
}

TEST_CASE("a limit over a cam's segment is that over its angles on the shaft",
          "[windows][shaft][optimise]") {
  const auto limit = [](const std::string& window) {
    return "[[constraints]]\nresponse = 'lead'\n" + window + "lower = -8\n";
  };
  const std::string varies =
      "[cams.a.variables.stroke]\nlower = 2\nupper = 60\nstart = 40\n"
      "[objective]\nminimize = 'a.stroke'\n";
  // b rises from 320 deg to 30 deg of the next turn.
  const auto named = best(on_shaft("phase = 320\n", varies + limit("over = 'b.rise'\n")));
  const auto by_hand =
      best(on_shaft("phase = 320\n", varies + limit("from = 320\n") + limit("to = 30\n")));
  CHECK(named.found.assessment.verdict == optim::Verdict::Certified);
  CHECK(by_hand.found.assessment.verdict == optim::Verdict::Certified);
  CHECK(named.found.x[0] == Approx(by_hand.found.x[0]).epsilon(1e-9));
  CHECK(named.found.assessment.limits[0].name == "lead over b.rise");
  // Its phase may vary: as late as the limit lets b rise, which is past the end of the turn.
  const std::string late =
      "[cams.b.variables.phase]\nlower = 200\nupper = 340\nstart = 300\n"
      "[objective]\nmaximize = 'b.phase'\n[[constraints]]\nresponse = 'shaft_torque'\n"
      "over = 'b.rise'\nupper = ";
  const auto latest = best(on_shaft("", late + "4\n"));
  CHECK(latest.found.assessment.verdict == optim::Verdict::Certified);
  const double phase = latest.found.x[0];
  INFO(phase);
  CHECK(phase > 291);
  const BoundProblem bound(read_problem(on_shaft("", late + "4\n"), "f.toml"));
  const auto problem = bound.problem({});
  const auto& curve = problem.constraints[0].response.curve();
  for (double earlier = phase - 5; earlier < phase; earlier += 1) {
    CHECK(optim::extreme_of(*curve.trace(std::vector{earlier}), optim::Part::Highest).value <
          4 + 1e-6);
  }
  CHECK(optim::extreme_of(*curve.trace(std::vector{phase}), optim::Part::Highest).value ==
        Approx(4).epsilon(1e-7));
  CHECK(optim::check_derivatives(problem, std::vector{phase}).agrees);
}

TEST_CASE("a window over a segment on a shaft that cannot be is refused in words",
          "[windows][shaft]") {
  const auto refusal = [](const std::string& window, const char* response = "lead") {
    return complaint([&] {
      read_problem(on_shaft("", fmt::format("[responses.half]\nunit = 'mm'\nformula = '0.5 * "
                                            "a.displacement'\n[[constraints]]\nresponse = '{}'\n"
                                            "upper = 30\n{}\n",
                                            response, window)),
                   "f.toml");
    });
  };
  CHECK_THAT(refusal("over = 'rise'"),
             Contains("a segment has its cam's name and a dot before it") && Contains("'a.rise'"));
  CHECK_THAT(refusal("over = 'c.rise'"), Contains("there is no cam with segments 'c'"));
  CHECK_THAT(refusal("over = 'b.rize'"), Contains("there is no segment 'rize'"));
  CHECK_THAT(refusal("over = 'b.rise'", "half"), Contains("half does not depend on b"));
}

TEST_CASE("windows that cannot be are refused in words", "[windows]") {
  const auto refusal = [](const std::string& window, const char* response = "peak pressure_angle") {
    return complaint([&] {
      read_problem(
          cam(fmt::format("[[constraints]]\nresponse = '{}'\nupper = 30\n{}\n", response, window)),
          "f.toml");
    });
  };
  CHECK_THAT(refusal("over = 'rize'"), Contains("there is no segment 'rize'") && Contains("rise"));
  CHECK_THAT(refusal("over = 'rise'\nfrom = 3"), Contains("over already says where"));
  CHECK_THAT(refusal("from = 50\nto = 20"), Contains("is empty"));
  CHECK_THAT(refusal("from = 50\nto = 400"),
             Contains("400 deg is outside the cycle, 0 .. 360 deg"));
  CHECK_THAT(refusal("over = 'rise'", "cam_mass"), Contains("cam_mass is a number"));
}

}  // namespace camlaw::problems::windows_test
