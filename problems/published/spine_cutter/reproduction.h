// SPDX-License-Identifier: MIT
#pragma once

#include "problems/published/table/reproduction.h"

namespace camlaw::problems {

/// Computes every number again that the spine-cutter paper prints (spine_cutter.csv) and finds by
/// itself under which departures from the stated inputs the digits agree. The hypotheses, declared
/// in reproduction.cpp: other numbers of blades, other depths, factor 4 for 2 in equation (7),
/// peaks read off a table of N steps (sampled, or by differences of the displacement), the members
/// behind the two degree-7 rows, whose coefficient the paper does not print, a degree-5 polynomial
/// in place of the cosine, and misprinted digits.
SystemReproduction reproduce_spine_cutter();

}  // namespace camlaw::problems
