// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "optim/fit/least_squares.h"

/// Parameters of a fit as lists of values and the other way round.
namespace camlaw::problems {

using FitParameters = std::vector<optim::FitParameter>;

std::vector<double> values_of(const optim::FitResult& fit);
/// The parameters with the first of them starting at these values, as far as their bounds let them.
FitParameters starting_at(FitParameters parameters, std::span<const double> values);
/// The parameters with those from `first` to before `last` held where they start.
FitParameters holding(FitParameters parameters, std::size_t first, std::size_t last);
bool is_held(const optim::FitParameter& parameter);

}  // namespace camlaw::problems
