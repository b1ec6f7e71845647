// SPDX-License-Identifier: MIT
#include "machines/signature_feeder.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

#include "machines/registry.h"
#include "tests/machines/system_fixture.h"
#include "tests/plain.h"

namespace camlaw::problems::signature_feeder_test {
namespace {

using testing::is_possible, testing::plain, testing::plain_derivatives, testing::PlainNumbers;

using testing::design_of, testing::response_of, testing::slope, testing::TestDesign;
constexpr double kPi = std::numbers::pi;
using Point = std::complex<double>;

const Mechanism& feeder() { return find_mechanism("signature-feeder"); }

/// The drive as points of the plane: O2 at 0, O1 at L, the crank's pin A nearest to O2 at phi = 0.
/// The guide's direction is the one from which A lies e to the left.
struct Drawn {
  Point pin;
  double guide, length;
};

Drawn drawn(const SignatureFeeder& m, double phi) {
  const Point pin = plain(m.centre_distance) - std::polar(plain(m.crank_radius), -phi);
  const double guide = std::arg(pin) - std::asin(plain(m.offset) / std::abs(pin));
  const Point along = pin * std::polar(1.0, -guide);
  REQUIRE(along.imag() == Approx(plain(m.offset)).margin(1e-14));
  return {pin, guide, along.real()};
}

/// Of a crank, an offset and a centre distance, in m; its formula is written once.
double peak_acceleration(double r1, double e, double distance) {
  static const Formula acceleration = Formula::record(4, [](std::span<const Expression> u) {
    SignatureFeeder m;
    m.crank_radius = u[1], m.offset = u[2], m.centre_distance = u[3];
    return m.drum_acceleration(u[0]);
  });
  double peak = 0;
  for (int i = 0; i < 3600; ++i) {
    const std::array<double, 4> u{2 * kPi * i / 3600, r1, e, distance};
    peak = std::max(peak, std::abs(acceleration(std::span<const double>(u))));
  }
  return peak;
}

}  // namespace

TEST_CASE("guide length and angle are those of the drawing", "[signature-feeder]") {
  const PlainNumbers numbers;
  const SignatureFeeder m;
  for (const double phi : {0.0, 0.4, 1.7, kPi, 4.4, 6.1}) {
    const Drawn d = drawn(m, phi), start = drawn(m, 0);
    CHECK(plain(m.guide_length(phi).value) == Approx(d.length).epsilon(1e-12));
    const double turned = start.guide - d.guide;
    CHECK(plain(m.guide_angle(phi).value) - plain(m.guide_angle(0.0).value) ==
          Approx(turned).epsilon(1e-11).margin(1e-13));
  }
}

TEST_CASE("derivatives by the crank's angle are those of the angle", "[signature-feeder]") {
  const PlainNumbers numbers;
  const auto printed = [] { return SignatureFeeder(); };
  const auto meshing = [] { return SignatureFeeder().meshing(); };
  for (const std::function<SignatureFeeder()>& make :
       {std::function(printed), std::function(meshing)}) {
    const SignatureFeeder m = make();
    for (const double phi : {0.0, 0.3, 1.0, 2.2, kPi, 4.0, 5.9}) {
      INFO(phi);
      const auto check = [&](const auto& of) {
        const auto at = of(m, phi);
        CHECK(plain(at.first) ==
              Approx(slope([&](double t) { return plain(of(m, phi + t).value); }, 1e-3))
                  .margin(1e-9));
        CHECK(plain(at.second) ==
              Approx(slope([&](double t) { return plain(of(m, phi + t).first); }, 1e-3))
                  .margin(1e-9));
        const auto exact =
            plain_derivatives([&](const auto& x) { return of(make(), x).value; }, phi);
        CHECK(plain(at.first) == Approx(exact[1]).epsilon(1e-12).margin(1e-12));
        CHECK(plain(at.second) == Approx(exact[2]).epsilon(1e-12).margin(1e-12));
      };
      check([](const auto& its, const auto& x) { return its.guide_length(x); });
      check([](const auto& its, const auto& x) { return its.guide_angle(x); });
      check([](const auto& its, const auto& x) { return its.rack_travel(x); });
      check([](const auto& its, const auto& x) { return its.drum_angle(x); });
      CHECK(plain(m.drum_velocity(phi)) ==
            Approx(plain(m.crank_speed) * plain(m.drum_angle(phi).first)));
      CHECK(plain(m.drum_acceleration(phi)) ==
            Approx(plain(m.crank_speed) * plain(m.crank_speed) * plain(m.drum_angle(phi).second)));
    }
  }
}

TEST_CASE("the cylinder follows the pin's velocity along the rack", "[signature-feeder]") {
  const PlainNumbers numbers;
  for (const double e : {0.0, 0.045, 0.052, 0.2}) {
    SignatureFeeder m;
    m.offset = e;
    double peak = 0;
    for (int i = 0; i < 3600; ++i) {
      const double phi = 2 * kPi * i / 3600;
      const Point velocity = Point(0, 1) * std::polar(plain(m.crank_radius), -phi);
      const double along = (velocity * std::polar(1.0, -drawn(m, phi).guide)).real();
      REQUIRE(plain(m.drum_angle(phi).first) ==
              Approx(along / plain(m.pinion_radius)).epsilon(1e-11).margin(1e-12));
      peak = std::max(peak, std::abs(plain(m.drum_angle(phi).first)));
    }
    CHECK(peak == Approx(plain(m.crank_radius) / plain(m.pinion_radius)).epsilon(1e-6));
  }
}

TEST_CASE("the meshing rack does not slip on the pinion, and the printed one does",
          "[signature-feeder]") {
  const PlainNumbers numbers;
  // The rack's point over O2, on its pitch line, has the velocity of the pinion's rim.
  const auto slip = [](const SignatureFeeder& m, double phi) {
    const auto pin = [&](double t) { return drawn(m, phi + t).pin; };
    const Point velocity(slope([&](double t) { return pin(t).real(); }, 1e-3),
                         slope([&](double t) { return pin(t).imag(); }, 1e-3));
    const double turning = slope([&](double t) { return drawn(m, phi + t).guide; }, 1e-3);
    const Drawn d = drawn(m, phi);
    const Point contact = plain(m.offset) * std::polar(1.0, d.guide + kPi / 2);
    const Point rack = velocity + Point(0, turning) * (contact - d.pin);
    const Point rim = Point(0, -plain(m.drum_angle(phi).first)) *
                      std::polar(plain(m.pinion_radius), d.guide + kPi / 2);
    return std::abs(rack - rim);
  };
  // In the guide the pinion turns by what the rack moves; outside by the guide's angle as well.
  const auto missed = [](const SignatureFeeder& m, double phi) {
    const double outside =
        plain(m.guide_length(phi).first) / plain(m.pinion_radius) + plain(m.guide_angle(phi).first);
    return std::abs(plain(m.drum_angle(phi).first) - outside);
  };
  for (const double phi : {0.3, 1.0, 2.2, 4.0, 5.9}) {
    CHECK(slip(SignatureFeeder{}.meshing(), phi) < 1e-9);
    CHECK(missed(SignatureFeeder{}.meshing(), phi) < 1e-13);
  }
  CHECK(missed(SignatureFeeder{}, 0.3) > 1e-3);
}

TEST_CASE("the cylinder swings by 2 r1 / r_p, and the guide between its common tangents",
          "[signature-feeder]") {
  const PlainNumbers numbers;
  for (const double e : {0.0, 0.045, 0.052, 0.2}) {
    SignatureFeeder m;
    m.offset = e;
    std::array<double, 2> drum{1e9, -1e9}, guide{1e9, -1e9};
    for (int i = 0; i < 36000; ++i) {
      const double phi = 2 * kPi * i / 36000;
      const double a = plain(m.drum_angle(phi).value), b = plain(m.guide_angle(phi).value);
      drum = {std::min(drum[0], a), std::max(drum[1], a)};
      guide = {std::min(guide[0], b), std::max(guide[1], b)};
    }
    CHECK(plain(m.drum_swing()) == Approx(drum[1] - drum[0]).epsilon(1e-7));
    CHECK(plain(m.guide_swing()) == Approx(guide[1] - guide[0]).epsilon(1e-7));
    CHECK(guide[0] == Approx(0).margin(1e-8));
    CHECK(plain(m.least_guide_length()) == Approx(plain(m.guide_length(0.0).value)).epsilon(1e-13));
    CHECK(plain(m.greatest_guide_length()) ==
          Approx(plain(m.guide_length(kPi).value)).epsilon(1e-13));
    CHECK(plain(m.rack_travel(0.0).value) == Approx(0).margin(1e-15));
  }
  CHECK(plain(SignatureFeeder{}.drum_swing()) == Approx(2 * 92.0 / 45));
}

TEST_CASE("a rack that leaves its guide is not a design", "[signature-feeder]") {
  const PlainNumbers numbers;
  SignatureFeeder m;
  CHECK(is_possible(m));
  m.offset = 0.6101;  // L - r1 = 0.610
  CHECK_FALSE(is_possible(m));
  m = {};
  m.crank_radius = 0.702;
  CHECK_FALSE(is_possible(m));
  m = {};
  m.pinion_radius = 0.6101;
  CHECK_FALSE(is_possible(m));
  const TestDesign design = design_of(feeder(), "constant-velocity", {}, {"offset"});
  const auto length = response_of(feeder(), "guide_length", design.binding);
  CHECK(std::isfinite(length.curve().at({10}).value(std::vector{600.0})));
  CHECK(std::isnan(length.curve().at({10}).value(std::vector{620.0})));
}

TEST_CASE("numbers and curves of the signature feeder have exact derivatives and bounds",
          "[signature-feeder]") {
  const PlainNumbers numbers;
  const TestDesign design =
      design_of(feeder(), "constant-velocity", {}, testing::all_parameters(feeder()));
  testing::check_numbers(feeder(), design);
  testing::check_curves(feeder(), design, {17.0, 88.0, 141.0, 256.0, 349.0});
  const SignatureFeeder m;
  const auto value = [&](const char* name, double angle) {
    return response_of(feeder(), name, design.binding).curve().at({angle}).value(design.x);
  };
  for (const double angle : {33.0, 210.0}) {
    const double phi = angle * kPi / 180;
    CHECK(value("drum_angle", angle) == Approx(plain(m.drum_angle(phi).value) * 180 / kPi));
    CHECK(value("drum_ratio", angle) == Approx(plain(m.drum_angle(phi).first)));
    CHECK(value("drum_ratio_slope", angle) == Approx(plain(m.drum_angle(phi).second)));
    CHECK(value("drum_acceleration", angle) == Approx(plain(m.drum_acceleration(phi))));
    CHECK(value("meshing_drum_acceleration", angle) ==
          Approx(plain(m.meshing().drum_acceleration(phi))));
    CHECK(value("rack_travel", angle) == Approx(plain(m.rack_travel(phi).value) * 1e3));
  }
}

TEST_CASE("the least acceleration of the feeder is that of a grid",
          "[signature-feeder][problem-files]") {
  const BoundProblem bound = testing::shipped("signature_feeder/least_acceleration.toml");
  const auto optimum = optim::optimise(bound.space());
  const auto& assessment = optimum.found.assessment;
  CHECK(assessment.verdict == optim::Verdict::Certified);
  // 2 r1 / r_p = 240 degrees; the guide's length gives the centre distance for each offset.
  const double radius = 0.045 * 240 * kPi / 180 / 2;
  const auto distance_for = [](double r1, double e, double reach) {
    return std::sqrt(reach * reach + e * e) - r1;
  };
  double offset = 0;
  const auto peak_at = [&](double e) {
    return peak_acceleration(radius, e, distance_for(radius, e, 0.8));
  };
  const double least = testing::grid_minimum(peak_at, 0.045, 0.2, 100, &offset);
  CHECK(offset == Approx(0.045));
  CHECK(assessment.objective.value == Approx(least).epsilon(1e-6));
  const ProblemStatement best = bound.at(optimum.options, optimum.found.x);
  CHECK(best.constants[feeder().parameter("crank_radius")] == Approx(radius * 1e3).epsilon(1e-7));
  CHECK(best.constants[feeder().parameter("offset")] == Approx(45).epsilon(1e-7));
  CHECK(best.constants[feeder().parameter("centre_distance")] ==
        Approx(1e3 * distance_for(radius, 0.045, 0.8)).epsilon(1e-6));
  for (const double r1 : {radius, radius * 1.02, radius * 1.1}) {
    for (const double reach : {0.7, 0.78, 0.8}) {
      for (const double e : {0.045, 0.05, 0.07, 0.1, 0.2}) {
        CHECK(peak_acceleration(r1, e, distance_for(r1, e, reach)) >= least * (1 - 1e-6));
      }
    }
  }
}

}  // namespace camlaw::problems::signature_feeder_test
