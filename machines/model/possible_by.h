// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "machines/model/mechanism.h"

/// Which machines there are: the set of parameters at which every margin is above 0, by the
/// margins' records (docs/theory.md, "Which machines there are").
namespace camlaw::problems {

/// What decides on a mechanism whose margins are these. A condition that holds all over what the
/// parameters accept decides nothing.
PossibleBy possible_by(std::vector<Margin> margins, std::size_t parameters);

/// What decides on any of the machines.
PossibleBy united(std::vector<PossibleBy> all);

/// Of the parameters that vary of a binding those that decide whether there is a machine, with the
/// others as they are there; increasing.
std::vector<std::size_t> deciding(const PossibleBy& possible_by, const Binding& binding);

/// Whether rules find that the machines of a binding which are possible are a convex set: each
/// margin is concave or quasiconcave in what varies.
bool is_convex_by_rules(const PossibleBy& possible_by, const Binding& binding);

/// Whether every machine of a box is possible, in which each varying parameter of the binding lies
/// within its bounds: proved by enclosures of the margins. False where that is not found.
bool all_possible(const PossibleBy& possible_by, const Binding& binding,
                  std::span<const optim::Bounds> box);

}  // namespace camlaw::problems
