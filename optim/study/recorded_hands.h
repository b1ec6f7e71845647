// SPDX-License-Identifier: MIT
#pragma once

#include "optim/crew/crew.h"
#include "optim/study/record.h"

namespace camlaw::optim {

/// Hands that take answers from a record where it has them, and record those that others give. The
/// record stays as long as what is returned. Exceptions from writing the record pass through.
Hands recorded_hands(Hands others, StudyRecord& record);

}  // namespace camlaw::optim
