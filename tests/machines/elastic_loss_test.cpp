// SPDX-License-Identifier: MIT
// The speed at which an elastic follower leaves its cam, against a closed form, the rigid follower,
// an integration in time, and the force at speeds below and above.
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <numbers>

#include "machines/follower_train/resonances.h"
#include "machines/registry.h"
#include "tests/machines/system_fixture.h"

namespace camlaw::problems::elastic_loss_test {
namespace {

using testing::design_of, testing::response_of, testing::TestDesign;

constexpr double kTurn = 2 * std::numbers::pi;

const Mechanism& roller() { return find_mechanism("disc-cam-roller"); }

struct Follower {
  double mass = 0.8, frequency = 150, damping = 0.05, share = 1;  // kg, Hz
  double rate = 5, preload = 150;                                 // N/mm, N
};

constexpr double kStroke = 0.02;  // m, of the mechanism

TestDesign held_by(const Follower& f, const Member& motion,
                   const std::vector<std::string>& of_law = {},
                   const std::vector<std::string>& of_machine = {}) {
  TestDesign design = design_of(roller(), motion, of_law, of_machine);
  const auto set = [&](const char* name, double value) {
    const std::size_t parameter = roller().parameter(name);
    design.binding.constants[parameter] = value;
    for (std::size_t k = 0; k < design.binding.parameters.size(); ++k) {
      if (design.binding.parameters[k] == parameter) {
        design.x[design.binding.variables[k]] = value;
      }
    }
  };
  set("stroke", 1000 * kStroke);
  set("mass", f.mass);
  set("spring_rate", f.rate);
  set("spring_preload", f.preload);
  set("load", 0);
  set("train_stiffness", f.share * f.mass * std::pow(kTurn * f.frequency, 2) / 1000);
  set("train_damping", f.damping);
  set("end_share", f.share);
  return design;
}

optim::Function loss_of(const TestDesign& design) {
  return response_of(roller(), "elastic_loss_speed", design.binding).function();
}

Member harmonic() {
  return motion_program(
      {{.name = "rise", .angle = 180, .to = 1, .law = find_law("simple-harmonic")},
       {.name = "return", .angle = 180, .to = 0, .law = find_law("simple-harmonic")}},
      Matched::Acceleration);
}

Member dwells(const char* law, Matched matched = Matched::Velocity) {
  return motion_program({{.name = "rise", .angle = 100, .to = 1, .law = find_law(law)},
                         {.name = "high", .angle = 50, .to = 1, .rests = true},
                         {.name = "return", .angle = 90, .to = 0, .law = find_law(law)},
                         {.name = "low", .angle = 120, .to = 0, .rests = true}},
                        matched);
}

/// Least force of simple harmonic motion all round, s = (1 - cos phi) / 2: with
/// G = (1 + 2 i zeta r) / (1 - r^2 + 2 i zeta r), r = omega / omega_n, the end moves as G times the
/// cam, and the force is P + c h / 2 plus the real part of h / 2 Z exp(i phi).
double harmonic_force(const Follower& f, double omega) {
  const std::complex<double> i(0, 1);
  const double r = omega / (kTurn * f.frequency), c = 1000 * f.rate;
  const auto G = (1.0 + 2.0 * i * f.damping * r) / (1.0 - r * r + 2.0 * i * f.damping * r);
  const auto Z = f.mass * omega * omega * (1 - f.share + f.share * G) - c;
  return f.preload + c * kStroke / 2 - kStroke / 2 * std::abs(Z);
}

/// The first change of sign among close speeds, halved on, in rpm.
double harmonic_crossing(const Follower& f) {
  double low = 0, high = 0;
  const double step = 1e-4 * kTurn * f.frequency;
  while (harmonic_force(f, high) > 0) {
    low = high;
    high += step;
  }
  for (int k = 0; k < 60; ++k) {
    const double middle = (low + high) / 2;
    (harmonic_force(f, middle) > 0 ? low : high) = middle;
  }
  return low * 60 / kTurn;
}

/// The least of (U8), N, over the last of so many turns from rest, by Runge and Kutta.
double integrated_force(const Follower& f, const Law<double>& law, double rpm, int turns) {
  constexpr int kSteps = 36000;  // joints at whole degrees are ends of steps
  const double omega = rpm * kTurn / 60, by_time = omega / kTurn;
  const double W = kTurn * f.frequency / by_time, h = 1.0 / kSteps;
  const auto motion = [&](int step, double part) {
    const double x = (step + part) / kSteps;
    return law(x, part < 1 ? Side::Right : Side::Left);
  };
  double z = 0, v = 0, least = 1e9;
  for (int turn = 0; turn < turns; ++turn) {
    for (int step = 0; step < kSteps; ++step) {
      const Motion<double> begin = motion(step, 0), middle = motion(step, 0.5),
                           end = motion(step, 1);
      const auto bent = [&](double a, double at, double rate) {
        return -a - 2 * f.damping * W * rate - W * W * at;
      };
      if (turn == turns - 1) {
        const double end_a = -(2 * f.damping * W * v + W * W * z);
        const double inertia = (1 - f.share) * begin.a + f.share * end_a;
        least = std::min(least, f.preload + 1000 * f.rate * kStroke * begin.s +
                                    f.mass * kStroke * by_time * by_time * inertia);
      }
      const double k1 = v, l1 = bent(begin.a, z, v);
      const double k2 = v + h / 2 * l1, l2 = bent(middle.a, z + h / 2 * k1, k2);
      const double k3 = v + h / 2 * l2, l3 = bent(middle.a, z + h / 2 * k2, k3);
      const double k4 = v + h * l3, l4 = bent(end.a, z + h * k3, k4);
      z += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      v += h / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
    }
  }
  return least;
}

/// The least of the response elastic_force at a speed, N.
double least_force(const Follower& f, const Member& motion, double rpm) {
  TestDesign design = held_by(f, motion);
  design.binding.constants[roller().parameter("speed")] = rpm;
  const auto trace = response_of(roller(), "elastic_force", design.binding).curve().trace({});
  const auto values = trace->values(optim::even_places(0, 360, 3600));
  return *std::ranges::min_element(values);
}

}  // namespace

TEST_CASE("harmonic motion all round leaves the cam at the speed of its closed form",
          "[elastic-loss]") {
  const Follower cases[] = {
      {},
      {.share = 0.4},
      // Thrown off below its resonance, and held on again far above it.
      {.frequency = 6, .damping = 0.3, .rate = 2, .preload = 20},
      {.frequency = 12, .damping = 0.1, .share = 0.7, .rate = 0, .preload = 30},
      {.damping = 0.6, .rate = 20, .preload = 10}};
  for (const Follower& f : cases) {
    INFO(f.frequency << " Hz, " << f.damping);
    const TestDesign design = held_by(f, harmonic());
    const double expected = harmonic_crossing(f);
    const auto loss = loss_of(design);
    CHECK(loss.value({}) == Approx(expected).epsilon(1e-9));
    const auto bounds = loss.enclose({});
    CHECK((bounds.lower <= expected && expected <= bounds.upper));
    CHECK(bounds.upper - bounds.lower <= 3e-8 * expected);
  }
}

TEST_CASE("a very stiff train leaves the cam where the rigid follower does", "[elastic-loss]") {
  const Member motion = dwells("poly-5-6-7-8-9", Matched::Acceleration);
  const TestDesign rigid = held_by({}, motion);
  const double limit =
      response_of(roller(), "contact_loss_speed", rigid.binding).function().value({});
  double before = 1;
  for (const double frequency : {250.0, 500.0, 1000.0, 2000.0}) {
    INFO(frequency);
    const double found = loss_of(held_by({.frequency = frequency}, motion)).value({});
    const double off = std::abs(found / limit - 1);
    CHECK(off < 0.5 * before);
    before = off;
  }
  CHECK(before < 1e-3);
}

TEST_CASE("integrated in time a follower holds just below the speed and leaves just above",
          "[elastic-loss]") {
  for (const char* law : {"modified-sine", "cycloidal"}) {
    const Follower f{.frequency = 60, .damping = 0.08, .share = 0.8};
    const Member motion = dwells(law);
    const double found = loss_of(held_by(f, motion)).value({});
    INFO(law << " " << found);
    CHECK(integrated_force(f, motion.law(), found * 0.9995, 8) > 0);
    CHECK(integrated_force(f, motion.law(), found * 1.0005, 8) < 0);
    for (double rpm = 0.3 * found; rpm < 0.99 * found; rpm += 0.06 * found) {
      INFO(rpm);
      CHECK(integrated_force(f, motion.law(), rpm, 8) > 0);
    }
  }
}

TEST_CASE("the first of several speeds at which a follower leaves its cam is found and proved",
          "[elastic-loss]") {
  // A resonance throws it off, and between it and the next it holds again.
  const Follower f{.frequency = 40, .damping = 0.01, .rate = 1, .preload = 12};
  const Member motion = dwells("cycloidal");
  const auto loss = loss_of(held_by(f, motion));
  const double found = loss.value({});
  double first = 0, again = 0;
  for (double rpm = 60; rpm < 200; rpm += 0.25) {
    const bool holds = least_force(f, motion, rpm) > 0;
    if (!holds && first == 0) first = rpm;
    if (holds && first > 0 && again == 0) again = rpm;
  }
  INFO(found << " " << again);
  CHECK(first - 0.25 <= found);
  CHECK(found <= first + 1e-3);
  CHECK(again > first);
  const auto bounds = loss.enclose({});
  CHECK((bounds.lower <= found && found <= bounds.upper));
  CHECK(bounds.upper - bounds.lower <= 3e-8 * found);
}

TEST_CASE("how much an elastic train's response bends with the speed is within its bound",
          "[elastic-loss]") {
  const std::complex<double> i(0, 1);
  for (const char* name : {"cycloidal", "modified-sine", "simple-harmonic", "parabolic"}) {
    INFO(name);
    const Member motion = dwells(name);
    const Law<double> law = motion.law();
    const double variation = acceleration_variation(motion.law<Interval>());
    constexpr int kPoints = 7200, kHarmonics = 300;
    std::vector<double> acceleration;
    double most = 0, known = std::abs(law(1.0, Side::Left).a - law(0.0, Side::Right).a);
    for (int p = 0; p < kPoints; ++p) {
      acceleration.push_back(law((p + 0.5) / kPoints).a);
      most = std::max(most, std::abs(acceleration.back()));
      if (p > 0) known += std::abs(acceleration[p] - acceleration[p - 1]);
    }
    CHECK(variation >= known);
    CHECK(variation <= 1.1 * known);
    std::vector<double> sizes{0};
    for (int k = 1; k <= kHarmonics; ++k) {
      std::complex<double> sum = 0;
      for (int p = 0; p < kPoints; ++p) {
        sum += acceleration[p] * std::exp(-i * (kTurn * k * (p + 0.5) / kPoints));
      }
      sizes.push_back(std::abs(sum) / kPoints);
      CHECK(sizes.back() <= std::min(most, variation / (kTurn * k)) + 1e-4 * most);
    }
    for (const double zeta : {0.002, 0.05, 0.6}) {
      const auto H = [&](double log_r) {
        const double r = std::exp(log_r);
        return (1.0 + 2.0 * i * zeta * r) / (1.0 - r * r + 2.0 * i * zeta * r);
      };
      for (const double ratio : {0.011, 0.02, 0.3, 1.7}) {
        const double slow = ratio, fast = 1.01 * ratio;
        const double bound = resonant_bend<double>({most, variation}, zeta, slow, fast);
        for (const double at : {slow, 1.004 * ratio, fast}) {
          double bend = 0;
          for (int k = 1; k <= kHarmonics; ++k) {
            const double h = 1e-4 * zeta, r = std::log(k * at);
            bend += 2 * sizes[k] * std::abs(H(r + h) - 2.0 * H(r) + H(r - h)) / (h * h);
          }
          CHECK(bend <= bound * (1 + 1e-3));
        }
        const auto exact = resonant_bend<Interval>({Interval(most), Interval(variation)},
                                                   Interval(zeta), Interval(slow), Interval(fast));
        CHECK(exact.lower() <= bound * (1 + 1e-9));
        CHECK(exact.upper() >= bound * (1 - 1e-9));
      }
    }
    // Where there are many periods in a turn it is far below what holds at any speed.
    CHECK(30 * resonant_bend<double>({most, variation}, 0.002, 0.02, 0.0201) <
          most * most_bend(0.002));
  }
}

TEST_CASE("the speed of contact loss has exact derivatives", "[elastic-loss]") {
  const TestDesign design = held_by({.share = 0.8}, dwells("modified-sine"), {"rise_angle"},
                                    {"mass", "stroke", "spring_rate", "spring_preload",
                                     "train_stiffness", "train_damping", "end_share"});
  testing::check_derivatives(loss_of(design), design.x, 2e-4, 2e-5, 1e-10);
  // The worst place is a joint, where the acceleration jumps.
  const TestDesign jumps = held_by(
      {.frequency = 400, .damping = 0.2, .rate = 2},
      motion_program({{.name = "rise", .angle = 90, .to = 1, .law = find_law("simple-harmonic")},
                      {.name = "high", .angle = 60, .to = 1, .rests = true},
                      {.name = "return", .angle = 70, .to = 0, .law = find_law("simple-harmonic")},
                      {.name = "low", .angle = 140, .to = 0, .rests = true}},
                     Matched::Velocity),
      {"rise_angle"}, {"spring_preload", "train_stiffness"});
  testing::check_derivatives(loss_of(jumps), jumps.x, 2e-4, 2e-5, 1e-10);
}

TEST_CASE("the shipped cam's follower leaves at the speed up to which it is said to hold",
          "[elastic-loss][problem-files]") {
  const auto bound = testing::shipped("cams/elastic_jump.toml");
  const ProblemStatement& statement = bound.statement();
  TestDesign design = design_of(*statement.mechanism, statement.laws.front(), {}, {});
  design.binding.constants = statement.constants;
  const auto speed = response_of(*statement.mechanism, "elastic_loss_speed", design.binding);
  CHECK(speed.function().value({}) == Approx(996.765).epsilon(1e-5));
}

TEST_CASE("where there is no speed of contact loss it is said why", "[elastic-loss]") {
  const auto none = [](const TestDesign& design, const char* why) {
    const auto loss = loss_of(design);
    CHECK(std::isnan(loss.value(design.x)));
    CHECK(std::isinf(loss.enclose(design.x).upper));
    CHECK_THAT(loss.why_undefined(design.x), Catch::Contains(why));
  };
  const Member motion = dwells("cycloidal");
  none(held_by({.frequency = 0}, motion), "train_stiffness is not stated");
  none(held_by({.damping = 0}, motion), "train_damping must be at least 0.002");
  none(held_by({.damping = 0.0019}, motion), "train_damping must be at least 0.002");
  none(held_by({.preload = 0}, motion), "neither spring nor load holds it at");
  none(held_by({.frequency = 1, .damping = 0.05, .preload = 2000}, motion),
       "it holds up to ten turns in a natural period");
  none(held_by({.frequency = 1e5}, motion), "as good as rigid");
  none(
      held_by({},
              motion_program(
                  {{.name = "rise", .angle = 180, .to = 1, .law = find_law("constant-velocity")},
                   {.name = "return", .angle = 180, .to = 0, .law = find_law("constant-velocity")}},
                  Matched::Displacement)),
      "velocity of the law jumps");
}

}  // namespace camlaw::problems::elastic_loss_test
