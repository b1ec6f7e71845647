// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "machines/model/turn_work.h"

/// The work of one design at many places: integrals up to the ends of steps, and from there on.
namespace camlaw::problems {

/// In plain numbers. A step of the quadrature is halved, up to six times, until the torque is a
/// polynomial of degree 9 in it but for 1e-13 of its size.
class RunningWork {
 public:
  explicit RunningWork(const TurnSections<double>& turn);

  double mean() const { return whole_.mean; }
  /// At a share of the turn.
  double at(double share) const;

 private:
  /// The quadrature's own places tell as many terms, and a smooth step needs no halving.
  static constexpr std::size_t kTerms = 10;
  using Terms = std::array<double, kTerms>;
  /// From t = -1 to 1 the torque is the sum of terms[n] P_n(t), of Legendre's polynomials.
  struct Step {
    double middle, half, before;
    Terms terms;
    double integral(double t) const;
  };
  void add_steps(const TurnSections<double>& turn, const TurnSections<double>::Section& section,
                 double begin, double end, int halvings);

  detail::Turned<double> whole_;
  double largest_ = 0;  ///< torque
  std::vector<Step> steps_;
};

/// The same enclosed.
class EnclosedWork {
 public:
  explicit EnclosedWork(TurnSections<Interval> turn);

  const Interval& mean() const { return whole_.mean; }
  /// At a place of the section that holds `inside`, shares of the turn; beyond the section's ends
  /// by rounding at most.
  Interval at(const Interval& share, double inside) const;

 private:
  /// The terms of a step serve for every part of it.
  using Steps = std::vector<detail::EnclosedStep>;

  TurnSections<Interval> turn_;
  std::vector<Steps> steps_;  ///< of each section
  detail::Turned<Interval> whole_;
  std::vector<std::vector<Interval>> before_;  ///< each step
};

}  // namespace camlaw::problems
