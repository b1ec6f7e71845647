// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "kinematics/law.h"

/// The lift that makes the end of an elastic follower move as wanted (docs/theory.md, "Polydyne
/// motion").
namespace camlaw {

namespace detail {

/// Where a motion over a cycle, of polynomials and harmonics, jumps in one of its derivatives from
/// 2 to `highest`, against the largest of each; the cycle's end meets its beginning.
inline std::optional<Impossible> polydyne_fault(const Law<double>& wanted, std::size_t highest) {
  constexpr std::size_t kOrders = 5;  // s to s'''', which the lift has in its acceleration
  // Of the largest derivative: a coefficient with seven digits joins as well.
  constexpr double kSlack = 1e-6;
  constexpr std::array kNames{"displacement", "velocity", "acceleration", "jerk",
                              "derivative of the jerk"};
  const auto& pieces = wanted.pieces();
  std::array<double, kOrders> size{};
  for (const auto& piece : pieces) {
    for (const double share : {0.0, 0.13, 0.31, 0.5, 0.69, 0.87, 1.0}) {
      const auto d = derivatives<kOrders>(piece, std::lerp(piece.begin, piece.end, share));
      for (std::size_t k = 0; k < kOrders; ++k) size[k] = std::max(size[k], std::abs(d[k]));
    }
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto& before = pieces[i == 0 ? pieces.size() - 1 : i - 1];
    const auto left = derivatives<kOrders>(before, before.end);
    const auto right = derivatives<kOrders>(pieces[i], pieces[i].begin);
    for (std::size_t k = 1; k <= highest; ++k) {
      if (std::abs(left[k] - right[k]) <= kSlack * size[k]) continue;
      if (k == 1) {
        return Impossible{fmt::format(
            "a polydyne lift is made for a motion without jumps of velocity, and at {:.6g} deg the "
            "velocity jumps: use laws in which it does not, such as 5-6-7-8-9",
            360 * pieces[i].begin)};
      }
      return Impossible{
          fmt::format("a polydyne lift has the wanted motion's {} in its own {}, and at {:.6g} deg "
                      "that one jumps: use laws in which it does not, such as 5-6-7-8-9",
                      kNames[k], kNames[k - 2], 360 * pieces[i].begin)};
    }
  }
  return {};
}

/// The exponential that damping leaves behind each joint is followed over so many pieces, each so
/// long in parts of its own length, e; what is left then, exp(-36) of it, is below rounding. Its
/// Taylor terms about the middle of a piece: the next one is 3e-17 of it.
inline constexpr int kLagPieces = 9;
inline constexpr double kLagStep = 4;
inline constexpr std::size_t kLagTerms = 24;

/// A piece of polynomials and harmonics about another origin.
template <class T>
Piece<T> about_origin(Piece<T> piece, const T& origin) {
  using std::cos;
  using std::sin;
  const T shift = origin - piece.origin;
  std::vector<T>& a = piece.polynomial;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = a.size() - 1; k-- > i;) a[k] = a[k] + shift * a[k + 1];
  }
  for (auto& h : piece.harmonics) {
    const T c = cos(h.frequency * shift), s = sin(h.frequency * shift);
    h = {c * h.sine - s * h.cosine, s * h.sine + c * h.cosine, h.frequency};
  }
  piece.origin = origin;
  return piece;
}

/// Adds g = y'' / W^2 to a piece of y, or with damping what has u + e u' = g there; `factor` is
/// 1 / W^2. Returns u alone.
template <class T>
Piece<T> add_lead(Piece<T>& piece, const T& factor, const T& e) {
  Piece<T> lead{piece.begin, piece.end, piece.origin, {}, {}, {}};
  std::vector<T>& u = lead.polynomial;
  if (piece.polynomial.size() > 2) u.resize(piece.polynomial.size() - 2);
  for (std::size_t k = u.size(); k-- > 0;) {
    const T twice = number<T>(static_cast<double>((k + 1) * (k + 2))) * piece.polynomial[k + 2];
    u[k] = factor * twice;
    if (k + 1 < u.size()) u[k] = u[k] - number<T>(static_cast<double>(k + 1)) * e * u[k + 1];
  }
  for (const auto& h : piece.harmonics) {
    const T turned = e * h.frequency, bent = -(factor * h.frequency * h.frequency);
    const T share = bent / (number<T>(1) + turned * turned);
    lead.harmonics.push_back(
        {share * (h.sine + turned * h.cosine), share * (h.cosine - turned * h.sine), h.frequency});
  }
  for (std::size_t k = 0; k < u.size(); ++k) piece.polynomial[k] = piece.polynomial[k] + u[k];
  for (std::size_t k = 0; k < lead.harmonics.size(); ++k) {
    piece.harmonics[k].sine = piece.harmonics[k].sine + lead.harmonics[k].sine;
    piece.harmonics[k].cosine = piece.harmonics[k].cosine + lead.harmonics[k].cosine;
  }
  return lead;
}

