// SPDX-License-Identifier: MIT
#include "machines/cams/leading_roller_cam.h"

#include "machines/cams/roller_cam.h"
#include "tests/machines/formulas/drawn_cam.h"

namespace camlaw::leading_roller_cam_test {
namespace {

using namespace testing;

auto arm_of(const OscillatingRollerCam& cam, double way) {
  return [&cam, way](double angle) {
    const double psi = plain(cam.lowest_angle()) + plain(motion_at(cam, angle).s);
    return on_cam(plain(cam.pivot_distance) - plain(cam.arm_length) * std::polar(1.0, -psi),
                  way * angle);
  };
}

}  // namespace

TEST_CASE("an oscillating roller cam that turns the other way gives the motion too", "[cams]") {
  const PlainNumbers numbers;
  const OscillatingRollerCam trailing;
  check_roller_cam(trailing, arm_of(trailing, 1));
  const LeadingRollerCam leading;
  // Drawn backwards, so that the curve runs clockwise again.
  const auto track = arm_of(leading, -1);
  const auto cam_at = [&](double angle) { return track(2 * kPi - angle); };
  const double h = 1e-6, r = plain(leading.roller_radius);
  std::vector<Point> profile;
  for (int i = 0; i < kAngles; ++i) {
    const auto [x, y] =
        plain(leading.pitch_curve(motion_at(leading, angle_of(i))).inside(r).place());
    profile.push_back(on_cam({x, y}, -angle_of(i)));
  }
  for (int i = 45; i < kAngles; i += 110) {
    const double angle = angle_of(i), back = 2 * kPi - angle;
    const auto f = motion_at(leading, angle);
    const double bend = curvature_of(cam_at(back - 1e-3), cam_at(back), cam_at(back + 1e-3));
    CHECK(plain(leading.pitch_curve(f).curvature()) == Approx(bend).epsilon(2e-3).margin(0.02));
    CHECK(nearest(profile, track(angle)) == Approx(r).epsilon(1e-5));
    // The way is square to the arm, away from the cam; signed as the slope of the rise.
    const Point normal =
        Point(0, 1) * (cam_at(back + h) - cam_at(back - h)) * std::polar(1.0, -angle);
    const Point way = Point(0, 1) * std::polar(1.0, -(plain(leading.lowest_angle()) + plain(f.s)));
    CHECK(plain(leading.pressure_angle(f)) == Approx(std::arg(way / normal)).margin(1e-7));
    // Power: the force turns the cam, which turns the other way now.
    const Point place = track(angle) * std::polar(1.0, -angle);
    const double lever = -std::imag(std::conj(place) * normal / std::abs(normal));
    CHECK(plain(leading.follower().torque(f)) ==
          Approx(lever * plain(leading.contact_force(f))).margin(1e-6).epsilon(1e-6));
  }
}

TEST_CASE("a negative offset is the other rotation of a translating follower", "[cams]") {
  const PlainNumbers numbers;
  RollerCam one, other;
  one.offset = 0.012;
  other.offset = -0.012;
  // Turned the other way the cam carries the mirrored point with the mirrored angle.
  for (double angle = 0.1; angle < 6.2; angle += 0.3) {
    const auto f = motion_at(one, angle);
    const auto w = other.pitch_curve(f);
    const Point mirrored = -std::conj(on_cam({plain(w.x), plain(w.y)}, angle));
    const Point turned =
        on_cam({plain(one.offset), plain(one.lowest_height()) + plain(f.s)}, -angle);
    CHECK(std::abs(mirrored - turned) < 1e-15);
  }
}

}  // namespace camlaw::leading_roller_cam_test
