// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/mechanism.h"

namespace camlaw::problems {

/// "follower-train": an elastic follower over one rise, and the vibration that is left.
Mechanism follower_train_mechanism();

}  // namespace camlaw::problems
