// SPDX-License-Identifier: MIT
#pragma once

#include "output/export/drawing.h"
#include "problems/statement/statement.h"

namespace camlaw::problems {

/// Draws on FOLLOWER what stands on the cam at cam angle 0: a roller (both of a conjugate pair), a
/// knife edge, or a flat face, as long as the contact needs it, with a cross where it touches; of
/// an arm also its pivot. `mark`, mm, is the size of what has none of its own. Nothing of a machine
/// of which only a profile is known.
void draw_follower(const ProblemStatement& design, double mark, Drawing& drawing);

}  // namespace camlaw::problems
