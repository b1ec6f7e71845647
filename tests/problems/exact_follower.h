// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "problems/statement/statement.h"
#include "problems/tolerance/profile_geometry.h"

/// Followers that run exactly on a profile with errors: the highest point that they touch, found
/// numerically.
namespace camlaw::problems::profile_errors_test {

using Point = std::complex<double>;

inline constexpr double kDegree = std::numbers::pi / 180;
inline constexpr const char* kProgram =
    "[[program.segments]]\nname = 'rise'\nangle = '110 deg'\nlaw = 'cycloidal'\n"
    "[[program.segments]]\nname = 'high'\nangle = '40 deg'\n"
    "[[program.segments]]\nname = 'return'\nangle = '120 deg'\nlaw = 'modified-sine'\n"
    "[[program.segments]]\nname = 'low'\n";

inline ProblemStatement cam(const std::string& mechanism, const std::string& constants,
                            const std::string& more = "") {
  return read_problem("mechanism = '" + mechanism + "'\n[constants]\nspeed = '300 rpm'\n" +
                          constants + kProgram + more,
                      "f.toml");
}

/// A cam, and where its follower stands when it touches a point of the frame.
struct Touching {
  std::string mechanism, constants;
  std::function<double(Point, double near)> at;
  double radius = 0;  ///< of a developed cam, m
};

inline std::vector<Touching> touching() {
  const auto roller = [](double offset, double r) {
    return [offset, r](Point p, double) {
      const double x = p.real() - offset;
      return p.imag() + std::sqrt(r * r - x * x);
    };
  };
  const auto arm = [](double l, double d, double r) {
    return [=](Point p, double near) {
      const Point from = p - d;
      const double size = std::abs(from);
      const double open = std::acos((r * r - l * l - size * size) / (2 * l * size));
      const double one = std::remainder(open - std::arg(from) - near, 2 * std::numbers::pi) + near;
      const double two = std::remainder(-open - std::arg(from) - near, 2 * std::numbers::pi) + near;
      return std::abs(one - near) < std::abs(two - near) ? one : two;
    };
  };
  return {{"disc-cam-roller",
           "stroke = '18 mm'\nbase_radius = '40 mm'\nroller_radius = '9 mm'\noffset = '6 mm'\n",
           roller(0.006, 0.009)},
          {"disc-cam-flat", "stroke = '12 mm'\nbase_radius = '45 mm'\n",
           [](Point p, double) { return p.imag(); }},
          {"end-cam", "stroke = '16 mm'\nradius = '45 mm'\nroller_radius = '8 mm'\n",
           roller(0, 0.008), 0.045},
          {"linear-cam", "stroke = '16 mm'\ntravel = '320 mm'\nroller_radius = '8 mm'\n",
           roller(0, 0.008), 0.320 / (2 * std::numbers::pi)},
          {"disc-cam-oscillating-roller",
           "swing = '14 deg'\nbase_radius = '42 mm'\nroller_radius = '9 mm'\n"
           "arm_length = '95 mm'\npivot_distance = '120 mm'\n",
           arm(0.095, 0.120, 0.009)},
          {"disc-cam-oscillating-flat",
           "swing = '10 deg'\nbase_radius = '45 mm'\nface_offset = '4 mm'\n"
           "pivot_distance = '120 mm'\n",
           [](Point p, double) {
             const Point from = p - 0.120;
             // The branch on which the face lies over the cam.
             return std::numbers::pi - std::asin(-0.004 / std::abs(from)) - std::arg(from);
           }},
          {"end-cam-oscillating",
           "swing = '12 deg'\nradius = '45 mm'\narm_length = '80 mm'\nroller_radius = '8 mm'\n",
           [](Point p, double near) {
             // The centre -l cos eta + i l sin eta is 8 mm away.
             const double l = 0.08, r = 0.008, size = std::abs(p);
             const double open = std::acos((l * l + size * size - r * r) / (2 * l * size));
             const double middle = std::numbers::pi - std::arg(p);
             const double one = std::remainder(middle + open - near, 2 * std::numbers::pi) + near;
             const double two = std::remainder(middle - open - near, 2 * std::numbers::pi) + near;
             return std::abs(one - near) < std::abs(two - near) ? one : two;
           },
           0.045}};
}

/// The profile of a design with an error along its normal, as its follower feels it.
class ExactFollower {
 public:
  ExactFollower(const ProfileGeometry& geometry, const Touching& touching)
      : geometry_(geometry), touching_(touching) {}

  /// Of the profile at the cam angle rad; the error is in m.
  template <class Error>
  Point profile(double angle, const Error& error) const {
    const auto x = geometry_.traces()[2]->at({angle / kDegree});
    const auto y = geometry_.traces()[3]->at({angle / kDegree});
    const Point p(x[0] / 1e3, y[0] / 1e3), along(x[1], y[1]);
    Point normal = Point(0, 1) * along / std::abs(along);
    const double outward =
        touching_.radius > 0 ? normal.imag() : normal.real() * p.real() + normal.imag() * p.imag();
    if (outward < 0) normal = -normal;
    return p + error(angle) * normal;
  }
  /// Where a point of the cam stands in the frame.
  Point in_frame(Point p, double angle) const {
    return touching_.radius > 0 ? p - touching_.radius * angle : p * std::polar(1.0, angle);
  }
  /// Where the follower stands: it touches the highest point within `reach` of its nominal one.
  template <class Error>
  double at(double angle, double reach, const Error& error) const {
    const double near =
        touching_.at(in_frame(profile(angle, [](double) { return 0.0; }), angle), start_);
    const auto height = [&](double where) {
      return touching_.at(in_frame(profile(where, error), angle), near);
    };
    constexpr double kGolden = 0.6180339887498949;
    double low = angle - reach, high = angle + reach;
    double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
    double at_a = height(a), at_b = height(b);
    for (int i = 0; i < 44; ++i) {
      if (at_a > at_b) {
        high = b, b = a, at_b = at_a;
        a = high - kGolden * (high - low);
        at_a = height(a);
      } else {
        low = a, a = b, at_a = at_b;
        b = low + kGolden * (high - low);
        at_b = height(b);
      }
    }
    return std::max(at_a, at_b);
  }
  /// Its second derivative by the angle, by Richardson from steps h and 2 h.
  template <class Error>
  double bend(double angle, double reach, double h, const Error& error) const {
    const double middle = at(angle, reach, error);
    const auto difference = [&](double step) {
      return (at(angle + step, reach, error) - 2 * middle + at(angle - step, reach, error)) /
             (step * step);
    };
    return (4 * difference(h) - difference(2 * h)) / 3;
  }

 private:
  const ProfileGeometry& geometry_;
  const Touching& touching_;
  double start_ = 0.8;  // of arms: beyond their angles, so that the outer side is touched
};

inline ProfilePlace<double> place_of(const ProfileGeometry& geometry, double degrees) {
  return geometry.place_at({degrees});
}

}  // namespace camlaw::problems::profile_errors_test
