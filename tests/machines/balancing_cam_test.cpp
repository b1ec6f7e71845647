// SPDX-License-Identifier: MIT
#include "machines/balancing_cam/balancing_cam.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "machines/registry.h"
#include "numerics/scalar/root.h"
#include "problems/published/systems.h"
#include "tests/machines/system_fixture.h"
#include "tests/plain.h"

namespace camlaw::problems::balancing_cam_test {
namespace {

using testing::plain, testing::PlainNumbers;

using testing::design_of, testing::response_of, testing::TestDesign;
constexpr double kPi = std::numbers::pi;

const Mechanism& balancing() { return find_mechanism("balancing-cam"); }

/// How many springs, their preload over the stroke, and their cone's height, m.
using Design = std::array<double, 3>;

/// A formula of a machine with these, and of what comes behind them.
template <class Machine, class F>
Formula recorded(std::size_t inputs, const F& formula) {
  return Formula::record(inputs, [&](std::span<const Expression> u) -> Expression {
    Machine machine;
    machine.springs = u[0], machine.preload_ratio = u[1], machine.cone_height = u[2];
    return formula(machine, u);
  });
}
double at(const Formula& formula, const Design& design) {
  return formula(std::span<const double>(design));
}

template <class Machine>
double deflection(const Design& design) {
  static const Formula formula = recorded<Machine>(3, [](const Machine& machine, const auto&) {
    return machine.deflection(surplus_of(machine.designed()).range);
  });
  return at(formula, design);
}

/// Greatest residual torque over a grid, and K with it.
template <class Machine>
double coefficient(const Design& design) {
  const auto touching = [](std::size_t section) {
    return recorded<Machine>(4, [section](const Machine& machine, const auto& u) {
      return BalancedTurn(machine).touching_torque(section, u[3]);
    });
  };
  static const Formula moving = touching(1), locked = touching(2);
  static const Formula peak = recorded<Machine>(
      3, [](const Machine& machine, const auto&) { return BalancedTurn(machine).peak_torque(); });
  static const Formula engagement = recorded<Machine>(
      3, [](const Machine& machine, const auto&) { return machine.engagement(); });
  const FormulaAlong<double> sections[] = {{moving, design}, {locked, design}};
  const double end = at(engagement, design);
  double greatest = 0;
  for (int i = 0; i < 7200; ++i) {
    const double phi = 2 * kPi * i / 7200;
    const double torque = sections[phi < end ? 0 : 1](std::span<const double>(&phi, 1));
    greatest = std::max(greatest, std::abs(torque));
  }
  return at(peak, design) / greatest;
}

/// Against one count of springs after the other, `least` the coefficient that is asked for.
template <class Machine>
void check_fewest(const char* file, int from, int to, double least) {
  INFO(file);
  const BoundProblem bound = testing::shipped(file);
  const auto optimum = optim::optimise(bound.space());
  CHECK(optimum.found.assessment.verdict == optim::Verdict::Certified);
  const PlainNumbers numbers;
  const double height = plain(Machine().cone_height);
  const auto works = [&](int springs) {
    // K grows with the preload here, and so does the deflection.
    const auto deflected = [&](double psi) {
      return deflection<Machine>({springs * 1.0, psi, height}) - 0.75 * height;
    };
    if (deflected(0.6) > 0) return false;
    const double psi = deflected(2) < 0 ? 2 : root_between(deflected, 0.6, 2);
    return coefficient<Machine>({springs * 1.0, psi, height}) >= least;
  };
  int springs = from;
  while (springs < to && !works(springs)) ++springs;
  CHECK(springs > from);
  CHECK(optimum.found.assessment.objective.value == springs);
}

}  // namespace

TEST_CASE("curves of the balancing cams have exact derivatives and bounds",
          "[balancing-cam][problem-files][heavy]") {
  for (const char* name : {"balancing-cam", "balancing-cam-spherical"}) {
    INFO(name);
    const Mechanism& mechanism = find_mechanism(name);
    TestDesign design =
        design_of(mechanism, "constant-velocity", {}, testing::all_parameters(mechanism));
    design.x[design.binding.variables[mechanism.parameter("lift_off")]] = 8;
    design.x[design.binding.variables[mechanism.parameter("speed")]] = 66;
    testing::check_curves(mechanism, design, {5.0, 33.0, 60.0, 88.0, 256.0});
  }
}

TEST_CASE("numbers of the balancing cam have exact derivatives", "[balancing-cam]") {
  const TestDesign design = design_of(
      balancing(), "constant-velocity", {},
      {"inertia", "friction", "design_speed", "preload_ratio", "cone_height", "thickness"});
  for (const auto& listed : balancing().responses) {
    if (!listed.number) continue;
    INFO(listed.name);
    const auto function = response_of(balancing(), listed.name, design.binding).function();
    // Small steps: with another design speed another peak soon is the greatest.
    testing::check_derivatives(function, design.x, 1e-4, 1e-5);
    const auto bounds = function.enclose(design.x);
    const double value = function.value(design.x);
    CHECK((bounds.lower <= value && value <= bounds.upper));
    CHECK(bounds.upper - bounds.lower <= 1e-8 * std::abs(value));
  }
}

TEST_CASE("the profile touches the roller and nothing of it lies deeper", "[balancing-cam]") {
  const TestDesign design = design_of(balancing(), "constant-velocity", {}, {});
  const auto x = response_of(balancing(), "profile_x", design.binding).curve().trace(design.x);
  const auto y = response_of(balancing(), "profile_y", design.binding).curve().trace(design.x);
  const PlainNumbers numbers;
  const PlanarBalancingCam machine;
  const BalancedTurn turn(machine);
  for (const double degrees : {10.0, 52.0, 80.0, 200.0}) {
    const double phi = degrees * kPi / 180;
    const double height =
        85 + 1e3 * plain(turn.roller(phi < plain(machine.engagement()) ? 1 : 2, phi).s);
    double nearest = 1e9;
    for (int i = 0; i < 36000; ++i) {
      const double at = i / 100.0;
      const double px = x->at({at})[0], py = y->at({at})[0];
      // The cam stands turned by phi; the roller on the frame's y axis.
      const double fx = px * std::cos(phi) - py * std::sin(phi);
      const double fy = px * std::sin(phi) + py * std::cos(phi);
      nearest = std::min(nearest, std::hypot(fx, fy - height));
    }
    CHECK(nearest == Approx(25).epsilon(1e-6));
  }
}

TEST_CASE("the fewest springs are those of a loop over all",
          "[balancing-cam][problem-files][heavy]") {
  check_fewest<PlanarBalancingCam>("balancing_cam/fewest_springs.toml", 40, 60, 9.1);
  check_fewest<SphericalBalancingCam>("balancing_cam/fewest_springs_spherical.toml", 25, 40, 3.7);
}

TEST_CASE("the least stress of the springs is that of a grid", "[balancing-cam][problem-files]") {
  const auto optimum = optim::optimise(testing::shipped("balancing_cam/least_stress.toml").space());
  CHECK(optimum.found.assessment.verdict == optim::Verdict::Certified);
  using Machine = PlanarBalancingCam;
  const Formula stress = recorded<Machine>(4, [](const Machine& machine, const auto& u) {
    return machine.spring().stress_lower_outer(u[3]);
  });
  double least = 1e18;
  for (int i = 0; i <= 70; ++i) {
    for (int k = 0; k <= 35; ++k) {
      const Design design{48, 0.6 + i / 50.0, (0.65 + k / 100.0) * 1e-3};
      const double f = deflection<Machine>(design);
      if (f > 0.75 * design[2] || coefficient<Machine>(design) < 9.1) continue;
      const std::array<double, 4> u{design[0], design[1], design[2], f};
      least = std::min(least, stress(std::span<const double>(u)) * 1e-6);
    }
  }
  CHECK(optimum.found.assessment.objective.value <= least * (1 + 1e-9));
  CHECK(optimum.found.assessment.objective.value == Approx(least).epsilon(0.01));
}

TEST_CASE("the printed coefficients name the loads that they would need", "[balancing-cam]") {
  const SystemReproduction result = find_reproducible("balancing-cam").reproduce(nullptr);
  REQUIRE(result.values.size() == 2);
  CHECK(result.unexplained == 2);
  // Planar, 6 slots: the ratio named gives 7.82 on a grid.
  const PlainNumbers numbers;
  const GenevaDrive<PlanarGeneva> drive{{}, 6, 1, 0.4553, 1};
  double greatest = 0;
  for (int i = 0; i <= 7200; ++i) {
    const double phi = plain(drive.engagement()) * i / 7200;
    greatest = std::max(greatest, plain(drive.torque(drive.wheel(true, phi))));
  }
  CHECK(greatest * 6 == Approx(7.82).epsilon(1e-4));
  const auto& causes = result.values[1].causes;
  CHECK(causes.front() == "loads: not stated");
  CHECK(std::any_of(causes.begin(), causes.end(), [](const auto& cause) {
    return cause.starts_with("inertia = 0.4553 kg m2 with slots=6");
  }));
}

}  // namespace camlaw::problems::balancing_cam_test
