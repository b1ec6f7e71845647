// SPDX-License-Identifier: MIT
#pragma once

#include "problems/published/table/reproduction.h"

namespace camlaw::problems {

/// Computes the die-press paper's table again (die_press.csv): stress, half-width and approach for
/// the loads of five laws. Hypotheses: another share of the spring's force in the load than all of
/// it, and the exact coefficients of Hertz. Rows that no share explains together with the others
/// name the load and the share that their stress implies, and which of their values is a misprint
/// under that load.
SystemReproduction reproduce_die_press();

}  // namespace camlaw::problems
