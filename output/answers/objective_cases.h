// SPDX-License-Identifier: MIT
#pragma once

#include "output/document/document.h"
#include "problems/statement/statement.h"

namespace camlaw::cli {

/// The first objective of a design in each load case, of which it is the worst or the weighted
/// mean: the value as its own objective would have it, and where it is at its worst. Empty where
/// the objective is not over cases.
Table objective_cases(const problems::ProblemStatement& design);

}  // namespace camlaw::cli
