// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

namespace camlaw::optim {

/// Which points no other point dominates: none is as small in every objective and smaller in one.
/// All objectives are to be small; points have equal length. Values that differ by less than
/// `tolerance` of their size count as equal, and equal points stand beside each other. A point with
/// an objective that is NaN is dominated; an infinite one is compared as it is.
std::vector<bool> non_dominated(std::span<const std::vector<double>> points,
                                double tolerance = 1e-9);

}  // namespace camlaw::optim
