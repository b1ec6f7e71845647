// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

namespace camlaw::optim {

/// Which points no other one dominates: none is as small in every objective and smaller in one.
/// All objectives are to be small; points have equal length. Values that differ by less than
/// `tolerance` of their size, or by no more than the objective's own of `tolerances` (empty: none),
/// count as equal, and equal points stand beside each other. A point with an objective that is NaN
/// is dominated; an infinite one is compared as it is.
///
/// Equal within a tolerance is not transitive: a row of points, each a little worse than the next
/// in one objective, must not fall to its last one. So a point goes where one that *stays*
/// dominates it (a kernel of the relation): first those stay that nothing dominates, what they
/// dominate goes, and so on. Where points dominate each other in a ring the smallest stays, and
/// what dominates it goes as well. None that stays dominates another.
std::vector<bool> non_dominated(std::span<const std::vector<double>> points,
                                double tolerance = 1e-9,
                                const std::vector<double>& tolerances = {});

}  // namespace camlaw::optim
