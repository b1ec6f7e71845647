// SPDX-License-Identifier: MIT
#include "machines/follower_train/follower_train.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "kinematics/laws/catalogue.h"
#include "numerics/scalar/dual.h"

namespace camlaw::follower_train_test {
namespace {

double residual(const std::string& law, double tau, double zeta = 0) {
  return residual_vibration(find_law(law).law(), tau, zeta);
}

/// The equation of motion by Runge and Kutta's fourth-order steps, piece by piece.
TrainState<double> integrated(const Law<double>& law, double tau, double zeta) {
  const double W = 2 * std::numbers::pi * tau;
  double z = 0, rate = 0;
  for (const auto& piece : law.pieces()) {
    constexpr int kSteps = 20000;
    const double h = (piece.end - piece.begin) / kSteps;
    const auto force = [&](double x) { return derivatives<3>(piece, x)[2]; };
    const auto slope = [&](double x, double q, double p) {
      return std::pair{p, -2 * zeta * W * p - W * W * q - force(x)};
    };
    for (int i = 0; i < kSteps; ++i) {
      const double x = piece.begin + i * h;
      const auto [a1, b1] = slope(x, z, rate);
      const auto [a2, b2] = slope(x + h / 2, z + h / 2 * a1, rate + h / 2 * b1);
      const auto [a3, b3] = slope(x + h / 2, z + h / 2 * a2, rate + h / 2 * b2);
      const auto [a4, b4] = slope(x + h, z + h * a3, rate + h * b3);
      z += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
      rate += h / 6 * (b1 + 2 * b2 + 2 * b3 + b4);
    }
  }
  return {z, rate};
}

}  // namespace

TEST_CASE("the cycloid leaves no vibration at whole period ratios from 2", "[dynamics]") {
  for (const double tau : {2.0, 3.0, 4.0, 7.0, 20.0}) {
    CHECK(residual("cycloidal", tau) == Approx(0).margin(1e-12));
    CHECK(residual("cycloidal", tau + 0.5) > 1e-5);
  }
  // In closed form: |sin(pi tau)| / (pi tau |1 - tau^2|) of the stroke.
  for (const double tau : {0.3, 0.77, 1.4, 2.6, 5.3}) {
    const double pt = std::numbers::pi * tau;
    const double expected = std::abs(std::sin(pt)) / (pt * std::abs(1 - tau * tau));
    CHECK(residual("cycloidal", tau) == Approx(expected).epsilon(1e-10));
  }
}

TEST_CASE("the cosine leaves no vibration at 1.5, 2.5, ...", "[dynamics]") {
  for (const double tau : {1.5, 2.5, 3.5, 9.5}) {
    CHECK(residual("cosine", tau) == Approx(0).margin(1e-12));
    CHECK(residual("cosine", tau + 0.5) > 1e-3);
  }
}

TEST_CASE("resonance of a harmonic with the train is finite", "[dynamics]") {
  // The limit of the closed form: pi / (2 pi).
  const double near = residual("cycloidal", 1 + 1e-9), at = residual("cycloidal", 1);
  CHECK(at == Approx(near).epsilon(1e-7));
  CHECK(at == Approx(0.5).epsilon(1e-12));
}

TEST_CASE("the closed form agrees with integration step by step", "[dynamics]") {
  for (const char* name : {"cycloidal", "modified-sine", "poly-3-4-5", "poly-4-5-6-7", "parabolic",
                           "modified-trapezoid", "gutman-1-3", "legendre c=-1.8,0.2",
                           "b-spline degree=3 knots=0.3,0.6 coefficients=0,0,0.3,0.7,1,1"}) {
    const Law<double> law = find_law(name).law();
    for (const double tau : {0.05, 0.8, 1.0, 2.3, 6.1, 14.7}) {
      for (const double zeta : {0.0, 0.03, 0.4}) {
        INFO(name << ", " << tau << ", " << zeta);
        const auto exact = FollowerTrain<double>{tau, zeta}.after(law).value();
        const auto steps = integrated(law, tau, zeta);
        CHECK(exact.z == Approx(steps.z).epsilon(1e-6).margin(1e-9));
        CHECK(exact.rate == Approx(steps.rate).epsilon(1e-6).margin(1e-8));
      }
    }
  }
}

TEST_CASE("the state inside a stretch leads on to its end", "[dynamics]") {
  // From the middle on is as good as from the beginning: checked by a law cut in two.
  const Law<double> law = find_law("modified-sine").law();
  const FollowerTrain<double> train{3.3, 0.05};
  double largest = 0;
  for (int i = 1; i <= 200; ++i)
    largest = std::max(largest, std::abs(train.at(law, i / 200.0).value().z));
  CHECK(largest > train.amplitude(train.after(law).value()));
  CHECK(train.at(law, 1).value().z == train.after(law).value().z);
  const auto a = train.at(law, 0.5).value(), b = train.at(law, 0.5 + 1e-6).value();
  CHECK((b.z - a.z) / 1e-6 == Approx(a.rate).epsilon(1e-4));
}

TEST_CASE("amplitude by a law's parameter has an exact derivative, and states add up",
          "[dynamics]") {
  const Family& family = find_family("legendre");
  const auto amplitude = [&](double c) {
    Member member{&family, family.defaults()};
    member.arguments.values()[0] = {-1.8, c};
    return residual_vibration(member.law(), 2.4, 0.02);
  };
  auto arguments = Arguments<Dual>({{Dual(-1.8), Dual(0.2, 0)}});
  const Member defaults{&family, family.defaults()};
  std::vector<std::vector<Dual>> values;
  for (std::size_t i = 0; i < defaults.arguments.size(); ++i) {
    values.emplace_back();
    for (const double v : defaults.arguments.list(i)) values.back().push_back(Dual(v));
  }
  values[0] = {Dual(-1.8), Dual(0.2, 0)};
  const Law<Dual> law = family.make(Arguments<Dual>(values));
  const Dual exact = residual_vibration(law, Dual(2.4), Dual(0.02));
  CHECK(exact.a == Approx(amplitude(0.2)).epsilon(1e-12));
  CHECK(exact.v[0] == Approx((amplitude(0.2 + 1e-5) - amplitude(0.2 - 1e-5)) / 2e-5).epsilon(1e-6));
}

TEST_CASE("trains and laws that do not fit are refused", "[dynamics]") {
  CHECK_THROWS_WITH(residual("elliptic", 2), Catch::Contains("does not consist of"));
  CHECK_THROWS_WITH(residual("cycloidal", 0), Catch::Contains("period ratio"));
  CHECK_THROWS_WITH(residual("cycloidal", 2, 1), Catch::Contains("damping"));
}

}  // namespace camlaw::follower_train_test
