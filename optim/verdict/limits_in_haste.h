// SPDX-License-Identifier: MIT
#pragma once

#include "optim/verdict/verdict.h"

namespace camlaw::optim {

/// For an answer for whose proofs there is no time: looks at the worst place of each side of a
/// limit once more, with what the bounds there come upon, and shows the side with less room.
/// Nothing is proved of what is met: all of its cycle is left open.
void look_in_haste(const Problem& problem, Design x, std::vector<LimitReport>& limits);

/// The same of a design that a search has judged on its way: where a limit turns out to be broken,
/// it is judged anew.
void judge_in_haste(const Problem& problem, Design x, Assessment& assessment);

}  // namespace camlaw::optim
