// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "machines/model/given.h"
#include "machines/model/mechanism.h"
#include "machines/model/possibility.h"

/// Machines: structs of expressions, such as SpineCutter, whose fields say what each parameter is
/// (machines/model/given.h). One with a member conditions() is undefined, NaN, where
/// one of them does not hold (machines/model/possibility.h).
namespace camlaw::problems {

/// The parameters of a machine, in the order of its fields.
template <class M>
const std::vector<MechanismParameter>& parameters_of() {
  static const std::vector<MechanismParameter> kept = [] {
    std::vector<MachineParameter> seen;
    Formula::record(0, [&seen](std::span<const Expression>) -> Expression {
      M{Given(seen)};
      return 0;
    });
    std::vector<MechanismParameter> result;
    for (const MachineParameter& p : seen) {
      result.push_back({p.name, p.symbol, p.unit, p.stored, p.meaning, p.default_value, p.low,
                        p.high, p.integer});
    }
    return result;
  }();
  return kept;
}

namespace detail {

/// From listed units to those of the formulas, for each parameter.
template <class M>
const std::vector<UnitFactor>& unit_factors() {
  static const std::vector<UnitFactor> kept = [] {
    std::vector<UnitFactor> result;
    for (const auto& p : parameters_of<M>()) result.emplace_back(p.unit, p.stored);
    return result;
  }();
  return kept;
}

/// The machine of these parameters, in listed units.
template <class M>
M machine_of(std::span<const Expression> parameters) {
  return M{Given(parameters, unit_factors<M>())};
}

/// A condition whose margin is a record of the machine's parameters, in their listed units.
struct RecordedCondition {
  Formula margin;
  const char* words;
  bool may_be_zero;

  bool holds(std::span<const double> parameters) const {
    return margin_holds(margin(parameters), may_be_zero);
  }
};

/// The conditions of a machine, in its order; none of one without conditions().
template <class M>
const std::vector<RecordedCondition>& conditions_of() {
  static const std::vector<RecordedCondition> kept = [] {
    std::vector<RecordedCondition> result;
    if constexpr (requires(const M& machine) { machine.conditions(); }) {
      constexpr std::size_t kCount =
          std::tuple_size_v<decltype(std::declval<const M&>().conditions())>;
      for (std::size_t k = 0; k < kCount; ++k) {
        const char* words = nullptr;
        bool may_be_zero = false;
        const auto write = [&](std::span<const Expression> parameters) {
          const Condition condition = machine_of<M>(parameters).conditions()[k];
          words = condition.words;
          may_be_zero = condition.may_be_zero;
          return condition.margin;
        };
        Formula margin = Formula::record(parameters_of<M>().size(), write);
        result.push_back({std::move(margin), words, may_be_zero});
      }
    }
    return result;
  }();
  return kept;
}

/// The first condition that fails with these parameters, in words; null where there is such a
/// machine.
template <class M>
const char* broken_condition(std::span<const double> parameters) {
  for (const RecordedCondition& condition : conditions_of<M>()) {
    if (!condition.holds(parameters)) return condition.words;
  }
  return nullptr;
}

}  // namespace detail

}  // namespace camlaw::problems
