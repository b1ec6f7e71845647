// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "kinematics/laws/build.h"
#include "kinematics/laws/catalogue.h"
#include "kinematics/laws/polynomial.h"
#include "kinematics/peaks.h"
#include "numerics/scalar/dual.h"

// Members at which an earlier peak search went wrong.

using namespace camlaw;

namespace {

template <class T>
std::array<T, 8> all_values(const Peaks<T>& p) {
  return {p.highest[0].value, p.highest[1].value, p.highest[2].value, p.highest[3].value,
          p.lowest[0].value,  p.lowest[1].value,  p.lowest[2].value,  p.lowest[3].value};
}

/// A member with its crossover seeded as the first dual direction.
Law<Dual> with_dual_crossover(const Member& member) {
  Arguments<Dual> arguments = member.arguments.as<Dual>();
  arguments.values()[member.family->parameter(kCrossover)][0].v[0] = 1;
  return member.family->make(arguments);
}

void check_dual_values(const std::string& name) {
  const Member member = find_law(name);
  const auto plain = all_values(peaks(member.law()));
  const auto dual = all_values(peaks(with_dual_crossover(member)));
  INFO(name);
  const double size[] = {plain[0], plain[1], plain[2], plain[3]};
  for (std::size_t i = 0; i < plain.size(); ++i) {
    if (std::isinf(plain[i])) {
      CHECK(dual[i].a == plain[i]);
    } else {
      CHECK(std::abs(dual[i].a - plain[i]) <= 1e-12 * std::max(1.0, std::abs(size[i % 4])));
    }
  }
}

}  // namespace

TEST_CASE("dual peaks have the values of plain ones at every crossover") {
  for (int percent = 4; percent <= 96; percent += 4) {
    for (const char* law : {"polynomial-5 alpha=-3", "cosine", "freudenstein-1-3",
                            "freudenstein-1-3-5", "poly-3-5-7", "modified-sine"}) {
      check_dual_values(std::string(law) + " crossover=" + std::to_string(percent / 100.0));
    }
  }
}

TEST_CASE("a flat-topped law's dual peak has the right derivative") {
  // C = C0 / (2 c) for the rise of a symmetric law, so dC/dc = -C / c.
  for (const double c : {0.06, 0.3, 0.71}) {
    const auto member = find_law("freudenstein-1-3 crossover=" + std::to_string(c));
    const auto up = peaks(with_dual_crossover(member)).high(Quantity::Acceleration).value;
    CHECK(up.v[0] == Approx(-up.a / c).epsilon(1e-9));
  }
}

TEST_CASE("short ramps are not jumps, in doubles and in intervals alike") {
  for (const char* name :
       {"trapezoidal-acceleration ramp=1e-6 constant=0.2",
        "trapezoidal-acceleration ramp=6.485357799564045e-06 constant=0.00195589",
        "scca a=1e-6 b=0.5 c=0.4"}) {
    INFO(name);
    const auto plain = peaks(find_law(name).law());
    const auto proof = peaks(find_law(name).law<Interval>());
    CHECK(std::isfinite(plain.max_jerk()));
    CHECK(std::isfinite(proof.max_jerk().upper()));
    CHECK(plain.max_jerk() == Approx(proof.max_jerk().upper()).epsilon(1e-6));
  }
}

TEST_CASE("a skewed half-ellipse keeps a finite dynamic moment") {
  for (int percent = 5; percent <= 95; percent += 3) {
    const auto name = "half-ellipse-velocity crossover=" + std::to_string(percent / 100.0);
    INFO(name);
    const double cm = peaks(find_law(name).law()).max_dynamic_moment();
    // v a = 32 / pi^2 at most, stretched by 1 / (2 c) on the shorter side.
    const double shorter = std::min(percent, 100 - percent) / 100.0;
    CHECK(cm == Approx(32 / (M_PI * M_PI) / (2 * shorter)).epsilon(1e-9));
  }
}

