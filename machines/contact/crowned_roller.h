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
  X greater;     ///< the greater principal sum of the curvatures with the crown, 1/m
  K smaller;     ///< the smaller one
  T face_width;  ///< b, m
  LineContact<T> material;

  /// (RB10)
  ContactEllipse<X> ellipse() const {
    return contact_ellipse(force, greater, smaller, material.plane_modulus());
  }
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
  return {force, across, greater, product / greater, face_width, material};
}

/// The greatest length by width of an ellipse at which the error of (RB9) is told: alpha = 500.
inline constexpr double kKnownElongation = 46.63;

enum class CrownCurve {
  MaxShear,
  ShearDepth,
  Stress,
  Shear,
  DepthOfShear,
  HalfLength,
  Fraction,
  Elongation
};

/// (K5), (K6) of the line contact, (RB10), (RB16), (RB17) of the crowned roller.
template <class T, class K, class X>
X crown_curve(CrownCurve which, const PressedRoller<T, K, X>& roller) {
  const X line_load = roller.force / roller.face_width;
  const T& ratio = roller.material.poisson_ratio;
  switch (which) {
    case CrownCurve::MaxShear:
      return max_shear(X(roller.material.pressure(line_load, roller.across)));
    case CrownCurve::ShearDepth:
      return shear_depth(X(roller.material.half_width(line_load, roller.across)));
    case CrownCurve::Stress:
      return roller.ellipse().pressure;
    case CrownCurve::Shear: {
      const ContactEllipse<X> ellipse = roller.ellipse();
      return crown_shear(ellipse.pressure, ellipse.elongation, ratio);
    }
    case CrownCurve::DepthOfShear: {
      const ContactEllipse<X> ellipse = roller.ellipse();
      return crown_shear_depth(ellipse.half_width, ellipse.elongation, ratio);
    }
    case CrownCurve::HalfLength:
      return roller.ellipse().half_length;
    case CrownCurve::Elongation:
      return roller.ellipse().elongation;
    case CrownCurve::Fraction:
      break;
  }
  return roller.ellipse().half_length / (number<X>(0.5) * roller.face_width);
}

enum class FilmCurve { Thickness, Lambda, CrownThickness, CrownLambda };

/// (RB7) Film of the line contact, (RB18) of the crowned roller, m, or over the roughness of both
/// surfaces, from the mean speed of the surfaces towards the contact, m/s.
template <class T, class K, class X>
X film_curve(FilmCurve which, const Lubricant<T>& oil, const PressedRoller<T, K, X>& roller,
             const X& speed) {
  const T modulus = roller.material.plane_modulus();
  const auto of_line = [&] {
    return oil.film(X(roller.force / roller.face_width), roller.across, speed, modulus);
  };
  const auto of_crown = [&] {
    return oil.point_film(roller.force, roller.greater, roller.ellipse().elongation, speed,
                          modulus);
  };
  switch (which) {
    case FilmCurve::Thickness:
      return of_line();
    case FilmCurve::Lambda:
      return of_line() / oil.roughness;
    case FilmCurve::CrownThickness:
      return of_crown();
    case FilmCurve::CrownLambda:
      break;
  }
  return of_crown() / oil.roughness;
}

}  // namespace camlaw
