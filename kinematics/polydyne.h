// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "kinematics/law.h"

/// The lift that makes the end of an elastic follower move as wanted (docs/theory.md, "Polydyne
/// motion").
namespace camlaw {

namespace detail {

/// Where a motion over a cycle, of polynomials and harmonics, jumps in one of its derivatives from
/// 2 to `highest`, against the largest of each; the cycle's end meets its beginning.
inline std::optional<Impossible> polydyne_fault(const Law<double>& wanted, std::size_t highest) {
  constexpr std::size_t kOrders = 5;
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

}  // namespace detail

/// (PD1) The lift over a cycle, s = y + y'' / W^2, W = 2 pi tau, for the end's wanted motion y, tau
/// the natural periods of the train in a cycle. The lift's derivatives up to `matched` are
/// continuous where those of y are up to two more: impossible where they are not, for a motion with
/// curves, and for a tau that is not above 0.
template <class T>
Possible<Law<T>> possible_polydyne(const Law<T>& wanted, const T& tau, std::size_t matched = 2) {
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
  std::vector<Piece<T>> pieces = wanted.pieces();
  for (Piece<T>& piece : pieces) {
    for (std::size_t k = 0; k + 2 < piece.polynomial.size(); ++k) {
      const T twice = number<T>(static_cast<double>((k + 1) * (k + 2))) * piece.polynomial[k + 2];
      piece.polynomial[k] = piece.polynomial[k] + factor * twice;
    }
    for (auto& h : piece.harmonics) {
      const T share = number<T>(1) - factor * h.frequency * h.frequency;
      h.sine = share * h.sine;
      h.cosine = share * h.cosine;
    }
  }
  return Law<T>::possible(std::move(pieces), wanted.ends());
}

}  // namespace camlaw
