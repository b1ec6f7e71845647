// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>

#include "optim/problem/check_derivatives.h"
#include "tests/machines/mechanism_fixture.h"
#include "tests/problems/complaint.h"
#include "tests/problems/shaft_fixture.h"

/// Derivatives, proofs and refusals of what a shaft of several cams needs.
namespace camlaw::problems::shaft_numbers_test {

using namespace shaft_fixture;
using Catch::Contains, testing::complaint;

TEST_CASE("enclosures of the work and of the balancing lift hold what they are",
          "[shaft][shaft-torque]") {
  const ProblemStatement shaft = read(pair(kRubbing));
  for (const std::string name : {"surplus_work", "balancing_lift"}) {
    const auto trace = trace_of(shaft, name);
    for (const EnclosedPart& part : enclosed_parts(*trace, {1.0, 0.3, 0.01, 1e-5})) {
      const auto& [share, length, from, to, bounds, least, most] = part;
      INFO(name << " from " << from << " to " << to);
      constexpr double kOfSamples = 1e-12;  // which are rounded
      CHECK(bounds.lower <= least + kOfSamples);
      CHECK(bounds.upper >= most - kOfSamples);
      if (share <= 0.01) {
        CHECK(bounds.upper - bounds.lower <= most - least + 1e-7 + 0.1 * share * length * share);
      }
    }
  }
}

TEST_CASE("derivatives of the shaft's numbers agree with differences", "[shaft][shaft-torque]") {
  // The acceleration of the parabolic law jumps, and with it the torque, where breaks move.
  for (const std::string law : {"modified-sine", "parabolic"}) {
    for (const std::string rubbing : {"", "load = 40\nguide_friction = 0.2\n"}) {
      const Moving moved(moving(law, "spring_rate = 4\nspring_preload = 80\n" + rubbing));
      std::vector<std::string> names{"torque_rms"};
      if (!rubbing.empty()) names.push_back("mean_torque");  // else it is 0
      // Else the work is lowest where a dwell ends, and stays so on one side only.
      if (law == "modified-sine" || !rubbing.empty()) {
        names.insert(names.end(), {"energy_fluctuation", "flywheel_inertia", "balancing_stroke"});
      }
      for (const std::string& name : names) {
        INFO(law << " " << rubbing << " " << name);
        testing::check_derivatives(moved.response(name).function(), moved.x, 1e-4, 2e-5, 1e-9);
      }
    }
  }
}

TEST_CASE("derivatives hold where a formula of the angle decides otherwise",
          "[shaft][shaft-torque]") {
  const Moving moved(load("a", "size * max(sin(angle) - 0.01 * size / 1 J, 0)", "phase = 5\n") +
                     load("b", "size * max(cos(2 * angle), -0.3)") +
                     "[cams.a.variables.size]\nlower = 1\nupper = 50\nstart = 20\n"
                     "[cams.b.variables.phase]\nlower = 1\nupper = 300\nstart = 47\n"
                     "[variables.speed]\nlower = 50\nupper = 400\nstart = 200\n");
  for (const std::string name : {"mean_torque", "torque_rms", "energy_fluctuation"}) {
    INFO(name);
    testing::check_derivatives(moved.response(name).function(), moved.x, 1e-4, 2e-5, 1e-9);
  }
}

/// A number at one design with its derivatives by what it depends on, and what encloses it.
struct Slopes {
  double value;
  std::vector<double> first, second;
  optim::Bounds bounds;

