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

/// A machine of a binding: constants with some parameters that vary.
template <template <class> class M>
class BoundMachine {
 public:
  explicit BoundMachine(const Binding& binding)
      : constants_(binding.constants), varying_(binding.parameters) {}

  /// How many of its parameters vary.
  std::size_t arguments() const { return varying_.size(); }

  /// The machine with its varying parameters at u, in their listed units.
  template <class T>
  M<T> at(std::span<const T> u) const {
    M<T> machine;
    const auto& factor = factors();
    for (std::size_t i = 0; i < factor.size(); ++i) {
      field(machine, i) = factor[i].template as<T>() * number<T>(constants_[i]);
    }
    for (std::size_t k = 0; k < varying_.size(); ++k) {
      field(machine, varying_[k]) = factor[varying_[k]].template as<T>() * u[k];
    }
    return machine;
  }

 private:
  template <class T>
  static T& field(M<T>& machine, std::size_t i) {
    using Traits = MachineTraits<M>;
    constexpr auto& fields = Traits::template fields<T>;
    if constexpr (requires { Traits::template part<T>; }) {
      auto& part = machine.*Traits::template part<T>;
      return i < fields.size() ? machine.*fields[i] : part.*part.fields[i - fields.size()];
    } else {
      return machine.*fields[i];
    }
  }

  /// From listed units to those of the formulas.
  static const std::vector<UnitFactor>& factors() {
    static const std::vector<UnitFactor> kept = [] {
      std::vector<UnitFactor> result;
      for (const auto& p : MachineTraits<M>::parameters()) result.emplace_back(p.unit, p.stored);
      return result;
    }();
    return kept;
  }

  std::vector<double> constants_;
  std::vector<std::size_t> varying_;
};

}  // namespace camlaw::problems
