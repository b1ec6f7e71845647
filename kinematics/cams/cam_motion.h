// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "kinematics/law.h"

/// What every cam with a follower has in common (docs/theory.md, "Cams").
namespace camlaw {

/// Displacement of a follower with its derivatives by the cam angle, in metres (or radians) and
/// radians.
template <class X>
struct FollowerMotion {
  X s, ds, dds, ddds;
};

/// (M1) From the motion of a whole cycle, x = phi / (2 pi), and the stroke.
template <class T, class X>
FollowerMotion<X> follower_over_angle(const T& stroke, const Motion<X>& motion) {
  const T turn = number<T>(1) / (number<T>(2) * pi<T>());
  const T first = stroke * turn, second = first * turn, third = second * turn;
  return {stroke * motion.s, first * motion.v, second * motion.a, third * motion.j};
}

/// What loads a translating follower and drives its cam. Fields in SI units.
template <class T>
struct FollowerLoad {
  T mass;            ///< m, kg, all that moves with the follower
  T spring_rate;     ///< c, N/m
  T spring_preload;  ///< F_0, N, at the lowest place
  T load;            ///< F_L, N, constant, against the rise
  T angular_speed;   ///< omega, rad/s, of the cam

  /// (M2) Force that the cam must give along the follower's way: F = m omega^2 s'' + c s + F_0 +
  /// F_L. Below 0 a cam closed by its spring loses its follower.
  template <class X>
  X force(const FollowerMotion<X>& y) const {
    const T inertia = mass * angular_speed * angular_speed;
    return inertia * y.dds + spring_rate * y.s + (spring_preload + load);
  }
  /// (M3) Torque on the cam's shaft without friction: M = F s', from M omega = F s' omega.
  template <class X>
  X torque(const FollowerMotion<X>& y) const {
    return force(y) * y.ds;
  }
};

/// A point that moves with the cam angle, seen from the frame, with its derivatives in the cam: w
/// the point itself, w1 and w2 the first and second derivative by the angle of the curve that it
/// draws on a cam turning the other way, all as complex numbers x + i y turned back by the angle.
template <class X>
struct CamCurve {
  X x, y, x1, y1, x2, y2;

  /// |w1|: length of the curve per radian.
  X speed() const {
    using std::sqrt;
    return sqrt(x1 * x1 + y1 * y1);
  }
  /// (M4) Curvature, 1/m, positive where the cam is convex: Im(conj(w2) w1) / |w1|^3.
  X curvature() const {
    const X length = speed();
    return (y1 * x2 - x1 * y2) / (length * length * length);
  }
  /// The point `distance` inside the curve, towards the cam: w - i d w1 / |w1|.
  template <class T>
  std::pair<X, X> inside(const T& distance) const {
    const X length = speed();
    return {x + distance * (y1 / length), y - distance * (x1 / length)};
  }
};

/// A point of the frame as it lies in the cam, which has turned by phi: (x + i y) exp(-i phi).
template <class X, class Phi>
std::pair<X, X> turned_back(const std::pair<X, X>& point, const Phi& phi) {
  using std::cos;
  using std::sin;
  const auto c = cos(phi), s = sin(phi);
  return {point.first * c + point.second * s, point.second * c - point.first * s};
}

}  // namespace camlaw
