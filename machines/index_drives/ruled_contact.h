// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <utility>

#include "numerics/formula/expression.h"

namespace camlaw {

/// A point beside a cam whose axis is y, m.
struct SpacePoint {
  Expression x, y, z;
};

/// The same point in the coordinates of the cam, which has turned by phi, rad, about y.
inline SpacePoint on_turned_cam(const SpacePoint& p, const Expression& phi) {
  const Expression c = cos(phi), s = sin(phi);
  return {c * p.x - s * p.z, p.y, c * p.z + s * p.x};
}

/// Of a cylindrical roller on a cam that it has cut: the contact in one plane across the roller's
/// axis (docs/theory.md, "Contact along a roller"). The flank is the envelope of the roller's
/// surface; by the angle theta from the roller's path round its axis the condition of contact is
/// A cos theta + B sin theta = 0, whatever the roller's radius. The roller drives its turret where
/// theta is beyond a right angle and holds it on the opposite side. All per radian of the cam.
struct RuledContact {
  Expression a, b;              ///< A, B, m, with B > 0
  Expression a_along, b_along;  ///< their derivatives along the roller's axis
  Expression a_turn, b_turn;    ///< ... and by the cam's angle, m
  Expression slide;             ///< v_e, m: what the axis slides along itself by, over the cam
  Expression spin;  ///< omega_e: how the roller's frame turns about the axis, over the cam

  Expression length() const { return sqrt(a * a + b * b); }
  /// (IX11) Pressure angle, rad: tan alpha = A / B. The contact is at theta = -alpha where the
  /// flank holds, half a turn further where it drives.
  Expression pressure_angle() const { return atan(a / b); }
  /// (IX11) cos theta and sin theta of the line of contact with the flank that drives (side -1) or
  /// holds (side 1).
  std::pair<Expression, Expression> direction(double side) const {
    const Expression share = Expression(side) / length();
    return {share * b, -(share * a)};
  }
  /// 1 / cos alpha.
  Expression inclination() const { return length() / b; }
  /// (IX13) Share of L^2 that a roller of this radius takes of the flank that drives (side -1) or
  /// holds (side 1): the flank is undercut where it reaches 1.
  Expression undercut(const Expression& radius, double side) const {
    const Expression l = length(), g = tilt() * radius;
    const Expression turning = spin * l + slide * tilt() - crossed(a_turn, b_turn);
    return (g * g - Expression(side) * radius * turning) / (l * l);
  }
  /// (IX12) Sum of the curvatures of roller and flank across the line of contact, 1/m.
  Expression curvature_sum(const Expression& radius, double side) const {
    const Expression g = slant(radius);
    return (g * g + 1) / (radius * (1 - undercut(radius, side)));
  }
  /// Tangent of the angle between the line of contact and the roller's axis: r_r G / L.
  Expression slant(const Expression& radius) const { return tilt() * radius / length(); }
  /// (IX21) Turns of the roller on its pin, by those of the cam, where it rolls in this plane on
  /// the flank that drives (side -1) or holds (side 1).
  Expression turns(const Expression& radius, double side) const {
    return absolute(1 / radius * length() + Expression(side) * spin);
  }
  /// (IX22) What the roller slides along its axis by, m.
  Expression axial_slip(const Expression& radius, double side) const {
    return slide - Expression(side) * radius * tilt();
  }
  /// (IX22) Mean of what both surfaces move towards the line of contact by, m.
  Expression rolled_way(const Expression& radius, double side) const {
    const Expression g = slant(radius);
    const Expression contact = length() * (1 - undercut(radius, side));
    const Expression slipped = Expression(0.5 * side) * g * axial_slip(radius, side);
    return absolute((contact - slipped) / sqrt(g * g + 1));
  }

 private:
  /// (A' B - B' A) / L.
  Expression crossed(const Expression& da, const Expression& db) const {
    return (da * b - db * a) / length();
  }
  Expression tilt() const { return crossed(a_along, b_along); }
};

/// Planes across a roller: at its ends away from and towards the cam's axis, and half-way.
enum class RollerPlace { Root, Middle, Tip };

/// Distance of a plane from the middle, in lengths of the roller, towards the tip.
constexpr double share_of(RollerPlace place) {
  return place == RollerPlace::Root ? -0.5 : place == RollerPlace::Tip ? 0.5 : 0;
}

}  // namespace camlaw
