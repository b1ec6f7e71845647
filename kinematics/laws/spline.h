// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/laws/build.h"
#include "kinematics/shape.h"

/// Laws that are splines. Equations: docs/theory.md, "Splines".
namespace camlaw {

/// The B-spline law of a degree: clamped at 0 and 1, `interior` knots in (0, 1) not decreasing (one
/// repeated m times leaves continuity degree - m), and degree + 1 + interior.size() coefficients of
/// s. Generic in knots and coefficients. Impossible for a wrong count, a knot out of order or
/// repeated more than `degree` times.
template <class T>
Possible<Law<T>> possible_b_spline(int degree, const std::vector<T>& interior,
                                   const std::vector<T>& coefficients);

/// The spline that goes through samples of a law: s at each x, and v too where `v` is not empty.
/// x must increase from 0 to 1. With s alone: degree 5 (less for fewer than six samples), knots at
/// the samples but the outer ones ("not a knot"), so that polynomials up to that degree come back
/// exactly. With v: degree 5 with double knots. Coefficients depend linearly on s and v, which may
/// be Dual; with Interval the law is the one of the midpoints. Impossible for bad x or counts.
template <class T>
Possible<Law<T>> possible_table(const std::vector<double>& x, const std::vector<T>& s,
                                const std::vector<T>& v = {});

/// All coefficients of a law that is a spline of this degree on these interior knots: each is the
/// polar form of a piece that it moves (docs/theory.md, FL3). Of a law that is no such spline,
/// those of a spline near it.
std::vector<double> spline_coefficients(const Law<double>& law, int degree,
                                        const std::vector<double>& interior);

/// These throw std::invalid_argument where that is impossible.
template <class T>
Law<T> b_spline(int degree, const std::vector<T>& interior, const std::vector<T>& coefficients) {
  return possible_b_spline(degree, interior, coefficients).value();
}

template <class T>
Law<T> table(const std::vector<double>& x, const std::vector<T>& s, const std::vector<T>& v = {}) {
  return possible_table(x, s, v).value();
}

// ---------------------------------------------------------------------------------------------

namespace detail {

/// Why degree, knots and count of coefficients do not fit together, if so.
std::optional<Impossible> bad_spline(int degree, const std::vector<double>& interior,
                                     std::size_t coefficients);

/// Where a table's interpolating spline lies and the matrix that gives its coefficients.
struct TableSpline {
  int degree;
  std::vector<double> knots;  ///< interior
  std::size_t samples;
  bool with_velocity;
};
Possible<TableSpline> table_spline(const std::vector<double>& x, std::size_t samples,
                                   std::size_t velocities);
/// Coefficients for each column of right-hand sides (s, then v, as interleaved rows).
Possible<std::vector<std::vector<double>>> solve_table(
    const TableSpline& spline, const std::vector<double>& x,
    const std::vector<std::vector<double>>& columns);

/// Clamped knot vector.
template <class T>
std::vector<T> clamped(int degree, const std::vector<T>& interior) {
  const auto ends = static_cast<std::size_t>(degree + 1);
  std::vector<T> knots(ends, number<T>(0));
  knots.insert(knots.end(), interior.begin(), interior.end());
  knots.insert(knots.end(), ends, number<T>(1));
  return knots;
}

/// de Boor's algorithm at x in the span `span` (index of its left knot) for coefficients of a
/// spline of the given degree whose knots start at `knots[skip]`; `d` is room for it.
template <class T>
T de_boor(std::size_t span, int degree, std::size_t skip, const std::vector<T>& knots,
          const std::vector<T>& coefficients, const T& x, std::vector<T>& d) {
  const auto p = static_cast<std::size_t>(degree);
  const std::size_t first = span - p - skip;
  d.assign(coefficients.begin() + static_cast<std::ptrdiff_t>(first),
           coefficients.begin() + static_cast<std::ptrdiff_t>(first + p + 1));
  for (std::size_t r = 1; r <= p; ++r) {
    for (std::size_t i = p; i >= r; --i) {
      const T& left = knots[first + i + skip];
      const T& right = knots[first + i + skip + p + 1 - r];
      const T share = (x - left) / (right - left);
      d[i] = (number<T>(1) - share) * d[i - 1] + share * d[i];
    }
  }
  return d[p];
}

template <class T>
T de_boor(std::size_t span, int degree, std::size_t skip, const std::vector<T>& knots,
          const std::vector<T>& coefficients, const T& x) {
  std::vector<T> room;
  return de_boor(span, degree, skip, knots, coefficients, x, room);
}

/// Coefficients of the derivative of a spline of this degree; `skip` as in de_boor.
template <class T>
std::vector<T> derivative_coefficients(int degree, std::size_t skip, const std::vector<T>& knots,
                                       const std::vector<T>& c) {
  std::vector<T> result;
  for (std::size_t i = 0; i + 1 < c.size(); ++i) {
    const T width = knots[i + 1 + skip + static_cast<std::size_t>(degree)] - knots[i + 1 + skip];
    // Zero width: a knot as often as the degree; the term has no support.
    result.push_back(value_of(width) == 0 ? number<T>(0)
                                          : number<T>(degree) * (c[i + 1] - c[i]) / width);
  }
  return result;
}

}  // namespace detail

template <class T>
Possible<Law<T>> possible_b_spline(int degree, const std::vector<T>& interior,
                                   const std::vector<T>& coefficients) {
  std::vector<double> plain;
  for (const T& knot : interior) plain.push_back(value_of(knot));
  if (auto fault = detail::bad_spline(degree, plain, coefficients.size())) {
    return std::move(*fault);
  }
  const std::vector<T> knots = detail::clamped(degree, interior);
  std::vector<std::vector<T>> levels{coefficients};  // of s, s', s'', ...
  for (int k = 0; k < degree; ++k) {
    levels.push_back(detail::derivative_coefficients(degree - k, static_cast<std::size_t>(k), knots,
                                                     levels.back()));
  }
  std::vector<Piece<T>> pieces;
  pieces.reserve(interior.size() + 1);
  std::vector<T> room;
  for (std::size_t j = static_cast<std::size_t>(degree); j + 1 < knots.size(); ++j) {
    if (!(value_of(knots[j]) < value_of(knots[j + 1]))) continue;
    // Powers about an end lose digits as fast as the degree grows. Up to degree 8 they keep all but
    // a few, and coefficients that do not matter at the begin have slopes of exactly 0 there.
    constexpr int kAboutBegin = 8;
    const T origin = degree <= kAboutBegin ? knots[j] : number<T>(0.5) * (knots[j] + knots[j + 1]);
    Piece<T> piece{knots[j], knots[j + 1], origin, {}, {}, {}};
    piece.polynomial.reserve(static_cast<std::size_t>(degree) + 1);
    double factorial = 1;
    for (int k = 0; k <= degree; ++k) {
      if (k > 1) factorial *= k;
      const auto level = static_cast<std::size_t>(k);
      piece.polynomial.push_back(
          detail::de_boor(j, degree - k, level, knots, levels[level], origin, room) /
          number<T>(factorial));
    }
    pieces.push_back(std::move(piece));
  }
  const Ends ends = natural_ends(piece_as<double>(pieces.front()), piece_as<double>(pieces.back()));
  return Law<T>::possible(std::move(pieces), ends);
}

template <class T>
Possible<Law<T>> possible_table(const std::vector<double>& x, const std::vector<T>& s,
                                const std::vector<T>& v) {
  const auto spline = detail::table_spline(x, s.size(), v.size());
  if (!spline) return spline.reason();
  std::vector<T> data;
  for (std::size_t i = 0; i < s.size(); ++i) {
    data.push_back(s[i]);
    if (!v.empty()) data.push_back(v[i]);
  }
  if constexpr (std::is_same_v<T, double> || std::is_same_v<T, Interval>) {
    std::vector<double> plain;
    for (const T& value : data) plain.push_back(value_of(value));
    const auto c = detail::solve_table(*spline, x, {plain});
    if (!c) return c.reason();
    const auto law = possible_b_spline<double>(spline->degree, spline->knots, c->front());
    if (!law) return law.reason();
    return law->template as<T>();
  } else {
    // Derivatives by the samples: every coefficient is a fixed combination of the data.
    std::vector<std::vector<double>> units(data.size(), std::vector<double>(data.size(), 0.0));
    for (std::size_t i = 0; i < data.size(); ++i) units[i][i] = 1;
    const auto inverse = detail::solve_table(*spline, x, units);
    if (!inverse) return inverse.reason();
    std::vector<T> c(data.size(), number<T>(0)), knots;
    for (std::size_t i = 0; i < c.size(); ++i) {
      for (std::size_t k = 0; k < data.size(); ++k) {
        c[i] = c[i] + number<T>((*inverse)[k][i]) * data[k];
      }
    }
    for (const double knot : spline->knots) knots.push_back(number<T>(knot));
    return possible_b_spline<T>(spline->degree, knots, c);
  }
}

}  // namespace camlaw
