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

TEST_CASE("windows that cannot be are refused in words", "[windows]") {
  const auto refusal = [](const std::string& window, const char* response = "peak pressure_angle") {
    return complaint([&] {
      read_problem(
          cam(fmt::format("[[constraints]]\nresponse = '{}'\nupper = 30\n{}\n", response, window)),
          "f.toml");
    });
  };
  CHECK_THAT(refusal("over = 'rize'"), Contains("no segment is called 'rize'") && Contains("rise"));
  CHECK_THAT(refusal("over = 'rise'\nfrom = 3"), Contains("over already says where"));
  CHECK_THAT(refusal("from = 50\nto = 20"), Contains("is empty"));
  CHECK_THAT(refusal("from = 50\nto = 400"),
             Contains("400 deg is outside the cycle, 0 .. 360 deg"));
  CHECK_THAT(refusal("over = 'rise'", "cam_mass"), Contains("cam_mass is a number"));
}

}  // namespace camlaw::problems::windows_test
