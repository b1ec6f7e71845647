// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "machines/model/arguments.h"
#include "machines/model/machine.h"
#include "machines/model/not_a_number.h"
#include "machines/model/possibility.h"
#include "machines/model/possible_by.h"
#include "machines/model/recorded_response.h"
#include "numerics/formula/expression.h"

/// Responses of a mechanism from formulas that are written once.
namespace camlaw::problems {

/// What a response is called and counted in.
struct ResponseAbout {
  std::string name;
  std::string unit;    ///< listed
  std::string stored;  ///< the one that the formula gives
  std::string meaning;
  std::vector<ShapeStatement> shapes = {};
  bool is_coordinate = false;  ///< of a point of a curve of the cam, such as its profile
};

/// A number: formula(machine) -> Expression for a machine M.
template <class M, class F>
MechanismResponse number_response(ResponseAbout about, F formula);

/// A curve: formula(machine, motion) or formula(machine, motion, x), of an M, the
/// follower's motion along x, a Motion<Expression>, and, if the formula wants it, x itself.
template <class M, class F>
MechanismResponse curve_response(ResponseAbout about, const Cycle& cycle, F formula);

/// A whole turn of the cam as one stretch: what motion programs run over.
inline const Cycle& turn_of_the_cam() {
  static const Cycle turn{"deg", {{0, 360}}};
  return turn;
}

// ---------------------------------------------------------------------------------------------

namespace detail {

/// The margins of a machine's conditions.
template <class M>
std::vector<Margin> margins_of() {
  std::vector<Margin> result;
  if constexpr (requires(const M& machine) { machine.conditions(); }) {
    const auto& conditions = conditions_of<M>();
    for (std::size_t k = 0; k < conditions.size(); ++k) {
      const auto write = [k](std::span<const Expression> parameters, std::span<const Expression>) {
        return machine_of<M>(parameters).conditions()[k].margin;
      };
      result.push_back({write, conditions[k].may_be_zero, [](std::size_t parameter) {
                          const MechanismParameter& p = parameters_of<M>()[parameter];
                          return Interval(p.low, p.high);
                        }});
    }
  }
  return result;
}

/// What decides whether there is such a machine.
template <class M>
const PossibleBy& possible_machines() {
  static const PossibleBy kept = possible_by(margins_of<M>(), parameters_of<M>().size());
  return kept;
}

/// What its describer says of a machine's response, and what decides whether it is a number.
template <class M>
MechanismResponse described(ResponseAbout about) {
  return {.name = std::move(about.name),
          .unit = std::move(about.unit),
          .meaning = std::move(about.meaning),
          .shapes = std::move(about.shapes),
          .possible_by = possible_machines<M>(),
          .is_possible =
              [](std::span<const double> parameters) {
                return broken_condition<M>(parameters) == nullptr;
              },
          .is_coordinate = about.is_coordinate};
}

}  // namespace detail

template <class M, class F>
MechanismResponse number_response(ResponseAbout about, F formula) {
  const UnitFactor factor(about.stored, about.unit);
  MechanismResponse response = detail::described<M>(std::move(about));
  response.write = [formula, factor](std::span<const Expression> parameters,
                                     std::span<const Expression>) {
    return factor.as<Expression>() * formula(detail::machine_of<M>(parameters));
  };
  return recorded_number(std::move(response), parameters_of<M>());
}

template <class M, class F>
MechanismResponse curve_response(ResponseAbout about, const Cycle& cycle, F formula) {
  const UnitFactor factor(about.stored, about.unit);
  MechanismResponse response = detail::described<M>(std::move(about));
  response.write = [formula, factor](std::span<const Expression> parameters,
                                     std::span<const Expression> u) {
    const auto machine = detail::machine_of<M>(parameters);
    const Motion<Expression> motion{u[0], u[1], u[2], u[3]};
    if constexpr (std::is_invocable_v<F, decltype(machine), decltype(motion), const Expression&>) {
      return factor.as<Expression>() * formula(machine, motion, u[4]);
    } else {
      return factor.as<Expression>() * formula(machine, motion);
    }
  };
  return recorded_curve(std::move(response), parameters_of<M>(), cycle, AtPulse::Infinite);
}

}  // namespace camlaw::problems
