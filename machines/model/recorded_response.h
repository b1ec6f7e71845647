// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "machines/model/curve_formula.h"
#include "machines/model/cycle.h"
#include "machines/model/mechanism.h"
#include "machines/model/recorded_kernel.h"
#include "machines/model/shape_rules.h"

/// Responses that are formulas: what they depend on, and the functions of a design that they make,
/// all from MechanismResponse::write.
namespace camlaw::problems {

/// What a curve's formula has beside the parameters.
inline constexpr std::array<const char*, 5> kPlaceNames{"s", "v", "a", "j", "x"};
inline constexpr std::size_t kOfPlace = kPlaceNames.size();

/// The other inputs of a response's formula: the angle over a turn, the motion and its place, or
/// the inner numbers.
std::vector<std::string> other_names(const MechanismResponse& response);

/// Records a formula with all parameters as inputs, in which the others follow.
Formula whole_formula(const Write& write, std::size_t parameters, std::size_t others);

/// Records a formula for what varies of a binding: these arguments come first among the inputs,
/// then `others`. Arguments that are 0 in `at`, where it is given, are constants, and what they
/// multiply is left out.
Recorded recorded_for(const Binding& binding, const Write& write, std::size_t others,
                      const IsPossible& is_possible, std::span<const double> at = {});

/// The parameters that a formula depends on, of as many as there are. It is recorded when they are
/// first asked for.
ParameterSet used_parameters(Write write, std::size_t parameters, std::size_t others);

/// Records several formulas without other inputs for what varies of a binding.
std::vector<Recorded> recorded_parts(const Binding& binding, const std::vector<Write>& writes,
                                     const IsPossible& is_possible);

/// The parameters that any of some formulas without other inputs depends on.
ParameterSet used_by_any(const std::vector<Write>& writes, std::size_t parameters);

/// The shape of a formula in what varies of a binding, by rules or enclosure: of a curve at every
/// place.
RuledShape ruled_shape(const MechanismResponse& response, const Binding& binding,
                       const std::vector<MechanismParameter>& parameters);

/// Completes a number, which has write, and inner where its formula holds other numbers.
MechanismResponse recorded_number(MechanismResponse response,
                                  const std::vector<MechanismParameter>& parameters);

/// Whether a curve goes to infinity with a pulse of the acceleration or the jerk; of a formula that
/// a file states nothing is known.
enum class AtPulse : char { Unknown, Infinite };

/// Completes a curve, which has write: its record is evaluated.
MechanismResponse recorded_curve(MechanismResponse response,
                                 const std::vector<MechanismParameter>& parameters,
                                 const Cycle& cycle, AtPulse at_pulse = AtPulse::Unknown);

}  // namespace camlaw::problems
