// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/responses.h"
#include "machines/model/turn_curve.h"

/// Responses over a turn of the driving shaft from formulas that are written once.
namespace camlaw::problems {

namespace detail {

/// How many sections the turn of a machine has: Machine::kSections, where it has such.
template <class Machine>
constexpr std::size_t sections_of() {
  if constexpr (requires { Machine::kSections; }) return Machine::kSections;
  return 1;
}

}  // namespace detail

/// A curve over the turn. work(machine) works out what the machine contributes and returns a
/// callable formula(section, angle) -> Expression, the angle in rad. Where the formula is not
/// smooth all round, the machine M has kSections and breaks(), the angles where sections meet.
template <class M, class F>
MechanismResponse turn_response(ResponseAbout about, F work) {
  using Numbers = std::span<const Expression>;
  constexpr std::size_t kSections = detail::sections_of<M>();
  const UnitFactor factor(about.stored, about.unit);
  MechanismResponse response = detail::described<M>(std::move(about));
  ShaftTurn turn;
  turn.sided = [work, factor](Numbers parameters, Numbers place) {
    const auto formula = work(detail::machine_of<M>(parameters));
    Expression before = formula(0, place[0]), result = before;
    for (std::size_t section = 1; section < kSections; ++section) {
      const Expression here = formula(section, place[0]);
      const bool is_same = here.step() == before.step();  // then the formula goes on
      if (!is_same) result = by_side(place[section], here, result);
      before = here;
    }
    return factor.template as<Expression>() * result;
  };
  if constexpr (kSections > 1) {
    for (std::size_t k = 0; k + 1 < kSections; ++k) {
      turn.breaks.push_back([k](Numbers parameters, Numbers) {
        return detail::machine_of<M>(parameters).breaks()[k];
      });
    }
  }
  return recorded_turn(std::move(response), std::move(turn), parameters_of<M>());
}

}  // namespace camlaw::problems
