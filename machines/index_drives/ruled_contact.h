// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <utility>

#include "numerics/scalar/absolute.h"
#include "numerics/scalar/scalar.h"

namespace camlaw {

/// A point beside a cam whose axis is y, m.
template <class X>
struct SpacePoint {
  X x, y, z;
};

/// The same point in the coordinates of the cam, which has turned by phi, rad, about y.
template <class X>
SpacePoint<X> on_turned_cam(const SpacePoint<X>& p, const X& phi) {
  using std::cos;
  using std::sin;
  const X c = cos(phi), s = sin(phi);
  return {c * p.x - s * p.z, p.y, c * p.z + s * p.x};
}

/// Of a cylindrical roller on a cam that it has cut: the contact in one plane across the roller's
/// axis (docs/theory.md, "Contact along a roller"). The flank is the envelope of the roller's
/// surface; by the angle theta from the roller's path round its axis the condition of contact is
/// A cos theta + B sin theta = 0, whatever the roller's radius. The roller drives its turret where
/// theta is beyond a right angle and holds it on the opposite side. All per radian of the cam.
template <class X>
struct RuledContact {
  X a, b;              ///< A, B, m, with B > 0
  X a_along, b_along;  ///< their derivatives along the roller's axis
  X a_turn, b_turn;    ///< ... and by the cam's angle, m
  X slide;             ///< v_e, m: what the axis slides along itself by, over the cam
  X spin;              ///< omega_e: how the roller's frame turns about the axis, over the cam

  X length() const {
    using std::sqrt;
    return sqrt(a * a + b * b);
  }
  /// (IX11) Pressure angle, rad: tan alpha = A / B. The contact is at theta = -alpha where the
  /// flank holds, half a turn further where it drives.
  X pressure_angle() const {
    using std::atan;
    return atan(a / b);
  }
  /// (IX11) cos theta and sin theta of the line of contact with the flank that drives (side -1) or
  /// holds (side 1).
  std::pair<X, X> direction(double side) const {
    const X share = number<X>(side) / length();
    return {share * b, -(share * a)};
  }
  /// 1 / cos alpha.
  X inclination() const { return length() / b; }
  /// (IX13) Share of L^2 that a roller of this radius takes of the flank that drives (side -1) or
  /// holds (side 1): the flank is undercut where it reaches 1.
  template <class T>
  X undercut(const T& radius, double side) const {
    const X l = length(), g = tilt() * radius;
    const X turning = spin * l + slide * tilt() - crossed(a_turn, b_turn);
    return (g * g - number<T>(side) * radius * turning) / (l * l);
  }
  /// (IX12) Sum of the curvatures of roller and flank across the line of contact, 1/m.
  template <class T>
  X curvature_sum(const T& radius, double side) const {
    const X g = slant(radius);
    return (g * g + number<T>(1)) / (radius * (number<X>(1) - undercut(radius, side)));
  }
  /// Tangent of the angle between the line of contact and the roller's axis: r_r G / L.
  template <class T>
  X slant(const T& radius) const {
    return tilt() * radius / length();
  }
  /// (IX21) Turns of the roller on its pin, by those of the cam, where it rolls in this plane on
  /// the flank that drives (side -1) or holds (side 1).
  template <class T>
  X turns(const T& radius, double side) const {
    return absolute(X(number<X>(1) / radius * length() + number<X>(side) * spin));
  }
  /// (IX22) What the roller slides along its axis by, m.
  template <class T>
  X axial_slip(const T& radius, double side) const {
    return slide - number<X>(side) * radius * tilt();
  }
  /// (IX22) Mean of what both surfaces move towards the line of contact by, m.
  template <class T>
  X rolled_way(const T& radius, double side) const {
    using std::sqrt;
    const X g = slant(radius);
    const X contact = length() * (number<X>(1) - undercut(radius, side));
    const X slipped = number<X>(0.5 * side) * g * axial_slip(radius, side);
    return absolute(X((contact - slipped) / sqrt(g * g + number<T>(1))));
  }

 private:
  /// (A' B - B' A) / L.
  X crossed(const X& da, const X& db) const { return (da * b - db * a) / length(); }
  X tilt() const { return crossed(a_along, b_along); }
};

/// Planes across a roller: at its ends away from and towards the cam's axis, and half-way.
enum class RollerPlace { Root, Middle, Tip };

/// Distance of a plane from the middle, in lengths of the roller, towards the tip.
constexpr double share_of(RollerPlace place) {
  return place == RollerPlace::Root ? -0.5 : place == RollerPlace::Tip ? 0.5 : 0;
}

}  // namespace camlaw
