// SPDX-License-Identifier: MIT
// The table on an elastic train behind an index drive, whose motion does not return, against a
// Fourier series, an integration step by step, the follower train of one rise, a closed form of the
// torque and the rigid drive.
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <numbers>

#include "machines/registry.h"
#include "tests/machines/fourier_train.h"
#include "tests/machines/index_fixture.h"
#include "tests/machines/system_fixture.h"

namespace camlaw::problems::elastic_index_test {
namespace {

using namespace std::complex_literals;
using testing::design_of, testing::response_of, testing::TestDesign;

constexpr double kTurn = 2 * std::numbers::pi, kInertia = 0.6, kStation = 45;  // kg m2, deg
constexpr const char* kDrives[] = {"parallel-index-cam", "indexing-barrel", "globoidal-cam"};

/// A drive of 8 stations at 120 rpm, with a table on a train.
struct Table {
  const Mechanism& mechanism;
  TestDesign design;

  Table(const char* drive, const Member& motion, double tau, double zeta,
        const std::vector<std::string>& of_law = {},
        const std::vector<std::string>& of_machine = {})
      : mechanism(find_mechanism(drive)), design(design_of(mechanism, motion, of_law, of_machine)) {
    set("stations", 8);
    set("rollers", 8);
    set("speed", 120);
    set("inertia", kInertia);
    set("train_stiffness", kInertia * std::pow(kTurn * 2 * tau, 2) * std::numbers::pi / 180);
    set("train_damping", zeta);
  }
  void set(const char* name, double value) {
    const std::size_t parameter = mechanism.parameter(name);
    design.binding.constants[parameter] = value;
    for (std::size_t k = 0; k < design.binding.parameters.size(); ++k) {
      if (design.binding.parameters[k] == parameter) design.x[design.binding.variables[k]] = value;
    }
  }
  optim::Function function(const char* name) const {
    return response_of(mechanism, name, design.binding).function();
  }
  double number(const char* name) const { return function(name).value(design.x); }
  double at(const char* name, double angle) const {
    return response_of(mechanism, name, design.binding).curve().at({angle}).value(design.x);
  }
};

Member indexed(const char* law, double angle) {
  return motion_program({{.name = "index", .angle = angle, .to = 1, .law = find_law(law)},
                         {.name = "rest", .angle = 360 - angle, .to = 1, .rests = true}},
                        Matched::Velocity, 1);
}

/// Of a cycloidal index over the first part of a turn.
double fourier_z(double length, double tau, double x) {
  return testing::fourier_deviation(
      tau, x, [&](double k) { return testing::cycloidal_term(1, 0, length, k); });
}

/// z of a modified sine over a third of a turn, after so many turns from rest, by Runge and Kutta.
double integrated_z(const Law<double>& law, double tau, double zeta, int turns, double x) {
  constexpr int kSteps = 28800;  // its joints, eighths of the third, are ends of steps
  const double W = kTurn * tau, h = 1.0 / kSteps;
  double z = 0, v = 0;
  const auto bent = [&](double place, double at, double rate) {
    return -law(std::min(place, 1.0)).a - 2 * zeta * W * rate - W * W * at;
  };
  const int last = static_cast<int>(std::lround(x * kSteps));
  for (int step = 0; step < turns * kSteps + last; ++step) {
    const double begin = step % kSteps * h, middle = begin + h / 2, end = begin + h;
    const double k1 = v, l1 = bent(begin, z, v);
    const double k2 = v + h / 2 * l1, l2 = bent(middle, z + h / 2 * k1, k2);
    const double k3 = v + h / 2 * l2, l3 = bent(middle, z + h / 2 * k2, k3);
    const double k4 = v + h * l3, l4 = bent(end, z + h * k3, k4);
    z += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    v += h / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
  }
  return z;
}

}  // namespace

TEST_CASE("the undamped steady state behind an index drive is its Fourier series",
          "[elastic-end][index]") {
  for (const double tau : {0.4, 2.7, 9.3, 30.5}) {
    const Table table("globoidal-cam", indexed("cycloidal", 120), tau, 0);
    CHECK(table.number("train_frequency") == Approx(2 * tau).epsilon(1e-12));
    for (const double angle : {0.0, 17.0, 60.0, 119.0, 120.0, 214.0, 359.0, 360.0}) {
      INFO(tau << " at " << angle);
      const double z = fourier_z(1.0 / 3, tau, angle / 360);
      CHECK(table.at("end_deviation", angle) == Approx(kStation * z).epsilon(1e-8).margin(1e-9));
      const double pull = -std::pow(kTurn * 2 * tau, 2) * kTurn / 8 * z;
      CHECK(table.at("end_acceleration", angle) == Approx(pull).epsilon(1e-8).margin(1e-6));
      CHECK(table.at("train_torque", angle) == Approx(kInertia * pull).epsilon(1e-8).margin(1e-6));
    }
    // It has gone on by a station, and moves as a turn before.
    CHECK(table.at("end_displacement", 360) - table.at("end_displacement", 0) ==
          Approx(kStation).epsilon(1e-10));
  }
}

TEST_CASE("the damped steady state behind an index drive is that of an integration",
          "[elastic-end][index]") {
  const Member motion = indexed("modified-sine", 120);
  const Table table("indexing-barrel", motion, 7.3, 0.1);
  for (const double angle : {0.0, 30.0, 90.0, 120.0, 200.0, 290.0}) {
    const double z = integrated_z(motion.law(), 7.3, 0.1, 6, angle / 360);
    CHECK(table.at("end_deviation", angle) == Approx(kStation * z).epsilon(1e-7).margin(1e-8));
    CHECK(table.at("end_displacement", angle) ==
          Approx(kStation * (z + motion.law()(angle / 360).s)).epsilon(1e-7).margin(1e-8));
  }
}

TEST_CASE("what an index leaves in the dwell is what the follower train of its rise leaves",
          "[elastic-end][index]") {
  // So much damping that the dwell does not pass on what it began with.
  const Mechanism& alone = find_mechanism("follower-train");
  for (const char* law : {"modified-sine", "poly-4-5-6-7", "cycloidal"}) {
    TestDesign train = design_of(alone, law, {}, {});
    const auto set = [&](const char* name, double value) {
      train.binding.constants[alone.parameter(name)] = value;
    };
    set("mass", 1);
    set("stiffness", std::pow(kTurn * 42 * 5, 2) / 1000);
    set("damping_ratio", 0.4);
    set("rise_angle", 60);
    set("stroke", 20);
    const double left =
        response_of(alone, "residual_amplitude", train.binding).function().value({});
    CHECK(left > 1e-4);
    for (const char* drive : kDrives) {
      INFO(law << " " << drive);
      const Table table(drive, indexed(law, 60), 42, 0.4);
      CHECK(table.number("residual_amplitude") / kStation == Approx(left / 20).epsilon(1e-9));
    }
  }
}

TEST_CASE("the torque of an elastic table is the rigid one's, and its own inertia besides",
          "[elastic-end][index]") {
  for (const char* drive : kDrives) {
    INFO(drive);
    Table table(drive, indexed("poly-5-6-7-8-9", 140), 11, 0.03);
    table.set("end_share", 0.7);
    table.set("load_torque", 12);
    Table stiff(drive, indexed("poly-5-6-7-8-9", 140), 2000, 0.03);
    for (const double angle : {10.0, 55.0, 100.0, 150.0, 190.0, 230.0, 320.0}) {
      const double end = 0.7 * kInertia, a = table.at("end_acceleration", angle);
      CHECK(table.at("elastic_torque", angle) ==
            Approx(table.at("turret_torque", angle) + end * (a - table.at("acceleration", angle)))
                .epsilon(1e-10));
      CHECK(table.at("train_torque", angle) == Approx(end * a).epsilon(1e-10));
      CHECK(stiff.at("elastic_torque", angle) ==
            Approx(stiff.at("turret_torque", angle)).epsilon(1e-4).margin(1e-6));
    }
    // Friction opposes the motion, and is no part of it.
    const double before = table.at("elastic_torque", 55);
    table.set("friction_torque", 5);
    CHECK(table.at("elastic_torque", 55) == before);
  }
}

TEST_CASE("the load leaves the driving flank of an elastic drive at the speed of a closed form",
          "[elastic-end][index]") {
  // Two stations by a cycloid each, s = 2 x - sin(4 pi x) / (2 pi), in stations: with
  // r = 2 omega / omega_n and the end's transfer G the least torque is
  // M_L - J omega^2 |1 - kappa + kappa G| / 2.
  const Member motion =
      motion_program({{.name = "first", .angle = 180, .to = 1, .law = find_law("cycloidal")},
                      {.name = "second", .angle = 180, .to = 2, .law = find_law("cycloidal")}},
                     Matched::Acceleration, 2);
  struct Case {
    double load, share, zeta, hertz;
  };
  for (const Case& c : {Case{20, 1, 0.05, 30}, Case{90, 0.6, 0.1, 12}, Case{300, 0.8, 0.3, 8}}) {
    INFO(c.load);
    const auto least = [&](double omega) {
      const double r = 2 * omega / (kTurn * c.hertz);
      const auto G = (1.0 + 2i * c.zeta * r) / (1.0 - r * r + 2i * c.zeta * r);
      return c.load - kInertia * omega * omega / 2 * std::abs(1 - c.share + c.share * G);
    };
    double first = 1;
    while (least(first) > 0) first += 0.01;
    const double expected =
        testing::root([&](double omega) { return -least(omega); }, first - 0.01, first);
    // At 120 rpm tau natural periods in a turn.
    Table table("globoidal-cam", motion, c.hertz / 2 * std::sqrt(c.share), c.zeta);
    table.set("end_share", c.share);
    table.set("load_torque", c.load);
    REQUIRE(table.number("train_frequency") == Approx(c.hertz));
    CHECK(table.number("elastic_loss_speed") == Approx(expected * 60 / kTurn).epsilon(1e-8));
    const auto held = table.function("elastic_loss_speed").enclose(table.design.x);
    CHECK(held.lower < table.number("elastic_loss_speed"));
    CHECK(held.upper - held.lower < 1e-6 * held.upper);
  }
}

TEST_CASE("an elastic drive that nothing holds to one flank changes it at any speed",
          "[elastic-end][index]") {
  const Table free("globoidal-cam", indexed("modified-sine", 120), 11, 0.05);
  const auto loss = free.function("elastic_loss_speed");
  CHECK(std::isnan(loss.value(free.design.x)));
  CHECK_THAT(loss.why_undefined(free.design.x),
             Catch::Contains("neither spring nor load holds it"));
  Table rigid("globoidal-cam", indexed("modified-sine", 120), 11, 0.05);
  rigid.set("load_torque", 10);
  rigid.set("train_stiffness", 0);
  CHECK_THAT(rigid.function("elastic_loss_speed").why_undefined(rigid.design.x),
             Catch::Contains("turret_torque"));
  CHECK(std::isnan(rigid.number("residual_amplitude")));
}

TEST_CASE("what an elastic table does has exact derivatives and bounds", "[elastic-end][index]") {
  const Table table(
      "globoidal-cam", indexed("modified-sine", 120), 11, 0.05, {"index_angle"},
      {"speed", "inertia", "load_torque", "train_stiffness", "train_damping", "end_share"});
  std::vector<double> x = table.design.x;
  const Binding& binding = table.design.binding;
  for (std::size_t k = 0; k < binding.parameters.size(); ++k) {
    const bool is_share = binding.parameters[k] == table.mechanism.parameter("end_share");
    if (is_share) x[binding.variables[k]] = 0.8;
  }
  testing::check_derivatives(table.function("residual_amplitude"), x, 1e-4, 1e-5, 1e-10);
  for (const char* name : {"end_displacement", "end_deviation", "end_acceleration", "train_torque",
                           "elastic_torque"}) {
    INFO(name);
    const auto response = response_of(table.mechanism, name, binding);
    const auto trace = response.curve().trace(x);
    for (const double place : {33.0, 97.0, 200.0, 333.0}) {
      testing::check_derivatives(response.curve().at({place}), x, 1e-4, 1e-5, 1e-10);
      const auto bounds = trace->enclose(place - 0.1, place + 0.1);
      for (const double by : {-0.1, 0.0, 0.07}) {
        const double value = trace->at({place + by})[0];
        CHECK((bounds.lower <= value && value <= bounds.upper));
      }
    }
  }
}

TEST_CASE("a polydyne motion of an index drive moves the table as wanted", "[elastic-end][index]") {
  const auto text = [](const char* more) {
    return std::string(
               "mechanism = 'globoidal-cam'\n[constants]\nstations = 8\nrollers = 8\n"
               "axis_distance = '220 mm'\nturret_radius = '100 mm'\nspeed = '120 rpm'\n"
               "inertia = '0.6 kg m2'\ntrain_stiffness = '60 N m/deg'\ntrain_damping = 0.05\n"
               "[program]\n") +
           more +
           "segments = [{name = 'dwell', angle = 100}, {name = 'index', angle = 150, law = "
           "'poly-5-6-7-8-9'}, {name = 'rest'}]\n";
  };
  const auto of = [](const std::string& problem) {
    return testing::Curves(read_problem(problem, "table.toml"), 400);
  };
  const auto wanted = of(text("")),
             made = of(text("polydyne = '120 rpm'\npolydyne_damping = 0.05\n"));
  double apart = 0;
  for (std::size_t i = 0; i < wanted["displacement"].size(); ++i) {
    CHECK(made["end_displacement"][i] == Approx(wanted["displacement"][i]).margin(1e-8));
    apart = std::max(apart, std::abs(made["displacement"][i] - wanted["displacement"][i]));
  }
  CHECK(apart > 1e-3);
}

}  // namespace camlaw::problems::elastic_index_test
