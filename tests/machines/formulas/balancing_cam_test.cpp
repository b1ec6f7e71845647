// SPDX-License-Identifier: MIT
#include "machines/balancing_cam/balancing_cam.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/plain.h"

namespace camlaw::balancing_cam_test {
namespace {

constexpr double kPi = std::numbers::pi;
using namespace testing;

constexpr int kSteps = 7200;

template <class Wheel>
double torque_at(const GenevaDrive<Wheel>& drive, double phi) {
  return plain(drive.torque(drive.wheel(phi < plain(drive.engagement()), phi)));
}

/// The drive's torque integrated over the turn by the midpoint rule, its extremes, and those of its
/// integral less the mean.
template <class Wheel>
void check_surplus(const GenevaDrive<Wheel>& drive) {
  double sum = 0, peak = -1e9, work = 0, low = 1e9, high = -1e9;
  const double h = 2 * kPi / kSteps;
  for (int i = 0; i < kSteps; ++i) sum += h * torque_at(drive, (i + 0.5) * h);
  for (int i = 0; i < kSteps; ++i) {
    const double torque = torque_at(drive, (i + 0.5) * h);
    peak = std::max(peak, torque);
    work += h * (torque - sum / (2 * kPi));
    low = std::min(low, work), high = std::max(high, work);
    const double phi = (i + 1) * h;
    const double exact =
        plain(drive.surplus_work(drive.wheel(phi < plain(drive.engagement()), phi), phi));
    REQUIRE(exact == Approx(work).margin(1e-4 * peak));
  }
  const Surplus surplus = surplus_of(drive);
  CHECK(plain(drive.mean_torque()) == Approx(sum / (2 * kPi)).epsilon(1e-5));
  CHECK(plain(surplus.peak_torque) == Approx(peak).epsilon(1e-5));
  CHECK(plain(surplus.highest_work) == Approx(high).epsilon(1e-4));
  CHECK(plain(surplus.range) == Approx(high - low).epsilon(1e-4));
}

/// Section of an angle.
template <class Machine>
std::size_t section_at(const Machine& m, double phi) {
  return phi < plain(m.lift_off) ? 0 : phi < plain(m.engagement()) ? 1 : 2;
}

template <class Machine>
double greatest_residual(const Machine& machine) {
  const BalancedTurn turn(machine);
  double greatest = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double phi = 2 * kPi * i / kSteps;
    greatest =
        std::max(greatest, std::abs(plain(turn.residual_torque(section_at(machine, phi), phi))));
  }
  return greatest;
}

}  // namespace

TEST_CASE("torque, mean and surplus work of a Geneva drive are those of quadrature",
          "[balancing-cam]") {
  for (const double slots : {3.0, 4.0, 6.0, 8.0}) {
    for (const double inertia : {0.0, 0.3, 4.0}) {
      INFO(slots << " slots, " << inertia);
      const PlainNumbers numbers;
      check_surplus(GenevaDrive<PlanarGeneva>{{}, slots, 6, inertia, 40});
      check_surplus(GenevaDrive<SphericalGeneva>{{}, slots, 6, inertia, 40});
    }
  }
}

TEST_CASE("without inertia the peak is the Geneva's velocity ratio", "[balancing-cam]") {
  const PlainNumbers numbers;
  // M_f beta' at its greatest: lambda / (1 - lambda), and tan(pi / n).
  for (const double n : {4.0, 6.0}) {
    const double lambda = std::sin(kPi / n);
    CHECK(plain(surplus_of(GenevaDrive<PlanarGeneva>{{}, n, 6, 0, 40}).peak_torque) ==
          Approx(40 * lambda / (1 - lambda)).epsilon(1e-12));
    CHECK(plain(surplus_of(GenevaDrive<SphericalGeneva>{{}, n, 6, 0, 40}).peak_torque) ==
          Approx(40 * std::tan(kPi / n)).epsilon(1e-12));
  }
}

