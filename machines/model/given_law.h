// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "machines/model/law_binding.h"
#include "machines/model/mechanism.h"

/// Laws of which a parameter is not set by itself, but has the value of one of the machine's
/// (Parameter::given_by): a motion program with times, whose angles follow the machine's speed.
namespace camlaw::problems {

/// The parameter of a family that the machine's parameter of this index gives.
std::optional<std::size_t> given_parameter(const Family& family, std::size_t machine_parameter);

/// Gives a law what it has of a machine, whose parameters have these values, in listed units.
void give(const std::vector<double>& constants, Member& law);

/// The law of a machine: what the machine gives it is the machine's constant, or varies with its
/// design variable. Throws std::invalid_argument as LawBinding does.
std::shared_ptr<const LawBinding> given_law(Member law, std::vector<LawVariable> variables,
                                            const Binding& machine);

/// The binding's own law where what the machine gives it has changed since it was bound: its
/// constants, and which of the parameters that give something still vary. The same law where it is
/// given nothing.
std::shared_ptr<const LawBinding> given_again(const Binding& machine);

/// The mechanism where one of its parameters gives its law something: whatever sees the law depends
/// on the parameter.
Mechanism giving_law(Mechanism mechanism, std::size_t parameter);

}  // namespace camlaw::problems
