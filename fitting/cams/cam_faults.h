// SPDX-License-Identifier: MIT
#pragma once

#include "fitting/cams/measured_cam.h"
#include "fitting/motions/record_faults.h"

namespace camlaw::problems {

/// The faults that a measured cam may have: its centre lies elsewhere (the unknowns are the true
/// one's coordinates, mm), or a size of its follower is another one (the unknown is the stated size
/// less the true one, mm), each by what it does to the lift at a fixed cam angle to first order
/// (docs/theory.md, "Measured cams", (I13) and (I14)).
PossibleFault centre_of(const MeasuredCam& cam);
std::vector<PossibleFault> possible_faults(const MeasuredCam& cam);

/// The follower with one size, named as in the fault, less by so much.
MeasuredFollower with_less(MeasuredFollower follower, const std::string& name, double less);

}  // namespace camlaw::problems