TEST_CASE("the crossover is continuous in the other parameters") {
  const auto c_of = [](const char* name) { return peaks(find_law(name).law()).max_acceleration(); };
  CHECK(c_of("trapezoidal-velocity t1=0.2 t2=0.2 crossover=0.3") ==
        Approx(c_of("trapezoidal-velocity t1=0.2 t2=0.2000000001 crossover=0.3")).epsilon(1e-8));
  CHECK(c_of("universal d1=0.1 d2=0.1 d3=0.1 d4=0.4 d5=0.1 d6=0.1 crossover=0.3") ==
        Approx(c_of("universal d1=0.100000000001 d2=0.1 d3=0.1 d4=0.4 d5=0.1 d6=0.1 crossover=0.3"))
            .epsilon(1e-8));
}

TEST_CASE("a break that rounding sets apart from the middle is the crossover") {
  for (const std::string name :
       {"scca a=0.7 b=0.2 c=0.1", "scca a=0.5 b=0.4 c=0.1", "scca a=0.6 b=0.3 c=0.1",
        "legendre c=0.1,0,0,0,0,0", "legendre c=0,0,0,0,0,0,0,0", "modified-sine"}) {
    const auto plain = peaks(find_law(name).law());
    for (int percent = 21; percent < 80; percent += 1) {
      const double at = percent / 100.0;
      INFO(name << " crossover=" << at);
      const auto moved = peaks(find_law(name + " crossover=" + std::to_string(at)).law());
      CHECK(moved.max_velocity() == Approx(plain.max_velocity()).epsilon(1e-12));
      CHECK(moved.max_acceleration() ==
            Approx(plain.max_acceleration() / (2 * std::min(at, 1 - at))).epsilon(1e-12));
    }
  }
}

TEST_CASE("a law of coefficients that are not finite is refused") {
  CHECK_THROWS_WITH(polynomial_law<double>({0, 0, 3, NAN}), Catch::Contains("not finite"));
  CHECK_THROWS_WITH(polynomial_law<double>({0, 0, 3, std::numeric_limits<double>::infinity()}),
                    Catch::Contains("not finite"));
  CHECK_THROWS_WITH(polynomial_law<Interval>({Interval::whole()}), Catch::Contains("not finite"));
}

TEST_CASE("Legendre laws of high order have close enclosures", "[heavy]") {
  for (const int terms : {8, 16, 40}) {
    std::string name = "legendre c=";
    for (int i = 0; i < terms; ++i) {
      name +=
          (i > 0 ? "," : "") + std::string(i % 2 == 0 ? "-" : "") + std::to_string(1.0 / (i + 2));
    }
    INFO(name);
    const auto plain = peaks(find_law(name).law());
    const auto proof = peaks(find_law(name).law<Interval>());
    for (const auto q : {Quantity::Velocity, Quantity::Acceleration}) {
      const Interval high = proof.high(q).value;
      CHECK(high.lower() <= plain.high(q).value * (1 + 1e-12));
      CHECK(high.upper() >= plain.high(q).value * (1 - 1e-12));
      CHECK(high.upper() - high.lower() <= 1e-9 * plain.high(q).value);
    }
  }
}

TEST_CASE("powers whose jerk grows without bound together have an infinite jerk") {
  const auto p = peaks(find_law("stoddart exponents=2.7,2.2").law());
  CHECK(p.jerk_inside_highest.value == std::numeric_limits<double>::infinity());
}

TEST_CASE("the largest size in intervals bounds both directions") {
  for (const char* name : {"poly-5-6-7-8-9", "cycloidal", "modified-sine crossover=0.4"}) {
    const auto p = peaks(find_law(name).law<Interval>());
    for (const auto q : {Quantity::Velocity, Quantity::Acceleration, Quantity::Moment}) {
      CHECK(p.absolute(q).value.upper() >= p.high(q).value.upper());
      CHECK(p.absolute(q).value.upper() >= -p.low(q).value.lower());
    }
  }
}

TEST_CASE("more derivatives than a curve gives are not a number") {
  CHECK(std::isnan(find_law("elliptic").law().derivatives<14>(0.3)[0]));
}
