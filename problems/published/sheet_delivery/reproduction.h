// SPDX-License-Identifier: MIT
#pragma once

#include "problems/published/table/reproduction.h"

namespace camlaw::problems {

/// Computes the least and the greatest efficiency of the sheet-delivery paper's figure 2 again
/// (sheet_delivery.csv), over the whole stretch. Hypotheses: every friction term dissipates, where
/// the print has it signed; digits cut off instead of rounded; misprinted digits.
SystemReproduction reproduce_sheet_delivery();

}  // namespace camlaw::problems
