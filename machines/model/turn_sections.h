// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "machines/model/cycle_mean.h"
#include "machines/model/decisions.h"
#include "machines/model/law_binding.h"
#include "machines/model/mechanism.h"
#include "machines/model/pulse.h"
#include "machines/model/recorded_kernel.h"
#include "machines/model/rest_velocity.h"

/// A curve over a whole turn as sections in which it is smooth, in any scalar: what integrals over
/// the turn are made of (docs/theory.md, "Integrals over the cycle"). Places are shares of the
/// turn, from 0 to 1.
namespace camlaw::problems {

/// What such a curve is made of, for what varies of a binding.
struct TurnRecord {
  Cycle cycle;
  /// The formula: of a curve that a law drives one, of the machine's arguments, s, v, a, j and the
  /// share; else one for each section, of the arguments and the angle, rad.
  std::vector<Recorded> formulas;
  std::vector<Decisions> decisions;  ///< of each formula
  std::vector<Recorded> breaks;      ///< without a law: where sections meet, rad
  std::shared_ptr<const LawBinding> law;
  std::vector<std::size_t> variables;  ///< of the design, behind the arguments and then the law's

  std::size_t arguments() const { return formulas.front().arguments; }
};

/// Of a curve over a turn that a law drives, or that is a formula of the angle; the binding is
/// narrowed to it.
std::shared_ptr<const TurnRecord> turn_record(const MechanismResponse& curve,
                                              const Binding& binding);

/// The curve of one design. Places of sections carry the derivatives of what moves them. In plain
/// and dual numbers a section ends where the formula decides otherwise too. Holds no more than a
/// reference to the record.
template <class T>
class TurnSections {
 public:
  struct Section {
    T begin, end;
    double rate;  ///< the steps of a quadrature that a whole turn of it needs at least
    std::size_t stretch = 0;
    std::size_t piece = 0;  ///< of the law; else the number of the formula
  };

  /// None where there is no such machine or law, and where the motion's velocity jumps.
  static std::optional<TurnSections> of(const TurnRecord& record, std::span<const T> u) {
    std::optional<TurnSections> result = whole(record, u);
    if constexpr (!std::is_same_v<T, Interval>) {
      if (result) result->split(u);
    }
    return result;
  }

  const std::vector<Section>& sections() const { return sections_; }
  /// Where the record's own sections end, which decisions do not count among.
  const std::vector<T>& joints() const { return joints_; }

  /// By a section's own formula, wherever the section's ends are.
  T at(const Section& section, const T& share) const {
    const auto taken = inputs(section, share);
    return formula_of(section)(std::span<const T>(taken));
  }
  /// The curve's Taylor terms about c and over a box.
  detail::TaylorTerms terms(const Section& section, const Interval& c, const Interval& box) const;

 private:
  friend class TurnSections<Dual>;
  friend class TurnSections<Dual2>;

  static std::optional<TurnSections> whole(const TurnRecord& record, std::span<const T> u);
  void add_pieces();
  void add_formulas(std::span<const T> machine);
  void split(std::span<const T> u);
  const FormulaAlong<T>& formula_of(const Section& section) const {
    return formulas_[law_ ? 0 : section.piece];
  }
  /// What the formula takes at a share.
  template <class X>
  std::vector<Joined<T, X>> inputs(const Section& section, const X& share) const {
    using R = Joined<T, X>;
    const R place = convert<R>(share);
    if (!law_) return {number<R>(2) * pi<R>() * place};
    const Stretch& stretch = record_->cycle.stretches[section.stretch];
    const auto d = derivatives<4>(law_->pieces()[section.piece], law_place(stretch, place));
    Motion<R> m = follower_motion(stretch, Motion<R>{d[0], d[1], d[2], d[3]});
    if constexpr (!std::is_same_v<R, Interval>) m = onto_ends(m);
    return {m.s, m.v, m.a, m.j, place};
  }
  /// The law's x at a share.
  template <class R>
  R law_place(const Stretch& stretch, const R& share) const {
    const Cycle::Part part = record_->cycle.part_of(stretch);
    if (part.begin == 0 && part.length == part.total) return share;
    return (number<R>(part.total) * share - number<R>(part.begin)) / number<R>(part.length);
  }

