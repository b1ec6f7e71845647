// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "machines/follower_train/follower_train.h"
#include "machines/model/law_number.h"

/// The speed at which a follower with an elastic train begins to leave its cam.
namespace camlaw::problems {

/// What of a machine matters: f_n, zeta, the force at displacement 0, what the spring adds up to
/// the stroke, and the mass at the cam and that at the train's end, both times the stroke.
inline constexpr std::size_t kLossParts = 6;

/// (U10) The lowest speed of the cam, in rad/s, at which the least force of the steady state is 0:
/// a follower leaves its cam, a turret crosses to its holding flank.
/// NaN, with the reason, where nothing holds the follower, where the train has no damping or no
/// steady state, and where the follower stays on the cam up to ten turns in a natural period. Of a
/// rigid train the reason names the response `rigid`.
LawKernel contact_loss(const std::string& rigid);

}  // namespace camlaw::problems
