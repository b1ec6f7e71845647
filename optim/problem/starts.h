// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "optim/problem/problem.h"

namespace camlaw::optim {

/// Places to begin at: the problem's own start first, then points of a Halton sequence, shifted by
/// the seed, that fill the box evenly. A side without a bound reaches ten scales from the start.
/// Fixed and whole variables keep their start.
std::vector<std::vector<double>> starts(const Problem& problem, int count, std::uint64_t seed);

}  // namespace camlaw::optim
