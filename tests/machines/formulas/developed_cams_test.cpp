// SPDX-License-Identifier: MIT
// Cams whose track is developed: end cams with an oscillating arm, and plates.
#include "machines/cams/linear_cam.h"
#include "machines/cams/oscillating_end_cam.h"
#include "tests/machines/formulas/drawn_cam.h"

namespace camlaw::developed_cams_test {
namespace {

using namespace testing;

OscillatingEndCam tilted_cam(double tilt) {
  OscillatingEndCam cam;
  cam.tilt = tilt;
  return cam;
}

std::vector<OscillatingEndCam> oscillating() {
  return {tilted_cam(0), tilted_cam(0.3), tilted_cam(-0.25)};
}

/// From the pivot; the arm lies along the circumference at mid-swing, but for the tilt.
Point roller_of(const OscillatingEndCam& cam, double s) {
  return -plain(cam.arm_length) * std::polar(1.0, -(plain(cam.tilt) + s - plain(cam.swing) / 2));
}

/// The same as the developed cam sees it, which slides to the left below.
auto track_of(const OscillatingEndCam& cam) {
  return [&cam](double angle) {
    return roller_of(cam, plain(motion_at(cam, angle).s)) + plain(cam.radius) * angle;
  };
}

auto track_of(const LinearCam& cam) {
  return [&cam](double angle) {
    return Point(plain(cam.travel) * angle / (2 * kPi), plain(motion_at(cam, angle).s));
  };
}

}  // namespace

TEST_CASE("an oscillating end cam, developed and rolled back, gives the motion", "[cams]") {
  const PlainNumbers numbers;
  for (const auto& cam : oscillating()) check_roller_cam(cam, track_of(cam));
}

TEST_CASE("the pressure angle of an oscillating end cam lies between normal and way", "[cams]") {
  const PlainNumbers numbers;
  for (const auto& cam : oscillating()) {
    const auto track = track_of(cam);
    const double h = 1e-6;
    for (double angle = 0.1; angle < 6.2; angle += 0.2) {
      const auto f = motion_at(cam, angle);
      const Point normal = Point(0, 1) * (track(angle + h) - track(angle - h));
      const Point way = roller_of(cam, plain(f.s) + h) - roller_of(cam, plain(f.s) - h);
      CHECK(plain(cam.pressure_angle(f)) == Approx(std::arg(normal / way)).margin(1e-7));
    }
  }
}

TEST_CASE("cams that slide take the power that their followers give", "[cams]") {
  const PlainNumbers numbers;
  // The cam yields along -x by its radius per radian.
  for (const auto& cam : oscillating()) {
    check_power(cam, track_of(cam),
                [&](Point, Point normal) { return -plain(cam.radius) * normal.real(); });
  }
  const LinearCam plate;
  check_power(plate, track_of(plate), [&](Point, Point normal) {
    return -plain(plate.travel) / (2 * kPi) * normal.real();
  });
}

TEST_CASE("a long arm moves as a roller that slides along the cam's axis", "[cams]") {
  const PlainNumbers numbers;
  EndCam end;
  OscillatingEndCam cam;
  for (const double length : {1e2, 1e3}) {
    cam.arm_length = length;
    cam.swing = plain(end.stroke) / length;
    cam.inertia = plain(end.mass) * length * length;
    for (double angle = 0.1; angle < 6.2; angle += 0.2) {
      const auto f = motion_at(cam, angle), g = motion_at(end, angle);
      const double close = 1 / length;
      CHECK(plain(cam.pressure_angle(f)) == Approx(plain(end.pressure_angle(g))).margin(close));
      CHECK(plain(cam.pitch_curve(f).curvature()) ==
            Approx(plain(end.pitch_curve(g).curvature())).margin(close));
      CHECK(plain(cam.contact_force(f)) == Approx(plain(end.contact_force(g))).margin(100 * close));
    }
  }
}

TEST_CASE("an arm on a straight track at rest sees no slope but its own tilt", "[cams]") {
  const PlainNumbers numbers;
  for (const auto& cam : oscillating()) {
    const FollowerMotion still{plain(cam.swing), 0, 0, 0};
    CHECK(plain(cam.pressure_angle(still)) ==
          Approx(plain(cam.tilt) + plain(cam.swing) / 2).epsilon(1e-14));
    CHECK(plain(cam.pitch_curve(still).curvature()) == 0);
  }
}

TEST_CASE("a cam plate, rolled back, gives the motion", "[cams]") {
  const PlainNumbers numbers;
  const LinearCam cam;
  check_roller_cam(cam, track_of(cam));
}

TEST_CASE("a cam plate is an end cam of the radius travel / (2 pi)", "[cams]") {
  const PlainNumbers numbers;
  LinearCam cam;
  EndCam end;
  end.radius = 0.06;
  cam.travel = 2 * kPi * plain(end.radius);
  end.spring_rate = plain(cam.spring_rate);
  end.spring_preload = plain(cam.spring_preload);
  for (double angle = 0.1; angle < 6.2; angle += 0.2) {
    const auto f = motion_at(cam, angle);
    CHECK(plain(cam.pressure_angle(f)) == Approx(plain(end.pressure_angle(f))).epsilon(1e-14));
    CHECK(plain(cam.pitch_curve(f).curvature()) ==
          Approx(plain(end.pitch_curve(f).curvature())).epsilon(1e-12));
    CHECK(plain(cam.contact_force(f)) == Approx(plain(end.contact_force(f))).epsilon(1e-14));
    // Force along the plate times its way is the follower's work.
    CHECK(plain(cam.plate_force(f)) * plain(end.radius) ==
          Approx(plain(end.follower().torque(f))).epsilon(1e-13));
    CHECK(plain(cam.plate_force(f)) ==
          Approx(plain(cam.contact_force(f)) * std::sin(plain(cam.pressure_angle(f))))
              .epsilon(1e-12));
  }
}

TEST_CASE("a roller on a plate with a circular hump rises as on the circle", "[cams]") {
  const PlainNumbers numbers;
  // s = sqrt((rho + r)^2 - u^2) - c around the top, u = R phi: the pitch curve is the circle.
  const LinearCam cam;
  const double whole = 0.04 + plain(cam.roller_radius), R = plain(cam.radius());
  for (double phi = -0.5; phi < 0.51; phi += 0.1) {
    const double u = R * phi, y = std::sqrt(whole * whole - u * u);
    const FollowerMotion f{y, -R * u / y, -R * R * whole * whole / (y * y * y), 0};
    CHECK(plain(cam.pitch_curve(f).curvature()) == Approx(1 / whole).epsilon(1e-12));
    CHECK(plain(cam.roller().profile_curvature(cam.pitch_curve(f).curvature())) ==
          Approx(1 / 0.04).epsilon(1e-11));
    CHECK(std::sin(plain(cam.pressure_angle(f))) == Approx(-u / whole).margin(1e-12));
  }
}

TEST_CASE("developed cams that cannot be are said to be impossible", "[cams]") {
  const PlainNumbers numbers;
  LinearCam plate;
  CHECK(is_possible(plate));
  plate.travel = 0;
  CHECK_FALSE(is_possible(plate));
  OscillatingEndCam cam;
  CHECK(is_possible(cam));
  cam.tilt = kPi / 2 - 0.1;  // past square at the top
  CHECK_FALSE(is_possible(cam));
  cam = OscillatingEndCam();
  cam.radius = 0;
  CHECK_FALSE(is_possible(cam));
}

}  // namespace camlaw::developed_cams_test
