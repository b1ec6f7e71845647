// SPDX-License-Identifier: MIT
#include "machines/balancing_cam/balancing_cam.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

namespace camlaw::balancing_cam_test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kSteps = 7200;

template <template <class> class Wheel>
double torque_at(const GenevaDrive<double, Wheel>& drive, double phi) {
  return drive.torque(drive.wheel(phi < drive.engagement(), phi));
}

/// The drive's torque integrated over the turn by the midpoint rule, its extremes, and those of its
/// integral less the mean.
template <template <class> class Wheel>
void check_surplus(const GenevaDrive<double, Wheel>& drive) {
  double sum = 0, peak = -1e9, work = 0, low = 1e9, high = -1e9;
  const double h = 2 * kPi / kSteps;
  for (int i = 0; i < kSteps; ++i) sum += h * torque_at(drive, (i + 0.5) * h);
  for (int i = 0; i < kSteps; ++i) {
    const double torque = torque_at(drive, (i + 0.5) * h);
    peak = std::max(peak, torque);
    work += h * (torque - sum / (2 * kPi));
    low = std::min(low, work), high = std::max(high, work);
    const double phi = (i + 1) * h;
    const double exact = drive.surplus_work(drive.wheel(phi < drive.engagement(), phi), phi);
    REQUIRE(exact == Approx(work).margin(1e-4 * peak));
  }
  const Surplus<double> surplus = surplus_of(drive);
  CHECK(drive.mean_torque() == Approx(sum / (2 * kPi)).epsilon(1e-5));
  CHECK(surplus.peak_torque == Approx(peak).epsilon(1e-5));
  CHECK(surplus.highest_work == Approx(high).epsilon(1e-4));
  CHECK(surplus.range == Approx(high - low).epsilon(1e-4));
}

/// Section of an angle.
template <class Machine>
std::size_t section_at(const Machine& m, double phi) {
  return phi < m.lift_off ? 0 : phi < m.engagement() ? 1 : 2;
}

template <class Machine>
double greatest_residual(const Machine& machine) {
  const BalancedTurn turn(machine);
  double greatest = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double phi = 2 * kPi * i / kSteps;
    greatest = std::max(greatest, std::abs(turn.residual_torque(section_at(machine, phi), phi)));
  }
  return greatest;
}

}  // namespace

TEST_CASE("torque, mean and surplus work of a Geneva drive are those of quadrature",
          "[balancing-cam]") {
  for (const double slots : {3.0, 4.0, 6.0, 8.0}) {
    for (const double inertia : {0.0, 0.3, 4.0}) {
      INFO(slots << " slots, " << inertia);
      check_surplus(GenevaDrive<double, PlanarGeneva>{{}, slots, 6, inertia, 40});
      check_surplus(GenevaDrive<double, SphericalGeneva>{{}, slots, 6, inertia, 40});
    }
  }
}

TEST_CASE("without inertia the peak is the Geneva's velocity ratio", "[balancing-cam]") {
  // M_f beta' at its greatest: lambda / (1 - lambda), and tan(pi / n).
  for (const double n : {4.0, 6.0}) {
    const double lambda = std::sin(kPi / n);
    CHECK(surplus_of(GenevaDrive<double, PlanarGeneva>{{}, n, 6, 0, 40}).peak_torque ==
          Approx(40 * lambda / (1 - lambda)).epsilon(1e-12));
    CHECK(surplus_of(GenevaDrive<double, SphericalGeneva>{{}, n, 6, 0, 40}).peak_torque ==
          Approx(40 * std::tan(kPi / n)).epsilon(1e-12));
  }
}

