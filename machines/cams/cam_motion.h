// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "kinematics/law.h"
#include "numerics/formula/expression.h"

/// What every cam with a follower has in common (docs/theory.md, "Cams").
namespace camlaw {

/// Displacement of a follower with its derivatives by the cam angle, in metres (or radians) and
/// radians.
struct FollowerMotion {
  Expression s, ds, dds, ddds;
};

/// (M1) From the motion of a whole cycle, x = phi / (2 pi), and the stroke.
inline FollowerMotion follower_over_angle(const Expression& stroke,
                                          const Motion<Expression>& motion) {
  const Expression turn = 1 / (2 * pi());
  const Expression first = stroke * turn, second = first * turn, third = second * turn;
  return {stroke * motion.s, first * motion.v, second * motion.a, third * motion.j};
}

/// What loads a translating follower and drives its cam. Fields in SI units.
struct FollowerLoad {
  Expression mass;            ///< m, kg, all that moves with the follower
  Expression spring_rate;     ///< c, N/m
  Expression spring_preload;  ///< F_0, N, at the lowest place
  Expression load;            ///< F_L, N, constant, against the rise
  Expression angular_speed;   ///< omega, rad/s, of the cam

  /// (M2) Force that the cam must give along the follower's path: F = m omega^2 s'' + c s + F_0 +
  /// F_L. Below 0 a cam closed by its spring loses its follower.
  Expression force(const FollowerMotion& y) const { return inertia_force(y) + static_force(y); }
  /// What of it the masses ask for, m omega^2 s'', and what stands: c s + F_0 + F_L.
  Expression inertia_force(const FollowerMotion& y) const {
    return mass * angular_speed * angular_speed * y.dds;
  }
  Expression static_force(const FollowerMotion& y) const {
    return spring_rate * y.s + (spring_preload + load);
  }
  /// (M33) Mass against what holds it, -m s'' / (c s + F_0 + F_L), s^2. Times omega^2 it is the
  /// share of the standing force that inertia takes: the follower leaves the cam where that
  /// reaches 1. NaN where nothing holds it.
  Expression lift_ratio(const FollowerMotion& y) const {
    const Expression holding = static_force(y);
    return where_positive(holding, -(mass * y.dds) / holding);
  }
  /// (M40) How far the spring is deflected from where it bears no load: F_0 / c + s. NaN where
  /// there is no spring.
  Expression spring_deflection(const FollowerMotion& y) const {
    return y.s + where_positive(spring_rate, spring_preload / spring_rate);
  }
  /// (M3) Torque on the cam's shaft without friction: M = F s', from M omega = F s' omega.
  Expression torque(const FollowerMotion& y) const { return force(y) * y.ds; }
};

/// A point of a curve on the cam, turned as the frame sees it: p, and the curve's derivative p1.
struct CamPoint {
  Expression x, y, x1, y1;

  std::pair<Expression, Expression> place() const { return {x, y}; }
  /// (M41) Distance from the cam's centre.
  Expression distance() const { return sqrt(x * x + y * y); }
  /// (M34) What the curve sweeps per radian: the area dA = cross(p1, p) / 2 and its polar moment
  /// dI = |p|^2 cross(p1, p) / 4, positive for a curve that runs clockwise round the centre.
  Expression area_rate() const { return Expression(0.5) * (x1 * y - y1 * x); }
  Expression moment_rate() const { return Expression(0.5) * (x * x + y * y) * area_rate(); }
};

/// A point that moves with the cam angle, seen from the frame, with its derivatives in the cam: w
/// the point itself, w1 and w2 the first and second derivative by the angle of the curve that it
/// draws on a cam turning the other way, all as complex numbers x + i y turned back by the angle.
struct CamCurve {
  Expression x, y, x1, y1, x2, y2;

  /// |w1|: length of the curve per radian.
  Expression speed() const { return sqrt(x1 * x1 + y1 * y1); }
  /// (M4) Curvature, 1/m, positive where the cam is convex: Im(conj(w2) w1) / |w1|^3.
  Expression curvature() const {
    const Expression length = speed();
    return (y1 * x2 - x1 * y2) / (length * length * length);
  }
  /// The point `distance` inside the curve, towards the cam: w - i d w1 / |w1|, and the derivative
  /// of the curve that it draws, w1 (1 - d k).
  CamPoint inside(const Expression& distance) const {
    const Expression length = speed();
    const Expression shorter = 1 - distance * curvature();
    return {x + distance * (y1 / length), y - distance * (x1 / length), shorter * x1, shorter * y1};
  }
};

/// A point of the frame as it lies in the cam, which has turned by phi: (x + i y) exp(-i phi).
inline std::pair<Expression, Expression> turned_back(const CamPoint& p, const Expression& phi) {
  const Expression c = cos(phi), s = sin(phi);
  return {p.x * c + p.y * s, p.y * c - p.x * s};
}

/// What a disc cam is cut from. Fields in SI units.
struct CamBlank {
  Expression density;      ///< rho, kg/m^3
  Expression bore_radius;  ///< r_0, m
  Expression width;        ///< b, m

  /// (M35) Mass, kg, from the area inside the profile: rho b (A - pi r_0^2).
  Expression mass(const Expression& area) const {
    return density * width * left(area - pi() * bore_radius * bore_radius);
  }
  /// (M36) Moment of inertia about the shaft, kg m^2, from the polar moment of the area:
  /// rho b (I - pi r_0^4 / 2).
  Expression inertia(const Expression& moment) const {
    const Expression square = bore_radius * bore_radius;
    return density * width * left(moment - pi() * square * square / 2);
  }

 private:
  /// NaN where the bore leaves nothing.
  static Expression left(const Expression& rest) { return where_positive(rest, rest); }
};

}  // namespace camlaw
