// SPDX-License-Identifier: MIT
#pragma once

#include "optim/crew/crew.h"
#include "optim/study/record.h"

namespace camlaw::optim {

/// Hands that take answers from a record where it has them, and put down those that others give.
/// The record stays as long as what is returned. What it throws where it cannot be written passes.
Hands recorded_hands(Hands others, StudyRecord& record);

}  // namespace camlaw::optim