TEST_CASE("the law of displacement stores the surplus work in straight springs",
          "[balancing-cam]") {
  const PlanarBalancingCam<double> machine;
  const BalancedTurn turn(machine);
  const double rate = machine.packet_rate() / machine.springs;
  const double stroke = machine.stroke(turn.surplus().range), preload = stroke;  // psi = 1
  for (double phi = 0.05; phi < 6.2; phi += 0.37) {
    const std::size_t section = section_at(machine, phi);
    const auto a = turn.displacement(section, phi);
    const auto series = turn.displacement(section, Series<double, 3>::variable(phi, 1)).s;
    CHECK(a.ds == Approx(series.c[1]).epsilon(1e-10).margin(1e-12));
    CHECK(a.dds == Approx(2 * series.c[2]).epsilon(1e-9).margin(1e-10));
    const double energy = rate * stroke * (preload * a.s + 0.5 * stroke * a.s * a.s);
    const double work = machine.surplus_work(machine.wheel(machine.moves(section), phi), phi);
    CHECK(energy == Approx(turn.surplus().highest_work - work).epsilon(1e-10).margin(1e-12));
  }
}

TEST_CASE("with straight springs the driver sees its mean alone", "[balancing-cam]") {
  // A cone that is flat beside the thickness has a straight characteristic.
  SphericalBalancingCam<double> machine;
  machine.cone_height = 0.01 * machine.thickness;
  machine.springs = 200000;
  machine.moved_mass = 0;
  const BalancedTurn turn(machine);
  for (double phi = 0.05; phi < 6.2; phi += 0.37) {
    CHECK(turn.residual_torque(section_at(machine, phi), phi) ==
          Approx(machine.mean_torque()).epsilon(2e-3));
  }
  CHECK(turn.peak_torque() / greatest_residual(machine) ==
        Approx(turn.peak_torque() / machine.mean_torque()).epsilon(2e-3));
}

TEST_CASE("springs and cam take no work over a turn", "[balancing-cam]") {
  PlanarBalancingCam<double> machine;
  machine.moved_mass = 3;
  machine.angular_speed = 9;  // not the speed that the cam is cut for
  const BalancedTurn turn(machine);
  double work = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double phi = 2 * kPi * (i + 0.5) / kSteps;
    const auto a = turn.displacement(section_at(machine, phi), phi);
    work += turn.balancing_torque(a) * 2 * kPi / kSteps;
  }
  CHECK(work == Approx(0).margin(1e-4 * turn.surplus().range));
}

TEST_CASE("twin cams halve the stroke and balance alike", "[balancing-cam]") {
  PlanarBalancingCam<double> one, two;
  one.moved_mass = two.moved_mass = 0;
  two.cams = 2;
  const BalancedTurn a(one), b(two);
  for (const double phi : {0.2, 0.9, 1.8, 4.0}) {
    const std::size_t section = section_at(one, phi);
    CHECK(b.roller(section, phi).s == Approx(a.roller(section, phi).s / 2));
    CHECK(b.spring_force(b.displacement(section, phi)) ==
          Approx(a.spring_force(a.displacement(section, phi))));
    CHECK(b.residual_torque(section, phi) == Approx(a.residual_torque(section, phi)));
  }
}

TEST_CASE("rollers off the cam leave the torque of the drive", "[balancing-cam]") {
  PlanarBalancingCam<double> machine;
  const double touching = greatest_residual(machine);
  machine.lift_off = 15 * kPi / 180;
  const double drive = torque_at(machine.drive(), machine.lift_off);
  REQUIRE(drive > touching);
  CHECK(greatest_residual(machine) == Approx(drive).epsilon(0.01));
  machine.lift_off = machine.engagement() + 0.1;
  CHECK_FALSE(is_possible(machine));
}

TEST_CASE("the springs needed are those that reach their catalogue's deflection",
          "[balancing-cam]") {
  PlanarBalancingCam<double> machine;
  const double range = surplus_of(machine.designed()).range;
  for (const double psi : {0.6, 1.0, 4.0}) {
    machine.preload_ratio = psi;
    machine.springs = machine.springs_needed(range);
    CHECK(machine.deflection(range) == Approx(machine.nominal_deflection()).epsilon(1e-12));
    // Equation (9): mean of the end forces times the stroke.
    const double stroke = machine.stroke(range), c = machine.packet_rate() / machine.springs;
    const double least = c * psi * stroke, most = c * (1 + psi) * stroke;
    CHECK((least + most) / 2 * stroke == Approx(range).epsilon(1e-12));
  }
}

}  // namespace camlaw::balancing_cam_test
