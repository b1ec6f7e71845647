// SPDX-License-Identifier: MIT
// Motions of trains that are kept and moved along lambda, against the same motions worked out in
// each scalar.
#include "machines/follower_train/standing_turn.h"

#include <catch2/catch.hpp>
#include <random>

#include "kinematics/laws/catalogue.h"
#include "kinematics/program/program.h"
#include "numerics/scalar/dual.h"

namespace camlaw::standing_turn_test {
namespace {

Member turn() {
  return motion_program({{.name = "rise", .angle = 120, .to = 1, .law = find_law("modified-sine")},
                         {.name = "high", .angle = 40, .to = 1, .rests = true},
                         {.name = "return", .angle = 90, .to = 0, .law = find_law("poly-3-4-5")},
                         {.name = "low", .angle = 110, .to = 0, .rests = true}},
                        Matched::Acceleration);
}

template <class T>
TrainState<T> worked_out(const FollowerTrain<T>& train, double x) {
  const Law<T> law = turn().possible_law<T>().value();
  const auto motion = TrainMotion<T>::periodic(train, law);
  return motion.value().at(x);
}

struct Place {
  double tau, zeta, x;
};

/// Trains with and without damping, near a resonance too, at places inside pieces and at joints.
std::vector<Place> places() {
  std::vector<Place> all{{1.5, 0, 0.4}, {10.6, 0.04, 1}, {3, 1e-3, 0.1}, {8.001, 0.01, 1.0 / 3}};
  std::mt19937 random(5);
  std::uniform_real_distribution<double> tau(0.6, 30), zeta(0, 0.3), x(0, 1);
  for (int i = 0; i < 20; ++i) all.push_back({tau(random), zeta(random), x(random)});
  return all;
}

void check_close(const Dual& found, const Dual& expected) {
  CHECK(found.a == Approx(expected.a).epsilon(1e-11).margin(1e-13));
  for (int i = 0; i < kDualWidth; ++i) {
    const double size = expected.v.cwiseAbs().maxCoeff();
    CHECK(found.v[i] == Approx(expected.v[i]).epsilon(1e-10).margin(1e-11 * size));
  }
}

}  // namespace

TEST_CASE("a kept motion has the derivatives of one that is worked out with them",
          "[elastic-end]") {
  const Member member = turn();
  const StandingTurn kept(member.possible_law().value(), member.possible_law<Interval>().value());
  for (const auto& [tau, zeta, x] : places()) {
    CAPTURE(tau, zeta, x);
    const FollowerTrain<double> plain{tau, zeta};
    const auto state = kept.at(plain, x);
    REQUIRE(state);
    CHECK(state->z == worked_out(plain, x).z);

    // Both ratios move with two of the directions, as with a speed and a mass.
    FollowerTrain<Dual> first{Dual(tau, 0), Dual(zeta)};
    first.period_ratio.v[1] = -2;
    first.damping_ratio.v[1] = 0.5;
    first.damping_ratio.v[2] = 1;
    const auto moved = kept.at(first, x);
    REQUIRE(moved);
    const auto as_dual = worked_out(first, x);
    check_close(moved->z, as_dual.z);
    check_close(moved->rate, as_dual.rate);

    FollowerTrain<Dual2> second{Dual2(first.period_ratio), Dual2(first.damping_ratio)};
    second.period_ratio.v[0] = Dual(1.0);
    second.period_ratio.v[1] = Dual(-2.0, 0);  // which bends
    second.damping_ratio.v[2] = Dual(1.0, 1);
    const auto bent = kept.at(second, x);
    REQUIRE(bent);
    const auto as_second = worked_out(second, x);
    check_close(bent->z.a, as_second.z.a);
    for (int i = 0; i < kDualWidth; ++i) {
      check_close(bent->z.v[i], as_second.z.v[i]);
      check_close(bent->rate.v[i], as_second.rate.v[i]);
    }

    const FollowerTrain<Interval> enclosing{Interval(tau), Interval(zeta)};
    const auto enclosed = kept.at(enclosing, x);
    REQUIRE(enclosed);
    CHECK(enclosed->z.lower() <= state->z);
    CHECK(state->z <= enclosed->z.upper());
  }
}

TEST_CASE("a train that has no steady state has none where motions are kept", "[elastic-end]") {
  const Member member = turn();
  const StandingTurn kept(member.possible_law().value(), member.possible_law<Interval>().value());
  const auto resonant = kept.at(FollowerTrain<Dual>{Dual(3.0), Dual(0.0)}, 0.3);
  REQUIRE(!resonant);
  CHECK(resonant.why() == TrainMotion<double>::periodic({3, 0}, kept.law()).why());
  CHECK(!kept.at(FollowerTrain<double>{2, 1}, 0.3));
}

}  // namespace camlaw::standing_turn_test
