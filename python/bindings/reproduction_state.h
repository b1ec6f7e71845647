// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

#include "problems/published/table/reproduction.h"

/// A published table computed again as numbers and texts alone, as Python pickles it.
namespace camlaw::python {

using Texts = std::vector<std::string>;
/// Id, quantity, law, condition, value, decimals, unit, place.
using PrintedState = std::tuple<std::string, std::string, std::string, std::string, double, int,
                                std::string, std::string>;
/// As printed, verdict, stated value, explained value, causes.
using ReproducedState = std::tuple<PrintedState, int, double, double, Texts>;
/// System, title, source, values, counts (reproduced, explained, unexplained, tried), departures,
/// other sets of them, notes, whether it is one of the program's.
using ReproductionState =
    std::tuple<std::string, std::string, std::string, std::vector<ReproducedState>,
               std::tuple<std::size_t, std::size_t, std::size_t, std::size_t>, Texts,
               std::vector<Texts>, Texts, bool>;

ReproductionState state_of(const problems::SystemReproduction& result);
problems::SystemReproduction reproduction_of(const ReproductionState& state);

}  // namespace camlaw::python
