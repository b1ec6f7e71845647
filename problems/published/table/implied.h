// SPDX-License-Identifier: MIT
#pragma once

#include "problems/published/table/stated_model.h"

namespace camlaw::problems::stated {

/// Adds to the causes of unexplained values which value of each implied parameter their print
/// needs, the hypotheses as stated. Values of one row, with the same law and settings, need the
/// same one: it is that of the value that confines it most, and each of the others says what comes
/// of it.
void add_implied(Model& model, SystemReproduction& result);

}  // namespace camlaw::problems::stated
