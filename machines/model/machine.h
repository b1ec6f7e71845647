// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
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
/// A machine with a member is_possible() is undefined, NaN, where that is false.
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

template <class Machine>
bool is_possible(const Machine& machine) {
  if constexpr (requires { machine.is_possible(); }) return machine.is_possible();
  return true;
}

/// A value of a parameter for finding out what depends on it: its default, but not 0, where
/// what it multiplies would vanish.
inline double typical_value(const MechanismParameter& p) {
  return p.default_value != 0 ? p.default_value : 0.31 * std::min(1.0, p.high);
}

/// The machine with every parameter at its typical value.
template <template <class> class M>
BoundMachine<M> typical_machine(std::vector<std::size_t> varying = {}) {
  Binding binding;
  for (const auto& p : MachineTraits<M>::parameters()) {
    binding.constants.push_back(typical_value(p));
  }
  binding.parameters = std::move(varying);
  return BoundMachine<M>(binding);
}

/// Places of a parameter's accepted range, even and, where it holds one sign, by orders of
/// magnitude.
inline std::vector<double> places_of_range(const MechanismParameter& p) {
  constexpr int kPlaces = 24;
  std::vector<double> places;
  for (int i = 0; i <= kPlaces; ++i) {
    const double share = static_cast<double>(i) / kPlaces;
    places.push_back(p.low + share * (p.high - p.low));
    if (p.low > 0) places.push_back(p.low * std::pow(p.high / p.low, share));
  }
  return places;
}

/// The parameters that decide whether a machine is possible: those that, moved over the range that
/// they accept while the others are typical, make a possible machine impossible or the other way
/// round. What depends on other parameters alone must still follow these, for it is a number only
/// where the machine is possible.
template <template <class> class M>
const std::vector<std::size_t>& parameters_of_possibility() {
  static const std::vector<std::size_t> kept = [] {
    const auto& parameters = MachineTraits<M>::parameters();
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const auto machine = typical_machine<M>({i});
      const auto possible_at = [&](double x) {
        return is_possible(machine.template at<double>(std::span(&x, 1)));
      };
      const bool typical = possible_at(typical_value(parameters[i]));
      const auto places = places_of_range(parameters[i]);
      if (std::any_of(places.begin(), places.end(),
                      [&](double x) { return possible_at(x) != typical; })) {
        result.push_back(i);
      }
    }
    return result;
  }();
  return kept;
}

}  // namespace camlaw::problems
