// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "machines/model/given.h"
#include "machines/model/mechanism.h"

/// Machines: class templates in their scalar, such as SpineCutter, whose fields say what each
/// parameter is (machines/model/given.h). One with a member conditions() is undefined, NaN, where
/// one of them does not hold (machines/model/possibility.h).
namespace camlaw::problems {

/// The parameters of a machine, in the order of its fields.
template <template <class> class M>
const std::vector<MechanismParameter>& parameters_of() {
  static const std::vector<MechanismParameter> kept = [] {
    std::vector<MachineParameter> seen;
    M<double>{Given<double>(seen)};
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
template <template <class> class M>
const std::vector<UnitFactor>& unit_factors() {
  static const std::vector<UnitFactor> kept = [] {
    std::vector<UnitFactor> result;
    for (const auto& p : parameters_of<M>()) result.emplace_back(p.unit, p.stored);
    return result;
  }();
  return kept;
}

/// The machine of these parameters, in listed units.
template <template <class> class M, class T>
M<T> machine_of(std::span<const T> parameters) {
  return M<T>{Given<T>(parameters, unit_factors<M>())};
}

}  // namespace detail

}  // namespace camlaw::problems
