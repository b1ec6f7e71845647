// SPDX-License-Identifier: MIT
#include "machines/follower_train/follower_train.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "kinematics/peaks.h"
#include "machines/follower_train/elastic_follower.h"
#include "machines/registry.h"
#include "optim/cycle/extremes.h"
#include "tests/machines/system_fixture.h"
#include "tests/plain.h"

namespace camlaw::problems::follower_train_test {
namespace {

using testing::plain, testing::PlainNumbers;

using testing::design_of, testing::response_of, testing::TestDesign;

const Mechanism& train() { return find_mechanism("follower-train"); }

/// Mass over the rise by Runge-Kutta of fourth order, in parts of the stroke and by x.
struct Integrated {
  double z, rate, peak;  ///< at the end; the greatest |y''|
};

Integrated integrated(const Law<double>& law, double tau, double zeta) {
  constexpr int kSteps = 20000;
  const double W = 2 * std::numbers::pi * tau, h = 1.0 / kSteps;
  double z = 0, v = 0, peak = 0;
  const auto bent = [&](double x, double at, double rate) {
    return -law(std::min(x, 1.0)).a - 2 * zeta * W * rate - W * W * at;
  };
  for (int i = 0; i < kSteps; ++i) {
    const double x = i * h;
    const double k1 = v, l1 = bent(x, z, v);
    const double k2 = v + h / 2 * l1, l2 = bent(x + h / 2, z + h / 2 * k1, k2);
    const double k3 = v + h / 2 * l2, l3 = bent(x + h / 2, z + h / 2 * k2, k3);
    const double k4 = v + h * l3, l4 = bent(x + h, z + h * k3, k4);
    z += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    v += h / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
    peak = std::max(peak, std::abs(2 * zeta * W * v + W * W * z));
  }
  return {z, v, peak};
}

}  // namespace

TEST_CASE("the train's numbers are those of a numerical integration", "[follower-train]") {
  for (const char* law : {"poly-3-4-5", "cycloidal", "modified-sine"}) {
    INFO(law);
    const TestDesign design = design_of(train(), law, {}, {});
    const PlainNumbers numbers;
    const ElasticFollower machine;
    const double time = plain(machine.rise_time());
    const auto value = [&](const char* name) {
      return response_of(train(), name, design.binding).function().value({});
    };
    CHECK(value("period_ratio") == Approx(0.05 * std::sqrt(1e5) / (2 * std::numbers::pi)));
    const Integrated end =
        integrated(find_law(law).law(), value("period_ratio"), plain(machine.damping_ratio));
    CHECK(value("residual_displacement") == Approx(20 * end.z).epsilon(1e-6).margin(1e-9));
    CHECK(value("residual_velocity") == Approx(0.02 / time * end.rate).epsilon(1e-6).margin(1e-9));
    const auto curve = response_of(train(), "mass_acceleration", design.binding);
    const auto peak = optim::extreme_of(*curve.curve().trace({}), optim::Part::Magnitude);
    CHECK(std::abs(peak.value) == Approx(0.02 / (time * time) * end.peak).epsilon(1e-6));
    const auto amplified = response_of(train(), "amplified_acceleration", design.binding);
    const auto over = optim::extreme_of(*amplified.curve().trace({}), optim::Part::Magnitude);
    CHECK(std::abs(over.value) ==
          Approx(end.peak / peaks(find_law(law).law()).max_acceleration()).epsilon(1e-6));
  }
}

TEST_CASE("numbers and curves of the train have exact derivatives and bounds", "[follower-train]") {
  const TestDesign design = design_of(train(), "legendre c=-3,1,-0.3", {"c"},
                                      {"mass", "stiffness", "damping_ratio", "stroke", "speed"});
  constexpr double kSame = 1e-10;  // what is left is a small difference of large numbers
  for (const auto& listed : train().responses) {
    if (!listed.number) continue;
    INFO(listed.name);
    const auto function = response_of(train(), listed.name, design.binding).function();
    testing::check_derivatives(function, design.x, 1e-3, 1e-6, kSame);
    const auto bounds = function.enclose(design.x);
    const double value = function.value(design.x);
    CHECK((bounds.lower <= value && value <= bounds.upper));
    CHECK(bounds.upper - bounds.lower <= 1e-7 * std::abs(value));
  }
  for (const char* name :
       {"deviation", "mass_displacement", "mass_acceleration", "amplified_acceleration"}) {
    INFO(name);
    const auto response = response_of(train(), name, design.binding);
    const auto trace = response.curve().trace(design.x);
    for (const double x : {0.13, 0.5, 0.77}) {
      testing::check_derivatives(response.curve().at({x}), design.x, 1e-4, 1e-6, kSame);
      const auto at = trace->at({x});
      CHECK(at[0] == Approx(response.curve().at({x}).value(design.x)).epsilon(1e-12));
      const auto value = [&](double by) { return trace->at({x + by})[0]; };
      CHECK(at[1] == Approx(testing::slope(value, 1e-4)).epsilon(1e-6));
      const auto rate = [&](double by) { return trace->at({x + by})[1]; };
      CHECK(at[2] == Approx(testing::slope(rate, 1e-4)).epsilon(1e-6));
      for (const double h : {1e-2, 1e-3, 1e-4}) {
        const auto bounds = trace->enclose(x - h, x + h);
        for (const double by : {-h, -0.4 * h, 0.0, 0.9 * h}) {
          CHECK((bounds.lower <= value(by) && value(by) <= bounds.upper));
        }
        // First order falls with h; what is bounded only as a whole with its square.
        CHECK(bounds.upper - bounds.lower <= 3 * h * std::abs(at[1]) + 1e6 * h * h);
      }
    }
  }
}

TEST_CASE("what no train can do is not a number", "[follower-train]") {
  // Drawn on its chord the law is not data: nothing is known of the train in closed form.
  const TestDesign design = design_of(train(), "inclined-sinusoid", {}, {});
  CHECK(
      std::isnan(response_of(train(), "residual_amplitude", design.binding).function().value({})));
  const TestDesign jump = design_of(train(), "constant-velocity", {}, {});
  CHECK(std::isnan(response_of(train(), "residual_amplitude", jump.binding).function().value({})));
  const auto curve = response_of(train(), "deviation", design.binding);
  CHECK(std::isnan(curve.curve().trace({})->at({0.5})[0]));
  CHECK(std::isinf(curve.curve().trace({})->enclose(0.4, 0.5).upper));
}

TEST_CASE("what is left over a range of speeds is what each speed leaves", "[follower-train]") {
  TestDesign design = design_of(train(), "cycloidal", {}, {});
  const auto set = [&](const char* name, double value) {
    design.binding.constants[train().parameter(name)] = value;
  };
  set("damping_ratio", 0);
  set("slowest_speed", 150);
  set("fastest_speed", 900);
  const double f = std::sqrt(200000 / 2.0) / (2 * std::numbers::pi);
  const auto curve = response_of(train(), "residual_over_speed", design.binding);
  const auto trace = curve.curve().trace({});
  CHECK(trace->breaks() == std::vector<double>{150, 900});
  for (const double rpm : {170.0, 333.0, 500.0, 870.0}) {
    INFO(rpm);
    const double tau = f * 60 / rpm / 4, pt = std::numbers::pi * tau;
    const double left = 20 * std::abs(std::sin(pt)) / (pt * std::abs(1 - tau * tau));
    CHECK(curve.curve().at({rpm}).value({}) == Approx(left).epsilon(1e-10));
    set("speed", rpm);
    CHECK(response_of(train(), "residual_amplitude", design.binding).function().value({}) ==
          Approx(left).epsilon(1e-10));
    const auto here = trace->at({rpm});
    CHECK(here[0] == Approx(left).epsilon(1e-10));
    const auto value = [&](double by) { return trace->at({rpm + by})[0]; };
    CHECK(here[1] == Approx(testing::slope(value, 0.05)).epsilon(1e-6));
    const auto rate = [&](double by) { return trace->at({rpm + by})[1]; };
    CHECK(here[2] == Approx(testing::slope(rate, 0.05)).epsilon(1e-6));
    double before = 0;
    for (const double h : {10.0, 1.0, 0.1}) {
      const auto bounds = trace->enclose(rpm - h, rpm + h);
      double highest = 0;
      for (const double by : {-h, -0.4 * h, 0.0, 0.9 * h, h}) {
        CHECK((bounds.lower <= value(by) && value(by) <= bounds.upper));
        highest = std::max(highest, value(by));
      }
      // The upper bound closes with the square.
      const double off = bounds.upper - highest - std::abs(here[1]) * h * 0.01;
      if (before > 0) CHECK(off <= 0.1 * before + 1e-12);
      before = std::abs(off);
    }
  }
  set("fastest_speed", 150);
  CHECK(std::isnan(
      response_of(train(), "residual_over_speed", design.binding).curve().trace({})->at({150})[0]));
  // By what the machine and the law have; at an end that varies, by that too.
  const TestDesign varied =
      design_of(train(), "legendre c=-3,1,-0.3", {"c"},
                {"mass", "stiffness", "damping_ratio", "stroke", "slowest_speed"});
  const auto moving = response_of(train(), "residual_over_speed", varied.binding);
  testing::check_derivatives(moving.curve().at({311}), varied.x, 1e-3, 1e-6, 1e-10);
  const auto end = moving.curve().tied({240}, varied.x);
  CHECK(end.joint == 0);
  testing::check_derivatives(moving.curve().at(end), varied.x, 1e-3, 1e-6, 1e-10);
}

TEST_CASE("no other law of the family is quieter over the range of speeds",
          "[follower-train][problem-files]") {
  const BoundProblem bound = testing::shipped("follower_train/quiet_over_speeds.toml");
  const auto optimum = optim::optimise(bound.space());
  const auto& assessment = optimum.found.assessment;
  CHECK(assessment.verdict == optim::Verdict::Certified);
  CHECK(assessment.global);
  const PlainNumbers numbers;
  ElasticFollower machine;
  machine.damping_ratio = 0.02;
  struct Looked {
    double left, peak;  // mm, m/s^2
  };
  const auto of = [&](const std::vector<double>& c) {
    Member member = find_law("legendre c=-3,0,0");
    member.arguments.values()[member.family->parameter("c")] = c;
    const Law<double> law = member.law();
    Looked looked{0, 0};
    for (int rpm = 240; rpm <= 360; rpm += 2) {
      const double tau = plain(machine.natural_frequency()) * 60 / rpm / 4;
      looked.left = std::max(looked.left, 20 * residual_vibration(law, tau, 0.02));
    }
    const double time = plain(machine.rise_time());
    looked.peak = 0.02 / (time * time) * integrated(law, plain(machine.period_ratio()), 0.02).peak;
    return looked;
  };
  const Looked best = of(optimum.found.x);
  CHECK(best.left == Approx(assessment.objective.value).epsilon(1e-3));
  CHECK(best.left <= assessment.objective.value * (1 + 1e-6));
  CHECK(best.peak <= 75 * (1 + 1e-6));
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 40; ++trial) {
    std::vector<double> c(optimum.found.x);
    const double size = std::pow(10.0, -trial % 4);
    for (double& value : c) value += size * normal(random);
    const Looked other = of(c);
    CHECK((other.peak > 75 * (1 - 1e-6) || other.left > best.left * (1 - 1e-3)));
  }
}

