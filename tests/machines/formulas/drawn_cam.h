// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "kinematics/program/program.h"
#include "machines/cams/cam_motion.h"
#include "tests/plain.h"

/// Cams drawn point by point for tests, with nothing of the formulas that are tested.
namespace camlaw::testing {

using Point = std::complex<double>;
inline constexpr double kPi = std::numbers::pi;
inline constexpr int kAngles = 3600;

/// Rise in 150 deg, rest, return in 130 deg, rest.
inline const Law<double>& drawn_program() {
  static const Law<double> law = motion_program({{"rise", 150, 1, false, find_law("modified-sine")},
                                                 {"high", 30, 1, true, {}},
                                                 {"back", 130, 0, false, find_law("cycloidal")},
                                                 {"low", 50, 0, true, {}}},
                                                Matched::Acceleration)
                                     .law();
  return law;
}

inline double angle_of(int i) { return 2 * kPi * i / kAngles; }

template <class Cam>
FollowerMotion motion_at(const Cam& cam, double angle) {
  const double turns = angle / (2 * kPi);
  return cam.over_angle(written(drawn_program()(turns - std::floor(turns))));
}

/// A point seen from the frame, as the cam at `angle` carries it: turned back.
inline Point on_cam(Point seen, double angle) { return seen * std::polar(1.0, -angle); }

/// 1 / radius of the circle through three points, positive where they turn clockwise, as the
/// curve on the cam runs.
inline double curvature_of(Point a, Point b, Point c) {
  const double turn = std::imag(std::conj(b - a) * (c - b));
  return -2 * turn / (std::abs(b - a) * std::abs(c - b) * std::abs(c - a));
}

/// A curve on the cam at every angle, from where it is at one.
template <class F>
std::vector<Point> drawn(const F& at) {
  std::vector<Point> all;
  for (int i = 0; i < kAngles; ++i) all.push_back(at(angle_of(i)));
  return all;
}

/// Where the line through p along `along` crosses that through q along `other`.
inline Point crossing(Point p, Point along, Point q, Point other) {
  return p + along * (std::imag(std::conj(other) * (q - p)) / std::imag(std::conj(other) * along));
}

/// The least distance of the points from a place.
inline double nearest(const std::vector<Point>& points, Point place) {
  double least = 1e9;
  for (const Point& p : points) least = std::min(least, std::abs(p - place));
  return least;
}

/// A roller cam against its pitch curve drawn by geometry alone, centre(angle) on the cam, which
/// runs clockwise or to the right: curvatures by three points, and the roller laid against the
/// envelope touches it and cuts it nowhere.
template <class Cam, class Centre>
void check_roller_cam(const Cam& cam, const Centre& centre) {
  const double h = 1e-4, r = plain(cam.roller_radius);
  const auto flank = [&](double angle, double side) {
    const Point step = centre(angle + h) - centre(angle - h);
    return centre(angle) - side * r * Point(0, 1) * step / std::abs(step);
  };
  const auto inner = drawn([&](double angle) { return flank(angle, 1); });
  const auto outer = drawn([&](double angle) { return flank(angle, -1); });
  for (int i = 45; i < kAngles - 45; i += 70) {
    INFO(i * 360.0 / kAngles << " deg");
    const double angle = angle_of(i), step = 1e-3;
    const double k = plain(cam.pitch_curve(motion_at(cam, angle)).curvature());
    const auto bend = [&](const auto& at) {
      return curvature_of(at(angle - step), at(angle), at(angle + step));
    };
    CHECK(bend(centre) == Approx(k).epsilon(2e-3).margin(0.02));
    CHECK(bend([&](double a) { return flank(a, 1); }) ==
          Approx(plain(cam.roller().profile_curvature(k))).epsilon(2e-3).margin(0.02));
    CHECK(bend([&](double a) { return flank(a, -1); }) ==
          Approx(k / (1 + r * k)).epsilon(2e-3).margin(0.02));
    CHECK(nearest(inner, centre(angle)) == Approx(r).epsilon(1e-5));
    CHECK(nearest(outer, centre(angle)) == Approx(r).epsilon(1e-5));
  }
}

/// Power in is power out: the force along the drawn normal drives the cam as the follower's torque
/// says, `push(angle)` being how much the cam's surface gives way along a direction by radian.
template <class Cam, class Centre, class Push>
void check_power(const Cam& cam, const Centre& centre, const Push& push) {
  const double h = 1e-5;
  for (double angle = 0.1; angle < 6.2; angle += 0.3) {
    const auto f = motion_at(cam, angle);
    const Point step = centre(angle + h) - centre(angle - h);
    const Point normal = Point(0, 1) * step / std::abs(step);
    CHECK(plain(cam.follower().torque(f)) ==
          Approx(push(centre(angle), normal) * plain(cam.contact_force(f)))
              .margin(1e-6)
              .epsilon(1e-6));
  }
}

}  // namespace camlaw::testing