  const TurnRecord* record_ = nullptr;
  std::vector<FormulaAlong<T>> formulas_;
  std::optional<Law<T>> law_;
  std::vector<PieceExpander> expanders_;  ///< of intervals
  std::vector<Section> sections_;
  std::vector<T> joints_;
};

/// As many steps as a stretch of this length needs, `whole` over the turn.
inline int turn_steps(double rate, double length, double whole) {
  const double steps = std::max(whole, rate) * length;
  return std::max(detail::kLeastSteps, static_cast<int>(std::ceil(steps)));
}

/// The steps of a quadrature between two places of section `section`, added to others.
template <class T>
void add_turn_steps(const T& begin, const T& end, double rate, std::size_t section,
                    std::vector<MeanStep<T>>& steps) {
  const int count = turn_steps(rate, value_of(T(end - begin)), detail::kMeanSteps);
  add_even_steps(begin, end, count, section, steps);
}

// ---------------------------------------------------------------------------------------------

template <class T>
std::optional<TurnSections<T>> TurnSections<T>::whole(const TurnRecord& record,
                                                      std::span<const T> u) {
  const auto machine = u.first(record.arguments());
  if (!is_possible_at(record.formulas.front().is_possible, machine)) return {};
  TurnSections result;
  result.record_ = &record;
  for (const Recorded& one : record.formulas) result.formulas_.emplace_back(one.formula, machine);
  if (record.law) {
    auto law = record.law->template possible_law_of<T>(u.subspan(machine.size()));
    if (!law || has_pulse(record.cycle, *law)) return {};
    result.law_.emplace(std::move(*law));
    result.add_pieces();
  } else {
    result.add_formulas(machine);
  }
  for (const Section& section : result.sections_) result.joints_.push_back(section.end);
  return result;
}

template <class T>
void TurnSections<T>::add_pieces() {
  const Cycle& cycle = record_->cycle;
  for (std::size_t k = 0; k < cycle.stretches.size(); ++k) {
    const Cycle::Part part = cycle.part_of(cycle.stretches[k]);
    for (std::size_t i = 0; i < law_->pieces().size(); ++i) {
      const Piece<T>& piece = law_->pieces()[i];
      const double rate = detail::harmonic_rate(piece) * part.total / part.length;
      sections_.push_back({part.at(piece.begin), part.at(piece.end), rate, k, i});
    }
  }
  if constexpr (std::is_same_v<T, Interval>) {
    for (const Piece<Interval>& piece : law_->pieces()) expanders_.emplace_back(piece);
  }
}

/// Breaks that have moved out of the turn, or past one another, leave sections without length.
template <class T>
void TurnSections<T>::add_formulas(std::span<const T> machine) {
  constexpr double kRate = 64;  // formulas of the angle may change quickly
  T begin = number<T>(0);
  for (std::size_t k = 0; k < formulas_.size(); ++k) {
    T end = number<T>(1);
    if (k < record_->breaks.size()) {
      end = record_->breaks[k].formula(machine) / (number<T>(2) * pi<T>());
      if (!(value_of(end) >= value_of(begin))) end = begin;
      if (!(value_of(end) <= 1)) end = number<T>(1);
    }
    sections_.push_back({begin, end, kRate, 0, k});
    begin = end;
  }
}

template <class T>
void TurnSections<T>::split(std::span<const T> u) {
  const auto& all = record_->decisions;
  if (std::none_of(all.begin(), all.end(), [](const Decisions& d) { return d.any(); })) return;
  std::vector<double> plain;
  for (const T& value : u) plain.push_back(value_of(value));
  const std::span<const double> arguments(plain.data(), record_->arguments());
  const std::vector<Dual> fixed(arguments.begin(), arguments.end());
  const auto base = TurnSections<double>::whole(*record_, plain);
  std::vector<Section> result;
  for (std::size_t p = 0; p < sections_.size(); ++p) {
    Section section = sections_[p];
    const auto& same = base->sections_[p];
    const Decisions& decisions = all[law_ ? 0 : section.piece];
    const std::pair<double, double> ends(same.begin, same.end);
    const auto found =
        decisions.in_sections(std::span(&ends, 1), arguments,
                              [&](std::size_t, double share) { return base->inputs(same, share); });
    const double length = same.end - same.begin;
    const auto exact = [&](const Decision& decision) {
      const Formula& decider = decisions.decider(decision.decider);
      const auto near = base->inputs(same, Dual(decision.place, 0));
      const double slope = FormulaAlong<Dual>(decider, fixed)(std::span<const Dual>(near)).v[0];
      const FormulaAlong<T> along(decider, u.first(record_->arguments()));
      const auto at_share = [&](const T& share) {
        const auto taken = inputs(section, share);
        return along(std::span<const T>(taken));
      };
      return exact_place<T>(at_share, slope, decision.place, length);
    };
    for (const T& place : exact_places<T>(found.front(), length, exact)) {
      result.push_back(section);
      result.back().end = section.begin = place;
    }
    result.push_back(section);
  }
  sections_ = std::move(result);
}

template <>
inline detail::TaylorTerms TurnSections<Interval>::terms(const Section& section, const Interval& c,
                                                         const Interval& box) const {
  constexpr std::size_t kTerms = detail::kTaylorTerms;
  using Terms = Series<Interval, kTerms>;
  const Interval one(1.0);
  if (!law_) {
    const Interval turn = Interval(2.0) * pi<Interval>();
    const auto of = [&](const Interval& share) {
      const Terms angle = Terms::variable(turn * share, turn);
      return formula_of(section)(std::span<const Terms>(&angle, 1));
    };
    return {of(c), of(box)};
  }
  const Stretch& stretch = record_->cycle.stretches[section.stretch];
  const Cycle::Part part = record_->cycle.part_of(stretch);
  const Piece<Interval>& piece = law_->pieces()[section.piece];
  const auto of = [&](const std::array<Interval, kTerms + 3>& d, const Interval& share) {
    const auto m = follower_motion(stretch, motion_series<kTerms>(d));
    std::array<Terms, 5> taken{m.s, m.v, m.a, m.j, Terms()};
    // From terms in the law's x to terms in the share.
    Interval factor = one;
    const Interval rate = one / part.slope<Interval>();
    for (std::size_t k = 0; k < kTerms; ++k) {
      for (std::size_t i = 0; i < 4; ++i) taken[i].c[k] = taken[i].c[k] * factor;
      factor = factor * rate;
    }
    taken[4] = Terms::variable(share, one);
    return formula_of(section)(std::span<const Terms>(taken));
  };
  return {
      of(derivatives<kTerms + 3>(piece, law_place(stretch, c)), c),
      of(detail::derivatives_over(piece, expanders_[section.piece], law_place(stretch, box)), box)};
}

}  // namespace camlaw::problems