TEST_CASE("the law of displacement stores the surplus work in straight springs",
          "[balancing-cam]") {
  const PlainNumbers numbers;
  const PlanarBalancingCam machine;
  const BalancedTurn turn(machine);
  const double rate = plain(machine.packet_rate()) / plain(machine.springs);
  const double stroke = plain(machine.stroke(turn.surplus().range)), preload = stroke;  // psi = 1
  for (double phi = 0.05; phi < 6.2; phi += 0.37) {
    const std::size_t section = section_at(machine, phi);
    const auto a = turn.displacement(section, phi);
    const auto series = plain_derivatives(
        [&](const auto& x) {
          return BalancedTurn(PlanarBalancingCam()).displacement(section, x).s;
        },
        phi);
    CHECK(plain(a.ds) == Approx(series[1]).epsilon(1e-10).margin(1e-12));
    CHECK(plain(a.dds) == Approx(series[2]).epsilon(1e-9).margin(1e-10));
    const double energy =
        rate * stroke * (preload * plain(a.s) + 0.5 * stroke * plain(a.s) * plain(a.s));
    const double work =
        plain(machine.surplus_work(machine.wheel(machine.moves(section), phi), phi));
    CHECK(energy == Approx(plain(turn.surplus().highest_work) - work).epsilon(1e-10).margin(1e-12));
  }
}

TEST_CASE("with straight springs the driver sees its mean alone", "[balancing-cam]") {
  const PlainNumbers numbers;
  // A cone that is flat beside the thickness has a straight characteristic.
  SphericalBalancingCam machine;
  machine.cone_height = 0.01 * plain(machine.thickness);
  machine.springs = 200000;
  machine.moved_mass = 0;
  const BalancedTurn turn(machine);
  for (double phi = 0.05; phi < 6.2; phi += 0.37) {
    CHECK(plain(turn.residual_torque(section_at(machine, phi), phi)) ==
          Approx(plain(machine.mean_torque())).epsilon(2e-3));
  }
  CHECK(plain(turn.peak_torque()) / greatest_residual(machine) ==
        Approx(plain(turn.peak_torque()) / plain(machine.mean_torque())).epsilon(2e-3));
}

TEST_CASE("springs and cam take no work over a turn", "[balancing-cam]") {
  const PlainNumbers numbers;
  PlanarBalancingCam machine;
  machine.moved_mass = 3;
  machine.angular_speed = 9;  // not the speed that the cam is cut for
  const BalancedTurn turn(machine);
  double work = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double phi = 2 * kPi * (i + 0.5) / kSteps;
    const auto a = turn.displacement(section_at(machine, phi), phi);
    work += plain(turn.balancing_torque(a)) * 2 * kPi / kSteps;
  }
  CHECK(work == Approx(0).margin(1e-4 * plain(turn.surplus().range)));
}

TEST_CASE("twin cams halve the stroke and balance alike", "[balancing-cam]") {
  const PlainNumbers numbers;
  PlanarBalancingCam one, two;
  one.moved_mass = two.moved_mass = 0;
  two.cams = 2;
  const BalancedTurn a(one), b(two);
  for (const double phi : {0.2, 0.9, 1.8, 4.0}) {
    const std::size_t section = section_at(one, phi);
    CHECK(plain(b.roller(section, phi).s) == Approx(plain(a.roller(section, phi).s) / 2));
    CHECK(plain(b.spring_force(b.displacement(section, phi))) ==
          Approx(plain(a.spring_force(a.displacement(section, phi)))));
    CHECK(plain(b.residual_torque(section, phi)) == Approx(plain(a.residual_torque(section, phi))));
  }
}

TEST_CASE("rollers off the cam leave the torque of the drive", "[balancing-cam]") {
  const PlainNumbers numbers;
  PlanarBalancingCam machine;
  const double touching = greatest_residual(machine);
  machine.lift_off = 15 * kPi / 180;
  const double drive = torque_at(machine.drive(), plain(machine.lift_off));
  REQUIRE(drive > touching);
  CHECK(greatest_residual(machine) == Approx(drive).epsilon(0.01));
  machine.lift_off = plain(machine.engagement()) + 0.1;
  CHECK_FALSE(is_possible(machine));
}

TEST_CASE("the springs needed are those that reach their catalogue's deflection",
          "[balancing-cam]") {
  const PlainNumbers numbers;
  PlanarBalancingCam machine;
  const double range = plain(surplus_of(machine.designed()).range);
  for (const double psi : {0.6, 1.0, 4.0}) {
    machine.preload_ratio = psi;
    machine.springs = plain(machine.springs_needed(range));
    CHECK(plain(machine.deflection(range)) ==
          Approx(plain(machine.nominal_deflection())).epsilon(1e-12));
    // Equation (9): mean of the end forces times the stroke.
    const double stroke = plain(machine.stroke(range)),
                 c = plain(machine.packet_rate()) / plain(machine.springs);
    const double least = c * psi * stroke, most = c * (1 + psi) * stroke;
    CHECK((least + most) / 2 * stroke == Approx(range).epsilon(1e-12));
  }
}

}  // namespace camlaw::balancing_cam_test
