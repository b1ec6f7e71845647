// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "optim/problem/problem.h"

namespace camlaw::optim {

/// Places to begin at: the problem's own start first, then points of a Halton sequence, shifted by
/// the seed, that fill the box evenly. A side without a bound reaches ten scales from the start.
/// Fixed and integer variables keep their start.
std::vector<std::vector<double>> starts(const Problem& problem, int count, std::uint64_t seed);

/// One of them, by its number from 0 on.
std::vector<double> nth_start(const Problem& problem, int number, std::uint64_t seed);

/// The same sequence, in which variables of one sign fill their sides evenly by orders of
/// magnitude: of a side from 1e-3 to 1e5 three eighths of the places are below 1, which evenly
/// filled would hold none.
std::vector<std::vector<double>> starts_by_magnitude(const Problem& problem, int count,
                                                     std::uint64_t seed);

}  // namespace camlaw::optim
