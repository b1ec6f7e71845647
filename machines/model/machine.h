// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "machines/model/mechanism.h"
#include "numerics/formula/unit_factor.h"

/// Joins the parameters of a mechanism, as people list them, to the fields of its formulas.
namespace camlaw::problems {

/// What a machine, a class template in its scalar such as SpineCutter, has to say of itself.
/// Specialised for each with
///   static const std::vector<MechanismParameter>& parameters();
///   template <class T> static constexpr std::array fields{&M<T>::..., ...};  // in that order
/// and, where a struct of the machine has the parameters behind those, with an array `fields` of
/// its own,
///   template <class T> static constexpr auto part = &M<T>::...;
/// A machine with a member conditions() is undefined, NaN, where one of them does not hold
/// (machines/model/possibility.h).
template <template <class> class M>
struct MachineTraits;

namespace detail {

/// The field of a machine behind a parameter.
template <template <class> class M, class T>
T& field_of(M<T>& machine, std::size_t parameter) {
  using Traits = MachineTraits<M>;
  constexpr auto& fields = Traits::template fields<T>;
  if constexpr (requires { Traits::template part<T>; }) {
    auto& part = machine.*Traits::template part<T>;
    return parameter < fields.size() ? machine.*fields[parameter]
                                     : part.*part.fields[parameter - fields.size()];
  } else {
    return machine.*fields[parameter];
  }
}

/// From listed units to those of the formulas, for each parameter.
template <template <class> class M>
const std::vector<UnitFactor>& unit_factors() {
  static const std::vector<UnitFactor> kept = [] {
    std::vector<UnitFactor> result;
    for (const auto& p : MachineTraits<M>::parameters()) result.emplace_back(p.unit, p.stored);
    return result;
  }();
  return kept;
}

/// The machine of these parameters, in listed units.
template <template <class> class M, class T>
M<T> machine_of(std::span<const T> parameters) {
  M<T> machine;
  const auto& factor = unit_factors<M>();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    field_of<M, T>(machine, i) = factor[i].template as<T>() * parameters[i];
  }
  return machine;
}

}  // namespace detail

}  // namespace camlaw::problems
