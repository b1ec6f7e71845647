// SPDX-License-Identifier: MIT
// Friction in the guides of translating followers, by the balance of a rigid slide in a guide: what
// presses it, the reactions at the guide's two ends, and their friction.
#include "machines/cams/conjugate_cam.h"
#include "machines/cams/flat_cam.h"
#include "machines/cams/knife_edge_cam.h"
#include "machines/cams/linear_cam.h"
#include "tests/machines/formulas/drawn_cam.h"

namespace camlaw::guide_friction_test {
namespace {

using namespace testing;

constexpr double kFriction = 0.15, kLength = 0.07, kStep = 1e-6;

template <class Cam>
Cam rubbing(Cam cam) {
  cam.guide_friction = kFriction;
  cam.guide_length = kLength;
  cam.mass = 1.3;
  cam.spring_rate = 4000;
  cam.spring_preload = 60;
  cam.load = 25;
  cam.angular_speed = 75;  // the inertia passes the spring's force in places
  return cam;
}
template <class Cam>
Cam rubbing(Cam cam, double offset) {
  cam.offset = offset;
  return rubbing(cam);
}

/// Where a cam touches, the normal there, upwards, and the guide: its axis and its near end.
struct Touch {
  Point place, normal, guide;
};

/// What is left of the force along the way: the cam's push less friction and what the motion asks.
template <class Cam>
double left_over(const Cam& cam, double angle, double push, const Touch& touch) {
  const auto s = [&](double at) { return plain(motion_at(cam, at).s); };
  const double h = 1e-4;
  const double velocity = (s(angle + h) - s(angle - h)) / (2 * h);
  const double bend = (s(angle + h) - 2 * s(angle) + s(angle - h)) / (h * h);
  const Point force = push * touch.normal / std::abs(touch.normal);
  const double moment = std::imag(std::conj(touch.place - touch.guide) * force);
  const double far = moment / kLength, near = -force.real() - far;  // reactions across the way
  const double rubbed = kFriction * (std::abs(near) + std::abs(far));
  const double against = std::abs(velocity) < 1e-7 ? 0 : std::copysign(rubbed, velocity);
  const double asked =
      plain(cam.mass) * plain(cam.angular_speed) * plain(cam.angular_speed) * bend +
      plain(cam.spring_rate) * s(angle) + plain(cam.spring_preload) + plain(cam.load);
  return force.imag() - against - asked;
}

/// Checks the balance all round, and that it has pushes and pulls with friction in it.
template <class Cam, class F>
void check_balance(const Cam& cam, const F& touch_at) {
  Cam smooth = cam;
  smooth.guide_friction = 0;
  int pushes = 0, pulls = 0, rubs = 0;
  for (double angle = 0.05; angle < 6.25; angle += 0.05) {
    const auto f = motion_at(cam, angle);
    const double push = plain(cam.contact_force(f));
    INFO(angle << ": " << push << " N");
    const Touch touch = touch_at(angle, push);
    CHECK(left_over(cam, angle, push, touch) == Approx(0).margin(1e-5 * (100 + std::abs(push))));
    const double along = push * touch.normal.imag() / std::abs(touch.normal);
    CHECK(plain(cam.drive_torque(f)) == Approx(along * plain(f.ds)).margin(1e-8));
    // What friction leaves of it is what the motion asks.
    CHECK(along * (1 - plain(guide_fraction(cam, f))) ==
          Approx(plain(cam.follower().force(f))).margin(1e-8));
    CHECK(plain(guide_fraction(smooth, f)) == 0);
    ++(push > 0 ? pushes : pulls);
    if (std::abs(push / plain(smooth.contact_force(f)) - 1) > 0.02) ++rubs;
  }
  CHECK(pushes > 20);
  CHECK(pulls > 5);
  CHECK(rubs > 20);
}

/// Of a curve on the cam the normal as the frame sees it, upwards; moved as the cam is.
template <class F>
Point normal_of(const F& curve, double angle, bool turns) {
  const Point step =
      (curve(angle + kStep) - curve(angle - kStep)) * (turns ? std::polar(1.0, angle) : Point(1));
  const Point normal = Point(0, 1) * step;
  return normal.imag() > 0 ? normal : -normal;
}

template <class Cam>
Touch of_disc(const Cam& cam, double radius, double angle, double below) {
  const double lowest = std::sqrt(radius * radius - plain(cam.offset) * plain(cam.offset));
  const auto centre = [&](double at) {
    return Point(plain(cam.offset), lowest + plain(motion_at(cam, at).s) - below);
  };
  const auto on = [&](double at) { return on_cam(centre(at), at); };
  return {
      centre(angle), normal_of(on, angle, true), {plain(cam.offset), lowest + plain(cam.overhang)}};
}

/// The same place and curvature of the motion with a velocity of either sign that is next to none.
template <class Cam>
std::pair<double, double> about_reversal(const Cam& cam, double place, double bend) {
  const auto at = [&](double ds) {
    return plain(cam.contact_force(FollowerMotion{place, ds, bend, 0}));
  };
  return {at(1e-12), at(-1e-12)};
}

}  // namespace

TEST_CASE("the balance of a roller or an edge in its guide holds", "[cams][guide]") {
  const PlainNumbers numbers;
  for (const double offset : {0.0, 0.009, -0.007}) {
    const auto roller = rubbing(RollerCam(), offset);
    check_balance(roller, [&](double angle, double) { return of_disc(roller, 0.05, angle, 0); });
    const auto edge = rubbing(KnifeEdgeCam(), offset);
    check_balance(edge, [&](double angle, double) { return of_disc(edge, 0.04, angle, 0); });
  }
}

TEST_CASE("the balance of a flat face in its guide holds wherever the guide stands",
          "[cams][guide]") {
  const PlainNumbers numbers;
  const auto cam = rubbing(FlatCam());
  for (const double height : {0.05, 0.3}) {
    check_balance(cam, [&](double angle, double) {
      // The cam's point there moves up as fast as the face: omega x.
      const double h = 1e-4;
      const double x =
          (plain(motion_at(cam, angle + h).s) - plain(motion_at(cam, angle - h).s)) / (2 * h);
      return Touch{
          {x, plain(cam.base_radius) + plain(motion_at(cam, angle).s)}, {0, 1}, {0, height}};
    });
  }
}

TEST_CASE("the balance of a roller on an end cam or a plate in its guide holds", "[cams][guide]") {
  const PlainNumbers numbers;
  const auto on_track = [](const auto& cam, double radius) {
    check_balance(cam, [&cam, radius](double angle, double) {
      const auto track = [&](double at) { return Point(radius * at, plain(motion_at(cam, at).s)); };
      return Touch{{0, plain(motion_at(cam, angle).s)},
                   normal_of(track, angle, false),
                   {0, plain(cam.overhang)}};
    });
  };
  on_track(rubbing(EndCam()), 0.05);
  auto plate = rubbing(LinearCam());
  on_track(plate, plain(plate.travel) / (2 * kPi));
  for (double angle = 0.1; angle < 6.2; angle += 0.2) {
    const auto f = motion_at(plate, angle);
    CHECK(plain(plate.plate_force(f)) ==
          Approx(plain(plate.contact_force(f)) * std::sin(plain(plate.pressure_angle(f))))
              .margin(1e-9));
  }
}

TEST_CASE("the balance of a carriage between two cams holds", "[cams][guide]") {
  const PlainNumbers numbers;
  for (const double offset : {0.0, 0.009, -0.007}) {
    auto cam = rubbing(ConjugateCam(), offset);
    check_balance(cam, [&](double angle, double push) {
      return of_disc(cam, 0.05, angle, push > 0 ? 0 : plain(cam.roller_distance));
    });
  }
}

TEST_CASE("friction jumps at a reversal where the cam presses across the way then",
          "[cams][guide]") {
  const PlainNumbers numbers;
  // Of a face, an end cam and a plate it does not: they press across with the velocity alone.
  for (const double bend : {-0.03, 0.01}) {
    const auto goes_through = [bend](const auto& cam) {
      const auto [rising, falling] = about_reversal(cam, 0.02, bend);
      CHECK(rising == Approx(falling).epsilon(1e-8));
      CHECK(rising == Approx(plain(cam.follower().force(FollowerMotion{0.02, 0, bend, 0}))));
    };
    goes_through(rubbing(FlatCam()));
    goes_through(rubbing(EndCam()));
    goes_through(rubbing(LinearCam()));
    goes_through(rubbing(RollerCam()));
    goes_through(rubbing(ConjugateCam()));
  }
  // The force F > 0 from the main cam, F < 0 from the second one: their own slopes and levers.
  const double offset = 0.009, y = std::sqrt(0.05 * 0.05 - offset * offset) + 0.02;
  const auto share = [](double slope, double before) {
    return kFriction * slope * (2 * before + kLength) / kLength;
  };
  const double of_main = share(offset / y, 0.04 - 0.02);
  const double of_second = share(offset / (0.14 - y), 0.04 - 0.02 + 0.14);
  const auto ratio = [](const auto& cam, double bend) {
    const auto [rising, falling] = about_reversal(cam, 0.02, bend);
    return rising / falling;
  };
  const auto roller = rubbing(RollerCam(), offset);
  const auto pair = rubbing(ConjugateCam(), offset);
  CHECK(ratio(roller, 0.01) == Approx((1 + of_main) / (1 - of_main)).epsilon(1e-8));
  CHECK(ratio(roller, -0.03) == Approx((1 - of_main) / (1 + of_main)).epsilon(1e-8));
  CHECK(ratio(pair, 0.01) == Approx((1 + of_main) / (1 - of_main)).epsilon(1e-8));
  CHECK(ratio(pair, -0.03) == Approx((1 - of_second) / (1 + of_second)).epsilon(1e-8));
}

TEST_CASE("a face, an end cam and a pair jam in guides that are too short", "[cams][guide]") {
  const PlainNumbers numbers;
  const auto check = [](auto cam, double needed) {
    // A rise with s' = 0.03 m and a force above 0; the same in a return.
    const FollowerMotion rise{0.01, 0.03, 0.01, 0}, fall{0.01, -0.03, 0.01, 0};
    cam.guide_length = needed * 1.001;
    CHECK(std::isfinite(plain(cam.contact_force(rise))));
    CHECK(plain(cam.contact_force(rise)) > 100 * plain(cam.follower().force(rise)));
    CHECK(plain(guide_fraction(cam, rise)) < 1);
    cam.guide_length = needed * 0.999;
    CHECK(std::isnan(plain(cam.contact_force(rise))));
    CHECK(std::isnan(plain(cam.drive_torque(rise))));
    CHECK(plain(guide_fraction(cam, rise)) > 1);
    CHECK(std::isfinite(plain(cam.contact_force(fall))));
  };
  check(rubbing(FlatCam()), 2 * kFriction * 0.03);
  // mu tan alpha (2 b + l) = l.
  const double slope = 0.03 / 0.05 * kFriction;
  check(rubbing(EndCam()), 2 * 0.03 * slope / (1 - slope));
  const double steep = 0.03 / 0.06 * kFriction;
  check(rubbing(ConjugateCam()), 2 * 0.03 * steep / (1 - steep));
}

TEST_CASE("a roller of a pair that bears nothing does not jam", "[cams][guide]") {
  const PlainNumbers numbers;
  // In a return the main roller bears, and the second one with its long lever would jam.
  auto cam = rubbing(ConjugateCam());
  cam.guide_friction = 0.4;
  const FollowerMotion fall{0.01, -0.03, 0.01, 0};
  REQUIRE(plain(cam.follower().force(fall)) > 0);
  const double slope = 0.03 / (0.14 - 0.05 - 0.01);
  REQUIRE(0.4 * slope * (2 * (0.04 - 0.01 + 0.14) + kLength) / kLength > 0.8);
  cam.guide_length = 0.03;
  REQUIRE(0.4 * slope * (2 * (0.04 - 0.01 + 0.14) + 0.03) / 0.03 > 1);
  CHECK(plain(cam.second_force(fall)) == 0);
  CHECK(plain(cam.main_force(fall)) == Approx(plain(cam.contact_force(fall))));
}

TEST_CASE("the overhang that is left is how far the contact is before the guide", "[cams][guide]") {
  const PlainNumbers numbers;
  const auto check = [](auto cam) {
    for (const double angle : {0.3, 1.4, 2.9, 4.0}) {
      const auto motion = motion_at(cam, angle);
      CHECK(plain(guide_overhang(cam, motion)) == Approx(plain(cam.overhang) - plain(motion.s)));
    }
  };
  check(rubbing(RollerCam()));
  check(rubbing(KnifeEdgeCam()));
  check(rubbing(EndCam()));
  check(rubbing(LinearCam()));
  check(rubbing(ConjugateCam()));
}

}  // namespace camlaw::guide_friction_test
