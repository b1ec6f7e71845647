// SPDX-License-Identifier: MIT
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <functional>
#include <vector>

#include "kinematics/program/program.h"
#include "machines/cams/end_cam.h"
#include "machines/cams/flat_cam.h"
#include "machines/cams/oscillating_roller_cam.h"
#include "machines/cams/roller_cam.h"
#include "numerics/scalar/series.h"
#include "tests/machines/formulas/drawn_cam.h"

namespace camlaw::cams_test {
namespace {

using namespace testing;

/// Roller centres and profile points on the cam, and the formula's values beside them.
struct Drawn {
  std::vector<Point> centre, profile;
  std::vector<double> profile_curvature;
};

template <class Cam>
Drawn drawn_cam(const Cam& cam) {
  Drawn result;
  for (int i = 0; i < kAngles; ++i) {
    const auto f = motion_at(cam, angle_of(i));
    const auto w = cam.pitch_curve(f);
    const auto [x, y] = plain(w.inside(cam.roller_radius).place());
    result.centre.push_back(on_cam({plain(w.x), plain(w.y)}, angle_of(i)));
    result.profile.push_back(on_cam({x, y}, angle_of(i)));
    result.profile_curvature.push_back(
        plain(cam.roller().profile_curvature(cam.pitch_curve(f).curvature())));
  }
  return result;
}

/// The profile does to the roller what the formulas say: laid against it, the roller touches at
/// one place, and nowhere does the cam come nearer.
template <class Cam>
void check_rolled_back(const Cam& cam) {
  const Drawn d = drawn_cam(cam);
  for (int i = 0; i < kAngles; i += 90) {
    INFO(i * 360.0 / kAngles << " deg");
    double nearest = 1e9;
    int at = 0;
    for (int k = 0; k < kAngles; ++k) {
      const double distance = std::abs(d.centre[i] - d.profile[k]);
      if (distance < nearest) nearest = distance, at = k;
    }
    CHECK(nearest == Approx(plain(cam.roller_radius)).epsilon(1e-5));
    CHECK(std::abs(d.profile[at] - d.profile[i]) < 2e-4);
  }
}

template <class Cam>
void check_curvature(const Cam& cam) {
  const Drawn d = drawn_cam(cam);
  for (int i = 45; i < kAngles; i += 70) {
    INFO(i * 360.0 / kAngles << " deg");
    const double measured = curvature_of(d.profile[i - 1], d.profile[i], d.profile[i + 1]);
    CHECK(measured == Approx(d.profile_curvature[i]).epsilon(2e-3).margin(0.02));
  }
}

/// Angle between the path of the roller's centre and the line from the contact to it.
template <class Cam>
void check_pressure_angle(const Cam& cam, const std::function<Point(double)>& centre_at) {
  for (int i = 30; i < kAngles; i += 110) {
    const double angle = angle_of(i), h = 1e-6;
    const auto f = motion_at(cam, angle);
    const auto w = cam.pitch_curve(f);
    const auto [x, y] = plain(w.inside(cam.roller_radius).place());
    const Point normal = Point(plain(w.x), plain(w.y)) - Point(x, y);
    // The way: where the centre goes with the follower's own coordinate.
    const Point way = (centre_at(plain(f.s) + h) - centre_at(plain(f.s) - h)) / (2 * h);
    const double alpha = std::abs(std::arg(normal / way));
    INFO(i * 360.0 / kAngles << " deg");
    CHECK(std::abs(plain(cam.pressure_angle(f))) == Approx(alpha).margin(1e-8));
  }
}

RollerCam offset_cam() {
  RollerCam cam;
  cam.offset = 0.012;
  return cam;
}

}  // namespace

TEST_CASE("the profile of a roller cam, rolled back, gives the motion", "[cams]") {
  const PlainNumbers numbers;
  check_rolled_back(RollerCam());
  check_rolled_back(offset_cam());
  check_rolled_back(OscillatingRollerCam());
}

TEST_CASE("curvature by three points of the profile is the formula's", "[cams]") {
  const PlainNumbers numbers;
  check_curvature(RollerCam());
  check_curvature(offset_cam());
  check_curvature(OscillatingRollerCam());
}

TEST_CASE("the pressure angle lies between the normal and the roller's way", "[cams]") {
  const PlainNumbers numbers;
  for (const auto& cam : {RollerCam(), offset_cam()}) {
    check_pressure_angle(
        cam, [&](double s) { return Point(plain(cam.offset), plain(cam.lowest_height()) + s); });
  }
  const OscillatingRollerCam oscillating;
  check_pressure_angle(oscillating, [&](double s) {
    return plain(oscillating.pivot_distance) -
           plain(oscillating.arm_length) *
               std::polar(1.0, -(plain(oscillating.lowest_angle()) + s));
  });
}

TEST_CASE("a roller on an eccentric circle sees a circle", "[cams]") {
  const PlainNumbers numbers;
  // The centre of a circle of radius rho turns with the cam at the distance epsilon, the roller's
  // keeps rho + r_r from it: (y + epsilon cos phi)^2 + (e - epsilon sin phi)^2 = (rho + r_r)^2.
  RollerCam cam;
  const double epsilon = 0.009, rho = 0.035;
  for (const double offset : {0.0, 0.01}) {
    cam.offset = offset;
    const double whole = rho + plain(cam.roller_radius);
    for (double phi = 0; phi < 6.28; phi += 0.4) {
      using Phi = Series<double, 4>;
      const Phi angle = Phi::variable(phi, 1);
      const Phi side = offset - epsilon * sin(angle);
      const Phi y = sqrt(whole * whole - side * side) - epsilon * cos(angle);
      const auto d = derivatives(y);
      const FollowerMotion f{d[0] - plain(cam.lowest_height()), d[1], d[2], d[3]};
      CHECK(plain(cam.pitch_curve(f).curvature()) == Approx(1 / whole).epsilon(1e-12));
      CHECK(plain(cam.roller().profile_curvature(cam.pitch_curve(f).curvature())) ==
            Approx(1 / rho).epsilon(1e-11));
    }
  }
}

TEST_CASE("a flat face on an eccentric circle is lifted by a harmonic", "[cams]") {
  const PlainNumbers numbers;
  // s = epsilon (1 - cos phi): the radius of curvature is that of the circle everywhere.
  FlatCam cam;
  cam.stroke = 2 * 0.009;
  const Law<double> harmonic = motion_program({{"up", 180, 1, false, find_law("cosine")},
                                               {"down", 180, 0, false, find_law("cosine")}},
                                              Matched::Acceleration)
                                   .law();
  for (double x = 0.01; x < 1; x += 0.07) {
    const auto f = cam.over_angle(written(harmonic(x)));
    CHECK(plain(f.s) == Approx(0.009 * (1 - std::cos(2 * kPi * x))).margin(1e-15));
    CHECK(plain(cam.profile_radius(f)) == Approx(plain(cam.base_radius) + 0.009).epsilon(1e-12));
    CHECK(plain(cam.contact_offset(f)) == Approx(0.009 * std::sin(2 * kPi * x)).margin(1e-15));
  }
}

TEST_CASE("the flat cam's profile, laid against the face, gives the motion", "[cams]") {
  const PlainNumbers numbers;
  const FlatCam cam;
  std::vector<Point> profile;
  for (int i = 0; i < kAngles; ++i) {
    const auto [x, y] = plain(cam.profile(motion_at(cam, angle_of(i))).place());
    profile.push_back(on_cam({x, y}, angle_of(i)));
  }
  for (int i = 0; i < kAngles; i += 75) {
    double highest = 0;
    for (const Point& p : profile) {
      highest = std::max(highest, std::imag(p * std::polar(1.0, angle_of(i))));
    }
    CHECK(highest ==
          Approx(plain(cam.base_radius) + plain(motion_at(cam, angle_of(i)).s)).epsilon(1e-6));
  }
}

TEST_CASE("the pressure angle of a cycloidal cam at its middle has a closed form", "[cams]") {
  const PlainNumbers numbers;
  // At half the rise v = 2: s' = 2 h / beta and s = h / 2.
  RollerCam cam;
  cam.stroke = 0.03;
  const double beta = 100 * kPi / 180;
  const Law<double> law = motion_program({{"rise", 100, 1, false, find_law("cycloidal")},
                                          {"back", 260, 0, false, find_law("cycloidal")}},
                                         Matched::Acceleration)
                              .law();
  const auto f = cam.over_angle(written(law(50.0 / 360)));
  const double expected = std::atan(2 * 0.03 / beta / (0.05 + 0.015));
  CHECK(plain(cam.pressure_angle(f)) == Approx(expected).epsilon(1e-12));
  // There s'' = 0: k = (y^2 + 2 s'^2) / (y^2 + s'^2)^(3/2).
  const double slope = 2 * 0.03 / beta, y = 0.065, square = y * y + slope * slope;
  CHECK(plain(cam.pitch_curve(f).curvature()) ==
        Approx((square + slope * slope) / std::pow(square, 1.5)).epsilon(1e-12));
}

TEST_CASE("no energy is lost without friction: torque over a turn adds up to nothing", "[cams]") {
  const PlainNumbers numbers;
  const auto sum = [](const auto& cam) {
    double total = 0, greatest = 0;
    for (int i = 0; i < kAngles; ++i) {
      const double torque = plain(cam.follower().torque(motion_at(cam, angle_of(i))));
      total += torque / kAngles;
      greatest = std::max(greatest, std::abs(torque));
    }
    return total / greatest;
  };
  CHECK(std::abs(sum(RollerCam())) < 1e-6);
  CHECK(std::abs(sum(OscillatingRollerCam())) < 1e-6);
  CHECK(std::abs(sum(EndCam())) < 1e-6);
}

TEST_CASE("the force between roller and cam drives the follower and brakes the cam", "[cams]") {
  const PlainNumbers numbers;
  // Its lever about the cam's centre is the torque: two ways to the same number.
  const auto check = [](const auto& cam, double phi) {
    const auto f = motion_at(cam, phi);
    const auto w = cam.pitch_curve(f);
    const auto [x, y] = plain(w.inside(cam.roller_radius).place());
    const Point out = (Point(plain(w.x), plain(w.y)) - Point(x, y)) / plain(cam.roller_radius);
    const double lever = std::imag(std::conj(Point(plain(w.x), plain(w.y))) * out);
    CHECK(plain(cam.follower().torque(f)) ==
          Approx(lever * plain(cam.contact_force(f))).margin(1e-9));
  };
  for (double phi = 0.1; phi < 6.2; phi += 0.3) {
    check(offset_cam(), phi);
    check(OscillatingRollerCam(), phi);
  }
}

TEST_CASE("an end cam is a curve on the developed cylinder", "[cams]") {
  const PlainNumbers numbers;
  EndCam cam;
  const auto at = [&](int i) {
    return Point(plain(cam.radius) * angle_of(i), plain(motion_at(cam, angle_of(i)).s));
  };
  for (int i = 40; i < kAngles; i += 90) {
    const auto f = motion_at(cam, angle_of(i));
    const Point step = at(i + 1) - at(i - 1);
    CHECK(plain(cam.pressure_angle(f)) == Approx(std::arg(step)).margin(1e-5));
    const double bend = -curvature_of(at(i - 1), at(i), at(i + 1));
    CHECK(-plain(cam.pitch_curve(f).curvature()) == Approx(bend).epsilon(1e-3).margin(0.02));
  }
}

TEST_CASE("line contact has Hertz's coefficients", "[cams]") {
  const PlainNumbers numbers;
  // For nu = 0.3: 0.418 and 1.52 (Roark; Johnson, Contact Mechanics, 1985, section 4.2).
  const LineContact steel{2.1e11, 0.3};
  const double w = 3e5, k = 1 / 0.01 + 1 / 0.05;
  CHECK(plain(steel.pressure(w, k)) == Approx(0.418 * std::sqrt(w * k * 2.1e11)).epsilon(1e-3));
  CHECK(plain(steel.half_width(w, k)) == Approx(1.52 * std::sqrt(w / (k * 2.1e11))).epsilon(3e-3));
  // The ellipse of pressure carries the load: w = pi a sigma / 2.
  CHECK(kPi / 2 * plain(steel.half_width(w, k)) * plain(steel.pressure(w, k)) ==
        Approx(w).epsilon(1e-14));
  CHECK(std::isnan(plain(steel.pressure(-1.0, k))));
}

TEST_CASE("geometry that cannot be is said to be impossible", "[cams]") {
  const PlainNumbers numbers;
  RollerCam cam;
  CHECK(is_possible(cam));
  cam.offset = plain(cam.prime_radius());
  CHECK_FALSE(is_possible(cam));
  OscillatingRollerCam oscillating;
  CHECK(is_possible(oscillating));
  oscillating.pivot_distance = 0.2;
  CHECK_FALSE(is_possible(oscillating));
}

}  // namespace camlaw::cams_test
