// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "optim/cycle/scales.h"
#include "optim/problem/problem.h"

/// Numbers that have a kink at a design (docs/optimisation.md, "Kinks").
namespace camlaw::optim {

/// The problem as it is about a design: a number that is the highest of several smooth pieces
/// there, as the objective or as a limit near its bound, is a curve with a part for each. Of a
/// limit with two bounds the one that is near is kept. None where no number is such, and for more
/// than 30 variables.
std::optional<Problem> with_pieces_apart(const Problem& problem, const Scales& scales, Design x);

/// The first number, the objective or a limit near its bound, that is the highest or the lowest of
/// several smooth pieces about a design; empty where none is.
std::string kinked_name(const Problem& problem, const Scales& scales, Design x);

}  // namespace camlaw::optim
