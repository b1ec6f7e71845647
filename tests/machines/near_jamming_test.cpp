// SPDX-License-Identifier: MIT
// Means over the turn of a follower that all but jams: its force has a narrow peak.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

#include "machines/registry.h"
#include "tests/machines/mechanism_fixture.h"

namespace camlaw::problems::near_jamming_test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kStroke = 0.03, kPrime = 0.048, kRoller = 0.008, kTurns = 200.0 / 60;  // SI units
constexpr double kMass = 1.2, kRate = 6000, kPreload = 200, kGuide = 0.06, kOverhang = 0.4;

/// At a place of a rise by the polynomial 3-4-5 over the whole turn, N m, N and turns of the
/// roller.
struct AtPlace {
  double torque, force, turns, fraction;
};

/// (M37) to (M39), (RB1), with the coefficient of friction.
AtPlace at(double x, double friction) {
  const double y = x * x, per_rad = 1 / (2 * kPi);
  const double s = kStroke * x * y * (10 - 15 * x + 6 * y);
  const double slope = kStroke * per_rad * y * (30 - 60 * x + 30 * y);
  const double bend = kStroke * per_rad * per_rad * x * (60 - 180 * x + 120 * y);
  const double omega = 2 * kPi * kTurns;
  const double force = kMass * omega * omega * bend + kRate * s + kPreload;
  const double tangent = slope / (kPrime + s);
  const double fraction = friction * (2 * (kOverhang - s) / kGuide + 1) * tangent;
  const double along = force / (1 - fraction);
  const double speed = std::hypot(kPrime + s, slope) / kRoller - 1;
  return {along * slope, along * std::hypot(1.0, tangent), speed, fraction};
}

/// Where the fraction is greatest, by golden sections.
double steepest() {
  const double ratio = (std::sqrt(5.0) - 1) / 2;
  double low = 0.1, high = 0.9;
  for (int i = 0; i < 100; ++i) {
    const double a = high - ratio * (high - low), b = low + ratio * (high - low);
    if (at(a, 1).fraction > at(b, 1).fraction) {
      high = b;
    } else {
      low = a;
    }
  }
  return std::midpoint(low, high);
}

/// The integral of f from 0 to 1 by Simpson's rule over u with x = middle + width sinh u: places
/// stand close where f has its peak.
double integral(const std::function<double(double)>& f, double middle, double width) {
  constexpr int kPieces = 40000;
  const double from = std::asinh(-middle / width), to = std::asinh((1 - middle) / width);
  double sum = 0;
  for (int i = 0; i <= kPieces; ++i) {
    const double u = from + (to - from) * i / kPieces;
    const double weight = i == 0 || i == kPieces ? 1 : i % 2 == 1 ? 4 : 2;
    sum += weight * f(middle + width * std::sinh(u)) * width * std::cosh(u);
  }
  return sum * (to - from) / (3 * kPieces);
}

testing::TestDesign near_jamming(const Mechanism& cam, double friction) {
  testing::TestDesign design =
      testing::design_of(cam, "poly-3-4-5", {}, {"base_radius", "spring_preload"});
  const auto set = [&](const char* name, double value) {
    design.binding.constants[cam.parameter(name)] = value;
  };
  set("stroke", 30), set("roller_radius", 8), set("speed", 200), set("mass", 1.2);
  set("spring_rate", 6), set("overhang", 400), set("guide_length", 60);
  set("guide_friction", friction), set("train_stiffness", 0);
  design.x = {200, 40};
  return design;
}

/// The fractions, from one that is harmless to one that no guide would be built for.
constexpr std::array kFractions{0.5, 0.9, 0.966, 0.99, 0.9965, 0.999, 0.9999};

}  // namespace

TEST_CASE("means over the turn keep their digits where a follower all but jams", "[cams]") {
  const Mechanism& cam = find_mechanism("disc-cam-roller");
  const double place = steepest();
  for (const double fraction : kFractions) {
    INFO(fraction);
    const double friction = fraction / at(place, 1).fraction;
    const double width = std::sqrt(1 - fraction);
    const auto mean = [&](const auto& f) {
      return integral([&](double x) { return f(at(x, friction)); }, place, width);
    };
    const testing::TestDesign design = near_jamming(cam, friction);
    const auto number = [&](const char* name) {
      return testing::response_of(cam, name, design.binding).function();
    };
    const double square = mean([](const AtPlace& p) { return p.torque * p.torque; });
    const double damage =
        mean([](const AtPlace& p) { return std::pow(p.force, 10.0 / 3) * p.turns; });
    const double turns = mean([](const AtPlace& p) { return p.turns; });
    CHECK(number("torque_rms").value(design.x) == Approx(std::sqrt(square)).epsilon(1e-11));
    const double load = std::pow(damage / turns, 0.3);
    CHECK(number("equivalent_load").value(design.x) == Approx(load).epsilon(1e-11));
    const double hours = 1e6 * std::pow(1e4, 10.0 / 3) / (damage * kTurns) / 3600;
    CHECK(number("life").value(design.x) == Approx(hours).epsilon(1e-10));
  }
}

TEST_CASE("the derivatives and bounds of means are those of their values near jamming", "[cams]") {
  const Mechanism& cam = find_mechanism("disc-cam-roller");
  for (const double fraction : kFractions) {
    INFO(fraction);
    const testing::TestDesign design = near_jamming(cam, fraction / at(steepest(), 1).fraction);
    for (const char* name : {"torque_rms", "equivalent_load", "life"}) {
      INFO(name);
      const auto f = testing::response_of(cam, name, design.binding).function();
      testing::check_derivatives(f, design.x, 1e-2 * (1 - fraction), 1e-6, 1e-12);
      const auto bounds = f.enclose(design.x);
      const double value = f.value(design.x), open = 1e-11 * value;
      CHECK((bounds.lower <= value + open && value - open <= bounds.upper));
      CHECK(bounds.upper - bounds.lower <= 1e-7 * value);
    }
  }
}

}  // namespace camlaw::problems::near_jamming_test
