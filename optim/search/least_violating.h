// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "optim/cycle/scales.h"

namespace camlaw::optim {

/// Of 128 places that fill the box evenly, as many that fill it by orders of magnitude and as many
/// on its faces, up to `count` at which limits are passed least, the least first and apart from
/// each other; none where the model gives no number. A search for the least violation begins there:
/// where the limits leave no convex set, the one that it came to first may not be the least. On a
/// face a law may have lost a phase, so that its curves are others than anywhere beside it.
/// `known`: where a search has ended already; nothing near it is wanted.
std::vector<std::vector<double>> least_violating(const Problem& problem, const Scales& scales,
                                                 Design known, std::size_t count,
                                                 std::uint64_t seed);

}  // namespace camlaw::optim
