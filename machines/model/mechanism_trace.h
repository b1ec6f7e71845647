// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "kinematics/expansion.h"
#include "machines/model/curve_formula.h"
#include "machines/model/cycle.h"
#include "optim/problem/curve.h"

namespace camlaw::problems {

/// A mechanism's curve for one design (docs/theory.md, "Bounds of a law over an interval"). A
/// design that makes no law is NaN everywhere and bounded nowhere. A jump of the formula inside a
/// piece of the law is a break. At a pulse (pulse_place) the curve is -infinite from the left and
/// infinite from the right: bounded neither way.
class MechanismTrace final : public optim::Trace {
 public:
  /// `uses` tells which of s, v, a, j the formula depends on, and `jumps` where it may jump
  /// (FormulaJumps::places); none where it never does.
  MechanismTrace(Cycle cycle, const std::array<bool, 4>& uses, std::optional<Law<double>> law,
                 std::function<std::optional<Law<Interval>>()> enclosing,
                 std::unique_ptr<const CurveFormula> formula,
                 const std::optional<std::vector<double>>& jumps = {});

  std::vector<double> breaks() const override;
  std::array<double, 3> at(optim::Place place) const override;
  std::vector<double> values(std::span<const optim::Place> places) const override;
  optim::Bounds enclose(double from, double to) const override;
  std::array<optim::Bounds, 3> expand(double from, double to) const override;
  std::string why_unbounded() const override;

 private:
  /// A part of the cycle in which one piece of the law runs.
  struct Section {
    double begin, end;
    std::size_t stretch, piece;
  };

  void add_sections(std::size_t stretch);
  void keep_jumps(const std::vector<double>& places);
  /// Infinite beside the pulse; elsewhere none.
  std::optional<double> pulse_at(optim::Place place) const;
  const Section& section_at(optim::Place place) const;
  /// The law's x of a place inside a section; none elsewhere.
  std::optional<double> place_inside(const Section& section, optim::Place place) const;
  Interval law_range(const Section& section, double from, double to) const;
  Interval value_at(const Section& section, double x, const Interval& ends) const;
  /// What the formula makes of a law's motion, of which s lies between the ends.
  template <std::size_t N>
  Series<Interval, N> over_motion(const Section& section, const Expansion::Derivatives& motion,
                                  const Interval& x, const Interval& ends) const;
  /// Where the law's s is proved to stay, to kBeyondEnds: 0 and 1, or infinite where it does not.
  const Interval& proved_ends() const;
  /// What is known of a stretch as a whole.
  struct Stretched {
    const Section& section;
    Interval x;
    Expansion motion;
    Series<Interval, 3> over;
    Interval ends = Interval::whole();  ///< which s was taken to lie between
  };
  /// None where nothing is enclosed.
  std::optional<Stretched> stretched(double from, double to) const;
  /// The place in the whole cycle, over the law's x.
  template <std::size_t N, class T>
  Series<T, N> place_series(const Section& section, const T& x) const {
    const Cycle::Part part = cycle_.part_of(cycle_.stretches[section.stretch]);
    Series<T, N> place(part.at(x));
    if constexpr (N > 1) place.c[1] = part.template slope<T>();
    return place;
  }

  const std::vector<PieceExpander>& expanders() const;

  Cycle cycle_;
  std::optional<Law<double>> law_;
  /// Makes the law in intervals, when something is first enclosed; then empty.
  mutable std::function<std::optional<Law<Interval>>()> enclosing_;
  mutable std::vector<PieceExpander> expanders_;  ///< of each piece; empty: nothing is enclosed
  mutable std::optional<Interval> ends_;          ///< proved_ends, when first asked for
  std::unique_ptr<const CurveFormula> formula_;
  bool uses_displacement_;
  std::vector<Section> sections_;
  std::optional<double> pulse_;  ///< its place
  double still_ = -1;          ///< s' is 0 up to this, where the formula has it (velocity_rounding)
  bool may_jump_;              ///< the formula
  std::vector<double> jumps_;  ///< where it does
};

}  // namespace camlaw::problems