  Slopes(const optim::Function& f, const std::vector<double>& x)
      : first(f.inputs().size(), -1),
        second(optim::packed_size(f.inputs().size()), -1),
        bounds(f.enclose(x)) {
    value = f.hessian(x, first, second);
  }
  double steepest() const { return *std::max_element(first.begin(), first.end()); }
};

void check_tip(const Slopes& tip) {
  REQUIRE(!tip.first.empty());
  CHECK(tip.value == 0);
  CHECK(tip.first == std::vector<double>(tip.first.size(), 0.0));
  CHECK(tip.second == std::vector<double>(tip.second.size(), 0.0));
  CHECK(tip.bounds.lower == 0);
  CHECK(tip.bounds.upper < 1e-150);
}

TEST_CASE("a torque that is 0 over the turn has a root mean square with slopes 0",
          "[shaft][shaft-torque]") {
  const std::string size = "size]\nlower = -5\nupper = 5\nstart = 0\n";
  const Moving moved(load("a", "size * sin(angle)", "phase = 0\n") +
                     load("b", "size * sin(2 * angle)", "phase = 0\n") + "[cams.a.variables." +
                     size + "[cams.b.variables." + size);
  const optim::Function rms = moved.response("torque_rms").function();
  check_tip(Slopes(rms, moved.x));
  // Beside the tip it is the cone sqrt((a^2 + b^2) / 2), however near.
  for (const double both : {1.0, 1e-9, 1e-100}) {
    const Slopes beside(rms, {both, both});
    INFO(both);
    CHECK(beside.value == Approx(both).epsilon(1e-13));
    CHECK(beside.steepest() == Approx(0.5).epsilon(1e-13));
    CHECK(beside.bounds.lower <= beside.value);
    CHECK(beside.bounds.upper >= beside.value);
  }
}

TEST_CASE("a machine that rests all round has a root mean square with slopes 0",
          "[cams][servo-axis]") {
  const auto resting = [](const std::string& machine, const std::string& rest) {
    return Moving("mechanism = '" + machine + "'\n" + rest +
                  "[[program.segments]]\nname = 'low'\nangle = 200\n"
                  "[[program.segments]]\nname = 'still_low'\n");
  };
  const Moving cam = resting("disc-cam-roller", "[variables.stroke]\nlower = 1\nupper = 50\n");
  for (const std::string name : {"torque_rms", "power_rms"}) {
    check_tip(Slopes(cam.response(name).function(), cam.x));
  }
  const Moving axis =
      resting("linear-servo-axis", "[variables.gear_ratio]\nlower = 1\nupper = 5\nstart = 2\n");
  for (const std::string name : {"torque_rms", "rms_utilisation"}) {
    check_tip(Slopes(axis.response(name).function(), axis.x));
  }
}

TEST_CASE("derivatives of the work and of the balancing lift agree with differences",
          "[shaft][shaft-torque]") {
  const Moving moved(moving("modified-sine", "spring_rate = 4\nspring_preload = 80\nload = 40\n"));
  for (const std::string name : {"surplus_work", "balancing_lift"}) {
    const optim::Response response = moved.response(name);
    CHECK(response.curve().breaks_move());
    const auto trace = response.curve().trace(moved.x);
    for (const double angle : {5.7, 63.1, 200.2, 290.5}) {
      INFO(name << " at " << angle);
      const optim::Function row = response.curve().at({angle});
      CHECK(row.value(moved.x) == Approx(trace->at({angle})[0]).epsilon(1e-9).margin(1e-9));
      testing::check_derivatives(row, moved.x, 1e-3, 1e-5, 1e-9);
      const std::vector<double> slopes = response.curve().slope_gradient({angle}, moved.x);
      for (std::size_t i = 0; i < slopes.size(); ++i) {
        const double difference = testing::slope(
            [&](double t) {
              std::vector<double> y = moved.x;
              y[i] += t;
              return response.curve().trace(y)->at({angle})[1];
            },
            1e-3);
        CHECK(slopes[i] == Approx(difference).epsilon(1e-5).margin(1e-6));
      }
    }
  }
}

TEST_CASE("a place of the work that is tied to a break goes with it", "[shaft][shaft-torque]") {
  const Moving moved(kSpeedOfShaft + slide("a", "parabolic", 100, kMassAlone) +
                     "[cams.a.variables.rise_angle]\nlower = 60\nupper = 130\nstart = 101\n");
  const optim::Response work = moved.response("surplus_work");
  const optim::Place place = work.curve().tied({101.0 / 2}, moved.x);
  REQUIRE(place.joint >= 0);
  std::vector<double> g(1);
  const optim::Function row = work.curve().at(place);
  row.gradient(moved.x, g);
  const double difference = testing::slope(
      [&](double t) {
        const std::vector<double> y{moved.x[0] + t};
        return work.curve().trace(y)->at({y[0] / 2})[0];
      },
      1e-3);
  CHECK(g[0] == Approx(difference).epsilon(1e-7));
}

TEST_CASE("limits on the shaft's numbers are proved to their last digits",
          "[shaft][shaft-torque]") {
  for (const std::string name : {"mean_torque", "torque_rms", "energy_fluctuation",
                                 "flywheel_inertia", "balancing_stroke", "balancing_force"}) {
    const double value = number_of(read(pair(kRubbing)), name);
    for (const double by : {-1e-6, 1e-6}) {
      const ProblemStatement stated =
          read(pair(kRubbing) + fmt::format("[[constraints]]\nresponse = '{}'\nupper = {:.17g}\n",
                                            name, value * (1 + by)));
      const optim::LimitReport report = standing(stated).front();
      INFO(name << " " << by);
      CHECK(report.met == (by > 0));
      CHECK(report.value == Approx(value).epsilon(1e-9));
      if (by > 0) CHECK(report.proved);
    }
  }
}

TEST_CASE("a motion that jumps has neither mean nor work", "[shaft][shaft-torque]") {
  const ProblemStatement shaft =
      read(kSpeedOfShaft + slide("a", "straight-line", 100, kMassAndSpring, "displacement") +
           slide("b", "cycloidal", 80, kMassAndSpring));
  for (const std::string name : {"mean_torque", "torque_rms", "energy_fluctuation",
                                 "flywheel_inertia", "balancing_stroke"}) {
    INFO(name);
    CHECK(std::isnan(number_of(shaft, name)));
  }
}

TEST_CASE("a cam without a drive torque leaves the shaft without one", "[shaft][shaft-torque]") {
  std::string other = load("b", "size * sin(angle)");
  other.replace(other.find("drive_torque"), std::string("drive_torque").size(), "brake_torque");
  const std::string text = kSpeedOfShaft + slide("a", "cycloidal", 90, kMassAlone) + other;
  CHECK_THAT(complaint(text + "[objective]\nminimize = 'torque_rms'\n"), Contains("torque_rms"));
  CHECK_THAT(complaint("[constants]\nspeed_fluctuation = 0.01\n" + other),
             Contains("speed_fluctuation"));
}

TEST_CASE("what the shaft accepts is checked", "[shaft][shaft-torque]") {
  const std::string cam = slide("a", "cycloidal", 90, kMassAlone);
  CHECK_THAT(complaint("[constants]\nspeed = 200\nspeed_fluctuation = 0\n" + cam),
             Contains("speed_fluctuation") && Contains("1e-06"));
  CHECK_THAT(complaint("[constants]\nspeed = 200\nbalancing_spring_rate = '5 N'\n" + cam),
             Contains("balancing_spring_rate"));
  CHECK_THAT(complaint(kSpeedOfShaft + cam +
                       "[responses.r]\nunit = 'mm'\nformula = '2 * balancing_lift'\n"),
             Contains("balancing_lift is a curve that is not computed by one formula"));
  const ProblemStatement held = read(
      kSpeedOfShaft + cam + "[responses.stored]\nunit = 'J'\nformula = '3 J + 2 * surplus_work'\n");
  CHECK(trace_of(held, "stored")->at({33})[0] ==
        Approx(3 + 2 * trace_of(held, "surplus_work")->at({33})[0]));
}

}  // namespace camlaw::problems::shaft_numbers_test
