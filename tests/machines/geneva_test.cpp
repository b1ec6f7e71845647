// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "machines/geneva/geneva_drive.h"
#include "machines/registry.h"
#include "tests/machines/system_fixture.h"
#include "tests/plain.h"

namespace camlaw::problems::geneva_test {
namespace {

using testing::plain, testing::PlainNumbers;

using testing::design_of, testing::response_of, testing::TestDesign;
constexpr double kPi = std::numbers::pi;

}  // namespace

TEST_CASE("numbers and curves of the Geneva drives have exact derivatives and bounds",
          "[geneva][problem-files]") {
  for (const char* name : {"geneva", "geneva-spherical"}) {
    INFO(name);
    const Mechanism& mechanism = find_mechanism(name);
    const TestDesign design =
        design_of(mechanism, "constant-velocity", {}, testing::all_parameters(mechanism));
    testing::check_numbers(mechanism, design);
    testing::check_curves(mechanism, design, {17.0, 60.0, 88.0, 141.0, 256.0, 349.0});
  }
}

TEST_CASE("a Geneva's curves break where the wheel is locked", "[geneva]") {
  const Mechanism& mechanism = find_mechanism("geneva");
  const TestDesign design = design_of(mechanism, "constant-velocity", {}, {"slots"});
  const optim::Response response = response_of(mechanism, "wheel_acceleration", design.binding);
  const optim::Curve& curve = response.curve();
  CHECK(curve.breaks_move());
  const auto trace = curve.trace(design.x);
  REQUIRE(trace->breaks() == std::vector<double>{0, trace->breaks()[1], 360});
  const double lock = trace->breaks()[1];
  CHECK(lock == Approx(120).epsilon(1e-14));  // 180 - 360 / 6
  const double omega = 2 * kPi;
  const double jump = -omega * omega * std::tan(kPi / 6);
  CHECK(trace->at({lock, true})[0] == Approx(jump).epsilon(1e-10));
  CHECK(trace->at({lock, false})[0] == 0);
  CHECK(curve.at({lock, true}).value(design.x) == Approx(jump).epsilon(1e-10));
  CHECK(curve.at({lock, false}).value(design.x) == 0);
  CHECK(trace->at({360, true})[0] == 0);
  const auto bounds = trace->enclose(lock - 1e-6, lock);
  CHECK((bounds.lower <= jump && jump <= bounds.upper && bounds.upper < 0));
  // More slots lock later: a place beyond the lock of 5 moves with 8.
  const auto at = curve.at({130});
  CHECK(at.value(std::vector{6.0}) == 0);
  CHECK(at.value(std::vector{8.0}) != 0);
}

TEST_CASE("the fastest Geneva is that of its known peaks", "[geneva][problem-files]") {
  const auto optimum = optim::optimise(testing::shipped("geneva/fastest.toml").space());
  CHECK(optimum.found.assessment.verdict == optim::Verdict::Certified);
  CHECK(optimum.found.assessment.global);
  // By hand over the slots: room 2 a (1 - cos(pi / n)), speed from the peak of beta'' on a grid.
  double best = 0;
  for (const double n : {4.0, 5.0, 6.0, 8.0}) {
    if (400 * (1 - std::cos(kPi / n)) < 45) continue;
    const PlainNumbers numbers;
    const PlanarGeneva geneva{n};
    double peak = 0;
    for (int i = 0; i <= 40000; ++i) {
      peak = std::max(
          peak, std::abs(plain(geneva.at(plain(geneva.half_engagement()) * i / 40000).second)));
    }
    best = std::max(best, std::sqrt(60 / peak) * 30 / kPi);
  }
  CHECK(optimum.found.assessment.objective.value == Approx(best).epsilon(1e-7));
}

TEST_CASE("the fastest spherical Geneva has the torque of its wheel's way",
          "[geneva][problem-files]") {
  const auto optimum = optim::optimise(testing::shipped("geneva/fastest_spherical.toml").space());
  CHECK(optimum.found.assessment.verdict == optim::Verdict::Certified);
  CHECK(optimum.found.assessment.global);
  // Power of friction and inertia over the speed, with differences of tan beta = tan(pi/n) sin
  // alpha.
  const double speed = optimum.found.assessment.objective.value * kPi / 30;
  const auto torque = [&](double slots) {
    const auto way = [&](double alpha) {
      return std::atan(std::tan(kPi / slots) * std::sin(alpha));
    };
    double greatest = 0;
    for (int i = 1; i < 20000; ++i) {
      const double alpha = kPi * (i / 20000.0 - 0.5), h = 1e-4;
      const double once = (way(alpha + h) - way(alpha - h)) / (2 * h);
      const double twice = (way(alpha + h) - 2 * way(alpha) + way(alpha - h)) / (h * h);
      greatest = std::max(greatest, std::abs((40 + 4 * speed * speed * twice) * once));
    }
    return greatest;
  };
  CHECK(torque(8) == Approx(150).epsilon(1e-6));
  for (const double fewer : {4.0, 5.0, 6.0}) CHECK(torque(fewer) > 150);
}

}  // namespace camlaw::problems::geneva_test
