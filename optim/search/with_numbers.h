// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "optim/problem/problem.h"

namespace camlaw::optim {

/// The problem of finding any design that meets those limits that are numbers at a design, with
/// room to each bound of a share of it; none where there is no such limit. For models that give no
/// number at a start: a design that their limits of validity allow. At their edge a model may be
/// infinite.
std::optional<Problem> with_numbers_only(const Problem& problem, Design x, double share);

}  // namespace camlaw::optim
