// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "optim/cycle/scales.h"
#include "optim/verdict/kkt.h"

namespace camlaw::optim {

/// Newton's method on the conditions of optimality themselves, from a design near an optimum. Peaks
/// move along with the design (docs/optimisation.md, "Polish"), so a few steps do what the exchange
/// of fixed angles takes many programs for. The design where the conditions hold to rounding and
/// every limit is met; of LeastViolation the design of least violation. Empty where the steps do
/// not lead to one, and for more than 300 variables.
std::optional<std::vector<double>> polished(const Problem& problem, const Scales& scales, Design x,
                                            Optimality optimality = Optimality::Objective);

}  // namespace camlaw::optim
