// SPDX-License-Identifier: MIT
#pragma once

#include "machines/contact/elliptic_contact.h"
#include "machines/contact/hertz.h"
#include "machines/contact/lubricant.h"

/// What a roller and a flank bear below their surfaces, and where the roller is crowned
/// (docs/theory.md, "Line contact", "Crowned rollers" and
/// "Lubricant film").
namespace camlaw {

/// A roller pressed on a flank. K is T, or X where the crown lies askew of the line of contact.
template <class T, class K, class X>
struct PressedRoller {
  X force;       ///< F, N
  X across;      ///< sum of the curvatures square to the line of contact, without a crown, 1/m
  X rolling;     ///< the principal sum of the curvatures towards which the roller rolls, 1/m
  K along;       ///< the other one, of the crown
  T face_width;  ///< b, m
  LineContact<T> material;

  /// (RB10)
  ContactEllipse<X> ellipse() const {
    return contact_ellipse(force, rolling, along, material.plane_modulus());
  }
  X line_load() const { return force / face_width; }
  /// (K5), (K6) of the line contact: greatest shear, Pa, and its depth, m.
  X line_shear() const { return max_shear(X(material.pressure(line_load(), across))); }
  X line_shear_depth() const { return shear_depth(X(material.half_width(line_load(), across))); }
  /// (RB16), (RB17) of the crowned roller.
  X shear() const {
    const ContactEllipse<X> own = ellipse();
    return crown_shear(own.pressure, own.slenderness, material.poisson_ratio);
  }
  X depth_of_shear() const {
    const ContactEllipse<X> own = ellipse();
    return crown_shear_depth(own.lesser_half_axis(), own.slenderness, material.poisson_ratio);
  }
  /// Length of the ellipse over the width of the face.
  X crown_fraction() const { return ellipse().half_length / (number<X>(0.5) * face_width); }
};

/// One whose crown, 1/m, lies along the line of contact.
template <class T, class X>
PressedRoller<T, T, X> pressed_roller(const X& force, const X& across, const T& crown,
                                      const T& face_width, const LineContact<T>& material) {
  return {force, across, across, crown, face_width, material};
}

/// (RB15) One on a line of contact whose angle to the roller's axis has the tangent `tilt`: the sum
/// of its curvatures is across + crown, their product across crown / (1 + tilt^2).
template <class T, class X>
PressedRoller<T, X, X> pressed_askew(const X& force, const X& across, const X& tilt, const T& crown,
                                     const T& face_width, const LineContact<T>& material) {
  using std::sqrt;
  const X half = number<X>(0.5) * (across + crown), apart = number<X>(0.5) * (across - crown);
  const X product = crown * (across / (number<X>(1) + tilt * tilt));
  // half^2 - product, of which nothing cancels.
  const X greater = half + sqrt(apart * apart + product * (tilt * tilt));
  const X lesser = product / greater;
  return {force,      across,  by_side(apart, greater, lesser), by_side(apart, lesser, greater),
          face_width, material};
}

/// The greatest length by width of an ellipse, or width by length, at which the error of (RB9) is
/// told: alpha = 500.
inline constexpr double kKnownElongation = 46.63;

/// What a roller is pressed on with oil between, and the mean speed of the surfaces towards the
/// contact, m/s.
template <class T, class K, class X>
struct RollerFilm {
  Lubricant<T> oil;
  PressedRoller<T, K, X> roller;
  X speed;

  /// (RB7) Film of the line contact, m.
  X of_line() const {
    return oil.film(X(roller.force / roller.face_width), roller.across, speed,
                    roller.material.plane_modulus());
  }
  /// (RB18) Film of the crowned roller, m.
  X of_crown() const {
    return oil.point_film(roller.force, roller.rolling, roller.ellipse().elongation, speed,
                          roller.material.plane_modulus());
  }
};

template <class T, class K, class X>
RollerFilm<T, K, X> roller_film(const Lubricant<T>& oil, const PressedRoller<T, K, X>& roller,
                                const X& speed) {
  return {oil, roller, speed};
}

}  // namespace camlaw
