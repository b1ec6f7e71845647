// SPDX-License-Identifier: MIT
#pragma once

#include "fitting/motions/faulty_rows.h"

/// Records of a lift that go on beyond one turn of the cam.
namespace camlaw::problems {

/// Puts the rows of a lift that stand beyond a turn of 360 deg from the first one where they are a
/// turn before, and notes it: if they repeat the rows there within the noise, and move enough to
/// tell that the turn is one of 360 deg to 0.1 % ((FS12) in docs/optimisation.md), or reach no
/// farther beyond it than that. Leaves records alone that are no lift by deg. Throws
/// std::invalid_argument where the rows do not repeat those a turn before, and where they do not
/// tell.
void fold_further_turns(MotionRecord& record);

}  // namespace camlaw::problems