/// (PD3) A piece of the lift with the exponential of this amplitude at its beginning: as many
/// pieces for every lift.
template <class T>
void add_with_lag(std::vector<Piece<T>>& all, const Piece<T>& piece, const T& amplitude,
                  const T& e) {
  using std::exp;
  const T even = (piece.end - piece.begin) / number<T>(kLagPieces + 1);
  const T natural = number<T>(kLagStep) * e;
  const bool is_short = value_of(even) < value_of(natural);  // it ends before the exponential
  const T step = is_short ? even : natural;
  for (int i = 0; i <= kLagPieces; ++i) {
    const bool is_last = i == kLagPieces;
    const T from = i == 0 ? piece.begin : all.back().end;
    const T to = is_last ? piece.end : piece.begin + number<T>(i + 1) * step;
    if (is_last && !is_short) {
      all.push_back(piece);
      all.back().begin = from;
      break;
    }
    const T middle = number<T>(0.5) * (from + to);
    Piece<T> part = about_origin(piece, middle);
    part.begin = from;
    part.end = to;
    if (part.polynomial.size() < kLagTerms) part.polynomial.resize(kLagTerms, number<T>(0));
    T term = amplitude * exp(-((middle - piece.begin) / e));
    for (std::size_t k = 0; k < kLagTerms; ++k) {
      part.polynomial[k] = part.polynomial[k] + term;
      term = -(term / (number<T>(static_cast<double>(k + 1)) * e));
    }
    all.push_back(std::move(part));
  }
}

/// (PD4) The amplitudes of the exponentials at the pieces' beginnings with which the lead u is
/// continuous over a cycle that repeats.
template <class T>
std::vector<T> lag_amplitudes(const std::vector<Piece<T>>& leads, const T& e) {
  using std::exp;
  const auto at = [](const Piece<T>& lead, const T& x) { return derivatives<1>(lead, x)[0]; };
  const auto around = [&](std::vector<T>& amplitudes) {
    T left = number<T>(0);
    for (std::size_t i = 0; i < leads.size(); ++i) {
      const Piece<T>& lead = leads[i];
      const Piece<T>& next = leads[(i + 1) % leads.size()];
      left = at(lead, lead.end) - at(next, next.begin) +
             amplitudes[i] * exp(-((lead.end - lead.begin) / e));
      if (i + 1 < leads.size()) amplitudes[i + 1] = left;
    }
    return left;
  };
  std::vector<T> amplitudes(leads.size(), number<T>(0));
  const T unclosed = around(amplitudes);
  amplitudes[0] = unclosed / (number<T>(1) - exp(-(number<T>(1) / e)));
  around(amplitudes);
  return amplitudes;
}

}  // namespace detail

/// (PD1), (PD2) The lift over a cycle for the end's wanted motion y, tau the natural periods of the
/// train in a cycle: s = y + y'' / W^2, W = 2 pi tau, without damping; with the damping ratio zeta
/// s + e s' = y + e y' + y'' / W^2, e = 2 zeta / W. The lift's derivatives up to `matched` are
/// continuous where those of y are up to two more: impossible where they are not, for a motion with
/// curves, and for a tau that is not above 0.
template <class T>
Possible<Law<T>> possible_polydyne(const Law<T>& wanted, const T& tau, std::size_t matched = 2,
                                   const T& damping = number<T>(0)) {
  if (!(value_of(tau) > 0)) {
    return Impossible{"polydyne: the natural periods of the train in a turn must be above 0"};
  }
  if (!wanted.is_data()) {
    return Impossible{"polydyne: the wanted motion does not consist of polynomials and harmonics"};
  }
  if (auto fault = detail::polydyne_fault(wanted.template as<double>(), 2 + matched)) {
    return std::move(*fault);
  }
  const T W = number<T>(2) * pi<T>() * tau, factor = number<T>(1) / (W * W);
  const T e = number<T>(2) * damping / W;
  std::vector<Piece<T>> pieces = wanted.pieces(), leads;
  for (Piece<T>& piece : pieces) leads.push_back(detail::add_lead(piece, factor, e));
  if (is_number(damping, 0)) return Law<T>::possible(std::move(pieces), wanted.ends());
  const std::vector<T> amplitudes = detail::lag_amplitudes(leads, e);
  std::vector<Piece<T>> lagging;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    detail::add_with_lag(lagging, pieces[i], amplitudes[i], e);
  }
  return Law<T>::possible(std::move(lagging), wanted.ends());
}

}  // namespace camlaw