TEST_CASE("no other law of the family is quieter and softer", "[follower-train][problem-files]") {
  const BoundProblem bound = testing::shipped("follower_train/quiet_rise.toml");
  const auto optimum = optim::optimise(bound.space());
  const auto& assessment = optimum.found.assessment;
  CHECK(assessment.verdict == optim::Verdict::Certified);
  CHECK(assessment.global);
  const PlainNumbers numbers;
  ElasticFollower machine;
  machine.damping_ratio = 0.02;
  const double time = plain(machine.rise_time());
  struct Looked {
    double place, velocity, peak;  // mm, mm/s, m/s^2
  };
  const auto of = [&](const std::vector<double>& c) {
    Member member = find_law("legendre c=-3,0,0");
    member.arguments.values()[member.family->parameter("c")] = c;
    const Integrated end = integrated(member.law(), plain(machine.period_ratio()), 0.02);
    return Looked{20 * end.z, 20 * end.rate / time, 0.02 * end.peak / (time * time)};
  };
  const auto meets = [](const Looked& c, double slack) {
    return std::abs(c.place) <= 0.005 * (1 + slack) && std::abs(c.velocity) <= 1.5 * (1 + slack);
  };
  const Looked best = of(optimum.found.x);
  CHECK(meets(best, 1e-4));
  CHECK(best.peak == Approx(assessment.objective.value).epsilon(1e-6));
  // Steps of every size: none finds a better one that meets the limits.
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 80; ++trial) {
    std::vector<double> c(optimum.found.x);
    const double size = std::pow(10.0, -trial % 5);
    for (double& value : c) value += size * normal(random);
    const Looked other = of(c);
    CHECK((!meets(other, -1e-6) || other.peak > best.peak * (1 - 1e-6)));
  }
}

}  // namespace camlaw::problems::follower_train_test
