// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "optim/pareto/pareto.h"

/// A front as numbers and texts alone, as Python pickles it.
namespace camlaw::python {

using Numbers = std::vector<double>;
using MaybeNumber = std::optional<double>;

/// Name, unit, sense, part.
using ObjectiveState = std::tuple<std::string, std::string, int, int>;
/// Name, unit, margin, angle, met, proved, price.
using StandingState = std::tuple<std::string, std::string, double, MaybeNumber, bool, bool, double>;
/// Part, x, objectives, costs, weights, verdict, reason, global, limits, solver.
using PointState = std::tuple<std::size_t, Numbers, Numbers, Numbers, Numbers, int, std::string,
                              bool, std::vector<StandingState>, std::string>;
/// Number, part, why.
using FailureState = std::tuple<std::size_t, std::size_t, std::string>;
/// A task of a record that is not believed: number, damaged, why.
using FaultState = std::tuple<std::int64_t, int, std::string>;
/// Hypervolume, what it is at most, that of mixtures, largest gap.
using SizeState = std::tuple<double, MaybeNumber, MaybeNumber, MaybeNumber>;
/// Parts, empty ones, those without an end, tasks, evaluations.
using CountState = std::tuple<std::size_t, std::size_t, std::size_t, std::size_t, long>;
/// Objectives, points, (ideal, nadir, reference, tolerances, sizes), measures, counts, failures,
/// (each is global, stopped, complete, of each objective whether its ideal is certified), remark.
using FrontState =
    std::tuple<std::vector<ObjectiveState>, std::vector<PointState>, std::vector<Numbers>,
               SizeState, CountState, std::vector<FailureState>,
               std::tuple<bool, bool, bool, std::vector<bool>>, std::string>;

FrontState state_of(const optim::Front& front);
optim::Front front_of(const FrontState& state);

}  // namespace camlaw::python
