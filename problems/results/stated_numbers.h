// SPDX-License-Identifier: MIT
#pragma once

#include "problems/law_files/json_type.h"
#include "problems/results/recorded_design.h"

namespace camlaw::problems {

/// Of the whole object of a result; what is not there or of another type is left out.
StatedNumbers stated_numbers(const Json& result);

}  // namespace camlaw::problems
